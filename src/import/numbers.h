#pragma once

#include <array>
#include <cstdint>

namespace lapidary::import {

enum class NumberStatus : std::uint8_t { ok, malformed, too_large };

namespace detail {

constexpr bool is_digit(char c) {
  return static_cast<unsigned char>(c - '0') < 10;
}

inline const char* eat_digits(const char* p, std::uint64_t& value) {
  for (; is_digit(*p); ++p) value = value * 10 + static_cast<std::uint64_t>(*p - '0');
  return p;
}

NumberStatus parse_long_number(const char* begin, const char* end, double& value);

}  // namespace detail

/// Reads a decimal number such as `-12.5e-3`, `+.5` or `7.` at `p` into `value`, correctly rounded,
/// and moves `p` behind it; what follows is not looked at. The text must not end in the number.
/// Numbers too small for a double become zero. `nan`, `inf` and hexadecimal are malformed. When
/// malformed, `p` stays.
inline NumberStatus parse_number(const char*& p, double& value) {
  const char* const begin = p;
  const char* q = p + (*p == '-' || *p == '+' ? 1 : 0);
  const char* const integer = q;
  std::uint64_t mantissa = 0;
  q = detail::eat_digits(q, mantissa);
  std::int64_t digits = q - integer;
  std::int64_t exponent = 0;
  if (*q == '.') {
    const char* const fraction = ++q;
    q = detail::eat_digits(q, mantissa);
    exponent = fraction - q;
    digits -= exponent;
  }
  if (digits == 0) return NumberStatus::malformed;
  if (*q == 'e' || *q == 'E') {
    const char* r = q + 1;
    const bool negative = *r == '-';
    if (*r == '-' || *r == '+') ++r;
    if (!detail::is_digit(*r)) return NumberStatus::malformed;
    std::int64_t stated = 0;
    for (; detail::is_digit(*r); ++r) stated = stated < 100000 ? stated * 10 + (*r - '0') : stated;
    exponent += negative ? -stated : stated;
    q = r;
  }
  p = q;
  // Both the mantissa and the power of ten are exact doubles here, so one rounding is all there is
  // (Clinger, "How to read floating point numbers accurately", 1990).
  constexpr std::array<double, 23> power = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                            1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                            1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  if (digits > 19 || mantissa > (std::uint64_t{1} << 53) || exponent < -22 || exponent > 22) {
    return detail::parse_long_number(begin, q, value);
  }
  const auto m = static_cast<double>(mantissa);
  const double magnitude = exponent < 0 ? m / power[static_cast<std::size_t>(-exponent)]
                                        : m * power[static_cast<std::size_t>(exponent)];
  value = *begin == '-' ? -magnitude : magnitude;
  return NumberStatus::ok;
}

/// Reads an integer at `p` and moves `p` behind it; false, and `p` stays, when there is none.
/// Beyond +-10^18 the value is saturated.
inline bool parse_integer(const char*& p, std::int64_t& value) {
  const bool negative = *p == '-';
  const char* q = p + (negative || *p == '+' ? 1 : 0);
  if (!detail::is_digit(*q)) return false;
  std::int64_t magnitude = 0;
  constexpr std::int64_t limit = 1'000'000'000'000'000'000;
  for (; detail::is_digit(*q); ++q) {
    magnitude = magnitude < limit / 10 ? magnitude * 10 + (*q - '0') : limit;
  }
  value = negative ? -magnitude : magnitude;
  p = q;
  return true;
}

}  // namespace lapidary::import
