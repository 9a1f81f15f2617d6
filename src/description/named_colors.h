#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace lapidary::description {

struct NamedColor {
  std::string_view name;
  std::uint32_t srgb;  ///< 0xRRGGBB
};

/// In ascending order of names.
std::span<const NamedColor> named_colors();

/// By its CSS name, in lower case.
std::optional<std::uint32_t> find_named_color(std::string_view name);

}  // namespace lapidary::description
