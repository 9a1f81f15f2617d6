#include "geometry/triangle_scene.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <algorithm>
#include <map>
#include <utility>

#include "base/error.h"
#include "geometry/bvh.h"
#include "geometry/rounded_bounds.h"
#include "math/constants.h"

namespace lapidary::geometry {
namespace {

constexpr RTCSceneFlags scene_flags = RTC_SCENE_FLAG_ROBUST;
constexpr RTCBuildQuality build_quality = RTC_BUILD_QUALITY_MEDIUM;

using DeviceHandle = std::shared_ptr<std::remove_pointer_t<RTCDevice>>;
using SceneHandle = std::unique_ptr<std::remove_pointer_t<RTCScene>, decltype(&rtcReleaseScene)>;
using GeometryHandle =
    std::unique_ptr<std::remove_pointer_t<RTCGeometry>, decltype(&rtcReleaseGeometry)>;

/// One instruction set on every machine, so that every machine finds the same hits; threads stay
/// where the pool put them.
DeviceHandle new_device() {
  // No number of threads: Embree would hold all of the process to it for the life of the device.
  const DeviceHandle device(rtcNewDevice("isa=avx2,set_affinity=0"), &rtcReleaseDevice);
  if (!device) throw Error({}, "the ray tracing library Embree could not be started");
  return device;
}

SceneHandle new_scene(RTCDevice device) {
  SceneHandle scene(rtcNewScene(device), &rtcReleaseScene);
  rtcSetSceneFlags(scene.get(), scene_flags);
  rtcSetSceneBuildQuality(scene.get(), build_quality);
  return scene;
}

void intersect(RTCScene scene, RTCRayHit& query) {
#if RTC_VERSION_MAJOR >= 4
  rtcIntersect1(scene, &query);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &query);
#endif
}

void occlude(RTCScene scene, RTCRay& query) {
#if RTC_VERSION_MAJOR >= 4
  rtcOccluded1(scene, &query);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene, &context, &query);
#endif
}

float float_limit(double t) {
  const float f = static_cast<float>(t);
  return static_cast<double>(f) < t ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

void set_ray(RTCRay& ray, const Line& line, Vec3d center, double t_max) {
  ray.org_x = static_cast<float>(line.origin.x - center.x);
  ray.org_y = static_cast<float>(line.origin.y - center.y);
  ray.org_z = static_cast<float>(line.origin.z - center.z);
  ray.dir_x = static_cast<float>(line.direction.x);
  ray.dir_y = static_cast<float>(line.direction.y);
  ray.dir_z = static_cast<float>(line.direction.z);
  ray.tnear = 0.0f;
  ray.tfar = float_limit(t_max);
  ray.time = 0.0f;
  ray.mask = ~0u;
  ray.id = 0;
  ray.flags = 0;
}

}  // namespace

struct TriangleScene::State {
  /// Vertices as Embree sees them, padded for its 16-byte loads; relative to `center` for a flat
  /// mesh, to the mesh's own origin for an instanced one.
  struct Vertices {
    std::vector<Vec3f> positions;
  };
  /// A mesh in its own coordinates, which all that use it share.
  struct SharedMesh {
    std::shared_ptr<const TriangleMesh> mesh;
    Vertices vertices;
    SceneHandle scene{nullptr, &rtcReleaseScene};
  };
  struct Placed {
    MeshPlacement placement;
    const Vertices* vertices = nullptr;
    bool instanced = false;
    Transform center_from_vertices;  ///< for instanced ones
    Vec3d origin;  ///< for flat and moving ones: what their vertices are relative to
    RTCScene own_scene = nullptr;  ///< for moving ones

    Vec3d vertex(std::uint32_t index) const { return Vec3d(vertices->positions[index]); }
  };

  std::vector<Placed> placed;
  std::vector<std::uint32_t> moving;  ///< of `placed`
  Bvh moving_boxes;
  std::map<const TriangleMesh*, std::shared_ptr<const SharedMesh>> shared_meshes;
  std::vector<std::unique_ptr<Vertices>> own_vertices;
  Vec3d center;
  Box3d bounds;
  DeviceHandle device;
  SceneHandle scene{nullptr, &rtcReleaseScene};

  void build(ThreadPool& pool, const State* earlier);
  void attach(RTCScene into, const TriangleMesh& mesh, const Vertices& vertices, unsigned id) const;
  void attach_instance(RTCScene of, const Transform& center_from_vertices, unsigned id);
  void add_flat(unsigned id);
  void add_instanced(unsigned id, const State* earlier);
  void add_moving(unsigned id, const State* earlier);
  const SharedMesh& shared(const std::shared_ptr<const TriangleMesh>& mesh, const State* earlier);
  std::shared_ptr<const SharedMesh> find_shared(const TriangleMesh& mesh) const;
  void build_moving_boxes();
};

void TriangleScene::State::attach(RTCScene into, const TriangleMesh& mesh, const Vertices& vertices,
                                  unsigned id) const {
  const GeometryHandle geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE),
                                &rtcReleaseGeometry);
  rtcSetGeometryBuildQuality(geometry.get(), build_quality);
  rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             vertices.positions.data(), 0, sizeof(Vec3f), mesh.positions.size());
  rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             mesh.triangles.data(), 0, sizeof(mesh.triangles[0]),
                             mesh.triangles.size());
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometryByID(into, geometry.get(), id);
}

void TriangleScene::State::attach_instance(RTCScene of, const Transform& center_from_vertices,
                                           unsigned id) {
  const GeometryHandle instance(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_INSTANCE),
                                &rtcReleaseGeometry);
  std::array<float, 12> matrix;  // 3x4, by columns
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      matrix[3 * column + row] = static_cast<float>(center_from_vertices.linear().row[row][column]);
    }
    matrix[9 + row] = static_cast<float>(center_from_vertices.offset()[row]);
  }
  rtcSetGeometryInstancedScene(instance.get(), of);
  rtcSetGeometryTransform(instance.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, matrix.data());
  rtcCommitGeometry(instance.get());
  rtcAttachGeometryByID(scene.get(), instance.get(), id);
}

void TriangleScene::State::add_flat(unsigned id) {
  Placed& p = placed[id];
  const TriangleMesh& mesh = *p.placement.mesh;
  auto vertices = std::make_unique<Vertices>();
  vertices->positions.reserve(mesh.positions.size() + 1);
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3d world = p.placement.world_from_mesh.point(mesh.position(i));
    vertices->positions.push_back(Vec3f(world - center));
  }
  vertices->positions.emplace_back();
  attach(scene.get(), mesh, *vertices, id);
  p.vertices = vertices.get();
  p.origin = center;
  own_vertices.push_back(std::move(vertices));
}

void TriangleScene::State::add_instanced(unsigned id, const State* earlier) {
  Placed& p = placed[id];
  const SharedMesh& mesh = shared(p.placement.mesh, earlier);
  p.instanced = true;
  p.vertices = &mesh.vertices;
  p.center_from_vertices = Transform::translation(-center) * p.placement.world_from_mesh *
                           Transform::translation(mesh.mesh->origin);
  attach_instance(mesh.scene.get(), p.center_from_vertices, id);
}

/// By content where it is not the very same.
std::shared_ptr<const TriangleScene::State::SharedMesh> TriangleScene::State::find_shared(
    const TriangleMesh& mesh) const {
  if (const auto found = shared_meshes.find(&mesh); found != shared_meshes.end()) {
    return found->second;
  }
  const auto found = std::ranges::find_if(
      shared_meshes, [&](const auto& entry) { return *entry.second->mesh == mesh; });
  return found == shared_meshes.end() ? nullptr : found->second;
}

const TriangleScene::State::SharedMesh& TriangleScene::State::shared(
    const std::shared_ptr<const TriangleMesh>& mesh, const State* earlier) {
  auto& entry = shared_meshes[mesh.get()];
  if (entry) return *entry;
  if (earlier != nullptr) entry = earlier->find_shared(*mesh);
  if (entry) return *entry;
  const auto fresh = std::make_shared<SharedMesh>();
  fresh->mesh = mesh;
  fresh->vertices.positions = mesh->positions;
  fresh->vertices.positions.emplace_back();
  fresh->scene = new_scene(device.get());
  attach(fresh->scene.get(), *mesh, fresh->vertices, 0);
  rtcCommitScene(fresh->scene.get());
  entry = fresh;
  return *entry;
}

void TriangleScene::State::add_moving(unsigned id, const State* earlier) {
  Placed& p = placed[id];
  const SharedMesh& mesh = shared(p.placement.mesh, earlier);
  p.own_scene = mesh.scene.get();
  p.vertices = &mesh.vertices;
  p.origin = mesh.mesh->origin;
  moving.push_back(id);
}

void TriangleScene::State::build_moving_boxes() {
  std::vector<Box3d> boxes;
  for (const std::uint32_t id : moving) {
    const MeshPlacement& p = placed[id].placement;
    // The float traversal may find what is a rounding of its coordinates outside of the box.
    const Box3d box = p.motion->swept(geometry::bounds(*p.mesh));
    boxes.push_back(padded(box, 0x1p-20 * max_component(box.extent())));
  }
  moving_boxes = Bvh(boxes);
}

void TriangleScene::State::build(ThreadPool& pool, const State* earlier) {
  std::map<const TriangleMesh*, int> uses;
  for (const Placed& p : placed) {
    if (!p.placement.motion) ++uses[p.placement.mesh.get()];
  }
  // What is shared with an earlier scene lives on its device.
  device = earlier != nullptr && earlier->device ? earlier->device : new_device();
  scene = new_scene(device.get());
  pool.run_inside([&] {
    for (unsigned id = 0; id < placed.size(); ++id) {
      if (placed[id].placement.motion) {
        add_moving(id, earlier);
      } else if (uses[placed[id].placement.mesh.get()] == 1) {
        add_flat(id);
      } else {
        add_instanced(id, earlier);
      }
    }
    rtcCommitScene(scene.get());
  });
  build_moving_boxes();
  if (rtcGetDeviceError(device.get()) != RTC_ERROR_NONE) {
    throw Error({}, "the triangles could not be put into a ray tracing structure",
                "is there enough memory?");
  }
}

bool is_same(const MeshPlacement& a, const MeshPlacement& b) {
  const bool same_mesh = a.mesh == b.mesh || *a.mesh == *b.mesh;
  const bool same_motion = a.motion == b.motion || (a.motion && b.motion && *a.motion == *b.motion);
  return a.world_from_mesh == b.world_from_mesh && same_motion && same_mesh;
}

TriangleScene::TriangleScene() : state_(std::make_shared<const State>()) {}

TriangleScene::TriangleScene(std::vector<MeshPlacement> placements, ThreadPool& pool,
                             const TriangleScene* earlier)
    : TriangleScene() {
  const auto placement_of = [](const State::Placed& p) -> const MeshPlacement& {
    return p.placement;
  };
  if (placements.empty()) return;
  if (earlier != nullptr &&
      std::ranges::equal(placements, earlier->state_->placed, is_same, {}, placement_of)) {
    state_ = earlier->state_;
    return;
  }
  const auto fresh = std::make_shared<State>();
  for (MeshPlacement& placement : placements) {
    const Box3d own = geometry::bounds(*placement.mesh);
    fresh->bounds.extend(placement.motion ? placement.motion->swept(own)
                                          : placement.world_from_mesh.box(own));
    fresh->placed.push_back({.placement = std::move(placement)});
  }
  fresh->center = fresh->bounds.center();
  fresh->build(pool, earlier != nullptr ? earlier->state_.get() : nullptr);
  state_ = fresh;
}

bool TriangleScene::empty() const {
  return state_->placed.empty();
}

bool TriangleScene::nearest(const Line& line, double t_max, TriangleHit& hit, double time) const {
  const State& s = *state_;
  if (s.placed.empty()) return false;
  RTCRayHit query;
  const auto find = [&](RTCScene scene, const Line& in, Vec3d center, double far) {
    set_ray(query.ray, in, center, far);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    intersect(scene, query);
    return query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
  };
  const auto found = [&](std::uint32_t placement) -> TriangleHit {
    return {static_cast<double>(query.ray.tfar), placement, query.hit.primID,
            static_cast<double>(query.hit.u), static_cast<double>(query.hit.v)};
  };
  bool any = find(s.scene.get(), line, s.center, t_max);
  if (any) {
    const bool instanced = query.hit.instID[0] != RTC_INVALID_GEOMETRY_ID;
    hit = found(instanced ? query.hit.instID[0] : query.hit.geomID);
  }
  s.moving_boxes.walk(line, any ? hit.t : t_max, [&](std::uint32_t i, double& far) {
    const State::Placed& p = s.placed[s.moving[i]];
    const Line own = p.placement.motion->space_at(time).line(line);
    if (!find(p.own_scene, own, p.origin, far)) return false;
    hit = found(s.moving[i]);
    far = hit.t;
    any = true;
    return false;
  });
  return any;
}

bool TriangleScene::occluded(const Line& line, double t_max, double time) const {
  const State& s = *state_;
  if (s.placed.empty()) return false;
  RTCRay query;
  set_ray(query, line, s.center, t_max);
  occlude(s.scene.get(), query);
  if (query.tfar < 0.0f) return true;
  return s.moving_boxes.walk(line, t_max, [&](std::uint32_t i, double& far) {
    const State::Placed& p = s.placed[s.moving[i]];
    set_ray(query, p.placement.motion->space_at(time).line(line), p.origin, far);
    occlude(p.own_scene, query);
    return query.tfar < 0.0f;
  });
}

void TriangleScene::refine(const Line& line, const Corners& c, TriangleHit& hit) {
  const Vec3d e1 = c.p1 - c.p0, e2 = c.p2 - c.p0;
  const Vec3d s = cross(line.direction, e2);
  const double det = dot(e1, s);
  const double size = length_squared(e1) * length_squared(s);
  if (!(det * det > 1e-24 * size)) return;
  const Vec3d to_origin = line.origin - c.p0;
  const Vec3d q = cross(to_origin, e1);
  const double inverse = 1.0 / det;
  hit.t = dot(e2, q) * inverse;
  hit.b1 = std::clamp(dot(to_origin, s) * inverse, 0.0, 1.0);
  hit.b2 = std::clamp(dot(line.direction, q) * inverse, 0.0, 1.0 - hit.b1);
}

Corners TriangleScene::corners(std::uint32_t placement, std::uint32_t triangle, double time) const {
  const State::Placed& p = state_->placed[placement];
  const auto& index = p.placement.mesh->triangles[triangle];
  const Corners c{p.vertex(index[0]), p.vertex(index[1]), p.vertex(index[2])};
  if (p.instanced) {
    const auto world = [&](Vec3d q) { return p.center_from_vertices.point(q) + state_->center; };
    return {world(c.p0), world(c.p1), world(c.p2)};
  }
  const Corners moved{c.p0 + p.origin, c.p1 + p.origin, c.p2 + p.origin};
  if (!p.placement.motion) return moved;
  const Transform map = p.placement.motion->at(time);
  return {map.point(moved.p0), map.point(moved.p1), map.point(moved.p2)};
}

const MeshPlacement& TriangleScene::placement(std::uint32_t index) const {
  return state_->placed[index].placement;
}

double TriangleScene::self_distance(Vec3d p, std::uint32_t placement, const Corners& c,
                                    double time) const {
  // In units of 2^-24: rounding the origin moves it by one per axis of its distance from the
  // centre; the edge tests of the robust traversal err by a few per edge length; an instance's
  // matrix, rounded and applied, by some four more of both.
  const State::Placed& placed = state_->placed[placement];
  const double edge = std::max(max_component(abs(c.p1 - c.p0)), max_component(abs(c.p2 - c.p0)));
  if (placed.placement.motion) {
    // In its own coordinates, on the way back at most as much longer as the map makes any vector.
    const Transform map = placed.placement.motion->at(time), inverse = map.inverse();
    const double distance = max_component(abs(inverse.point(p) - placed.origin));
    const double own_edge = frobenius_norm(inverse.linear()) * edge;
    return 0x1p-24 * 4.0 * frobenius_norm(map.linear()) * (distance + own_edge);
  }
  const double distance = max_component(abs(p - state_->center));
  const double factor = placed.instanced ? 12.0 : 4.0;
  return 0x1p-24 * factor * (distance + edge);
}

double TriangleScene::float_error() const {
  const Box3d& box = state_->bounds;
  return box.empty() ? 0.0 : 0x1p-24 * 12.0 * 1.5 * max_component(box.extent());
}

Box3d TriangleScene::bounds() const {
  return state_->bounds;
}

std::size_t TriangleScene::triangle_count() const {
  std::size_t count = 0;
  for (const State::Placed& p : state_->placed) count += p.placement.mesh->triangles.size();
  return count;
}

void* TriangleScene::native_scene() const {
  return state_->scene.get();
}

}  // namespace lapidary::geometry
