#include "app/ray_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace lapidary::app {
namespace {

constexpr std::string_view white = " \t\r\n";

/// Takes a number and what separates it from the next off the front of `text`.
double take_number(std::string_view& text) {
  const auto wrong = [] {
    return std::invalid_argument("takes six numbers, origin x,y,z and direction x,y,z");
  };
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) throw wrong();
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  const std::size_t next = text.find_first_not_of(white);
  const bool has_white = next != 0;
  text.remove_prefix(std::min(next, text.size()));
  if (text.empty()) return value;
  if (text.front() == ',') {
    text.remove_prefix(1);
    text.remove_prefix(std::min(text.find_first_not_of(white), text.size()));
    if (text.empty()) throw wrong();
  } else if (!has_white) {
    throw wrong();
  }
  return value;
}

}  // namespace

ProbeCommand::Ray parse_ray(std::string_view text) {
  // What geometry::Line assumes of magnitudes: squares must not underflow.
  constexpr double least = 1e-60, most = 1e60;
  text.remove_prefix(std::min(text.find_first_not_of(white), text.size()));
  std::array<double, 6> n{};
  for (double& number : n) number = take_number(text);
  if (!text.empty()) {
    throw std::invalid_argument("takes six numbers and no more, origin and direction");
  }
  const ProbeCommand::Ray ray{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
  const double length = max_component(abs(ray.direction));
  if (length == 0.0) throw std::invalid_argument("takes a direction that is not zero");
  if (!(length >= least && length <= most && max_component(abs(ray.origin)) <= most)) {
    throw std::invalid_argument("takes coordinates up to 1e60 and a direction of 1e-60 to 1e60");
  }
  return ray;
}

}  // namespace lapidary::app
