#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/input_files.h"
#include "base/log.h"
#include "geometry/triangle_mesh.h"
#include "import/find_file.h"
#include "import/mtl.h"

namespace lapidary::import {

/// Where the shading normals of an OBJ file come from.
enum class ObjNormals : std::uint8_t {
  /// The file's normals. Corners without: by smoothing groups if the file has any statement of them
  /// (s off: flat), otherwise smooth except across edges sharper than ObjOptions::crease.
  automatic,
  as_file,  ///< the file's normals, flat where it has none
  smooth,   ///< smooth over all faces that share a vertex, whatever the file says
  flat      ///< none
};

struct ObjOptions {
  WarningLog* warnings = nullptr;  ///< null: nobody wants to know
  AllowFile allow;                 ///< which material files (mtllib) may be read
  InputFiles* files = nullptr;     ///< notes what is read; null: nobody wants to know
  ObjNormals normals = ObjNormals::automatic;
  /// Degrees between the normals of two faces, beyond which their edge is sharp. At 55 the corners
  /// of boxes and of six-sided prisms are sharp, eight-sided ones are round.
  double crease = 55;
};

/// Triangles in a row that stand under one `g` or `o` statement. A name may come again.
struct ObjGroup {
  std::string name;  ///< the rest of the statement; empty before the first
  std::uint32_t first_triangle = 0;
  std::uint32_t triangle_count = 0;  ///< at least 1
};

struct ObjScene {
  geometry::TriangleMesh mesh;
  /// What mesh.materials refers to: those in use, in the order of their first use. A default called
  /// "default" comes first if some face has no material.
  std::vector<MtlMaterial> materials;
  std::vector<ObjGroup> groups;
};

/// Reads a Wavefront OBJ file with its material libraries.
///
/// Faces keep their orientation and may be polygons of any shape; negative indices count backwards;
/// corners may lack uvs or normals. Equal corners (position, uv, normal) become one vertex,
/// vertices no face uses are left out, triangles of zero area as floats are dropped. Positions are
/// floats relative to `mesh.origin`, which is 0 unless the object is far away from it for its size.
///
/// Tells `warnings` once about each kind of thing it skips (lines, points, free forms, unknown
/// statements, zero-area triangles), about polygons that cross themselves, and about material files
/// or materials that are missing: such a material has its name and default values. Throws Error for
/// anything else that is wrong, and for a file without triangles.
ObjScene read_obj(const std::filesystem::path& file, const ObjOptions& options = {});

/// The same for a text; `file` names it in messages and is where material files are relative to.
ObjScene parse_obj(std::string_view text, const std::filesystem::path& file,
                   const ObjOptions& options = {});

}  // namespace lapidary::import
