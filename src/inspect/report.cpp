#include "inspect/report.h"

#include <map>
#include <variant>

#include "description/leaves.h"
#include "description/solids.h"

namespace lapidary::inspect {
namespace {

struct KindOf {
  std::string operator()(const geometry::Solid& solid) const { return std::visit(*this, solid); }
  std::string operator()(const geometry::Sheet& sheet) const { return std::visit(*this, sheet); }
  std::string operator()(const description::Mesh&) const { return "mesh"; }
  std::string operator()(const std::shared_ptr<const description::Group>&) const { return "group"; }
  std::string operator()(const description::Combination& combination) const {
    switch (combination.operation()) {
      case description::SetOperation::unite:
        return "union";
      case description::SetOperation::intersect:
        return "intersection";
      case description::SetOperation::complement:
        return "complement";
      case description::SetOperation::subtract:
      case description::SetOperation::section:
        break;
    }
    return "difference";
  }
  std::string operator()(const geometry::Sphere&) const { return "sphere"; }
  std::string operator()(const geometry::Box&) const { return "box"; }
  std::string operator()(const geometry::Cylinder&) const { return "cylinder"; }
  std::string operator()(const geometry::Cone&) const { return "cone"; }
  std::string operator()(const geometry::Torus&) const { return "torus"; }
  std::string operator()(const geometry::Quadric&) const { return "quadric"; }
  std::string operator()(const geometry::HalfSpace&) const { return "half-space"; }
  std::string operator()(const geometry::MeshBody&) const { return "mesh"; }
  std::string operator()(const geometry::Polyhedron&) const { return "polyhedron"; }
  std::string operator()(const geometry::Prism&) const { return "prism"; }
  std::string operator()(const geometry::Rectangle&) const { return "rectangle"; }
  std::string operator()(const geometry::Disk&) const { return "disk"; }
};

/// Looks at every mesh once, however often it is used.
class Closures {
 public:
  const geometry::MeshClosure& of(const geometry::TriangleMesh& mesh) {
    const auto found = known_.find(&mesh);
    if (found != known_.end()) return found->second;
    return known_.emplace(&mesh, geometry::examine_closure(mesh)).first->second;
  }

 private:
  std::map<const geometry::TriangleMesh*, geometry::MeshClosure> known_;
};

/// As scenes call them.
struct KindOfLight {
  std::string operator()(const description::PointLight&) const { return "point_light"; }
  std::string operator()(const description::SpotLight&) const { return "spot_light"; }
  std::string operator()(const description::DistantLight&) const { return "distant_light"; }
  std::string operator()(const description::ConstantEnvironment&) const { return "environment"; }
  std::string operator()(const description::ImageEnvironment&) const { return "environment"; }
};

ObjectReport report_on(const description::Leaf& leaf, Closures& closures) {
  ObjectReport report;
  report.name = leaf.name;
  report.kind = std::visit(KindOf{}, leaf.object.content);
  report.where = leaf.object.where.location();
  report.measure = measure(leaf);
  report.worn = worn_by(leaf);
  report.closed = std::holds_alternative<geometry::Solid>(leaf.object.content) ||
                  leaf.object.combination() != nullptr;
  if (const auto* mesh = std::get_if<description::Mesh>(&leaf.object.content)) {
    report.triangles = mesh->triangles->triangles.size();
    report.closure = closures.of(*mesh->triangles);
    report.closed = report.closure->closed();
    if (!report.closed) report.measure.volume.reset();
  }
  if (!leaf.removed.empty()) report.measure.area = report.measure.volume = std::nullopt;
  return report;
}

}  // namespace

SceneReport inspect(const description::SceneDescription& scene) {
  SceneReport report;
  Closures closures;
  std::vector<Body> bodies;
  description::for_each_leaf(scene.objects, [&](const description::Leaf& leaf) {
    const ObjectReport& surface = report.surfaces.emplace_back(report_on(leaf, closures));
    // Whether combinations overlap others takes more than is known here.
    if (surface.closed && !leaf.object.combination() && leaf.removed.empty()) {
      bodies.push_back({&leaf.object, leaf.world_from_object, surface.measure.bounds,
                        report.surfaces.size() - 1});
    }
    report.lights += surface.worn.glow == Glow::none ? 0 : 1;
    if (surface.worn.glow == Glow::whole) return;
    ++report.objects;
    report.operands += description::operand_count(leaf.object);
    report.triangles += surface.triangles;
  });
  for (const description::Light& light : scene.lights) {
    report.lights_without_surface.push_back(
        {std::visit(KindOfLight{}, light.model), light.where.location()});
  }
  report.lights += scene.lights.size();
  report.overlaps = find_overlaps(std::move(bodies));
  return report;
}

}  // namespace lapidary::inspect
