#pragma once

#include "math/transform.h"

namespace lapidary::geometry {

/// How a linear map changes areas: an area with unit normal n becomes |cofactors(m) n| times as
/// large.
Mat3 cofactors(const Mat3& m);

/// Carlson's completely symmetric elliptic integral of the second kind R_G; arguments >= 0, at
/// most one of them zero.
/// Accuracy: about 4 ulp.
/// Source: Carlson 1995, "Numerical computation of real or complex elliptic integrals"; DLMF
/// 19.21.10 and 19.36.
double carlson_rg(double x, double y, double z);

/// Area of the image of the unit sphere: 4 pi R_G of the squared products of two semi-axes each.
/// Accuracy: relative 1e-14.
double ellipsoid_area(const Mat3& linear);

/// Length of the closed curve a cos(phi) + b sin(phi), an ellipse; a and b not parallel.
/// Accuracy: relative 1e-14.
double ellipse_perimeter(Vec3d a, Vec3d b);

/// The integral over phi from 0 to 2 pi of |a cos(phi) + b sin(phi) + c|: for c = 0 the perimeter
/// of an ellipse, otherwise what the area of a cone's side under an affine map comes down to.
/// Accuracy: relative 1e-13, by quadrature; about 10 microseconds.
double ellipse_distance_integral(Vec3d a, Vec3d b, Vec3d c);

}  // namespace lapidary::geometry
