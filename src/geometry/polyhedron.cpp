#include "geometry/polyhedron.h"

#include <algorithm>

#include <immintrin.h>

#include "base/error.h"
#include "geometry/affine_area.h"
#include "geometry/affine_error.h"
#include "geometry/convex_hull.h"
#include "geometry/polyhedron_data.h"
#include "math/same_bits.h"
#include "sampling/warp.h"

namespace lapidary::geometry {
namespace {

using Data = Polyhedron::Data;

Vec3d area_vector(const Data::Piece& piece) {
  const auto& [a, b, c] = piece.corners;
  return cross(b - a, c - a) * 0.5;
}

std::vector<Data::Planes> in_fours(const std::vector<HalfSpace>& faces) {
  std::vector<Data::Planes> planes((faces.size() + Data::lanes - 1) / Data::lanes);
  for (std::size_t i = 0; i < planes.size() * Data::lanes; ++i) {
    const HalfSpace& face = faces[std::min(i, faces.size() - 1)];
    Data::Planes& four = planes[i / Data::lanes];
    const std::size_t lane = i % Data::lanes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      four.point[axis][lane] = face.point[axis];
      four.normal[axis][lane] = face.normal[axis];
    }
    const Vec3d n = abs(face.normal);
    four.normal_length[lane] = n.x + n.y + n.z;
  }
  return planes;
}

}  // namespace

Data::Data(std::vector<HalfSpace> faces_, double normal_roundings_, std::vector<Piece> pieces_,
           const Box3d& box_)
    : faces(std::move(faces_)),
      normal_roundings(normal_roundings_),
      planes(in_fours(faces)),
      pieces(std::move(pieces_)),
      box(box_) {
  if (pieces.empty()) return;
  area = volume = 0;
  const Vec3d tip = pieces[0].corners[0];
  for (const Piece& piece : pieces) {
    const Vec3d n = area_vector(piece);
    area_to.push_back(area += length(n));
    volume += dot(piece.corners[0] - tip, n) / 3.0;
  }
}

/// All else follows from this.
bool has_same_content(const Polyhedron& a, const Polyhedron& b) {
  const Data &p = *a.data_, &q = *b.data_;
  if (&p == &q) return true;
  const auto same_piece = [](const Data::Piece& x, const Data::Piece& y) {
    return same_bits(x.corners, y.corners) && x.patch == y.patch;
  };
  return same_bits(p.faces, q.faces) && same_bits(p.normal_roundings, q.normal_roundings) &&
         same_bits(p.box, q.box) && std::ranges::equal(p.pieces, q.pieces, same_piece);
}

std::optional<Polyhedron> intersection(std::span<const HalfSpace> half_spaces) {
  PolyhedronFaces found = faces_of_intersection(half_spaces);
  if (!found.has_volume) return std::nullopt;
  std::vector<HalfSpace> faces(half_spaces.begin(), half_spaces.end());
  return Polyhedron(
      std::make_shared<const Data>(std::move(faces), 0, std::move(found.pieces), found.box));
}

Polyhedron image(const Polyhedron& bounded, std::span<const HalfSpace> planes,
                 const Transform& map) {
  const bool mirrored = map.mirrors();
  std::vector<Data::Piece> pieces;
  Box3d box;
  for (Data::Piece piece : bounded.data_->pieces) {
    for (Vec3d& corner : piece.corners) box.extend(corner = map.point(corner));
    if (mirrored) std::swap(piece.corners[1], piece.corners[2]);
    pieces.push_back(piece);
  }
  std::vector<HalfSpace> faces(planes.begin(), planes.end());
  return Polyhedron(std::make_shared<const Data>(std::move(faces), 0, std::move(pieces), box));
}

namespace {

__extension__ typedef __float128 Quad;

/// The plane of a triangle, its normal right to one rounding: 113 bits leave 60 for cancellation.
HalfSpace plane_of(Vec3d a, Vec3d b, Vec3d c) {
  const auto component = [&](std::size_t i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    return static_cast<double>((Quad(b[j]) - a[j]) * (Quad(c[k]) - a[k]) -
                               (Quad(b[k]) - a[k]) * (Quad(c[j]) - a[j]));
  };
  return {a, {component(0), component(1), component(2)}};
}

}  // namespace

Polyhedron hull_of(std::span<const Vec3d> points) {
  const ConvexHull hull = convex_hull(points);
  if (hull.triangles.empty()) {
    throw Error({}, "the points lie in one plane, so their hull has no volume",
                "a polyhedron needs at least four points, not all in a plane");
  }
  std::vector<HalfSpace> faces(hull.face_count);
  std::vector<double> sizes(hull.face_count, 0.0);
  std::vector<Data::Piece> pieces;
  Box3d box;
  for (std::size_t i = 0; i < hull.triangles.size(); ++i) {
    const auto& [a, b, c] = hull.triangles[i];
    pieces.push_back({{points[a], points[b], points[c]}, hull.faces[i]});
    for (const Vec3d& p : pieces.back().corners) box.extend(p);
    // The largest triangle of a face has the normal with the least cancellation.
    const double size = length(area_vector(pieces.back()));
    if (size < sizes[hull.faces[i]]) continue;
    sizes[hull.faces[i]] = size;
    faces[hull.faces[i]] = plane_of(points[a], points[b], points[c]);
  }
  return Polyhedron(std::make_shared<const Data>(std::move(faces), 1, std::move(pieces), box));
}

HalfSpace Polyhedron::face(Patch patch) const {
  return data_->faces[patch];
}

std::size_t Polyhedron::face_count() const {
  return data_->faces.size();
}

double Polyhedron::volume() const {
  return data_->volume;
}

Vec3d outward_normal(const Polyhedron& polyhedron, Patch patch, Vec3d) {
  return normalize(polyhedron.data_->faces[patch].normal);
}

SurfaceUv surface_uv(const Polyhedron& polyhedron, Patch patch, Vec3d p) {
  return surface_uv(polyhedron.data_->faces[patch], 0, p);
}

bool contains(const Polyhedron& polyhedron, Vec3d p) {
  return std::ranges::all_of(polyhedron.data_->faces,
                             [&](const HalfSpace& face) { return contains(face, p); });
}

Box3d bounds(const Polyhedron& polyhedron) {
  return polyhedron.data_->box;
}

double area(const Polyhedron& polyhedron) {
  return polyhedron.data_->area;
}

BoundaryPoint sample_boundary(const Polyhedron& polyhedron, Vec2d u, double u_patch) {
  const Data& data = *polyhedron.data_;
  if (data.pieces.empty()) {
    return {data.faces[0].point, normalize(data.faces[0].normal), 0, 0.0};
  }
  const auto found = std::ranges::upper_bound(data.area_to, u_patch * data.area);
  const auto last = static_cast<std::ptrdiff_t>(data.area_to.size()) - 1;
  const auto& [corners, patch] =
      data.pieces[static_cast<std::size_t>(std::min(found - data.area_to.begin(), last))];
  const Vec2d b = sample_triangle(u);
  const Vec3d p = corners[0] + (corners[1] - corners[0]) * b.x + (corners[2] - corners[0]) * b.y;
  return {p, outward_normal(polyhedron, patch, p), patch, 1.0 / data.area};
}

namespace {

/// A ball inside of all planes.
struct Ball {
  Vec3d center;
  double radius = 0;  ///< not positive where none was found
};

Ball ball_inside(const Data& data) {
  Ball ball{{}, infinity};
  const double share = 1.0 / (3.0 * static_cast<double>(data.pieces.size()));
  for (const Data::Piece& piece : data.pieces) {
    for (const Vec3d& corner : piece.corners) ball.center += corner * share;
  }
  for (const HalfSpace& face : data.faces) {
    const double height = dot(ball.center - face.point, normalize(face.normal));
    const double error = 16 * rounding_unit * (one_norm(ball.center) + one_norm(face.point));
    ball.radius = std::min(ball.radius, -height - error);
  }
  return ball;
}

std::optional<Polyhedron> displaced_outwards(const std::vector<HalfSpace>& faces, double error) {
  std::vector<HalfSpace> displaced;
  for (HalfSpace face : faces) {
    // The point rounds by less than what is added to the error here.
    const double shift = 2 * error + 4 * rounding_unit * one_norm(face.point);
    face.point += normalize(face.normal) * shift;
    displaced.push_back(face);
  }
  return intersection(displaced);
}

}  // namespace

Box3d displaced_bounds(const Polyhedron& polyhedron, double error) {
  const Data& data = *polyhedron.data_;
  if (error == 0.0) return data.box;
  // Planes at least a radius away from a point are no further out than those of the same solid
  // made larger about that point, by the displacement over the radius.
  const Ball ball = data.pieces.empty() ? Ball{} : ball_inside(data);
  if (const double growth = error / ball.radius; ball.radius > 0 && growth < 0x1p-20) {
    const Vec3d reach = max(abs(data.box.min - ball.center), abs(data.box.max - ball.center));
    const double rounding = 4 * rounding_unit * one_norm(max(abs(data.box.min), abs(data.box.max)));
    const Vec3d more = reach * (2 * growth) + Vec3d{rounding, rounding, rounding};
    return {data.box.min - more, data.box.max + more};
  }
  const auto displaced = displaced_outwards(data.faces, error);
  return displaced ? displaced->data_->box : Box3d::all();
}

Box3d affine_bounds(const Polyhedron& polyhedron, const Transform& map) {
  if (polyhedron.data_->pieces.empty()) return map.box(polyhedron.data_->box);
  Box3d box;
  for (const Data::Piece& piece : polyhedron.data_->pieces) {
    for (const Vec3d& corner : piece.corners) box.extend(map.point(corner));
  }
  return box;
}

double affine_area(const Polyhedron& polyhedron, const Mat3& linear) {
  if (polyhedron.data_->pieces.empty()) return infinity;
  const Mat3 areas = cofactors(linear);
  double area = 0;
  for (const Data::Piece& piece : polyhedron.data_->pieces) {
    area += length(areas * area_vector(piece));
  }
  return area;
}

std::vector<UvChart> uv_charts(const Polyhedron& polyhedron) {
  std::vector<UvChart> charts;
  for (Patch face = 0; face < polyhedron.face_count(); ++face) {
    charts.push_back(planar_chart(face));
  }
  return charts;
}

std::optional<PatchPoint> point_at(const Polyhedron& polyhedron, const UvChart& chart, Vec2d uv) {
  return point_at(polyhedron.face(chart.first), chart, uv);
}

}  // namespace lapidary::geometry
