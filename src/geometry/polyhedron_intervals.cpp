#include <immintrin.h>

#include "geometry/plane_crossing.h"
#include "geometry/polyhedron_data.h"

/// Lines against many planes, four at a time: plane_crossing.h lane by lane, with the same
/// operations in the same order, so that a plane has the same crossing here as in a half-space.
namespace lapidary::geometry {
namespace {

constexpr double u_ = rounding_unit;

struct Four {
  __m256d v;
};
Four four(double x) {
  return {_mm256_set1_pd(x)};
}
Four four(const std::array<double, 4>& x) {
  return {_mm256_load_pd(x.data())};
}
Four operator+(Four a, Four b) {
  return {_mm256_add_pd(a.v, b.v)};
}
Four operator-(Four a, Four b) {
  return {_mm256_sub_pd(a.v, b.v)};
}
Four operator*(Four a, Four b) {
  return {_mm256_mul_pd(a.v, b.v)};
}
Four operator/(Four a, Four b) {
  return {_mm256_div_pd(a.v, b.v)};
}
Four operator-(Four a) {
  return {_mm256_xor_pd(a.v, _mm256_set1_pd(-0.0))};
}
Four magnitude(Four a) {
  return {_mm256_andnot_pd(_mm256_set1_pd(-0.0), a.v)};
}
Four operator<=(Four a, Four b) {
  return {_mm256_cmp_pd(a.v, b.v, _CMP_LE_OQ)};
}
Four operator<(Four a, Four b) {
  return {_mm256_cmp_pd(a.v, b.v, _CMP_LT_OQ)};
}
Four both(Four mask, Four also) {
  return {_mm256_and_pd(mask.v, also.v)};
}
Four but_not(Four mask, Four never) {
  return {_mm256_andnot_pd(never.v, mask.v)};
}
Four choose(Four mask, Four yes, Four no) {
  return {_mm256_blendv_pd(no.v, yes.v, mask.v)};
}
unsigned bits(Four mask) {
  return static_cast<unsigned>(_mm256_movemask_pd(mask.v));
}

/// The greatest crossing so far, and the greatest that one could be: exits are negated.
struct Last {
  Four t = four(-infinity), tau = four(0.0), highest = four(-infinity), patch = four(0.0);

  void extend(Four where, Four t_new, Four tau_new, Four patch_new) {
    const Four later = both(where, t < t_new);
    t = choose(later, t_new, t);
    tau = choose(later, tau_new, tau);
    patch = choose(later, patch_new, patch);
    const Four high = t_new + tau_new;
    highest = choose(both(where, highest < high), high, highest);
  }

  /// The greatest of the four lanes; of equal ones the one with the least patch.
  Event event(Crossing crossing) const {
    alignas(32) std::array<double, 4> t4, tau4, highest4, patch4;
    _mm256_store_pd(t4.data(), t.v), _mm256_store_pd(tau4.data(), tau.v);
    _mm256_store_pd(highest4.data(), highest.v), _mm256_store_pd(patch4.data(), patch.v);
    std::size_t best = 0;
    double most = highest4[0];
    for (std::size_t i = 1; i < 4; ++i) {
      most = std::max(most, highest4[i]);
      if (t4[i] > t4[best] || (t4[i] == t4[best] && patch4[i] < patch4[best])) best = i;
    }
    // The difference rounds once; infinite when no plane is crossed this way.
    const double tau_of_all = std::isfinite(most) ? (most - t4[best]) * (1 + 2 * u_) : 0.0;
    return {t4[best], std::max(tau4[best], tau_of_all), static_cast<Patch>(patch4[best]), crossing};
  }
};

/// A line ready for four planes.
struct FourLines {
  std::array<Four, 3> origin, direction;
  Four origin_error, direction_error;

  explicit FourLines(const Line& line)
      : origin_error(four(line.origin_error)), direction_error(four(line.direction_error)) {
    for (std::size_t i = 0; i < 3; ++i) {
      origin[i] = four(line.origin[i]), direction[i] = four(line.direction[i]);
    }
  }
};

struct FourBounded {
  Four value, error;
};

/// The dot product of v and the normals with the error that height_over and slope_over derive.
FourBounded dot_with(const Polyhedron::Data::Planes& planes, const std::array<Four, 3>& v,
                     double roundings, Four displacement) {
  const Four x = v[0] * four(planes.normal[0]), y = v[1] * four(planes.normal[1]),
             z = v[2] * four(planes.normal[2]);
  const Four terms = magnitude(x) + magnitude(y) + magnitude(z);
  return {x + y + z, four(roundings * u_) * terms + four(planes.normal_length) * displacement};
}

}  // namespace

void intervals(const Polyhedron& polyhedron, const Line& line, EventBuffer& events) {
  events.clear();
  const Polyhedron::Data& data = *polyhedron.data_;
  const FourLines lines(line);
  Last entry, exit;
  Four patch{_mm256_setr_pd(0, 1, 2, 3)};
  for (const Polyhedron::Data::Planes& planes : data.planes) {
    const std::array<Four, 3> q{lines.origin[0] - four(planes.point[0]),
                                lines.origin[1] - four(planes.point[1]),
                                lines.origin[2] - four(planes.point[2])};
    const auto height = dot_with(planes, q, data.normal_roundings + 4, lines.origin_error);
    const auto slope =
        dot_with(planes, lines.direction, data.normal_roundings + 3, lines.direction_error);
    const Four parallel = magnitude(slope.value) <= four(2.0) * slope.error;
    for (unsigned rest = bits(parallel); rest != 0; rest &= rest - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(rest));
      const Vec3d n{planes.normal[0][lane], planes.normal[1][lane], planes.normal[2][lane]};
      const Bounded h{height.value.v[lane], height.error.v[lane]};
      if (!is_below(h, n)) return;
    }
    const Four inverse = four(1.0) / slope.value;
    const Four t = -height.value * inverse;
    const Four x = slope.error * magnitude(inverse);
    const Four tau =
        (height.error * magnitude(inverse) + x * magnitude(t)) * (four(1.0) + four(2.0) * x) +
        four(2 * u_) * magnitude(t);
    const Four enters = slope.value < four(0.0), leaves = four(0.0) < slope.value;
    entry.extend(but_not(enters, parallel), t, tau, patch);
    exit.extend(but_not(leaves, parallel), -t, tau, patch);
    patch = patch + four(4.0);
  }
  const Event in = entry.event(Crossing::enter);
  Event out = exit.event(Crossing::leave);
  out.t = -out.t;
  if (!(in.t < out.t)) return;
  events.set_inside_at_start(in.t == -infinity);
  if (in.t > -infinity) events.push(in);
  if (out.t < infinity) events.push(out);
}

}  // namespace lapidary::geometry
