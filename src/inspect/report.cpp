#include "inspect/report.h"

#include <algorithm>
#include <map>
#include <memory>
#include <variant>

#include "description/leaves.h"
#include "description/solids.h"
#include "inspect/lone_body.h"
#include "inspect/naming.h"
#include "scene/assemble.h"

namespace lapidary::inspect {
namespace {

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
  std::string operator()(const description::ProfileLight&) const { return "point_light"; }
  std::string operator()(const description::SpotLight&) const { return "spot_light"; }
  std::string operator()(const description::DistantLight&) const { return "distant_light"; }
  std::string operator()(const description::ConstantEnvironment&) const { return "environment"; }
  std::string operator()(const description::ImageEnvironment&) const { return "environment"; }
  std::string operator()(const description::Sky&) const { return "sky"; }
};

ObjectReport report_on(const description::Leaf& leaf, Closures& closures) {
  ObjectReport report;
  report.name = leaf.name;
  report.kind = kind_of(leaf.object);
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
  report.combined = is_combined(leaf);
  if (report.combined) report.measure.area = report.measure.volume = std::nullopt;
  return report;
}

/// Looks at combinations as far as there are not too many.
class Combinations {
 public:
  Combinations(const description::SceneDescription& scene, ThreadPool& pool) : pool_(pool) {
    std::size_t count = 0;
    description::for_each_leaf(scene,
                               [&](const description::Leaf& leaf) { count += is_combined(leaf); });
    budget_.crossings = total_crossings / std::clamp<std::size_t>(count, 1, most_bodies);
  }

  /// Null if there are too many.
  const geometry::SolidScene* look_at(const description::Leaf& leaf, ObjectReport& report) {
    const std::size_t operands = description::operand_count(leaf.object);
    if (bodies_.size() == most_bodies || operands > most_operands - operands_) return nullptr;
    operands_ += operands;
    bodies_.push_back(std::make_unique<const geometry::SolidScene>(lone_body(leaf)));
    const geometry::SolidScene& body = *bodies_.back();
    CombinationReport& combination = report.combination.emplace();
    combination.bounds = body.bounds(0);
    combination.operands = examine_operands(body);
    const bool unbounded = !combination.bounds.empty() && !combination.bounds.bounded();
    if (!unbounded) combination.size = measure_by_lines(body, budget_, pool_);
    return &body;
  }

 private:
  // Some seconds, and a few hundred megabytes.
  static constexpr std::size_t total_crossings = std::size_t{1} << 23;
  static constexpr std::size_t most_bodies = 1000;
  static constexpr std::size_t most_operands = std::size_t{1} << 21;

  ThreadPool& pool_;
  LineBudget budget_;
  std::size_t operands_ = 0;
  std::vector<std::unique_ptr<const geometry::SolidScene>> bodies_;
};

/// Bodies whose overlaps nobody means: opaque ones, those of one priority together.
class OpaqueBodies {
 public:
  void add(const description::Leaf& leaf, const Body& body) {
    if (description::as_glass(*scene::filling_of(leaf)) != nullptr) return;
    by_priority_[leaf.priority].push_back(body);
  }

  OverlapSearch find_overlaps() {
    OverlapSearch all;
    for (auto& [priority, bodies] : by_priority_) {
      const OverlapSearch search = inspect::find_overlaps(std::move(bodies));
      all.overlaps.insert(all.overlaps.end(), search.overlaps.begin(), search.overlaps.end());
      all.complete = all.complete && search.complete;
    }
    std::ranges::sort(all.overlaps, {},
                      [](const Overlap& o) { return std::pair(o.first, o.second); });
    return all;
  }

 private:
  std::map<std::int32_t, std::vector<Body>> by_priority_;
};

}  // namespace

SceneReport inspect(const description::SceneDescription& scene, ThreadPool& pool) {
  SceneReport report;
  Closures closures;
  Combinations combinations(scene, pool);
  OpaqueBodies bodies;
  description::for_each_leaf(scene, [&](const description::Leaf& leaf) {
    ObjectReport& surface = report.surfaces.emplace_back(report_on(leaf, closures));
    Body body{&leaf.object, leaf.world_from_object, surface.measure.bounds,
              report.surfaces.size() - 1};
    if (surface.combined) {
      body.combined = combinations.look_at(leaf, surface);
      if (body.combined) body.bounds = surface.combination->bounds;
      if (!body.combined) ++report.unmeasured;
    }
    if (surface.closed && (body.combined || !surface.combined)) bodies.add(leaf, body);
    report.lights += surface.worn.glow == Glow::none ? 0 : 1;
    if (surface.worn.glow == Glow::whole) return;
    ++report.objects;
    report.operands += description::operand_count(leaf.object);
    for (const auto& removed : leaf.removed) {
      report.operands += description::operand_count(*removed.solid);
    }
    report.triangles += surface.triangles;
  });
  for (const description::Light& light : scene.lights) {
    report.lights_without_surface.push_back(
        {std::visit(KindOfLight{}, light.model), light.where.location()});
  }
  report.lights += scene.lights.size();
  report.overlaps = bodies.find_overlaps();
  return report;
}

}  // namespace lapidary::inspect
