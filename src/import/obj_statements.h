#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/log.h"
#include "import/text_blocks.h"
#include "math/vec.h"

namespace lapidary::import {

/// From `first_triangle` on, until the next change, `value` holds.
struct ObjChange {
  std::uint32_t first_triangle = 0;
  std::uint32_t value = 0;
};

/// A name or a text with the place where it stands first.
struct ObjName {
  std::string text;
  Location where;
};

/// What an OBJ file says, with polygons cut into triangles and indices resolved, but nothing
/// joined, dropped or made up yet.
struct ObjStatements {
  static constexpr std::uint32_t none = 0xffffffff;
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<Vec3d> positions;
  std::vector<Vec2f> uvs;
  std::vector<Vec3f> normals;              ///< unit length or zero
  std::vector<Triangle> triangles;         ///< into `positions`
  std::vector<Triangle> uv_triangles;      ///< into `uvs` or `none`; empty if no corner has one
  std::vector<Triangle> normal_triangles;  ///< into `normals` or `none`; likewise

  std::vector<ObjName> material_names;       ///< of usemtl, each once
  std::vector<ObjChange> material_changes;   ///< into `material_names`, or `none`
  std::vector<std::string> group_names;      ///< of g and o, each statement one
  std::vector<ObjChange> group_changes;      ///< into `group_names`
  std::vector<ObjChange> smoothing_changes;  ///< group number, 0 is off
  bool states_smoothing = false;
  std::vector<ObjName> libraries;  ///< of mtllib: the rest of the line
};

/// Reads all statements. What is skipped is summed up in `warnings`, if not null: one warning a
/// kind. Throws Error for a number or index that is missing, malformed, not finite or out of range,
/// a face of fewer than 3 corners, and a file without faces.
ObjStatements parse_obj_statements(TextBlocks blocks, const std::string& file,
                                   WarningLog* warnings);

}  // namespace lapidary::import
