#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "math/interval.h"
#include "transport/photon.h"

namespace lapidary::transport {

/// The photons of one pass, ordered along a Morton curve, with tables of their cells of several
/// sizes: whatever radius is asked for, within the range that was stated, at most eight cells of
/// about that size are looked at, each a contiguous run. Immutable once built.
///
/// The order of photons that come as input does not matter: those in a cell are in that order.
class PhotonMap {
 public:
  /// Radii that will be asked for, > 0.
  struct Radii {
    double smallest = 0;
    double largest = 0;
  };

  PhotonMap() = default;
  /// Photons' positions count from `origin`. Time: linear.
  PhotonMap(std::vector<Photon> photons, Vec3d origin, Radii radii);

  bool empty() const { return photons_.empty(); }
  std::span<const Photon> photons() const { return photons_; }
  const Radii& radii() const { return radii_; }
  std::size_t bytes() const;

  /// Calls `use(photon, distance_squared)` for every photon within `radius`, which lies in the
  /// stated range, of the world point p; in an order that depends on nothing but the photons.
  template <typename Use>
  void for_each_near(Vec3d p, double radius, Use&& use) const {
    const Vec3f at(p - origin_);
    const auto r = static_cast<float>(radius);
    if (!reaches(at, r)) return;
    for (const Run& run : runs_near(at, radius)) {
      for (std::uint32_t i = run.begin; i < run.end; ++i) {
        const float distance_squared = length_squared(photons_[i].position - at);
        if (distance_squared < r * r) use(photons_[i], static_cast<double>(distance_squared));
      }
    }
  }

 private:
  /// Photons [begin, end).
  struct Run {
    std::uint32_t begin = 0, end = 0;
  };
  /// The cells of one size that hold photons, in a hash table with open addresses.
  struct Level {
    struct Entry {
      std::uint64_t code = 0;
      Run run;  ///< empty: a free entry
    };
    std::vector<Entry> entries;  ///< a power of two of them
    Run find(std::uint64_t code) const;
  };
  struct Cell {
    std::array<std::uint32_t, 3> at;
  };

  bool reaches(Vec3f at, float radius) const;
  std::array<Run, 8> runs_near(Vec3f at, double radius) const;
  Cell cell_of(Vec3f position) const;
  std::vector<std::uint64_t> sort();
  Level make_level(std::span<const std::uint64_t> codes, unsigned level) const;

  std::vector<Photon> photons_;
  Vec3d origin_;
  Radii radii_;
  Vec3f low_, high_;  ///< around all photons
  Vec3d corner_;      ///< of the first cell; what lies beyond the last ones counts as in them
  double cell_ = 1;   ///< side of the smallest cells
  std::vector<Level> levels_;  ///< of sides cell_, 2 cell_, 4 cell_, ...
};

}  // namespace lapidary::transport
