#include "bsdf/rough_dielectric.h"

// Both sides look alike to the facets: below the surface everything is mirrored in it, so that
// wo.z > 0 throughout, and `eta` is the index beyond over the index on wo's side.
namespace lapidary::bsdf {
namespace {

Vec3d mirrored(Vec3d w, bool mirror) {
  return mirror ? Vec3d(w.x, w.y, -w.z) : w;
}

// Density of wi per density of h, for wi refracted by a facet with normal h: Walter's equation 17,
// with the minus sign of cos_i = |wi.h| written out.
double refraction_jacobian(double cos_o, double cos_i, double eta) {
  const double stretch = cos_o - eta * cos_i;
  return eta * eta * cos_i / (stretch * stretch);
}

// Smith's shadowing of a refracted direction (z < 0), independent of the masking above: the share
// of light that the model lets through.
double shadowing_below(const Ggx& facets, Vec3d wi) {
  return facets.visible_share({wi.x, wi.y, -wi.z});
}

BsdfValue reflected(const RoughDielectric& bsdf, Vec3d wo, Vec3d wi, double side) {
  const Vec3d h = normalize(wo + wi);
  const RelativeIndex::Split split = bsdf.index.split(std::min(dot(wo, h), 1.0), side);
  const double density = bsdf.facets.density(h);
  const double f_cos = density * bsdf.facets.reflection_share(wo, wi);
  const double pdf = 0.5 * density / (wo.z + bsdf.facets.slant(wo));
  return {split.reflectance * static_cast<float>(f_cos), split.chance_to_reflect * pdf};
}

BsdfValue refracted(const RoughDielectric& bsdf, Vec3d wo, Vec3d wi, double side, Mode mode) {
  const double eta = bsdf.index.hero(side);
  const Vec3d sum = wo + eta * wi;  // along h, or against it when eta < 1
  const double length2 = length_squared(sum);
  if (length2 == 0.0) return {};
  const Vec3d h = sum * (std::copysign(1.0, sum.z) / std::sqrt(length2));
  const double cos_o = dot(wo, h), cos_i = -dot(wi, h);
  if (!(cos_o > 0.0 && cos_i > 0.0)) return {};

  const RelativeIndex::Split split = bsdf.index.split(std::min(cos_o, 1.0), side);
  const double density =
      bsdf.facets.visible_density(wo, h) * refraction_jacobian(cos_o, cos_i, eta);
  const double f_cos = split.transmittance * density * shadowing_below(bsdf.facets, wi);
  return {bsdf.index.refracted(f_cos, eta, mode), (1.0 - split.chance_to_reflect) * density};
}

}  // namespace

BsdfValue evaluate_with_pdf(const RoughDielectric& bsdf, Vec3d wo, Vec3d wi, Mode mode) {
  if (wo.z == 0.0 || wi.z == 0.0) return {};
  const Vec3d o = mirrored(wo, wo.z < 0.0), i = mirrored(wi, wo.z < 0.0);
  return i.z > 0.0 ? reflected(bsdf, o, i, wo.z) : refracted(bsdf, o, i, wo.z, mode);
}

std::optional<BsdfSample> sample(const RoughDielectric& bsdf, Vec3d wo, double u_lobe, Vec2d u,
                                 Mode mode) {
  if (wo.z == 0.0) return {};
  const Vec3d o = mirrored(wo, wo.z < 0.0);
  const Vec3d h = bsdf.facets.sample_visible(o, u);
  const double cos_o = std::min(dot(o, h), 1.0);
  if (!(cos_o > 0.0)) return {};
  const RelativeIndex::Split split = bsdf.index.split(cos_o, wo.z);
  const double q = split.chance_to_reflect;
  const double visible = bsdf.facets.visible_density(o, h);

  if (u_lobe < q) {
    const Vec3d wi = 2.0 * cos_o * h - o;
    if (!(wi.z > 0.0)) return {};
    const double share = 2.0 * (o.z + bsdf.facets.slant(o)) * bsdf.facets.reflection_share(o, wi);
    return BsdfSample{mirrored(wi, wo.z < 0.0), split.reflectance * static_cast<float>(share / q),
                      q * visible / (4.0 * cos_o), Lobe::glossy};
  }
  const double eta = bsdf.index.hero(wo.z);
  const Vec3d wi = (cos_o / eta - split.cos_refracted) * h - o * (1.0 / eta);
  if (!(wi.z < 0.0)) return {};
  const double weight = split.transmittance / (1.0 - q) * shadowing_below(bsdf.facets, wi);
  const double jacobian = refraction_jacobian(cos_o, split.cos_refracted, eta);
  return BsdfSample{mirrored(wi, wo.z < 0.0),
                    bsdf.index.refracted(weight, eta, mode),
                    (1.0 - q) * visible * jacobian,
                    Lobe::glossy,
                    Side::transmitted,
                    eta,
                    bsdf.index.carried_by_refraction()};
}

}  // namespace lapidary::bsdf
