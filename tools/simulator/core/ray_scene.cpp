// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/core/ray_scene.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <vector>

#include <embree3/rtcore.h>

namespace enfilade::simulator {
namespace {

constexpr std::size_t kPacket = 8;
constexpr unsigned kOpaqueId = 0;
constexpr unsigned kGlassId = 1;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Vertex {
  float x, y, z;
};

struct Triangle {
  unsigned a, b, c;
};

struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;

  /// Both ends of a prism are fans from its first corner; rays see both sides of a triangle.
  void add(const Solid& solid) {
    const unsigned first = static_cast<unsigned>(vertices.size()),
                   n = static_cast<unsigned>(solid.base.size());
    for (const double z_m : {solid.bottom_m, solid.top_m})
      for (const Point2& p : solid.base)
        vertices.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(z_m)});
    const unsigned top = first + n;
    for (unsigned i = 1; i + 1 < n; ++i) {
      triangles.push_back({first, first + i, first + i + 1});
      triangles.push_back({top, top + i, top + i + 1});
    }
    for (unsigned i = 0; i < n; ++i) {
      const unsigned next = (i + 1) % n;
      triangles.push_back({first + i, first + next, top + next});
      triangles.push_back({first + i, top + next, top + i});
    }
  }
};

void attach(RTCDevice device, RTCScene scene, const Mesh& mesh, unsigned id) {
  if (mesh.triangles.empty()) return;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                           sizeof(Vertex), mesh.vertices.size());
  void* triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            sizeof(Triangle), mesh.triangles.size());
  std::memcpy(vertices, mesh.vertices.data(), mesh.vertices.size() * sizeof(Vertex));
  std::memcpy(triangles, mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle));
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, id);
  rtcReleaseGeometry(geometry);  // the scene keeps it alive
}

/// Rays beyond the end of the list point nowhere and are masked out.
void load(std::span<const Ray> rays, RTCRayHit8& packet, int (&valid)[kPacket]) {
  for (std::size_t i = 0; i < kPacket; ++i) {
    valid[i] = i < rays.size() ? -1 : 0;
    const Ray ray = i < rays.size() ? rays[i] : Ray{0, 0, 0, 1, 0, 0};
    packet.ray.org_x[i] = ray.ox, packet.ray.org_y[i] = ray.oy, packet.ray.org_z[i] = ray.oz;
    packet.ray.dir_x[i] = ray.dx, packet.ray.dir_y[i] = ray.dy, packet.ray.dir_z[i] = ray.dz;
    packet.ray.tnear[i] = 0.0f, packet.ray.tfar[i] = kInfinity;
    packet.ray.time[i] = 0.0f, packet.ray.mask[i] = ~0u, packet.ray.flags[i] = 0, packet.ray.id[i] = 0;
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
}

}  // namespace

class RayScene::Impl {
 public:
  explicit Impl(const World& world) : device_(rtcNewDevice("threads=1")) {
    if (!device_) throw std::runtime_error("Embree cannot start on this CPU: it needs SSE2 at least");
    Mesh opaque, glass;
    for (const Solid& solid : world.solids) (solid.glass ? glass : opaque).add(solid);
    fixed_ = new_scene(opaque, glass);
    for (const MovingSolid& moving : world.moving) {
      Mesh mesh;
      mesh.add(moving.solid);
      moving_.push_back({new_scene(mesh, {}), moving.waypoints.front().cast<float>()});
    }
  }

  ~Impl() {
    for (const Mover& mover : moving_) rtcReleaseScene(mover.scene);
    rtcReleaseScene(fixed_);
    rtcReleaseDevice(device_);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void place_moving(std::span<const Point2> positions) {
    for (std::size_t i = 0; i < moving_.size(); ++i) moving_[i].position = positions[i].cast<float>();
  }

  void cast(std::span<const Ray> rays, std::span<float> distances_m) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    RTCRayHit8 packet;
    alignas(32) int valid[kPacket];
    for (std::size_t first = 0; first < rays.size(); first += kPacket) {
      const std::size_t count = std::min(kPacket, rays.size() - first);
      load(rays.subspan(first, count), packet, valid);
      rtcIntersect8(valid, fixed_, &context, &packet);
      for (const Mover& mover : moving_) intersect(mover, valid, context, packet);
      for (std::size_t i = 0; i < count; ++i)
        distances_m[first + i] = packet.hit.geomID[i] == kGlassId ? kInfinity : packet.ray.tfar[i];
    }
  }

 private:
  struct Mover {
    RTCScene scene;
    Eigen::Vector2f position;
  };

  RTCScene new_scene(const Mesh& opaque, const Mesh& glass) const {
    RTCScene scene = rtcNewScene(device_);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
    attach(device_, scene, opaque, kOpaqueId);
    attach(device_, scene, glass, kGlassId);
    rtcCommitScene(scene);
    return scene;
  }

  /// The rays go to the mover's frame and back, so that nothing is built anew when it walks. A nearer hit
  /// takes the place of an earlier one.
  static void intersect(const Mover& mover, const int* valid, RTCIntersectContext& context,
                        RTCRayHit8& packet) {
    alignas(32) float x[kPacket], y[kPacket];
    std::copy_n(packet.ray.org_x, kPacket, x);
    std::copy_n(packet.ray.org_y, kPacket, y);
    for (std::size_t i = 0; i < kPacket; ++i) {
      packet.ray.org_x[i] -= mover.position.x();
      packet.ray.org_y[i] -= mover.position.y();
    }
    rtcIntersect8(valid, mover.scene, &context, &packet);
    std::copy_n(x, kPacket, packet.ray.org_x);
    std::copy_n(y, kPacket, packet.ray.org_y);
  }

  RTCDevice device_;
  RTCScene fixed_ = nullptr;
  std::vector<Mover> moving_;
};

RayScene::RayScene(const World& world) : impl_(std::make_unique<Impl>(world)) {}
RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

void RayScene::place_moving(std::span<const Point2> positions) { impl_->place_moving(positions); }
void RayScene::cast(std::span<const Ray> rays, std::span<float> distances_m) const {
  impl_->cast(rays, distances_m);
}

}  // namespace enfilade::simulator
