#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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

/// What is told while a mesh is read, and what it may read in turn.
struct MeshReading {
  WarningLog* warnings = nullptr;  ///< null: nobody wants to know
  AllowFile allow = {};            ///< which files a mesh file may refer to; empty: any
  InputFiles* files = nullptr;     ///< notes what is read; null: nobody wants to know
};

/// Reads mesh files; a file that is asked for again is shared, and so becomes an instance. It is
/// then noted again, but does not warn again.
class MeshFiles {
 public:
  /// Pictures come through `images`, which must outlive this; null: materials have none.
  explicit MeshFiles(ImageFiles* images = nullptr) : images_(images) {}

  /// The file as an object with its materials, called like the file and standing upright. Throws
  /// Error when it cannot be read or has no triangles.
  description::ObjectPtr read(const std::filesystem::path& file, const MeshOptions& options,
                              const MeshReading& reading);

  /// Another scene follows: drops what the present one has not asked for.
  void begin_scene();

 private:
  struct Entry {
    description::ObjectPtr object;
    std::vector<InputFiles::Note> notes;
    bool is_used = false;  ///< by the present scene
  };
  description::ObjectPtr read_object(const std::filesystem::path& file, const MeshOptions& options,
                                     const MeshReading& reading) const;

  ImageFiles* images_;
  std::map<std::pair<std::filesystem::path, MeshOptions>, Entry> read_;
};

/// Bytes that `mesh` holds, about.
std::size_t size_in_memory(const geometry::TriangleMesh& mesh);

}  // namespace lapidary::import
