#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "base/log.h"
#include "description/object.h"
#include "import/find_file.h"
#include "import/image_file.h"
#include "import/obj.h"

namespace lapidary::import {

/// Which way is up in the coordinates of a file.
enum class UpAxis { y, z };

struct MeshOptions {
  ObjNormals normals = ObjNormals::automatic;
  std::optional<UpAxis> up;  ///< none: as files of its kind have it (OBJ: y)

  auto operator<=>(const MeshOptions&) const = default;
};

/// The placement that stands a mesh of that orientation upright, z up; null when it does already.
std::shared_ptr<const Transform> upright(UpAxis up);

/// Reads mesh files; a file that is asked for again is shared, and so becomes an instance.
class MeshFiles {
 public:
  /// `warnings` may be null. `allow` says which files a mesh file may refer to; empty: any.
  /// Pictures come through `images`, which must outlive this; null: materials have none. `files`
  /// notes what is read of meshes and materials, and may be null.
  explicit MeshFiles(WarningLog* warnings = nullptr, AllowFile allow = {},
                     ImageFiles* images = nullptr, InputFiles* files = nullptr)
      : warnings_(warnings), allow_(std::move(allow)), images_(images), files_(files) {}

  /// The file as an object with its materials, called like the file and standing upright. Throws
  /// Error when it cannot be read or has no triangles.
  description::ObjectPtr read(const std::filesystem::path& file, const MeshOptions& options);

 private:
  WarningLog* warnings_;
  AllowFile allow_;
  ImageFiles* images_;
  InputFiles* files_;
  std::map<std::pair<std::filesystem::path, MeshOptions>, description::ObjectPtr> read_;
};

/// Bytes that `mesh` holds, about.
std::size_t size_in_memory(const geometry::TriangleMesh& mesh);

}  // namespace lapidary::import
