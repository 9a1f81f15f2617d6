#include "math/axis_angle.h"

#include <cmath>

namespace lapidary {

// The unit quaternion (w, v), up to scale: the trace or the greatest entry of the diagonal says
// which of its four components is large enough to divide by.
AxisAngle least_turn(const Mat3& rotation) {
  const auto& m = rotation.row;
  const double trace = m[0].x + m[1].y + m[2].z;
  double w = 0;
  Vec3d v;
  const auto [i, j, k] = [&]() -> std::array<std::size_t, 3> {
    if (m[0].x >= m[1].y && m[0].x >= m[2].z) return {0, 1, 2};
    return m[1].y >= m[2].z ? std::array<std::size_t, 3>{1, 2, 0}
                            : std::array<std::size_t, 3>{2, 0, 1};
  }();
  if (trace >= m[i][i]) {
    w = 1.0 + trace;
    v = {m[2].y - m[1].z, m[0].z - m[2].x, m[1].x - m[0].y};
  } else {
    v[i] = 1.0 + m[i][i] - m[j][j] - m[k][k];
    v[j] = m[j][i] + m[i][j];
    v[k] = m[k][i] + m[i][k];
    w = m[k][j] - m[j][k];
  }
  if (w < 0.0) w = -w, v = -v;
  const double sine = length(v);
  if (sine == 0.0) return {};
  return {v / sine, 2.0 * std::atan2(sine, w)};
}

}  // namespace lapidary
