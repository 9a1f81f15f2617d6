#include "transport/photon_map.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "base/mix_bits.h"

namespace lapidary::transport {
namespace {

constexpr unsigned bits_per_axis = 21;
constexpr std::uint32_t most_cells = 1u << bits_per_axis;
/// Diameter of a ball over its radius, and what rounding may add.
constexpr double ball = 2.001;

/// The bits of a number of 21 bits, three places apart.
constexpr std::uint64_t spread_bits(std::uint64_t x) {
  x = (x | x << 32) & 0x001f00000000ffffULL;
  x = (x | x << 16) & 0x001f0000ff0000ffULL;
  x = (x | x << 8) & 0x100f00f00f00f00fULL;
  x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
  return (x | x << 2) & 0x1249249249249249ULL;
}

constexpr std::uint64_t morton(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  return spread_bits(x) | spread_bits(y) << 1 | spread_bits(z) << 2;
}

/// Keys with the places they were at, in ascending order of keys, equal ones as they came.
struct Keyed {
  std::uint64_t code;
  std::uint32_t index;
};

void radix_sort(std::vector<Keyed>& keys, unsigned bits) {
  constexpr unsigned digit = 11;
  std::vector<Keyed> other(keys.size());
  for (unsigned shift = 0; shift < bits; shift += digit) {
    std::array<std::uint32_t, (1u << digit) + 1> starts{};
    const auto value = [&](const Keyed& k) { return (k.code >> shift) & ((1u << digit) - 1); };
    for (const Keyed& k : keys) ++starts[value(k) + 1];
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    for (const Keyed& k : keys) other[starts[value(k)]++] = k;
    keys.swap(other);
  }
}

}  // namespace

PhotonMap::PhotonMap(std::vector<Photon> photons, Vec3d origin, Radii radii)
    : photons_(std::move(photons)), origin_(origin), radii_(radii) {
  if (photons_.empty()) return;
  low_ = high_ = photons_.front().position;
  for (const Photon& photon : photons_) {
    low_ = lapidary::min(low_, photon.position);
    high_ = lapidary::max(high_, photon.position);
  }
  // A ball reaches over at most two cells that are as wide as itself along each axis.
  cell_ = ball * radii.smallest;
  // Photons that flew off over a floor without end share the outermost cells: the others must not
  // suffer from them.
  const auto half = static_cast<float>(0.5 * most_cells * cell_);
  corner_ = Vec3d(lapidary::max(low_, Vec3f(-half, -half, -half)));
  const std::vector<std::uint64_t> codes = sort();
  double side = cell_;
  for (unsigned level = 0;; ++level, side *= 2.0) {
    levels_.push_back(make_level(codes, level));
    if (side >= ball * radii.largest || level == bits_per_axis) break;
  }
}

std::size_t PhotonMap::bytes() const {
  std::size_t sum = photons_.capacity() * sizeof(Photon);
  for (const Level& level : levels_) sum += level.entries.capacity() * sizeof(Level::Entry);
  return sum;
}

PhotonMap::Cell PhotonMap::cell_of(Vec3f position) const {
  const Vec3d from = Vec3d(position) - corner_;
  const auto along = [&](double x) {
    return static_cast<std::uint32_t>(std::clamp(x / cell_, 0.0, double{most_cells - 1}));
  };
  return {{along(from.x), along(from.y), along(from.z)}};
}

std::vector<std::uint64_t> PhotonMap::sort() {
  std::vector<Keyed> keys(photons_.size());
  for (std::uint32_t i = 0; i < keys.size(); ++i) {
    const Cell cell = cell_of(photons_[i].position);
    keys[i] = {morton(cell.at[0], cell.at[1], cell.at[2]), i};
  }
  const Cell last = cell_of(high_);
  const std::uint32_t most = std::max({last.at[0], last.at[1], last.at[2]});
  radix_sort(keys, 3 * static_cast<unsigned>(std::bit_width(most)));
  std::vector<Photon> sorted(photons_.size());
  std::vector<std::uint64_t> codes(photons_.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    sorted[i] = photons_[keys[i].index];
    codes[i] = keys[i].code;
  }
  photons_ = std::move(sorted);
  return codes;
}

PhotonMap::Level PhotonMap::make_level(std::span<const std::uint64_t> codes, unsigned level) const {
  const unsigned shift = 3 * level;
  std::size_t cells = 1;
  for (std::size_t i = 1; i < codes.size(); ++i) {
    if (codes[i] >> shift != codes[i - 1] >> shift) ++cells;
  }
  Level made;
  made.entries.resize(std::bit_ceil(2 * cells));
  const std::size_t mask = made.entries.size() - 1;
  for (std::size_t begin = 0; begin < codes.size();) {
    const std::uint64_t code = codes[begin] >> shift;
    std::size_t end = begin + 1;
    while (end < codes.size() && codes[end] >> shift == code) ++end;
    std::size_t slot = mix_bits(code) & mask;
    while (made.entries[slot].run.end != 0) slot = (slot + 1) & mask;
    made.entries[slot] = {code,
                          {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)}};
    begin = end;
  }
  return made;
}

PhotonMap::Run PhotonMap::Level::find(std::uint64_t code) const {
  const std::size_t mask = entries.size() - 1;
  for (std::size_t slot = mix_bits(code) & mask;; slot = (slot + 1) & mask) {
    const Entry& entry = entries[slot];
    if (entry.run.end == 0 || entry.code == code) return entry.run;
  }
}

bool PhotonMap::reaches(Vec3f at, float radius) const {
  if (photons_.empty()) return false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(at[axis] >= low_[axis] - radius && at[axis] <= high_[axis] + radius)) return false;
  }
  return true;
}

std::array<PhotonMap::Run, 8> PhotonMap::runs_near(Vec3f at, double radius) const {
  unsigned level = 0;
  double side = cell_;
  while (side < ball * radius && level + 1 < levels_.size()) ++level, side *= 2.0;
  const auto r = static_cast<float>(radius);
  const Vec3f reach{r, r, r};
  const Cell low = cell_of(at - reach), high = cell_of(at + reach);
  std::array<Run, 8> runs;
  std::array<std::array<std::uint32_t, 2>, 3> cells;
  std::array<std::size_t, 3> counts;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    cells[axis] = {low.at[axis] >> level, high.at[axis] >> level};
    counts[axis] = cells[axis][0] == cells[axis][1] ? 1 : 2;
  }
  for (std::size_t z = 0; z < counts[2]; ++z) {
    for (std::size_t y = 0; y < counts[1]; ++y) {
      for (std::size_t x = 0; x < counts[0]; ++x) {
        runs[x + 2 * y + 4 * z] =
            levels_[level].find(morton(cells[0][x], cells[1][y], cells[2][z]));
      }
    }
  }
  return runs;
}

}  // namespace lapidary::transport
