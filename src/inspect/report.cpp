#include "inspect/report.h"

#include <algorithm>
#include <map>
#include <variant>

#include "description/leaves.h"

namespace lapidary::inspect {
namespace {

struct KindOf {
  std::string operator()(const geometry::Solid& solid) const { return std::visit(*this, solid); }
  std::string operator()(const geometry::Sheet& sheet) const { return std::visit(*this, sheet); }
  std::string operator()(const description::Mesh&) const { return "mesh"; }
  std::string operator()(const std::shared_ptr<const description::Group>&) const { return "group"; }
  std::string operator()(const geometry::Sphere&) const { return "sphere"; }
  std::string operator()(const geometry::Box&) const { return "box"; }
  std::string operator()(const geometry::Cylinder&) const { return "cylinder"; }
  std::string operator()(const geometry::Cone&) const { return "cone"; }
  std::string operator()(const geometry::Torus&) const { return "torus"; }
  std::string operator()(const geometry::Quadric&) const { return "quadric"; }
  std::string operator()(const geometry::HalfSpace&) const { return "half-space"; }
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

bool shines(const description::Leaf& leaf) {
  const auto is_emissive = [](const description::MaterialPtr& material) {
    return material && std::holds_alternative<description::Emissive>(material->model);
  };
  if (is_emissive(leaf.material)) return true;
  const auto* mesh = std::get_if<description::Mesh>(&leaf.object.content);
  return mesh != nullptr && std::ranges::any_of(mesh->materials, is_emissive);
}

ObjectReport report_on(const description::Leaf& leaf, Closures& closures) {
  ObjectReport report;
  report.name = leaf.name;
  report.kind = std::visit(KindOf{}, leaf.object.content);
  report.where = leaf.object.where.location();
  report.measure = measure(leaf);
  report.closed = std::holds_alternative<geometry::Solid>(leaf.object.content);
  if (const auto* mesh = std::get_if<description::Mesh>(&leaf.object.content)) {
    report.triangles = mesh->triangles->triangles.size();
    report.closure = closures.of(*mesh->triangles);
    report.closed = report.closure->closed();
    if (!report.closed) report.measure.volume.reset();
  }
  return report;
}

}  // namespace

SceneReport inspect(const description::SceneDescription& scene) {
  SceneReport report;
  Closures closures;
  std::vector<Body> bodies;
  description::for_each_leaf(scene.objects, [&](const description::Leaf& leaf) {
    const ObjectReport& object = report.objects.emplace_back(report_on(leaf, closures));
    if (object.closed) {
      bodies.push_back(
          {&leaf.object, leaf.world_from_object, object.measure.bounds, report.objects.size() - 1});
    }
    report.operands += std::holds_alternative<geometry::Solid>(leaf.object.content) ? 1 : 0;
    report.triangles += object.triangles;
    report.lights += shines(leaf) ? 1 : 0;
  });
  report.lights += scene.lights.size();
  report.overlaps = find_overlaps(std::move(bodies));
  return report;
}

}  // namespace lapidary::inspect
