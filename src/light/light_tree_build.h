#pragma once

#include <cstdint>
#include <span>

#include "light/influence.h"

namespace lapidary::light {

// For LightTree alone: how lights are divided into two groups.

/// Where the normals of emitting surfaces point, and how far from them light goes.
struct EmissionCone {
  Vec3d axis{0, 0, 1};  ///< unit length
  double angle = 0;     ///< in [0, pi], holds all normals; pi: all directions
  double spread = 0;    ///< in [0, pi], from a normal
};

/// A cone that holds both. Source: Conty Estevez & Kulla 2018, algorithm 1.
EmissionCone united(const EmissionCone& a, const EmissionCone& b);

/// One or more lights.
struct LightGroup {
  void add(const LightGroup& b);
  bool is_empty() const { return box.empty(); }

  Box3d box;
  EmissionCone cone;
  double radius = infinity;  ///< of a ball about the centre of `box` that holds the lights, too
  double strength = 0;       ///< intensity
  std::uint32_t light = 0;   ///< of one light
};

LightGroup group_of(const Influence& light, std::uint32_t index);

/// Puts at least two lights into an order of which a first part, whose length it returns, and the
/// rest make two groups that are cheap to choose from: small, bright in few directions, alike.
/// `all` is the group of all of them. Source: Conty Estevez & Kulla 2018, section 4.4, the surface
/// area orientation heuristic.
std::size_t cut(std::span<LightGroup> lights, const LightGroup& all);

/// The same by number alone, along the longest edge of where they are.
std::size_t halve(std::span<LightGroup> lights);

}  // namespace lapidary::light
