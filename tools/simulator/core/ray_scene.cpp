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

RTCGeometry attach(RTCDevice device, RTCScene scene, const Mesh& mesh, unsigned id) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                           sizeof(Vertex), std::max<std::size_t>(mesh.vertices.size(), 1));
  void* triangles =
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Triangle),
                              std::max<std::size_t>(mesh.triangles.size(), 1));
  std::memcpy(vertices, mesh.vertices.data(), mesh.vertices.size() * sizeof(Vertex));
  std::memcpy(triangles, mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle));
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, id);
  rtcReleaseGeometry(geometry);
  return geometry;  // the scene keeps it alive
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
    fixed_ = new_scene(RTC_BUILD_QUALITY_HIGH);
    moving_ = new_scene(RTC_BUILD_QUALITY_LOW);
    add_fixed(world);
    add_moving(world);
  }

  ~Impl() {
    rtcReleaseScene(fixed_);
    rtcReleaseScene(moving_);
    rtcReleaseDevice(device_);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void place_moving(std::span<const Point2> positions) {
    if (meshes_.empty()) return;
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
      auto* vertices =
          static_cast<Vertex*>(rtcGetGeometryBufferData(geometries_[i], RTC_BUFFER_TYPE_VERTEX, 0));
      const float x = static_cast<float>(positions[i].x()), y = static_cast<float>(positions[i].y());
      for (std::size_t v = 0; v < meshes_[i].vertices.size(); ++v) {
        const Vertex& at = meshes_[i].vertices[v];
        vertices[v] = {at.x + x, at.y + y, at.z};
      }
      rtcUpdateGeometryBuffer(geometries_[i], RTC_BUFFER_TYPE_VERTEX, 0);
      rtcCommitGeometry(geometries_[i]);
    }
    rtcCommitScene(moving_);
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
      unsigned fixed_id[kPacket];
      std::copy_n(packet.hit.geomID, kPacket, fixed_id);
      if (!meshes_.empty()) {
        std::fill_n(packet.hit.geomID, kPacket, RTC_INVALID_GEOMETRY_ID);
        rtcIntersect8(valid, moving_, &context, &packet);
      }
      for (std::size_t i = 0; i < count; ++i) {
        const bool mover = !meshes_.empty() && packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
        const bool glass = !mover && fixed_id[i] == kGlassId;
        distances_m[first + i] = glass ? kInfinity : packet.ray.tfar[i];
      }
    }
  }

 private:
  RTCScene new_scene(RTCBuildQuality quality) const {
    RTCScene scene = rtcNewScene(device_);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, quality);
    return scene;
  }

  void add_fixed(const World& world) {
    Mesh opaque, glass;
    for (const Solid& solid : world.solids) (solid.glass ? glass : opaque).add(solid);
    attach(device_, fixed_, opaque, 0);
    if (!glass.triangles.empty()) attach(device_, fixed_, glass, kGlassId);
    rtcCommitScene(fixed_);
  }

  void add_moving(const World& world) {
    std::vector<Point2> starts;
    for (const MovingSolid& moving : world.moving) {
      Mesh& mesh = meshes_.emplace_back();
      mesh.add(moving.solid);
      geometries_.push_back(attach(device_, moving_, mesh, static_cast<unsigned>(meshes_.size()) - 1));
      starts.push_back(moving.waypoints.front());
    }
    place_moving(starts);
  }

  RTCDevice device_;
  RTCScene fixed_ = nullptr;
  RTCScene moving_ = nullptr;
  std::vector<Mesh> meshes_;  ///< of the moving solids, about their origin
  std::vector<RTCGeometry> geometries_;
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
