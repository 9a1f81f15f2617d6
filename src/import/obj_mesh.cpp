#include "import/obj_mesh.h"

#include <algorithm>
#include <utility>

#include "geometry/vertex_normals.h"
#include "import/vertex_table.h"

namespace lapidary::import {
namespace {

constexpr std::uint32_t none = ObjStatements::none;
using Triangle = ObjStatements::Triangle;

std::vector<std::uint8_t> used_vertices(const std::vector<Triangle>& triangles,
                                        std::size_t vertices) {
  std::vector<std::uint8_t> used(vertices);
  for (const Triangle& t : triangles) {
    for (const std::uint32_t v : t) used[v] = 1;
  }
  return used;
}

// Floats about 0 keep all that matters of coordinates up to this many times the object's size;
// beyond that they are stored relative to its centre.
constexpr double far_away = 64;

Vec3d choose_origin(const Box3d& box) {
  const double farthest = max_component(max(abs(box.min), abs(box.max)));
  return farthest <= far_away * max_component(box.extent()) ? Vec3d() : box.center();
}

void place_positions(const std::vector<Vec3d>& positions, const std::vector<std::uint8_t>& used,
                     geometry::TriangleMesh& mesh) {
  Box3d box;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (used[v]) box.extend(positions[v]);
  }
  mesh.origin = choose_origin(box);
  mesh.positions.reserve(positions.size());
  for (const Vec3d& p : positions) mesh.positions.emplace_back(p - mesh.origin);
}

bool has_area(const std::vector<Vec3f>& positions, const Triangle& t) {
  const Vec3d a(positions[t[0]]), b(positions[t[1]]), c(positions[t[2]]);
  return cross(b - a, c - a) != Vec3d();
}

template <typename T>
void erase_at(std::vector<T>& items, const std::vector<std::uint32_t>& sorted_places) {
  if (items.empty() || sorted_places.empty()) return;
  std::size_t kept = sorted_places.front(), next = 0;
  for (std::size_t i = kept; i < items.size(); ++i) {
    if (next < sorted_places.size() && sorted_places[next] == i) {
      ++next;
    } else {
      items[kept++] = items[i];
    }
  }
  items.resize(kept);
}

void shift(std::vector<ObjChange>& changes, const std::vector<std::uint32_t>& dropped) {
  for (ObjChange& c : changes) {
    const auto behind = std::ranges::lower_bound(dropped, c.first_triangle);
    c.first_triangle -= static_cast<std::uint32_t>(behind - dropped.begin());
  }
}

std::uint32_t drop_flat_triangles(const std::vector<Vec3f>& positions, ObjStatements& statements) {
  std::vector<std::uint32_t> dropped;
  for (std::uint32_t i = 0; i < statements.triangles.size(); ++i) {
    if (!has_area(positions, statements.triangles[i])) dropped.push_back(i);
  }
  if (dropped.empty()) return 0;
  erase_at(statements.triangles, dropped);
  erase_at(statements.uv_triangles, dropped);
  erase_at(statements.normal_triangles, dropped);
  shift(statements.material_changes, dropped);
  shift(statements.group_changes, dropped);
  shift(statements.smoothing_changes, dropped);
  return static_cast<std::uint32_t>(dropped.size());
}

// Leaves out positions that no triangle uses.
void drop_unused_positions(std::vector<Vec3f>& positions, std::vector<Triangle>& triangles,
                           const std::vector<std::uint8_t>& used) {
  if (std::ranges::find(used, 0) == used.end()) return;
  std::vector<std::uint32_t> new_index(positions.size(), none);
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (!used[v]) continue;
    positions[count] = positions[v];
    new_index[v] = count++;
  }
  positions.resize(count);
  positions.shrink_to_fit();
  for (Triangle& t : triangles) t = {new_index[t[0]], new_index[t[1]], new_index[t[2]]};
}

// One smoothing group per triangle.
std::vector<std::uint32_t> smoothing_groups(const ObjStatements& statements) {
  std::vector<std::uint32_t> groups(statements.triangles.size());
  const std::vector<ObjChange>& changes = statements.smoothing_changes;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const std::size_t end = i + 1 < changes.size() ? changes[i + 1].first_triangle : groups.size();
    std::fill(groups.begin() + changes[i].first_triangle,
              groups.begin() + static_cast<std::ptrdiff_t>(end), changes[i].value);
  }
  return groups;
}

geometry::SplitNormals make_normals(const std::vector<Vec3f>& positions,
                                    const ObjStatements& statements, ObjNormals source,
                                    double crease) {
  if (source == ObjNormals::smooth) {
    return {.normals = geometry::smooth_normals(positions, statements.triangles)};
  }
  if (statements.states_smoothing) {
    return geometry::normals_by_group(positions, statements.triangles,
                                      smoothing_groups(statements));
  }
  return geometry::normals_by_crease(positions, statements.triangles, crease);
}

// Whether the file leaves some corner without a normal.
bool lacks_normals(const ObjStatements& statements) {
  if (statements.normal_triangles.empty()) return true;
  return std::ranges::any_of(statements.normal_triangles, [](const Triangle& t) {
    return t[0] == none || t[1] == none || t[2] == none;
  });
}

// Gives corners without a normal one of `made`, which is appended to the file's normals.
void fill_normals(ObjStatements& statements, geometry::SplitNormals made) {
  std::vector<Triangle> all = statements.triangles;
  for (const auto& use : made.uses) all[use.triangle][use.corner] = use.normal;
  if (statements.normal_triangles.empty()) {
    statements.normals = std::move(made.normals);
    statements.normal_triangles = std::move(all);
    return;
  }
  const auto offset = static_cast<std::uint32_t>(statements.normals.size());
  statements.normals.insert(statements.normals.end(), made.normals.begin(), made.normals.end());
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& normal = statements.normal_triangles[i][k];
      if (normal == none) normal = offset + all[i][k];
    }
  }
}

// Vertices split at creases when the file shares positions and states nothing else.
void adopt(geometry::SplitNormals made, geometry::TriangleMesh& mesh) {
  mesh.normals = std::move(made.normals);
  for (const std::uint32_t v : made.added) mesh.positions.push_back(mesh.positions[v]);
  for (const auto& use : made.uses) mesh.triangles[use.triangle][use.corner] = use.normal;
}

template <typename T>
std::vector<T> gather(const std::vector<T>& values, const std::vector<VertexTable::Key>& keys,
                      std::size_t which) {
  std::vector<T> result;
  result.reserve(keys.size());
  for (const VertexTable::Key& key : keys) {
    result.push_back(key[which] == none ? T{} : values[key[which]]);
  }
  return result;
}

// One vertex for each kind of corner.
void weld(ObjStatements& statements, geometry::TriangleMesh& mesh) {
  VertexTable table(mesh.positions.size());
  const bool has_uvs = !statements.uv_triangles.empty();
  const bool has_normals = !statements.normal_triangles.empty();
  for (std::size_t i = 0; i < statements.triangles.size(); ++i) {
    Triangle& t = statements.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      t[k] = table.number_of({t[k], has_uvs ? statements.uv_triangles[i][k] : none,
                              has_normals ? statements.normal_triangles[i][k] : none});
    }
  }
  mesh.positions = gather(mesh.positions, table.keys(), 0);
  if (has_uvs) mesh.uvs = gather(statements.uvs, table.keys(), 1);
  if (has_normals) mesh.normals = gather(statements.normals, table.keys(), 2);
  mesh.triangles = std::move(statements.triangles);
}

}  // namespace

ObjMesh build_obj_mesh(ObjStatements& statements, ObjNormals normals, double crease) {
  ObjMesh result;
  geometry::TriangleMesh& mesh = result.mesh;
  std::vector<std::uint8_t> used = used_vertices(statements.triangles, statements.positions.size());
  place_positions(statements.positions, used, mesh);
  statements.positions = {};
  result.dropped_triangles = drop_flat_triangles(mesh.positions, statements);

  if (normals == ObjNormals::flat || normals == ObjNormals::smooth)
    statements.normal_triangles = {};
  const bool must_make = normals == ObjNormals::smooth ||
                         (normals == ObjNormals::automatic && lacks_normals(statements));
  if (statements.uv_triangles.empty() && statements.normal_triangles.empty()) {
    if (result.dropped_triangles > 0) used = used_vertices(statements.triangles, used.size());
    drop_unused_positions(mesh.positions, statements.triangles, used);
    mesh.triangles = statements.triangles;
    if (must_make) adopt(make_normals(mesh.positions, statements, normals, crease), mesh);
    return result;
  }
  if (must_make)
    fill_normals(statements, make_normals(mesh.positions, statements, normals, crease));
  weld(statements, mesh);
  return result;
}

}  // namespace lapidary::import
