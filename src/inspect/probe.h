#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "description/scene_description.h"
#include "geometry/bvh.h"
#include "geometry/own_space.h"
#include "geometry/sheet.h"
#include "geometry/solid_scene.h"
#include "geometry/sweep.h"
#include "inspect/mesh_crossings.h"
#include "scene/scene.h"

namespace lapidary::inspect {

/// A surface that a ray meets.
struct ProbeHit {
  double t = 0;        ///< in units of the ray's direction
  std::string object;  ///< its name, or what and where it is: "sphere (scene.lua:7)"
  /// Which part of the object: of a solid the number, from 0 in the order of writing, among all
  /// that it is combined of; of a mesh that nothing cuts the triangle; of a sheet 0.
  std::uint32_t leaf = 0;
  std::string kind;  ///< of that part: "cylinder", "triangle", "disk", ...
  Vec3d normal;      ///< unit length; out of the solid, or to the front
  /// `enter`: the ray comes from outside of the solid, or from the front.
  geometry::Crossing crossing = geometry::Crossing::enter;
  /// What fills the ray's way to and from here: the glass, if it has a name, or else the object;
  /// "outside" where there is nothing.
  std::string medium_before, medium_after;
};

/// All surfaces of a scene along any ray, as a renderer has them when the frame begins; needs no
/// camera and no lights.
///
/// Solids have a surface where the medium changes, as geometry::Sweep says. A sheet or triangle
/// that cannot be told from such a place comes before it and has its t. Triangles are met in
/// double, where a renderer finds them in float.
class Probe {
 public:
  /// Throws Error where the solids of the scene cannot be built.
  explicit Probe(const description::SceneDescription& scene);

  /// Those at t > 0, in ascending t. The origin is finite, the direction has any length but zero.
  std::vector<ProbeHit> along(Vec3d origin, Vec3d direction) const;

 private:
  /// A sheet or a mesh that nothing cuts, where it stands.
  struct PlacedSheet {
    geometry::PreparedSheet sheet;
    std::uint32_t object;
    std::string kind;
    Vec3d normal;  ///< of the front
  };
  struct PlacedMesh {
    std::shared_ptr<const MeshTriangles> triangles;  ///< shared by all places of the mesh
    geometry::OwnSpace space;
    std::uint32_t object;
    scene::Filling filling;  ///< its medium is 1 if it is filled with glass, else 0
    std::string medium;
  };
  /// A crossing with one of them.
  struct Flat {
    ProbeHit hit;
    double tau;
    std::uint32_t mesh;  ///< `no_mesh` of sheets
    std::uint32_t object;
  };
  class Media;
  static constexpr std::uint32_t no_mesh = ~0u;

  void add_solids(const description::SceneDescription& scene);
  using KnownMeshes = std::map<const geometry::TriangleMesh*, std::shared_ptr<const MeshTriangles>>;
  void add_mesh(const description::Leaf& leaf, const description::Mesh& mesh, std::uint32_t object,
                KnownMeshes& known);
  std::vector<Flat> flats_along(const geometry::Line& line, Media& media) const;
  void add_mesh_crossings(std::uint32_t mesh, const geometry::Line& line, Media& media,
                          std::vector<Flat>& flats) const;
  ProbeHit solid_hit(const geometry::Line& line, const geometry::Transition& found) const;

  std::vector<std::string> labels_;  ///< of objects
  geometry::SolidScene solids_;
  std::vector<scene::Filling> fillings_;     ///< of regions
  std::vector<std::string> region_media_;    ///< names
  std::vector<std::uint32_t> first_leaves_;  ///< of regions
  std::vector<PlacedSheet> sheets_;
  geometry::Bvh sheet_bvh_;
  std::vector<PlacedMesh> meshes_;
};

}  // namespace lapidary::inspect
