// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/export/gltf_scene.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

namespace roomcast::recording {
namespace {

using nlohmann::json;

constexpr int kFloat = 5126, kUnsignedInt = 5125;           // glTF component types
constexpr int kArrayBuffer = 34962, kElementArray = 34963;  // glTF buffer targets

void append_u32(std::uint32_t value, std::vector<std::uint8_t>& out) {
  for (int shift = 0; shift < 32; shift += 8)
    out.push_back(static_cast<std::uint8_t>(value >> shift));
}
void append_float(float value, std::vector<std::uint8_t>& out) {
  append_u32(std::bit_cast<std::uint32_t>(value), out);
}
void pad(std::vector<std::uint8_t>& bytes, std::uint8_t with) {
  while (bytes.size() % 4 != 0) bytes.push_back(with);
}

/// JSON and binary part of a GLB file under construction.
struct Document {
  json root = {{"asset", {{"version", "2.0"}, {"generator", "roomcast"}}},
               {"extensionsUsed", {"KHR_materials_unlit"}},
               {"scene", 0},
               {"scenes", {{{"nodes", json::array()}}}},
               {"nodes", json::array()},
               {"meshes", json::array()},
               {"materials", json::array()},
               {"textures", json::array()},
               {"images", json::array()},
               {"samplers",
                {{{"magFilter", 9729}, {"minFilter", 9729}, {"wrapS", 33071}, {"wrapT", 33071}}}},
               {"accessors", json::array()},
               {"bufferViews", json::array()}};
  std::vector<std::uint8_t> binary;

  /// Adds a buffer view of the bytes appended to `binary` since `begin`.
  int view(std::size_t begin, int target) {
    json view = {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", binary.size() - begin}};
    if (target != 0) view["target"] = target;
    root["bufferViews"].push_back(std::move(view));
    pad(binary, 0);
    return static_cast<int>(root["bufferViews"].size()) - 1;
  }
  int accessor(int view, int component, std::size_t count, const char* type) {
    root["accessors"].push_back(
        {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
    return static_cast<int>(root["accessors"].size()) - 1;
  }
};

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

int add_positions(const Mesh& mesh, Document& document) {
  Eigen::AlignedBox3f box;
  const std::size_t begin = document.binary.size();
  for (const auto& point : mesh.points_m) {
    box.extend(point);
    for (int i = 0; i < 3; ++i) append_float(point[i], document.binary);
  }
  const int accessor =
      document.accessor(document.view(begin, kArrayBuffer), kFloat, mesh.points_m.size(), "VEC3");
  json& entry = document.root["accessors"][static_cast<std::size_t>(accessor)];
  entry["min"] = {box.min().x(), box.min().y(), box.min().z()};
  entry["max"] = {box.max().x(), box.max().y(), box.max().z()};
  return accessor;
}

int add_texture_places(const Mesh& mesh, Document& document) {
  const std::size_t begin = document.binary.size();
  for (const auto& place : mesh.texture) {
    append_float(place.x(), document.binary);
    append_float(place.y(), document.binary);
  }
  return document.accessor(document.view(begin, kArrayBuffer), kFloat, mesh.texture.size(), "VEC2");
}

int add_triangles(const Mesh& mesh, Document& document) {
  const std::size_t begin = document.binary.size();
  for (const std::uint32_t index : mesh.triangles) append_u32(index, document.binary);
  return document.accessor(document.view(begin, kElementArray), kUnsignedInt, mesh.triangles.size(),
                           "SCALAR");
}

int add_material(const std::vector<std::uint8_t>& jpeg, Document& document) {
  json material = {{"extensions", {{"KHR_materials_unlit", json::object()}}},
                   {"doubleSided", true}};
  if (!jpeg.empty()) {
    const std::size_t begin = document.binary.size();
    document.binary.insert(document.binary.end(), jpeg.begin(), jpeg.end());
    document.root["images"].push_back(
        {{"bufferView", document.view(begin, 0)}, {"mimeType", "image/jpeg"}});
    document.root["textures"].push_back(
        {{"sampler", 0}, {"source", document.root["images"].size() - 1}});
    material["pbrMetallicRoughness"] = {
        {"baseColorTexture", {{"index", document.root["textures"].size() - 1}}},
        {"metallicFactor", 0}};
  }
  document.root["materials"].push_back(std::move(material));
  return static_cast<int>(document.root["materials"].size()) - 1;
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
              const std::vector<std::uint8_t>& jpeg, Document& document) {
  const json primitive = {{"attributes",
                           {{"POSITION", add_positions(mesh, document)},
                            {"TEXCOORD_0", add_texture_places(mesh, document)}}},
                          {"indices", add_triangles(mesh, document)},
                          {"material", add_material(jpeg, document)}};
  document.root["meshes"].push_back({{"name", name}, {"primitives", {primitive}}});
  document.root["nodes"].push_back({{"name", name},
                                    {"mesh", document.root["meshes"].size() - 1},
                                    {"matrix", matrix_of(world_from_depth)}});
  document.root["scenes"][0]["nodes"].push_back(document.root["nodes"].size() - 1);
}

/// glTF does not allow empty lists.
void drop_empty_lists(json& root) {
  for (auto entry = root.begin(); entry != root.end();) {
    entry = entry->is_array() && entry->empty() ? root.erase(entry) : ++entry;
  }
}

void append_chunk(const std::vector<std::uint8_t>& content, std::uint32_t type,
                  std::vector<std::uint8_t>& out) {
  append_u32(static_cast<std::uint32_t>(content.size()), out);
  append_u32(type, out);
  out.insert(out.end(), content.begin(), content.end());
}

void append_glb(Document& document, std::vector<std::uint8_t>& out) {
  constexpr std::uint32_t kGlb = 0x46546C67, kJson = 0x4E4F534A, kBin = 0x004E4942;
  if (!document.binary.empty())
    document.root["buffers"] = {{{"byteLength", document.binary.size()}}};
  drop_empty_lists(document.root);
  const std::string text = document.root.dump();
  std::vector<std::uint8_t> json_chunk(text.begin(), text.end());
  pad(json_chunk, ' ');
  const std::size_t length =
      12 + 8 + json_chunk.size() + (document.binary.empty() ? 0 : 8 + document.binary.size());
  append_u32(kGlb, out);
  append_u32(2, out);
  append_u32(static_cast<std::uint32_t>(length), out);
  append_chunk(json_chunk, kJson, out);
  if (!document.binary.empty()) append_chunk(document.binary, kBin, out);
}

}  // namespace

GltfScene::GltfScene(const std::vector<SetSensor>& sensors) : sensors_(sensors) {
  for (const SetSensor& sensor : sensors) points_.emplace_back(sensor.depth);
}

Status GltfScene::append(const FrameSet& set, std::vector<std::uint8_t>& out) {
  Document document;
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
  append_glb(document, out);
  return {};
}

}  // namespace roomcast::recording
