// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/export/gltf_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <nlohmann/json.hpp>

#include "roomcast/core/utc_text.h"
#include "roomcast/recording/export/glb_document.h"
#include "roomcast/recording/export/little_endian_bytes.h"

namespace roomcast::recording {
namespace {

using nlohmann::json;

struct Mesh {
  std::vector<Eigen::Vector3f> points_m;
  std::vector<Eigen::Vector2f> texture;
  std::vector<std::uint32_t> triangles;
};

constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();

bool is_one_surface(const DepthPoints& points, const std::array<Eigen::Vector2i, 3>& corners) {
  float least = std::numeric_limits<float>::max(), most = 0;
  for (const auto& corner : corners) {
    const float z = points.z_m(corner.x(), corner.y());
    least = std::min(least, z);
    most = std::max(most, z);
  }
  return least > 0 && most - least < largest_step_m(least);
}

/// One vertex per reading used by a triangle; triangles connect neighbours of one surface.
Mesh mesh_of(const DepthPoints& points) {
  const int width = points.camera().width, height = points.camera().height;
  Mesh mesh;
  Image<std::uint32_t> vertex(width, height, kNoVertex);
  const auto index_of = [&](const Eigen::Vector2i& at) {
    std::uint32_t& index = vertex.at(at.x(), at.y());
    if (index == kNoVertex) {
      index = static_cast<std::uint32_t>(mesh.points_m.size());
      mesh.points_m.push_back(points.point_m(at.x(), at.y()));
      mesh.texture.emplace_back((static_cast<float>(at.x()) + 0.5F) / static_cast<float>(width),
                                (static_cast<float>(at.y()) + 0.5F) / static_cast<float>(height));
    }
    return index;
  };
  const auto add = [&](const std::array<Eigen::Vector2i, 3>& corners) {
    if (!is_one_surface(points, corners)) return;
    for (const auto& corner : corners) mesh.triangles.push_back(index_of(corner));
  };
  for (int y = 0; y + 1 < height; ++y) {
    for (int x = 0; x + 1 < width; ++x) {
      // Counter-clockwise as seen by the sensor, whose y points down.
      add({Eigen::Vector2i(x, y), {x, y + 1}, {x + 1, y}});
      add({Eigen::Vector2i(x + 1, y), {x, y + 1}, {x + 1, y + 1}});
    }
  }
  return mesh;
}

std::size_t add_texture_places(const Mesh& mesh, GlbDocument& document) {
  const std::size_t begin = document.binary.size();
  for (const auto& place : mesh.texture) {
    append_float(place.x(), document.binary);
    append_float(place.y(), document.binary);
  }
  return document.add_list(begin, kGlbArrayBuffer, {kGlbFloat, mesh.texture.size(), "VEC2"});
}

std::size_t add_triangles(const Mesh& mesh, GlbDocument& document) {
  const std::size_t begin = document.binary.size();
  for (const std::uint32_t index : mesh.triangles) append_u32(index, document.binary);
  return document.add_list(begin, kGlbElementArray,
                           {kGlbUnsignedInt, mesh.triangles.size(), "SCALAR"});
}

/// glTF's matrices are column-major.
json matrix_of(const RigidTransform& transform) {
  const auto rows = row_major_from_transform(transform);
  json matrix = json::array();
  for (std::size_t column = 0; column < 4; ++column)
    for (std::size_t row = 0; row < 4; ++row) matrix.push_back(rows[4 * row + column]);
  return matrix;
}

void add_node(const std::string& name, const RigidTransform& world_from_depth, const Mesh& mesh,
              const std::vector<std::uint8_t>& jpeg, GlbDocument& document) {
  const json primitive = {{"attributes",
                           {{"POSITION", document.add_positions(mesh.points_m)},
                            {"TEXCOORD_0", add_texture_places(mesh, document)}}},
                          {"indices", add_triangles(mesh, document)},
                          {"material", document.add_unlit_material(jpeg)}};
  document.root["meshes"].push_back({{"name", name}, {"primitives", {primitive}}});
  document.add_node({{"name", name}, {"matrix", matrix_of(world_from_depth)}});
}

}  // namespace

GltfScene::GltfScene(const std::vector<SetSensor>& sensors) : sensors_(sensors) {
  for (const SetSensor& sensor : sensors) points_.emplace_back(sensor.depth);
}

Status GltfScene::append(const FrameSet& set, nanoseconds captured,
                         std::vector<std::uint8_t>& out) {
  GlbDocument document;
  if (captured.count() > 0)
    document.root["scenes"][0]["extras"] = {{"captured", utc_text(captured)}};
  for (const SetFrame& frame : set.frames) {
    if (!frame.world_from_depth && set.frames.size() > 1) continue;
    DepthPoints& points = points_[frame.sensor];
    points.set(frame.pictures->depth_mm);
    const Mesh mesh = mesh_of(points);
    if (mesh.triangles.empty()) continue;
    std::vector<std::uint8_t> jpeg;
    if (!frame.pictures->color.empty()) {
      const auto problem = jpeg_.encode(frame.pictures->color, kTextureQuality, jpeg);
      if (!problem.empty()) return Error{ErrorCode::kMalformed, "no texture: " + problem};
    }
    add_node(sensors_[frame.sensor].name, frame.world_from_depth.value_or(RigidTransform()), mesh,
             jpeg, document);
  }
  document.append_to(out);
  return {};
}

}  // namespace roomcast::recording
