#include "geometry/compound_surface.h"

#include <algorithm>

namespace lapidary::geometry {
namespace {

std::vector<double> measures(const std::vector<CompoundSurface::Piece>& pieces) {
  std::vector<double> all;
  all.reserve(pieces.size());
  for (const CompoundSurface::Piece& piece : pieces) all.push_back(piece.surface.measure());
  return all;
}

}  // namespace

CompoundSurface::CompoundSurface(std::vector<Piece> pieces)
    : pieces_(std::move(pieces)), by_measure_(measures(pieces_)) {}

std::optional<CompoundSurface::Point> CompoundSurface::draw(Vec2d u, double part,
                                                            const std::optional<Vec3d>& eye) const {
  const auto choice = by_measure_.sample(part);
  const Piece& piece = pieces_[choice.index];
  auto drawn = piece.surface.draw(u, choice.remainder, eye);
  if (!drawn) return std::nullopt;
  drawn->density *= choice.probability;
  return Point{piece.leaf, *drawn};
}

double CompoundSurface::density(std::uint32_t leaf, Patch patch, Vec3d p) const {
  const auto found = std::ranges::lower_bound(pieces_, leaf, {}, &Piece::leaf);
  if (found == pieces_.end() || found->leaf != leaf) return 0.0;
  const auto index = static_cast<std::size_t>(found - pieces_.begin());
  return by_measure_.probability(index) * found->surface.density(patch, p);
}

Box3d CompoundSurface::bounds() const {
  Box3d all;
  for (const Piece& piece : pieces_) all.extend(piece.surface.box());
  return all;
}

}  // namespace lapidary::geometry
