#include "inspect/operands.h"

#include <algorithm>
#include <cmath>

#include "geometry/sweep.h"
#include "inspect/naming.h"
#include "inspect/solid_leaves.h"
#include "sampling/sobol.h"
#include "sampling/warp.h"

namespace lapidary::inspect {
namespace {

using geometry::SolidScene;

constexpr std::uint64_t seed = 1991;
constexpr std::size_t lines_each = 256;
constexpr std::size_t most_examined = 4096;

/// The part of an unbounded box near which people build: about the origin, as far out again as what
/// bounds it has.
Box3d finite_part(Box3d box) {
  double reach = 1;
  for (const Vec3d& corner : {box.min, box.max}) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (std::isfinite(corner[i])) reach = std::max(reach, 2 * std::abs(corner[i]));
    }
  }
  const Vec3d far{reach, reach, reach};
  return {max(box.min, -far), min(box.max, far)};
}

/// Lines through random points of a box.
class AimedLines {
 public:
  AimedLines(const Box3d& box, std::uint32_t stream)
      : box_(finite_part(box)), stream_(stream), whole_line_(!box.bounded()) {}

  /// Starts outside of the box and ends beyond it.
  geometry::Ray ray(std::size_t index) const {
    const PixelSampler sampler(seed, stream_, 0, static_cast<std::uint32_t>(index));
    const Block8 u = sampler.block(0);
    const Vec3d extent = box_.extent(), direction = sample_uniform_sphere({u[0], u[1]});
    const Vec3d p = box_.min + Vec3d{u[2] * extent.x, u[3] * extent.y, u[4] * extent.z};
    // Never zero, not even for a box without extent.
    const double before = 1.01 * length(extent) + 1e-9 * (1e-30 + max_component(abs(p)));
    geometry::Ray ray{p - direction * before, direction};
    if (!whole_line_) ray.t_max = 2 * before;
    return ray;
  }

 private:
  Box3d box_;
  std::uint32_t stream_;
  bool whole_line_;
};

struct LineResult {
  bool met_body;  ///< at all
  std::uint64_t cut_groups;
};

/// Calls `visit` for what surfaces the ray meets.
template <typename Visit>
LineResult follow(const SolidScene& body, const geometry::Ray& ray, Visit visit) {
  geometry::Sweep sweep(body, ray);
  geometry::Transition found;
  bool any = false;
  while (sweep.next(found)) {
    any = true;
    visit(found);
  }
  return {any || sweep.region() != SolidScene::no_region, sweep.cut_groups()};
}

/// Every so many-th leaf is looked at where there are too many.
std::size_t stride_of(std::size_t leaves) {
  return std::max<std::size_t>(1, (leaves + most_examined - 1) / most_examined);
}

}  // namespace

OperandReport examine_operands(const SolidScene& body) {
  const geometry::Compound& compound = body.world();
  const std::vector<Box3d> boxes = leaf_boxes(compound);
  OperandReport report;
  report.stated = compound.stated_leaves();
  report.live = compound.live_leaves();
  report.lines = lines_each;
  report.empty = true;
  std::vector<bool> seen(report.stated);
  const std::size_t stride = stride_of(boxes.size());
  for (std::size_t number = 0; number < boxes.size(); number += stride) {
    if (boxes[number].empty()) continue;
    const auto leaf = static_cast<std::uint32_t>(number);
    std::vector<std::uint32_t> unseen = stated_as(compound, leaf);
    report.examined += unseen.size();
    const auto drop_seen = [&] { std::erase_if(unseen, [&](auto part) { return seen[part]; }); };
    drop_seen();
    const AimedLines lines(boxes[leaf], leaf);
    for (std::size_t i = 0; i < lines_each && !unseen.empty(); ++i) {
      const LineResult line = follow(body, lines.ray(i), [&](const auto& found) {
        seen[compound.stated_leaf(found.leaf, found.patch)] = true;
      });
      report.empty = report.empty && !line.met_body;
      report.cut_lines += line.cut_groups > 0 ? 1 : 0;
      ++report.lines_followed;
      drop_seen();
    }
    for (const std::uint32_t part : unseen) {
      report.idle.push_back({part, kind_of(compound.leaf(part).solid.solid())});
    }
  }
  std::ranges::sort(report.idle, {}, &IdleOperand::number);
  if (boxes.empty()) report.empty = geometry::region_at(body, {}) == SolidScene::no_region;
  return report;
}

bool seems_empty(const SolidScene& body) {
  const std::vector<Box3d> boxes = leaf_boxes(body.world());
  if (boxes.empty()) return geometry::region_at(body, {}) == SolidScene::no_region;
  for (std::size_t leaf = 0; leaf < boxes.size(); leaf += stride_of(boxes.size())) {
    if (boxes[leaf].empty()) continue;
    const AimedLines lines(boxes[leaf], static_cast<std::uint32_t>(leaf));
    for (std::size_t i = 0; i < lines_each; ++i) {
      if (follow(body, lines.ray(i), [](const auto&) {}).met_body) return false;
    }
  }
  return true;
}

}  // namespace lapidary::inspect
