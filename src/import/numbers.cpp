#include "import/numbers.h"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <system_error>

namespace lapidary::import::detail {
namespace {

// Whether a number that no double can hold is too small: the decimal place of its first digit
// tells.
bool is_tiny(std::string_view text) {
  const std::size_t e = text.find_first_of("eE");
  const std::string_view digits = text.substr(0, e);
  const bool negative_exponent = e != std::string_view::npos && text[e + 1] == '-';
  const std::size_t first = digits.find_first_of("123456789");
  if (first == std::string_view::npos) return true;
  const std::size_t point = std::min(digits.find('.'), digits.size());
  const auto place = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
  std::int64_t exponent = 0;
  if (e != std::string_view::npos) {
    for (const char c : text.substr(e + 1)) {
      if (is_digit(c)) exponent = std::min<std::int64_t>(exponent * 10 + (c - '0'), 1'000'000'000);
    }
  }
  return place + (negative_exponent ? -exponent : exponent) < 0;
}

}  // namespace

NumberStatus parse_long_number(const char* begin, const char* end, double& value) {
  if (*begin == '+') ++begin;
  const auto [at, error] = std::from_chars(begin, end, value);
  if (error == std::errc() && at == end) return NumberStatus::ok;
  if (error != std::errc::result_out_of_range) return NumberStatus::malformed;
  if (!is_tiny({begin, static_cast<std::size_t>(end - begin)})) return NumberStatus::too_large;
  value = *begin == '-' ? -0.0 : 0.0;
  return NumberStatus::ok;
}

}  // namespace lapidary::import::detail
