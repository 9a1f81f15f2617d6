#include "light/light_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "light/light_tree_build.h"

namespace lapidary::light {
namespace {

struct Angle {
  double cosine = 1, sine = 0;

  /// This less `b`, but not below zero; both in [0, pi].
  Angle less(Angle b) const {
    if (cosine >= b.cosine) return {};
    return {cosine * b.cosine + sine * b.sine, sine * b.cosine - cosine * b.sine};
  }
};

Angle angle_of(double cosine) {
  return {cosine, std::sqrt(std::max(0.0, 1.0 - cosine * cosine))};
}

/// Cosines below this count as this: lights at a grazing angle keep a chance.
constexpr double least_cosine = 1e-3;
/// What cosines may be wrong by where they decide that light cannot arrive.
constexpr double cosine_error = 1e-6;

/// The mean of what is positive of heights that are spread evenly from `height` - `reach` to
/// `height` + `reach`; 0 where nothing is.
double mean_above(double height, double reach) {
  if (height >= reach) return height;
  const double highest = height + reach;
  return highest > 0.0 ? highest * highest / (4.0 * reach) : 0.0;
}

float rounded_up(double x) {
  return x > 0.0 ? std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity())
                 : 0.0f;
}

}  // namespace

// Conty Estevez & Kulla 2018, equation 3, with the clamped distance of section 4.2. There cosines
// are bounds over a ball. That makes distant lamps over a wide floor far too important: a cluster
// of them is flat, and shines on the floor at a grazing angle. So cosines are means over the box
// here, and bounds only decide where there is nothing.
double LightTree::Node::at(const LitPoint& to) const {
  const Vec3d d = to.p - Vec3d(center);
  const double distance_squared = length_squared(d);
  const double radius_squared = static_cast<double>(radius) * radius;
  if (!(distance_squared > radius_squared)) {
    return radius_squared > 0.0 ? strength / radius_squared : strength;
  }
  const double distance = std::sqrt(distance_squared);
  double cosines = emission_cosine(d, distance);
  if (!(to.normal == Vec3d())) {
    const double height = mean_above(-dot(d, to.normal), extent(to.normal));
    if (!(height > 0.0)) return 0.0;
    cosines *= std::max(height / distance, least_cosine);
  }
  return strength * cosines / distance_squared;
}

double LightTree::Node::emission_cosine(Vec3d d, double distance) const {
  if (!(cos_normals > -1.0f)) return 1.0;
  const double height = dot(d, Vec3d(axis));
  const bool is_panel = cos_normals > 0.999f && cos_spread < 0.5f;
  if (is_panel) {
    const double mean = mean_above(height, extent(Vec3d(axis)) + sin_normals * distance);
    return mean > 0.0 ? std::max(mean / distance, least_cosine) : 0.0;
  }
  const double sine = std::min(1.0, radius / distance);
  const Angle seen{std::sqrt(1.0 - sine * sine), sine};
  const Angle mean =
      angle_of(std::clamp(height / distance, -1.0, 1.0)).less({cos_normals, sin_normals});
  const double bound = mean.less(seen).cosine;
  if (bound < cos_spread - cosine_error) return 0.0;
  return std::max({mean.cosine, 0.1 * bound, least_cosine});
}

/// Fills nodes from groups of lights.
class LightTree::Builder {
 public:
  Builder(LightTree& tree, std::vector<LightGroup> lights)
      : tree_(tree), lights_(std::move(lights)) {}

  void build() {
    tree_.nodes_.reserve(2 * lights_.size() - 1);
    tree_.nodes_.resize(1);
    fill(0, lights_, {});
  }

 private:
  struct Place {
    int depth = 0;
    std::uint64_t turns = 0;
  };

  void fill(std::size_t at, std::span<LightGroup> lights, const Place& place) {
    LightGroup all;
    for (const LightGroup& light : lights) all.add(light);
    if (lights.size() == 1) all = lights.front();
    tree_.nodes_[at] = node_of(all);
    if (lights.size() == 1) {
      tree_.trails_[all.light] = place.turns | std::uint64_t{1} << place.depth;
      return;
    }
    const auto next = tree_.nodes_.size();
    tree_.nodes_[at].next = static_cast<std::uint32_t>(next);
    tree_.nodes_.resize(next + 2);
    // Halves from here on keep within the bits of a trail.
    constexpr int deepest_cut = 30;
    const std::size_t left = place.depth < deepest_cut ? cut(lights, all) : halve(lights);
    fill(next, lights.first(left), {place.depth + 1, place.turns});
    fill(next + 1, lights.subspan(left),
         {place.depth + 1, place.turns | std::uint64_t{1} << place.depth});
  }

  Node node_of(const LightGroup& group) const {
    Node node;
    node.center = Vec3f(group.box.center());
    // The centre is that of the box only within rounding.
    const Vec3d far = max(abs(group.box.min), abs(group.box.max));
    const double rounding = 0x1p-23 * max_component(far);
    const Vec3d half = 0.5 * group.box.extent();
    node.half = {rounded_up(half.x + rounding), rounded_up(half.y + rounding),
                 rounded_up(half.z + rounding)};
    // Of a ball that is given, where that is smaller than the one around the box.
    node.radius = rounded_up(std::min(length(half), group.radius) + 2.0 * rounding);
    node.axis = Vec3f(group.cone.axis);
    const double widened = std::min(pi, group.cone.angle + 1e-6);
    node.cos_normals = widened < pi ? static_cast<float>(std::cos(widened)) : -1.0f;
    node.sin_normals = static_cast<float>(std::sin(widened));
    node.cos_spread = static_cast<float>(std::cos(group.cone.spread));
    const double share = group.strength / tree_.total_;
    node.strength = std::max(static_cast<float>(share), std::numeric_limits<float>::denorm_min());
    node.light = group.light;
    return node;
  }

  LightTree& tree_;
  std::vector<LightGroup> lights_;
};

LightTree::LightTree(std::span<const Influence> lights) : trails_(lights.size()) {
  std::vector<LightGroup> standing;
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    const bool counts = lights[i].reach != Influence::Reach::everywhere &&
                        lights[i].strength > 0.0 && !lights[i].box.empty();
    if (!counts) continue;
    standing.push_back(group_of(lights[i], i));
    total_ += lights[i].strength;
  }
  if (!standing.empty()) Builder(*this, std::move(standing)).build();
}

LightTree::Shares LightTree::shares(const Node& parent, const LitPoint& to) const {
  const double left = nodes_[parent.next].at(to), right = nodes_[parent.next + 1].at(to);
  const double sum = left + right;
  if (!(sum > 0.0)) return {};
  return {left / sum, right / sum};
}

std::size_t LightTree::bytes() const {
  return nodes_.capacity() * sizeof(Node) + trails_.capacity() * sizeof(std::uint64_t);
}

}  // namespace lapidary::light
