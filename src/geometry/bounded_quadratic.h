#pragma once

#include "geometry/plane_crossing.h"

namespace lapidary::geometry {

/// f(s) = a s^2 + 2 b s + c (note the 2) whose coefficients are known within their errors.
struct BoundedQuadratic {
  Bounded a, b, c;
};

/// Where f changes sign, in ascending order. The sign of an f that is zero everywhere, to within
/// its errors, is undecided.
struct SignChanges {
  enum class Start : std::uint8_t { negative, positive, undecided };

  Start start;  ///< the sign at s = -infinity
  int count = 0;
  Bounded s[2];
};

/// All sign changes of f, with bounds that hold for every f within the errors.
///
/// A leading coefficient within twice its error of zero counts as zero: the far root of such an f
/// is further away than |b / a error|, and counts as infinitely far. Likewise b, for a constant,
/// and a near root that is itself about as far.
///
/// Error analysis. The two roots of the computed f are found to 5 u |s|: the discriminant has a
/// relative error of 3 u (Jeannerod, Louvet & Muller 2013), so its root 2.5 u, and neither -b -
/// root nor the quotients cancel. At a distance x from such a root s the exact f differs from
/// +-2 root x by at most
///     e + 2 x (a error |s| + b error) + (|a| + a error) x^2,
///     e = a error s^2 + 2 b error |s| + c error.
/// With h = root - a error |s| - b error > 0 and (|a| + a error) e < h^2, f has certain and
/// different signs at x = +-e/h, so exactly one exact root is within e/h of s. Otherwise the line
/// is close to a tangent. Exact roots lie where |computed f| is at most the error: out of the two
/// roots by at most the x of (|a| - a error) x^2 + 2 h x = e, e and h of the worse root, and
/// anywhere between them; so that x and the roots' distance together bound all errors.
SignChanges sign_changes(const BoundedQuadratic& f);

}  // namespace lapidary::geometry
