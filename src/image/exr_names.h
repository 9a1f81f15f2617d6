#pragma once

// Inside image/ only.

#include <algorithm>
#include <array>
#include <string_view>

namespace lapidary::image {

/// Attributes that OpenEXR gives a meaning and a type: "Reading and Writing OpenEXR Image Files",
/// predefined attributes, those a program must not use for anything else.
inline constexpr std::array<std::string_view, 16> reserved_exr_names = {"channels",
                                                                        "chromaticities",
                                                                        "chunkCount",
                                                                        "compression",
                                                                        "dataWindow",
                                                                        "displayWindow",
                                                                        "envmap",
                                                                        "lineOrder",
                                                                        "maxSamplesPerPixel",
                                                                        "name",
                                                                        "pixelAspectRatio",
                                                                        "screenWindowCenter",
                                                                        "screenWindowWidth",
                                                                        "tiles",
                                                                        "type",
                                                                        "version"};

inline bool is_reserved_exr_name(std::string_view name) {
  return std::find(reserved_exr_names.begin(), reserved_exr_names.end(), name) !=
         reserved_exr_names.end();
}

}  // namespace lapidary::image
