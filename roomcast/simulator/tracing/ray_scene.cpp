// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/tracing/ray_scene.h"

#include <cstring>
#include <limits>

#include "roomcast/simulator/tracing/embree.h"

namespace roomcast::simulator {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kSkin_m = 0.001F;

void set_ray(RTCRay& ray, const Vector3f& origin, const Vector3f& direction, float near,
             float far) {
  ray.org_x = origin.x();
  ray.org_y = origin.y();
  ray.org_z = origin.z();
  ray.dir_x = direction.x();
  ray.dir_y = direction.y();
  ray.dir_z = direction.z();
  ray.tnear = near;
  ray.tfar = far;
  ray.time = 0.0F;
  ray.mask = ~0U;
  ray.id = 0;
  ray.flags = 0;
}

}  // namespace

struct RayScene::Handles {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  Handles() = default;
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;
  ~Handles() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

RayScene::RayScene(const TriangleMesh& mesh, std::unique_ptr<Handles> handles)
    : mesh_(mesh), handles_(std::move(handles)) {}

RayScene::~RayScene() = default;

Result<std::unique_ptr<RayScene>> RayScene::build(const TriangleMesh& mesh) {
  auto handles = std::make_unique<Handles>();
  handles->device = rtcNewDevice("threads=1");
  if (handles->device == nullptr) {
    return Error{ErrorCode::kUnavailable, "The simulator cannot start: Embree gave no device."};
  }
  handles->scene = rtcNewScene(handles->device);
  rtcSetSceneFlags(handles->scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(handles->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                            sizeof(Vector3f), mesh.positions.size());
  void* triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            sizeof(mesh.triangles[0]), mesh.triangles.size());
  const bool enough_memory = positions != nullptr && triangles != nullptr;
  if (enough_memory) {
    std::memcpy(positions, mesh.positions.data(), sizeof(Vector3f) * mesh.positions.size());
    std::memcpy(triangles, mesh.triangles.data(),
                sizeof(mesh.triangles[0]) * mesh.triangles.size());
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(handles->scene, geometry);
  }
  rtcReleaseGeometry(geometry);
  if (!enough_memory) {
    return Error{ErrorCode::kUnavailable, "The simulator cannot start: no memory for its room."};
  }
  rtcCommitScene(handles->scene);
  return std::unique_ptr<RayScene>(new RayScene(mesh, std::move(handles)));
}

std::optional<RayHit> RayScene::first_hit(const Vector3f& origin_m,
                                          const Vector3f& direction) const {
  RTCRayHit query{};
  set_ray(query.ray, origin_m, direction, kSkin_m, std::numeric_limits<float>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  intersect(handles_->scene, query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const auto& corner = mesh_.triangles[query.hit.primID];
  const float b = query.hit.u;
  const float c = query.hit.v;
  const float a = 1.0F - b - c;
  RayHit hit;
  hit.t = query.ray.tfar;
  hit.triangle = query.hit.primID;
  hit.normal =
      (a * mesh_.normals[corner[0]] + b * mesh_.normals[corner[1]] + c * mesh_.normals[corner[2]])
          .normalized();
  if (hit.normal.dot(direction) > 0.0F) hit.normal = -hit.normal;
  hit.uv_m = a * mesh_.uv_m[corner[0]] + b * mesh_.uv_m[corner[1]] + c * mesh_.uv_m[corner[2]];
  return hit;
}

bool RayScene::blocked(const Vector3f& from_m, const Vector3f& to_m) const {
  const Vector3f way = to_m - from_m;
  const float length = way.norm();
  if (length < 2.0F * kSkin_m) return false;
  RTCRay ray{};
  set_ray(ray, from_m, way / length, kSkin_m, length - kSkin_m);
  find_obstacle(handles_->scene, ray);
  return ray.tfar < 0.0F;
}

}  // namespace roomcast::simulator
