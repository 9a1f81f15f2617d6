#include "geometry/vertex_normals.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "math/constants.h"

namespace lapidary::geometry {
namespace {

Vec3f to_unit(Vec3d v) {
  const double squared = length_squared(v);
  return squared > 0 ? Vec3f(v * (1 / std::sqrt(squared))) : Vec3f();
}

struct Edges {
  Vec3d ab, bc, ca;
};

Edges edges_of(std::span<const Vec3f> positions, const TriangleIndices& t) {
  const Vec3d a(positions[t[0]]), b(positions[t[1]]), c(positions[t[2]]);
  return {b - a, c - b, a - c};
}

// Zero for a triangle of zero area.
Vec3f unit_normal(const Edges& e) {
  return to_unit(cross(e.ab, e.bc));
}

// Angle between the vectors of length la and lb that enclose it, from their dot product.
float angle(double dot_product, double la_lb) {
  return static_cast<float>(std::acos(std::clamp(dot_product / la_lb, -1.0, 1.0)));
}

// Angles at a, b and c of a triangle of nonzero area.
std::array<float, 3> corner_angles(const Edges& e) {
  const double ab = length(e.ab), bc = length(e.bc), ca = length(e.ca);
  const float at_a = angle(-dot(e.ab, e.ca), ab * ca);
  const float at_b = angle(-dot(e.ab, e.bc), ab * bc);
  return {at_a, at_b, std::max(static_cast<float>(pi) - at_a - at_b, 0.0F)};
}

struct Facets {
  std::vector<Vec3f> normals;       // one per triangle, unit length or zero
  std::vector<Vec3f> vertex_means;  // one per vertex, unit length or zero
};

Facets facets_of(std::span<const Vec3f> positions, std::span<const TriangleIndices> triangles) {
  Facets facets;
  facets.normals.reserve(triangles.size());
  facets.vertex_means.resize(positions.size());
  for (const TriangleIndices& t : triangles) {
    const Edges edges = edges_of(positions, t);
    const Vec3f n = unit_normal(edges);
    facets.normals.push_back(n);
    if (n == Vec3f()) continue;
    const std::array<float, 3> angles = corner_angles(edges);
    for (std::size_t k = 0; k < 3; ++k) facets.vertex_means[t[k]] += n * angles[k];
  }
  for (Vec3f& mean : facets.vertex_means) mean = to_unit(Vec3d(mean));
  return facets;
}

// A corner of a triangle at some vertex, with what normals there depend on.
struct Corner {
  std::uint32_t vertex = 0;
  std::uint32_t triangle = 0;
  std::uint32_t corner = 0;
};

// All corners at vertices marked in `chosen`, by vertex and then in order of triangles.
std::vector<Corner> corners_at(std::span<const std::uint8_t> chosen,
                               std::span<const TriangleIndices> triangles) {
  std::vector<std::uint32_t> next(chosen.size() + 1);  // at first one place on: counts
  for (const TriangleIndices& t : triangles) {
    for (const std::uint32_t v : t) next[v + 1] += chosen[v];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<Corner> corners(next.back());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t v = triangles[i][k];
      if (chosen[v]) corners[next[v]++] = {v, i, k};
    }
  }
  return corners;
}

// Gives the corners of a vertex that have the same class a normal of their own. Class numbers are
// below the number of corners, or equal to it for corners that get none.
class Splitter {
 public:
  Splitter(std::span<const Vec3f> positions, std::span<const TriangleIndices> triangles)
      : positions_(positions), triangles_(triangles) {}

  void split(std::span<const Corner> corners, std::span<const std::uint32_t> classes,
             SplitNormals& result) {
    add_up(corners, classes);
    const std::uint32_t vertex = corners[0].vertex;
    index_of_class_.assign(corners.size() + 1, none);
    index_of_class_[classes[0]] = vertex;
    result.normals[vertex] = to_unit(sums_[classes[0]]);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      std::uint32_t& index = index_of_class_[classes[k]];
      if (index == none) {
        index = static_cast<std::uint32_t>(result.normals.size());
        result.normals.push_back(to_unit(sums_[classes[k]]));
        result.added.push_back(vertex);
      }
      if (index != vertex) result.uses.push_back({corners[k].triangle, corners[k].corner, index});
    }
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  void add_up(std::span<const Corner> corners, std::span<const std::uint32_t> classes) {
    sums_.assign(corners.size() + 1, Vec3d());
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Edges edges = edges_of(positions_, triangles_[corners[k].triangle]);
      const Vec3f n = unit_normal(edges);
      if (n == Vec3f() || classes[k] == corners.size()) continue;
      sums_[classes[k]] += Vec3d(n) * static_cast<double>(corner_angles(edges)[corners[k].corner]);
    }
  }

  std::span<const Vec3f> positions_;
  std::span<const TriangleIndices> triangles_;
  std::vector<Vec3d> sums_;
  std::vector<std::uint32_t> index_of_class_;
};

// Calls `visit` with the corners of one vertex after the other.
template <typename Visit>
void for_each_vertex(std::span<const Corner> corners, Visit visit) {
  for (std::size_t begin = 0; begin < corners.size();) {
    std::size_t end = begin + 1;
    while (end < corners.size() && corners[end].vertex == corners[begin].vertex) ++end;
    visit(corners.subspan(begin, end - begin));
    begin = end;
  }
}

// Finds which corners of a vertex are joined by smooth edges.
class Fans {
 public:
  Fans(std::span<const Vec3f> facet_normals, std::span<const TriangleIndices> triangles,
       float least_cosine)
      : facet_normals_(facet_normals), triangles_(triangles), least_cosine_(least_cosine) {}

  // The class of each corner; corners are of one vertex.
  std::span<const std::uint32_t> classify(std::span<const Corner> corners) {
    parents_.resize(corners.size());
    std::iota(parents_.begin(), parents_.end(), 0U);
    spokes_.clear();
    for (std::uint32_t k = 0; k < corners.size(); ++k) {
      const TriangleIndices& t = triangles_[corners[k].triangle];
      spokes_.push_back({t[(corners[k].corner + 1) % 3], k});
      spokes_.push_back({t[(corners[k].corner + 2) % 3], k});
    }
    std::sort(spokes_.begin(), spokes_.end());
    for (std::size_t i = 1; i < spokes_.size(); ++i) {
      const auto [end_a, a] = spokes_[i - 1];
      const auto [end_b, b] = spokes_[i];
      if (end_a == end_b && smooth(corners[a].triangle, corners[b].triangle)) join(a, b);
    }
    for (std::uint32_t k = 0; k < parents_.size(); ++k) parents_[k] = root(k);
    return parents_;
  }

 private:
  bool smooth(std::uint32_t a, std::uint32_t b) const {
    return dot(facet_normals_[a], facet_normals_[b]) >= least_cosine_;
  }
  std::uint32_t root(std::uint32_t k) {
    while (parents_[k] != k) k = parents_[k] = parents_[parents_[k]];
    return k;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a), b = root(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

  std::span<const Vec3f> facet_normals_;
  std::span<const TriangleIndices> triangles_;
  float least_cosine_;
  std::vector<std::uint32_t> parents_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> spokes_;  // far vertex, corner
};

struct GroupsAtVertices {
  std::vector<std::uint32_t> first;  // of the first triangle at the vertex
  std::vector<std::uint8_t> mixed;   // 1 where triangles of several groups meet
};

GroupsAtVertices groups_at_vertices(std::size_t vertices,
                                    std::span<const TriangleIndices> triangles,
                                    std::span<const std::uint32_t> groups) {
  GroupsAtVertices at{std::vector<std::uint32_t>(vertices), std::vector<std::uint8_t>(vertices)};
  std::vector<std::uint8_t> seen(vertices);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (const std::uint32_t v : triangles[i]) {
      if (!seen[v]) at.first[v] = groups[i];
      if (at.first[v] != groups[i]) at.mixed[v] = 1;
      seen[v] = 1;
    }
  }
  return at;
}

// The class of a corner is the first corner of its group.
void classify_by_group(std::span<const Corner> corners, std::span<const std::uint32_t> groups,
                       std::vector<std::uint32_t>& classes) {
  const auto count = static_cast<std::uint32_t>(corners.size());
  const auto group = [&](std::uint32_t k) { return groups[corners[k].triangle]; };
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return group(a) < group(b); });
  classes.resize(count);
  for (std::uint32_t i = 0, first = 0; i < count; ++i) {
    if (group(order[i]) != group(order[first])) first = i;
    classes[order[i]] = group(order[i]) == 0 ? count : order[first];
  }
}

}  // namespace

std::vector<Vec3f> smooth_normals(std::span<const Vec3f> positions,
                                  std::span<const TriangleIndices> triangles) {
  return facets_of(positions, triangles).vertex_means;
}

SplitNormals normals_by_crease(std::span<const Vec3f> positions,
                               std::span<const TriangleIndices> triangles, double crease) {
  Facets facets = facets_of(positions, triangles);
  SplitNormals result;
  result.normals = std::move(facets.vertex_means);

  const auto least_cosine = [](double degrees) {
    return static_cast<float>(std::cos(radians(std::min(degrees, 180.0))));
  };
  const float near_mean = least_cosine(crease / 2);
  std::vector<std::uint8_t> creased(positions.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (facets.normals[i] == Vec3f()) continue;
    for (const std::uint32_t v : triangles[i]) {
      if (dot(facets.normals[i], result.normals[v]) < near_mean) creased[v] = 1;
    }
  }
  Splitter splitter(positions, triangles);
  Fans fans(facets.normals, triangles, least_cosine(crease));
  for_each_vertex(corners_at(creased, triangles), [&](std::span<const Corner> corners) {
    splitter.split(corners, fans.classify(corners), result);
  });
  return result;
}

SplitNormals normals_by_group(std::span<const Vec3f> positions,
                              std::span<const TriangleIndices> triangles,
                              std::span<const std::uint32_t> groups) {
  SplitNormals result;
  result.normals = smooth_normals(positions, triangles);
  const GroupsAtVertices at = groups_at_vertices(positions.size(), triangles, groups);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (at.first[v] == 0) result.normals[v] = Vec3f();
  }
  Splitter splitter(positions, triangles);
  std::vector<std::uint32_t> classes;
  for_each_vertex(corners_at(at.mixed, triangles), [&](std::span<const Corner> corners) {
    classify_by_group(corners, groups, classes);
    splitter.split(corners, classes, result);
  });
  return result;
}

}  // namespace lapidary::geometry
