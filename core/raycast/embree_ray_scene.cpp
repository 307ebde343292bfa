// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/raycast/embree_ray_scene.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cstring>

#include "core/base/check.h"
#include "core/base/log.h"

namespace spin {
namespace {

constexpr std::size_t kPacket = 16;

void onError(void*, RTCError code, const char* text) {
  if (code == RTC_ERROR_CANCELLED) return;
  log(LogLevel::Error,
      "Embree reports error " + std::to_string(static_cast<int>(code)) + ": " + (text ? text : "no text"));
}

/// One device for the process: it owns Embree's threads and start-up work.
RTCDevice device() {
  static const RTCDevice shared = [] {
    const RTCDevice made = rtcNewDevice(nullptr);
    SPIN_CHECK(made, "Embree could not start");
    rtcSetDeviceErrorFunction(made, onError, nullptr);
    return made;
  }();
  return shared;
}

RTCRay toEmbree(const Ray& ray) {
  RTCRay r{};
  r.org_x = ray.origin.x, r.org_y = ray.origin.y, r.org_z = ray.origin.z;
  r.dir_x = ray.direction.x, r.dir_y = ray.direction.y, r.dir_z = ray.direction.z;
  r.tnear = ray.tMin;
  r.tfar = ray.tMax;
  r.mask = ~0u;
  return r;
}

class EmbreeRayScene final : public RayScene {
 public:
  EmbreeRayScene() : m_scene(rtcNewScene(device())) {
    rtcSetSceneFlags(m_scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(m_scene, RTC_BUILD_QUALITY_MEDIUM);
  }
  ~EmbreeRayScene() override { rtcReleaseScene(m_scene); }
  EmbreeRayScene(const EmbreeRayScene&) = delete;
  EmbreeRayScene& operator=(const EmbreeRayScene&) = delete;

  std::uint32_t addTriangles(const std::vector<Vec3f>& positions,
                             const std::vector<std::uint32_t>& indices) override {
    SPIN_CHECK(indices.size() % 3 == 0, "indices come in threes");
    const RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
    const auto copy = [&](RTCBufferType type, RTCFormat format, std::size_t stride, const void* data,
                          std::size_t count) {
      void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, stride, count);
      if (count > 0 && buffer) std::memcpy(buffer, data, stride * count);
    };
    static_assert(sizeof(Vec3f) == 3 * sizeof(float));
    copy(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, sizeof(Vec3f), positions.data(), positions.size());
    copy(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), indices.data(),
         indices.size() / 3);
    rtcCommitGeometry(geometry);
    const unsigned id = rtcAttachGeometry(m_scene, geometry);
    rtcReleaseGeometry(geometry);
    return id;
  }
  bool commit(const CancelToken& cancel) override {
    const auto goOn = [](void* token, double) {
      return !static_cast<const CancelToken*>(token)->cancelled();
    };
    rtcSetSceneProgressMonitorFunction(m_scene, goOn, const_cast<CancelToken*>(&cancel));
    rtcCommitScene(m_scene);
    rtcSetSceneProgressMonitorFunction(m_scene, nullptr, nullptr);
    return !cancel.cancelled();
  }

  bool occluded(const Ray& ray) const override {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay r = toEmbree(ray);
    rtcOccluded1(m_scene, &context, &r);
    return r.tfar < 0.0f;
  }

  void occludedMany(const Ray* rays, std::size_t count, std::uint8_t* blocked) const override {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    for (std::size_t begin = 0; begin < count; begin += kPacket)
      occludedPacket(context, rays + begin, std::min(kPacket, count - begin), blocked + begin);
  }

  std::optional<RayHit> closest(const Ray& ray) const override {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit hit{};
    hit.ray = toEmbree(ray);
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(m_scene, &context, &hit);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return RayHit{hit.ray.tfar, hit.hit.geomID, hit.hit.primID};
  }
  const char* name() const override { return "embree"; }

 private:
  void occludedPacket(RTCIntersectContext& context, const Ray* rays, std::size_t count,
                      std::uint8_t* blocked) const {
    alignas(64) RTCRay16 packet{};
    alignas(64) int valid[kPacket] = {};
    for (std::size_t k = 0; k < count; ++k) {
      valid[k] = -1;
      packet.org_x[k] = rays[k].origin.x;
      packet.org_y[k] = rays[k].origin.y;
      packet.org_z[k] = rays[k].origin.z;
      packet.dir_x[k] = rays[k].direction.x;
      packet.dir_y[k] = rays[k].direction.y;
      packet.dir_z[k] = rays[k].direction.z;
      packet.tnear[k] = rays[k].tMin;
      packet.tfar[k] = rays[k].tMax;
      packet.mask[k] = ~0u;
    }
    rtcOccluded16(valid, m_scene, &context, &packet);
    for (std::size_t k = 0; k < count; ++k) blocked[k] = packet.tfar[k] < 0.0f ? 1 : 0;
  }

  RTCScene m_scene;
};

}  // namespace

std::unique_ptr<RayScene> makeEmbreeRayScene() {
  return std::make_unique<EmbreeRayScene>();
}

}  // namespace spin
