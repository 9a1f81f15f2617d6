// What our nearest-hit query costs on top of Embree's own, on incoherent rays in a million
// triangles: same rays, same RTCScene, one thread, in turns.

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <random>
#include <vector>

#include "blob.h"
#include "geometry/world.h"
#include "report.h"

namespace {

using namespace lapidary;

std::vector<geometry::Ray> incoherent_rays(std::size_t count) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> gauss;
  const auto direction = [&] {
    return normalize(Vec3d{gauss(random), gauss(random), gauss(random)});
  };
  std::vector<geometry::Ray> rays(count);
  for (geometry::Ray& ray : rays) {
    ray.origin = direction() * 2.0;
    ray.direction = normalize(direction() * 0.9 - ray.origin);
  }
  return rays;
}

std::size_t count_hits(const geometry::World& world, const std::vector<geometry::Ray>& rays) {
  std::size_t hits = 0;
  for (const geometry::Ray& ray : rays) hits += std::isfinite(world.nearest(ray).t) ? 1 : 0;
  return hits;
}

RTCRayHit query(const geometry::Ray& ray) {
  RTCRayHit q{};
  q.ray.org_x = static_cast<float>(ray.origin.x);
  q.ray.org_y = static_cast<float>(ray.origin.y);
  q.ray.org_z = static_cast<float>(ray.origin.z);
  q.ray.dir_x = static_cast<float>(ray.direction.x);
  q.ray.dir_y = static_cast<float>(ray.direction.y);
  q.ray.dir_z = static_cast<float>(ray.direction.z);
  q.ray.tfar = std::numeric_limits<float>::infinity();
  q.ray.mask = ~0u;
  q.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  q.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return q;
}

std::size_t count_bare_hits(RTCScene scene, const std::vector<geometry::Ray>& rays) {
  std::size_t hits = 0;
  for (const geometry::Ray& ray : rays) {
    RTCRayHit q = query(ray);
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(scene, &q);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &q);
#endif
    hits += q.hit.geomID != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
  }
  return hits;
}

}  // namespace

int main() {
  ThreadPool pool(1);
  geometry::World::Parts parts;
  parts.meshes.push_back({std::make_shared<geometry::TriangleMesh>(bench::blob()), {}});
  const geometry::World world(std::move(parts), pool);
  const auto bare_scene = static_cast<RTCScene>(world.triangles().native_scene());

  const auto rays = incoherent_rays(1'000'000);
  std::vector<double> ratios, rates;
  for (int i = 0; i < 7; ++i) {
    std::size_t ours = 0, bare = 0;
    const double bare_time = bench::seconds([&] { bare = count_bare_hits(bare_scene, rays); });
    const double our_time = bench::seconds([&] { ours = count_hits(world, rays); });
    if (ours + 100 < bare || bare + 100 < ours) return 1;
    ratios.push_back(bare_time / our_time);
    rates.push_back(static_cast<double>(rays.size()) / our_time / 1e6);
  }
  const auto median = [](std::vector<double>& v) {
    std::sort(v.begin(), v.end());
    return v[v.size() / 2];
  };
  bench::report("mesh.nearest_mrays", median(rates), "M/s");
  bench::report("mesh.nearest_vs_embree", median(ratios), "ratio", ">=0.85");
}
