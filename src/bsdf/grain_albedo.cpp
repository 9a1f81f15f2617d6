#include "bsdf/grain_albedo.h"

#include <atomic>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "bsdf/coat_albedo.h"
#include "bsdf/facet_albedo.h"
#include "bsdf/fresnel.h"
#include "bsdf/material.h"

namespace lapidary::bsdf {
namespace {

using Part = GrainAlbedo::Part;
using Place = GrainDirections::Place;

// Tables by index, roughness and anisotropy, each evenly spaced in its coordinate.
constexpr std::size_t indices = 13, roughnesses = 20, anisotropies = 8;
// Their entries by direction.
constexpr std::size_t cosines = 32;
std::size_t azimuths(const GrainDirections& directions) {
  return directions.has_edge() ? 25 : 9;
}

double grid(std::size_t i, std::size_t size) {
  return static_cast<double>(i) / static_cast<double>(size - 1);
}

// By the root of roughness, closer the smoother they are: far from the normal the least that is
// lost counts.
const double smoothest = std::sqrt(smallest_roughness);
double roughness_place(double alpha) {
  return (std::sqrt(roughness_coordinate(alpha)) - smoothest) / (1.0 - smoothest);
}
// Closer the higher it is.
double anisotropy_place(double anisotropy) {
  return 1.0 - std::sqrt(1.0 - std::min(anisotropy / (1.0 - Grain::least_ratio), 1.0));
}
Grain grain_at(std::size_t roughness, std::size_t anisotropy) {
  const double root = std::lerp(smoothest, 1.0, grid(roughness, roughnesses));
  const double left = 1.0 - grid(anisotropy, anisotropies);
  return {alpha_from_roughness(root * root), (1.0 - Grain::least_ratio) * (1.0 - left * left)};
}
// The inverse of coat_index_coordinate; facets between equal media reflect nothing.
double eta_at(std::size_t index) {
  const double s = grid(index, indices), r = std::max(0.5 * s * s, 5e-4);
  return (1.0 + r) / (1.0 - r);
}

struct Table {
  std::vector<float> values;  ///< rows of cosines, by azimuth
  double log_average;         ///< falls by powers of alpha

  double at(std::size_t row, std::size_t column, double down, double right) const {
    const float* first = values.data() + row * cosines + column;
    return between(between(first[0], first[1], right),
                   between(first[cosines], first[cosines + 1], right), down);
  }
};

double part_of(Part part, const Ggx& facets, Vec3d v, double eta) {
  switch (part) {
    case Part::lost_by_metal:
      return loss_of_white_facets(facets, v);
    case Part::reflected_by_coat:
      return reflected_by_facets(facets, v, eta) / refract(v.z, eta).reflectance;
    case Part::lost_by_glass:
      break;
  }
  return loss_of_facets(facets, v, eta);
}

struct Lookup {
  TablePlace azimuth, cosine;

  Lookup(const GrainDirections& directions, const Ggx& facets, Vec3d v) {
    const Place place = directions.of(facets, v);
    azimuth = table_place(place.across, azimuths(directions));
    cosine = table_place(place.up, cosines);
  }
  double in(const Table& table) const {
    return table.at(azimuth.index, cosine.index, azimuth.fraction, cosine.fraction);
  }
};

/// 1/pi times the integral over the half sphere of f(v) v.z, by the midpoint rule over azimuths and
/// the logarithm of alpha + v.z: what facets lose has a part at each size of v.z from alpha up.
template <typename Function>
double average_of(double alpha, const Function& f) {
  constexpr int turns = 32, steps = 96;
  const double range = std::log1p(1.0 / alpha);
  const auto cosine = [&](double t) { return std::min(alpha * std::expm1(range * t), 1.0); };
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double low = cosine(i / (1.0 * steps)), high = cosine((i + 1.0) / steps);
    const double z = cosine((i + 0.5) / steps), sine = std::sqrt(1.0 - z * z);
    double ring = 0.0;
    for (int k = 0; k < turns; ++k) {
      const double phi = 0.5 * pi * (k + 0.5) / turns;
      ring += f(Vec3d(sine * std::cos(phi), sine * std::sin(phi), z));
    }
    sum += ring / turns * (high - low) * (high + low);
  }
  return sum;
}

Table make_table(Part part, const Grain& grain, double eta) {
  const GrainDirections directions(grain, eta);
  const Ggx facets(grain);
  const std::size_t rows = azimuths(directions);
  Table table;
  table.values.reserve(rows * cosines);
  for (std::size_t a = 0; a < rows; ++a) {
    for (std::size_t c = 0; c < cosines; ++c) {
      const Vec3d v = directions.at({grid(a, rows), grid(c, cosines)});
      table.values.push_back(static_cast<float>(part_of(part, facets, v, eta)));
    }
  }
  // Of what the table says, not of the truth: what is made up for is what is thought to be lost.
  table.log_average = std::log(average_of(grain.alpha, [&](Vec3d v) {
    const double value = Lookup(directions, facets, v).in(table);
    return part == Part::reflected_by_coat ? value * refract(v.z, eta).reflectance : value;
  }));
  return table;
}

}  // namespace

/// Those of one part, of glass seen from one side.
class GrainAlbedo::Tables {
 public:
  enum class Side { outside, inside };
  Tables(Part part, Side side) : part_(part), side_(side) {}
  Tables(const Tables&) = delete;
  Tables& operator=(const Tables&) = delete;
  ~Tables() {
    for (auto& slot : slots_) delete slot.load();
  }

  /// That there is one.
  const Table& make(std::size_t index, std::size_t roughness, std::size_t anisotropy) {
    auto& slot = slots_[slot_of(index, roughness, anisotropy)];
    const Table* made = slot.load(std::memory_order_acquire);
    if (made != nullptr) return *made;
    const double eta = part_ == Part::lost_by_metal ? 1.0 : eta_at(index);
    auto table = std::make_unique<const Table>(make_table(part_, grain_at(roughness, anisotropy),
                                                          side_ == Side::inside ? 1.0 / eta : eta));
    return slot.compare_exchange_strong(made, table.get(), std::memory_order_acq_rel)
               ? *table.release()
               : *made;
  }
  /// One that has been made.
  const Table& at(std::size_t index, std::size_t roughness, std::size_t anisotropy) const {
    return *slots_[slot_of(index, roughness, anisotropy)].load(std::memory_order_acquire);
  }
  /// How many indices lie around one.
  std::size_t indices_around() const { return part_ == Part::lost_by_metal ? 1 : 2; }

  static Tables& of(Part part, double eta) {
    static Tables metal(Part::lost_by_metal, Side::outside);
    static Tables coat(Part::reflected_by_coat, Side::outside);
    static Tables glass(Part::lost_by_glass, Side::outside);
    static Tables inside(Part::lost_by_glass, Side::inside);
    switch (part) {
      case Part::lost_by_metal:
        return metal;
      case Part::reflected_by_coat:
        return coat;
      case Part::lost_by_glass:
        break;
    }
    return eta < 1.0 ? inside : glass;
  }

 private:
  static std::size_t slot_of(std::size_t index, std::size_t roughness, std::size_t anisotropy) {
    return (index * roughnesses + roughness) * anisotropies + anisotropy;
  }

  Part part_;
  Side side_;
  std::array<std::atomic<const Table*>, indices * roughnesses * anisotropies> slots_{};
};

namespace {

/// The sum over the tables around a cell of `value(index, roughness, anisotropy)`, by their shares.
template <typename Value>
double sum_around(const std::array<std::uint16_t, 3>& cell, const std::array<float, 3>& fraction,
                  std::size_t indices_around, const Value& value) {
  const auto in_row = [&](std::size_t index, std::size_t roughness) {
    return between(value(index, roughness, cell[2]), value(index, roughness, cell[2] + 1u),
                   static_cast<double>(fraction[2]));
  };
  const auto of_index = [&](std::size_t index) {
    return between(in_row(index, cell[1]), in_row(index, cell[1] + 1u),
                   static_cast<double>(fraction[1]));
  };
  if (indices_around == 1) return of_index(cell[0]);
  return between(of_index(cell[0]), of_index(cell[0] + 1u), static_cast<double>(fraction[0]));
}

}  // namespace

GrainAlbedo::GrainAlbedo(Part part, const Grain& grain, double eta) : directions_(grain, eta) {
  Tables& tables = Tables::of(part, eta);
  tables_ = &tables;
  const std::array<TablePlace, 3> places{
      table_place(coat_index_coordinate(std::max(eta, 1.0 / eta)), indices),
      table_place(roughness_place(grain.alpha), roughnesses),
      table_place(anisotropy_place(grain.anisotropy), anisotropies)};
  for (std::size_t i = 0; i < places.size(); ++i) {
    cell_[i] = static_cast<std::uint16_t>(places[i].index);
    fraction_[i] = static_cast<float>(places[i].fraction);
  }
  average_ = std::exp(sum_around(cell_, fraction_, tables.indices_around(),
                                 [&](std::size_t i, std::size_t r, std::size_t a) {
                                   return tables.make(i, r, a).log_average;
                                 }));
}

double GrainAlbedo::at(const Ggx& facets, Vec3d v) const {
  const Lookup lookup(directions_, facets, v);
  return sum_around(
      cell_, fraction_, tables_->indices_around(),
      [&](std::size_t i, std::size_t r, std::size_t a) { return lookup.in(tables_->at(i, r, a)); });
}

}  // namespace lapidary::bsdf
