#include "transport/caustic_pass.h"

#include <cmath>

namespace lapidary::transport {
namespace {

/// Photons of surfaces that turn further away than this (25 degrees) are not of this one.
constexpr double least_agreement = 0.9;

/// The share of photons in what both ways can find.
double share_of_photon(const Photon& photon, double chance_density, double area) {
  if (photon.density == 0.0f) return 1.0;
  const WideTurn turn{area, chance_density};
  return 1.0 - share_of_chance(turn, static_cast<double>(photon.density));
}

SampledSpectrum gather(const CausticPass& pass, const CausticLayer& layer, const Gather& at) {
  if (layer.map.empty()) return {};
  SampledSpectrum sum;
  const Vertex& vertex = at.vertex;
  const Vec3d ng = vertex.surface.geometric_normal;
  const double radius = layer.radius(at.width), radius_squared = radius * radius;
  const double area = photon_area(pass, at.width);
  const auto kernel = 2.0 / (pi * radius_squared * pass.emitted);
  layer.map.for_each_near(vertex.surface.p, radius, [&](const Photon& photon, double d2) {
    // What it brings at other wavelengths than a path has kept is for other paths.
    const SampledSpectrum carried =
        at.throughput *
        light_within(radius, photon.power, photon.dispersion.value(), photon.hero());
    if (photon.depth > at.depth_left || carried.is_zero()) return;
    const Vec3d wi_world(photon.wi);
    const double cos_geometric = std::abs(dot(ng, wi_world));
    // What lies on the other side of a thin wall stays there.
    const double agreement = dot(ng, Vec3d(photon.normal));
    if (std::abs(agreement) < least_agreement || cos_geometric == 0.0) return;
    if ((dot(ng, wi_world) > 0.0) != (agreement > 0.0)) return;
    const Vec3d wi = vertex.frame.to_local(wi_world);
    if (!sides_agree(vertex, wi_world, wi)) return;
    const bsdf::BsdfValue f = evaluate_with_pdf(vertex.bsdf, vertex.wo, wi, bsdf::Mode::radiance);
    if (f.f_cos.is_zero()) return;
    double weight = terminator_share(vertex, wi_world, wi) / cos_geometric;
    if (at.method == CausticMethod::automatic) {
      weight *= share_of_photon(photon, f.pdf / cos_geometric, area);
    }
    const SampledSpectrum given =
        f.f_cos * carried * static_cast<float>(weight * (1.0 - d2 / radius_squared));
    sum += given;
    if (at.gathered != nullptr) {
      at.gathered->push_back({photon.number, given.average() * static_cast<float>(kernel)});
    }
  });
  return sum * static_cast<float>(kernel);
}

}  // namespace

SampledSpectrum gather(const CausticPass& pass, const Gather& at) {
  return gather(pass, pass.focused, at) + gather(pass, pass.diffused, at);
}

}  // namespace lapidary::transport
