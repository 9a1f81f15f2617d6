#include "bsdf/facet_albedo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <immintrin.h>

#include "bsdf/fresnel.h"

namespace lapidary::bsdf {
namespace {

/// Eight numbers, one of each facet that is looked at together.
using Lanes = float __attribute__((vector_size(32)));
constexpr std::size_t width = sizeof(Lanes) / sizeof(float);

constexpr float tiny = 1e-9f;  ///< over which what is 0 over 0 is 0

Lanes root(Lanes x) {
  return _mm256_sqrt_ps(x);
}
Lanes positive(Lanes x) {
  return _mm256_max_ps(x, _mm256_setzero_ps());
}
Lanes at_most_one(Lanes x) {
  return _mm256_min_ps(x, _mm256_set1_ps(1.0f));
}

/// Gauss and Legendre's places in [0, 1], with weights that sum to 1.
template <std::size_t Count>
std::array<Vec2d, Count> gauss_places() {
  std::array<Vec2d, Count> places;
  for (std::size_t i = 0; i < Count; ++i) {
    double x = std::cos(pi * (static_cast<double>(i) + 0.75) / (Count + 0.5)), slope = 0.0;
    for (int step = 0; step < 20; ++step) {
      double before = 1.0, value = x;  // Legendre polynomials
      for (std::size_t k = 2; k <= Count; ++k) {
        const auto n = static_cast<double>(k);
        const double next = ((2.0 * n - 1.0) * x * value - (n - 1.0) * before) / n;
        before = value;
        value = next;
      }
      slope = Count * (x * value - before) / (x * x - 1.0);
      x -= value / slope;
    }
    places[i] = {0.5 + 0.5 * x, 1.0 / ((1.0 - x * x) * slope * slope)};
  }
  return places;
}

/// Places on the unit disk that stand for all of it: on rings, which are closer at the rim, where
/// steep facets are; those of every second ring between those of the others.
struct Rule {
  static constexpr std::size_t count = 24;  ///< of rings
  static constexpr std::size_t turns = 2;   ///< lanes of places on a ring
  struct Ring {
    double radius, inner;  ///< inner: 1 - radius^2
    float weight;
    std::array<Lanes, turns> x, y;  ///< of unit length
  };
  std::array<Ring, count> rings;

  Rule() {
    const auto places = gauss_places<count>();
    for (std::size_t i = 0; i < count; ++i) {
      const double left = places[i].x;
      Ring& ring = rings[i];
      ring.inner = left * left;
      ring.radius = std::sqrt(1.0 - ring.inner);
      ring.weight = static_cast<float>(2.0 * left * places[i].y / (turns * width));
      for (std::size_t k = 0; k < turns * width; ++k) {
        const double shift = i % 2 == 0 ? 0.25 : 0.75;
        const double angle = 2.0 * pi * (static_cast<double>(k) + shift) / (turns * width);
        ring.x[k / width][k % width] = static_cast<float>(std::cos(angle));
        ring.y[k / width][k % width] = static_cast<float>(std::sin(angle));
      }
    }
  }
};

const Rule& rule() {
  static const Rule made;
  return made;
}

struct LaneVector {
  Lanes x, y, z;
};

/// One over the other; divisions are what takes time here.
struct Share {
  Lanes part, whole;
  Lanes value() const { return part / whole; }
};

/// What is to be known of facets and of the light that falls on them.
class Lit {
 public:
  Lit(const Ggx& facets, Vec3d v)
      : x_(static_cast<float>(v.x)),
        y_(static_cast<float>(v.y)),
        z_(static_cast<float>(v.z)),
        slant_(static_cast<float>(facets.slant(v))) {
    const double alpha2 = facets.alpha * facets.alpha;
    xx_ = static_cast<float>(alpha2 * facets.s_xx);
    xy_ = static_cast<float>(2.0 * alpha2 * facets.s_xy);
    yy_ = static_cast<float>(alpha2 * facets.s_yy);
  }

  /// The cosine to facets with normals h.
  Lanes cosine(const LaneVector& h) const {
    return at_most_one(positive(x_ * h.x + y_ * h.y + z_ * h.z));
  }
  /// Of what is reflected, the share that other facets keep from leaving.
  Share kept_of_reflected(const LaneVector& h, Lanes cosine) const {
    const Lanes twice = cosine + cosine;
    const Way way(*this, twice * h.x - x_, twice * h.y - y_, twice * h.z - z_);
    return {z_ * way.beyond, z_ * way.slant + way.z * slant_ + tiny};
  }
  /// The same of what is refracted.
  Share kept_of_refracted(const LaneVector& h, Lanes cosine, Lanes cos_refracted, float eta) const {
    const float inverse = 1.0f / eta;
    const Lanes along = cosine * inverse - cos_refracted;
    const Way way(*this, along * h.x - x_ * inverse, along * h.y - y_ * inverse,
                  z_ * inverse - along * h.z);
    return {way.beyond, way.z + way.slant + tiny};
  }

 private:
  /// Of light that goes out; z is 0 where it goes in.
  struct Way {
    Lanes z, slant;
    Lanes beyond;  ///< slant - z, without the cancellation

    Way(const Lit& lit, Lanes x, Lanes y, Lanes up) : z(positive(up)) {
      const Lanes aside = lit.xx_ * x * x + lit.xy_ * x * y + lit.yy_ * y * y;
      slant = root(z * z + aside);
      beyond = aside / (slant + z + tiny);
    }
  };

  float x_, y_, z_, slant_;
  float xx_, xy_, yy_;  ///< of the square of alpha by direction
};

/// The mean of `share(h, cosine)` over the facets that v sees, as `Ggx::sample_visible` draws them.
template <typename Share>
double mean_over_visible(const Ggx& facets, Vec3d v, const Lit& lit, const Share& share) {
  const Ggx::Stretch stretch = facets.stretch();
  const Vec3d seen = normalize(stretch.of(v));
  const double span = 1.0 + std::min(seen.z, 1.0);
  // Rings begin at the view's azimuth, so that a grain that turns with it changes nothing.
  const double sine = std::sqrt(seen.x * seen.x + seen.y * seen.y);
  const Vec2d way = sine > 1e-6 ? Vec2d{seen.x / sine, seen.y / sine} : Vec2d{1.0, 0.0};
  // In these axes, what stretches.
  const auto along_x = static_cast<float>(stretch.xx * way.x + stretch.xy * way.y);
  const auto along_y = static_cast<float>(stretch.xy * way.x + stretch.yy * way.y);
  const auto aside_x = static_cast<float>(stretch.xy * way.x - stretch.xx * way.y);
  const auto aside_y = static_cast<float>(stretch.yy * way.x - stretch.xy * way.y);
  const auto shift = static_cast<float>(sine);
  Lanes sum{};
  for (const auto& ring : rule().rings) {
    const double height = span * ring.inner;
    const auto radius = static_cast<float>(ring.radius * std::sqrt(span * (2.0 - span + height)));
    const auto z = static_cast<float>(height);
    for (std::size_t turn = 0; turn < Rule::turns; ++turn) {
      const Lanes along = shift + radius * ring.x[turn], aside = radius * ring.y[turn];
      const Lanes hx = along_x * along + aside_x * aside, hy = along_y * along + aside_y * aside;
      const Lanes inverse = 1.0f / root(hx * hx + hy * hy + z * z + tiny);
      const LaneVector h{hx * inverse, hy * inverse, z * inverse};
      sum += ring.weight * share(h, lit.cosine(h));
    }
  }
  double total = 0.0;
  for (std::size_t i = 0; i < width; ++i) total += static_cast<double>(sum[i]);
  return std::min(total, 1.0);
}

struct LaneRefraction {
  Share reflectance;
  Lanes cos_refracted;
};

/// `bsdf::refract`; under total internal reflection the equations give 1 by themselves.
LaneRefraction refract_lanes(Lanes cosine, float eta) {
  const Lanes bent = root(positive(1.0f - (1.0f - cosine * cosine) * (1.0f / (eta * eta))));
  const Lanes s = cosine - eta * bent, s_whole = cosine + eta * bent + tiny;
  const Lanes p = eta * cosine - bent, p_whole = eta * cosine + bent + tiny;
  const Lanes a = s * p_whole, b = p * s_whole, whole = s_whole * p_whole;
  return {{0.5f * (a * a + b * b), whole * whole}, bent};
}

}  // namespace

double loss_of_white_facets(const Ggx& facets, Vec3d v) {
  const Lit lit(facets, v);
  return mean_over_visible(facets, v, lit, [&](const LaneVector& h, Lanes cosine) {
    return lit.kept_of_reflected(h, cosine).value();
  });
}

double reflected_by_facets(const Ggx& facets, Vec3d v, double eta) {
  const Lit lit(facets, v);
  const auto index = static_cast<float>(eta);
  return mean_over_visible(facets, v, lit, [&](const LaneVector& h, Lanes cosine) {
    const Share facet = refract_lanes(cosine, index).reflectance;
    const Share kept = lit.kept_of_reflected(h, cosine);
    return Share{facet.part * (kept.whole - kept.part), facet.whole * kept.whole}.value();
  });
}

double loss_of_facets(const Ggx& facets, Vec3d v, double eta) {
  const Lit lit(facets, v);
  const auto index = static_cast<float>(eta);
  return mean_over_visible(facets, v, lit, [&](const LaneVector& h, Lanes cosine) {
    const auto [facet, bent] = refract_lanes(cosine, index);
    const Share back = lit.kept_of_reflected(h, cosine);
    const Share on = lit.kept_of_refracted(h, cosine, bent, index);
    return Share{
        facet.part * back.part * on.whole + (facet.whole - facet.part) * on.part * back.whole,
        facet.whole * back.whole * on.whole}
        .value();
  });
}

}  // namespace lapidary::bsdf
