#include "inspect/probe.h"

#include <algorithm>

#include "description/leaves.h"
#include "geometry/affine_error.h"
#include "inspect/naming.h"
#include "inspect/solid_leaves.h"
#include "scene/assemble.h"

namespace lapidary::inspect {

using description::Leaf;
using description::MaterialPtr;
using geometry::Crossing;
using geometry::SolidScene;
using geometry::Transition;

namespace {

constexpr const char* outside = "outside";

/// What a body of `object` that is filled with `material` is named by.
std::string medium_name(const MaterialPtr& material, const std::string& object) {
  std::string glass = material ? glass_name(*material) : "";
  return glass.empty() ? object : glass;
}

/// Negative zeros are nobody's concern.
Vec3d without_signed_zeros(Vec3d v) {
  return {v.x + 0.0, v.y + 0.0, v.z + 0.0};
}

}  // namespace

/// What a ray is inside of, on its way: a region of the solids, and any number of glass meshes, of
/// which the one fills the place that `scene::Filling` says.
class Probe::Media {
 public:
  explicit Media(const Probe& probe) : probe_(probe), depths_(probe.meshes_.size(), 0) {}

  void set_region(std::uint32_t region) { region_ = region; }
  void cross(std::uint32_t mesh, Crossing crossing) {
    depths_[mesh] += crossing == Crossing::enter ? 1 : -1;
  }
  /// What the medium here is called.
  const std::string& name() const {
    scene::Filling filling;
    const std::string* name = &outside_;
    if (region_ != SolidScene::no_region) {
      filling = probe_.fillings_[region_];
      name = &probe_.region_media_[region_];
    }
    for (std::size_t i = 0; i < depths_.size(); ++i) {
      const PlacedMesh& mesh = probe_.meshes_[i];
      if (depths_[i] <= 0 || mesh.filling.medium == 0 || !mesh.filling.beats(filling)) continue;
      filling = mesh.filling;
      name = &mesh.medium;
    }
    return *name;
  }

 private:
  const Probe& probe_;
  std::vector<int> depths_;  ///< of meshes
  std::uint32_t region_ = SolidScene::no_region;
  std::string outside_ = outside;
};

Probe::Probe(const description::SceneDescription& scene) {
  add_solids(scene);
  std::vector<bool> is_body(labels_.size());
  for (const scene::Filling& filling : fillings_) is_body[filling.object] = true;
  std::vector<Box3d> boxes;
  KnownMeshes known;
  std::uint32_t object = 0;
  description::for_each_leaf(scene.objects, [&](const Leaf& leaf) {
    const std::uint32_t index = object++;
    if (const auto* sheet = std::get_if<geometry::Sheet>(&leaf.object.content)) {
      const geometry::Sheet placed = geometry::transformed(*sheet, leaf.world_from_object);
      sheets_.push_back({geometry::prepared(placed), index, kind_of(placed), front_normal(placed)});
      boxes.push_back(geometry::bounds(placed));
    } else if (const auto* mesh = std::get_if<description::Mesh>(&leaf.object.content)) {
      if (!is_body[index]) add_mesh(leaf, *mesh, index, known);
    }
  });
  sheet_bvh_ = geometry::Bvh(boxes);
}

void Probe::add_solids(const description::SceneDescription& scene) {
  description::for_each_leaf(scene.objects,
                             [&](const Leaf& leaf) { labels_.push_back(label_of(leaf)); });
  scene::Solids solids = scene::assemble(scene);
  for (const scene::SolidRegion& region : solids.regions) {
    fillings_.push_back({region.region.medium, region.region.priority, region.object});
    region_media_.push_back(
        medium_name(solids.media[region.region.medium], labels_[region.object]));
  }
  solids_ = SolidScene(scene::geometry_parts(std::move(solids)));
  first_leaves_ = first_leaves(solids_);
}

void Probe::add_mesh(const Leaf& leaf, const description::Mesh& mesh, std::uint32_t object,
                     KnownMeshes& known) {
  std::shared_ptr<const MeshTriangles>& triangles = known[mesh.triangles.get()];
  if (!triangles) triangles = std::make_shared<const MeshTriangles>(mesh.triangles);
  const MaterialPtr& inside = leaf.interior ? leaf.interior : leaf.material;
  const bool is_glass = description::as_glass(*inside) && !description::is_thin(*inside);
  meshes_.push_back({triangles,
                     geometry::OwnSpace(leaf.world_from_object),
                     object,
                     {is_glass ? 1u : 0u, leaf.priority, object},
                     medium_name(inside, labels_[object])});
}

void Probe::add_mesh_crossings(std::uint32_t mesh, const geometry::Line& line, Media& media,
                               std::vector<Flat>& flats) const {
  const PlacedMesh& placed = meshes_[mesh];
  for (const MeshCrossing& c : placed.triangles->crossings(placed.space.line(line))) {
    if (!(c.t > 0.0)) {
      media.cross(mesh, c.crossing);
      continue;
    }
    Flat flat{{}, 0, mesh, placed.object};
    flat.hit.t = c.t;
    flat.hit.object = labels_[placed.object];
    flat.hit.leaf = c.triangle;
    flat.hit.kind = "triangle";
    flat.hit.normal = normalize(placed.space.world_normal(placed.triangles->normal(c.triangle)));
    flat.hit.crossing = c.crossing;
    // Roundings of coordinates, as a step along the line.
    const double reach = geometry::one_norm(line.origin) + c.t * geometry::one_norm(line.direction);
    flat.tau = 16 * geometry::rounding_unit * reach / length(line.direction);
    flats.push_back(std::move(flat));
  }
}

/// What `media` has to cross before the ray starts it crosses.
std::vector<Probe::Flat> Probe::flats_along(const geometry::Line& line, Media& media) const {
  std::vector<Flat> flats;
  sheet_bvh_.walk_line(line, [&](std::uint32_t index) {
    const PlacedSheet& sheet = sheets_[index];
    const auto event = intersect(sheet.sheet, line);
    if (!event || !(event->t > 0.0)) return;
    Flat flat{{}, event->tau, no_mesh, sheet.object};
    flat.hit.t = event->t;
    flat.hit.object = labels_[sheet.object];
    flat.hit.kind = sheet.kind;
    flat.hit.normal = sheet.normal;
    flat.hit.crossing = event->crossing;
    flats.push_back(std::move(flat));
  });
  // The hierarchy has an order of its own.
  std::ranges::sort(flats, {}, &Flat::object);
  for (std::uint32_t i = 0; i < meshes_.size(); ++i) add_mesh_crossings(i, line, media, flats);
  // Those of one mesh keep their order.
  std::ranges::stable_sort(flats, {}, [](const Flat& f) { return f.hit.t; });
  return flats;
}

ProbeHit Probe::solid_hit(const geometry::Line& line, const Transition& found) const {
  const std::uint32_t region = found.surface_of;
  const Vec3d normal =
      solids_.outward_normal(found.place, found.leaf, found.patch, line.at(found.t));
  ProbeHit hit;
  hit.t = found.t;
  hit.object = labels_[fillings_[region].object];
  const geometry::Compound& compound = solids_.compound(found.place);
  const std::uint32_t leaf = compound.stated_leaf(found.leaf, found.patch);
  hit.leaf = found.place == 0 ? leaf - first_leaves_[region] : leaf;
  hit.kind = kind_of(compound.leaf(leaf).solid.solid());
  hit.normal = found.is_complement ? -normal : normal;
  hit.crossing = region == found.after ? Crossing::enter : Crossing::leave;
  return hit;
}

std::vector<ProbeHit> Probe::along(Vec3d origin, Vec3d direction) const {
  const geometry::Ray ray{origin, direction};
  const geometry::Line line = ray.line();
  Media media(*this);
  std::vector<Flat> flats = flats_along(line, media);
  auto flat = flats.begin();
  std::vector<ProbeHit> hits;
  const auto add = [&](ProbeHit hit, auto change_media) {
    hit.normal = without_signed_zeros(hit.normal);
    hit.medium_before = media.name();
    change_media();
    hit.medium_after = media.name();
    hits.push_back(std::move(hit));
  };
  const auto add_flats_up_to = [&](double last_t, double tau) {
    for (; flat != flats.end() && flat->hit.t - flat->tau <= last_t + tau; ++flat) {
      flat->hit.t = std::min(flat->hit.t, last_t);
      add(std::move(flat->hit), [&] {
        if (flat->mesh != no_mesh) media.cross(flat->mesh, flat->hit.crossing);
      });
    }
  };
  geometry::Sweep sweep(solids_, ray);
  Transition found;
  while (sweep.next(found)) {
    media.set_region(found.before);
    add_flats_up_to(found.t, found.tau);
    add(solid_hit(line, found), [&] { media.set_region(found.after); });
  }
  media.set_region(sweep.region());
  add_flats_up_to(infinity, 0);
  return hits;
}

}  // namespace lapidary::inspect
