#include "bsdf/rough_dielectric.h"

#include <algorithm>

// Both sides look alike to the facets: below the surface everything is mirrored in it, so that
// wo.z > 0 throughout, and `eta` is the index beyond over the index on wo's side.
namespace lapidary::bsdf {
namespace {

Vec3d mirrored(Vec3d w, double side) {
  return side < 0.0 ? Vec3d(w.x, w.y, -w.z) : w;
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

// Fresnel reflectance for diffuse light from the thinner side: a fit by Kulla & Conty
// 2017. It only decides to which side the wide lobes lean.
double average_reflectance(double eta) {
  const double n = std::max(eta, 1.0 / eta);
  return (n - 1.0) / (4.08567 + 1.00071 * n);
}

}  // namespace

// wo on its side, mirrored to z > 0, and what follows from it alone.
struct RoughDielectric::View {
  Vec3d wo;
  double side;  // the sign of wo.z before
  double eta;
  const Loss& near;
  const Loss& far;
  double lost;  // of light from wo
};

// The shares are the same fraction T of what diffuse light could carry both ways: with a lost share
// M on average, index n, reciprocity asks for share M n^2 to be the same on either side.
RoughDielectric::RoughDielectric(const RelativeIndex& index, const Grain& grain)
    : index_(index),
      facets_(grain),
      lobe_(grain.alpha),
      above_{GlassAlbedo(grain, index.hero(1.0))},
      below_{GlassAlbedo(grain, index.hero(-1.0))} {
  const double eta = index.hero(1.0);
  const double from_above = above_.average(), from_below = eta * eta * below_.average();
  const double exchanged = (1.0 - average_reflectance(eta)) * std::min(from_above, from_below);
  if (exchanged > 0.0) {
    above_.refracted_share = exchanged / from_above;
    below_.refracted_share = exchanged / from_below;
  }
}

// What is lost on the way from wo comes out to a side in proportion to what would be lost the other
// way, as reciprocity asks.
double RoughDielectric::spread(double lost, const Loss& side, Vec3d v) const {
  const double average = side.average();
  return average > 0.0 ? lost * side.at(facets_, v) / average * v.z * inv_pi : 0.0;
}

BsdfValue RoughDielectric::reflected(const View& view, Vec3d wi) const {
  const Vec3d h = normalize(view.wo + wi);
  const RelativeIndex::Split split = index_.split(std::min(dot(view.wo, h), 1.0), view.side);
  const double density = facets_.density(h);
  const double narrow = density * facets_.reflection_share(view.wo, wi);
  const double pdf_narrow =
      split.chance_to_reflect * 0.5 * density / (view.wo.z + facets_.slant(view.wo));

  const double kept = 1.0 - view.near.refracted_share;
  const double wide = kept * spread(view.lost, view.near, wi);
  return {
      split.reflectance * static_cast<float>(narrow) + SampledSpectrum(static_cast<float>(wide)),
      between(pdf_narrow, kept * lobe_.pdf(wi.z), view.lost)};
}

BsdfValue RoughDielectric::refracted(const View& view, Vec3d wi, Mode mode) const {
  const double passed = view.near.refracted_share;
  double f_cos = passed * spread(view.lost, view.far, mirrored(wi, -1.0));
  double pdf = passed * view.lost * lobe_.pdf(-wi.z);

  const Vec3d sum = view.wo + view.eta * wi;  // along h, or against it when eta < 1
  const Vec3d h = sum * (std::copysign(1.0, sum.z) / std::max(length(sum), 1e-300));
  const double cos_o = dot(view.wo, h), cos_i = -dot(wi, h);
  if (cos_o > 0.0 && cos_i > 0.0) {
    const RelativeIndex::Split split = index_.split(std::min(cos_o, 1.0), view.side);
    const double density =
        facets_.visible_density(view.wo, h) * refraction_jacobian(cos_o, cos_i, view.eta);
    f_cos += split.transmittance * density * shadowing_below(facets_, wi);
    pdf += (1.0 - view.lost) * (1.0 - split.chance_to_reflect) * density;
  }
  return {index_.refracted(f_cos, view.eta, mode), pdf};
}

BsdfValue RoughDielectric::evaluate_with_pdf(Vec3d wo, Vec3d wi, Mode mode) const {
  if (wo.z == 0.0 || wi.z == 0.0) return {};
  const Vec3d o = mirrored(wo, wo.z), i = mirrored(wi, wo.z);
  const Loss& near = loss_from(wo.z);
  const View view{o, wo.z, index_.hero(wo.z), near, loss_from(-wo.z), near.at(facets_, o)};
  return i.z > 0.0 ? reflected(view, i) : refracted(view, i, mode);
}

// A direction by way of one facet, in the mirrored frame.
std::optional<Vec3d> RoughDielectric::sample_facet(const View& view, double u_lobe, Vec2d u) const {
  const Vec3d h = facets_.sample_visible(view.wo, u);
  const double cos_o = std::min(dot(view.wo, h), 1.0);
  if (!(cos_o > 0.0)) return {};
  const RelativeIndex::Split split = index_.split(cos_o, view.side);
  if (u_lobe < split.chance_to_reflect) {
    const Vec3d wi = 2.0 * cos_o * h - view.wo;
    return wi.z > 0.0 ? std::optional(wi) : std::nullopt;
  }
  const Vec3d wi = (cos_o / view.eta - split.cos_refracted) * h - view.wo * (1.0 / view.eta);
  return wi.z < 0.0 ? std::optional(wi) : std::nullopt;
}

std::optional<BsdfSample> RoughDielectric::sample(Vec3d wo, double u_lobe, Vec2d u,
                                                  Mode mode) const {
  if (wo.z == 0.0) return {};
  const Vec3d o = mirrored(wo, wo.z);
  const Loss& near = loss_from(wo.z);
  const View view{o, wo.z, index_.hero(wo.z), near, loss_from(-wo.z), near.at(facets_, o)};

  std::optional<Vec3d> wi;
  if (u_lobe < view.lost) {
    const bool passes = u_lobe < view.lost * near.refracted_share;
    wi = mirrored(lobe_.sample(u), passes ? -1.0 : 1.0);
  } else {
    wi = sample_facet(view, (u_lobe - view.lost) / (1.0 - view.lost), u);
  }
  if (!wi) return {};
  const bool passes = wi->z < 0.0;
  const BsdfValue value = passes ? refracted(view, *wi, mode) : reflected(view, *wi);
  if (!(value.pdf > 0.0)) return {};

  BsdfSample sample{normalize(mirrored(*wi, wo.z)),
                    value.f_cos * static_cast<float>(1.0 / value.pdf), value.pdf, Lobe::glossy};
  if (passes) {
    sample.side = Side::transmitted;
    sample.relative_index = view.eta;
    sample.carried = index_.carried_by_refraction();
  }
  return sample;
}

}  // namespace lapidary::bsdf
