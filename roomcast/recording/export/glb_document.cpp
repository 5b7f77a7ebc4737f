// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/export/glb_document.h"

#include <utility>

#include <Eigen/Geometry>

#include "roomcast/recording/export/little_endian_bytes.h"

namespace roomcast::recording {
namespace {

using nlohmann::json;

void pad(std::vector<std::uint8_t>& bytes, std::uint8_t with) {
  while (bytes.size() % 4 != 0) bytes.push_back(with);
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

}  // namespace

GlbDocument::GlbDocument()
    : root({{"asset", {{"version", "2.0"}, {"generator", "roomcast"}}},
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
            {"bufferViews", json::array()}}) {}

std::size_t GlbDocument::add_view(std::size_t begin, int target) {
  json view = {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", binary.size() - begin}};
  if (target != 0) view["target"] = target;
  root["bufferViews"].push_back(std::move(view));
  pad(binary, 0);
  return root["bufferViews"].size() - 1;
}

std::size_t GlbDocument::add_list(std::size_t begin, int target, const List& list) {
  const std::size_t view = add_view(begin, target);
  const std::size_t accessor = add_coded_list(list);
  root["accessors"][accessor]["bufferView"] = view;
  return accessor;
}

std::size_t GlbDocument::add_coded_list(const List& list) {
  json accessor = {{"componentType", list.component}, {"count", list.count}, {"type", list.type}};
  if (list.normalized) accessor["normalized"] = true;
  root["accessors"].push_back(std::move(accessor));
  return root["accessors"].size() - 1;
}

std::size_t GlbDocument::add_positions(std::span<const Eigen::Vector3f> points_m) {
  const std::size_t begin = binary.size();
  for (const auto& point : points_m) append_floats(point, binary);
  const std::size_t view = add_view(begin, kGlbArrayBuffer);
  const std::size_t accessor = add_coded_positions(points_m, points_m.size());
  root["accessors"][accessor]["bufferView"] = view;
  return accessor;
}

std::size_t GlbDocument::add_coded_positions(std::span<const Eigen::Vector3f> points_m,
                                             std::size_t count) {
  Eigen::AlignedBox3f box;
  for (const auto& point : points_m) box.extend(point);
  const std::size_t accessor = add_coded_list({kGlbFloat, count, "VEC3"});
  json& entry = root["accessors"][accessor];
  entry["min"] = {box.min().x(), box.min().y(), box.min().z()};
  entry["max"] = {box.max().x(), box.max().y(), box.max().z()};
  return accessor;
}

std::size_t GlbDocument::add_unlit_material(const std::vector<std::uint8_t>& jpeg) {
  json material = {{"extensions", {{"KHR_materials_unlit", json::object()}}},
                   {"doubleSided", true}};
  if (!jpeg.empty()) {
    const std::size_t begin = binary.size();
    binary.insert(binary.end(), jpeg.begin(), jpeg.end());
    root["images"].push_back({{"bufferView", add_view(begin, 0)}, {"mimeType", "image/jpeg"}});
    root["textures"].push_back({{"sampler", 0}, {"source", root["images"].size() - 1}});
    material["pbrMetallicRoughness"] = {
        {"baseColorTexture", {{"index", root["textures"].size() - 1}}}, {"metallicFactor", 0}};
  }
  root["materials"].push_back(std::move(material));
  return root["materials"].size() - 1;
}

void GlbDocument::add_node(json node) {
  node["mesh"] = root["meshes"].size() - 1;
  root["nodes"].push_back(std::move(node));
  root["scenes"][0]["nodes"].push_back(root["nodes"].size() - 1);
}

void GlbDocument::append_to(std::vector<std::uint8_t>& out) {
  constexpr std::uint32_t kGlb = 0x46546C67, kJson = 0x4E4F534A, kBin = 0x004E4942;
  if (!binary.empty()) root["buffers"] = {{{"byteLength", binary.size()}}};
  drop_empty_lists(root);
  const std::string text = root.dump();
  std::vector<std::uint8_t> json_chunk(text.begin(), text.end());
  pad(json_chunk, ' ');
  const std::size_t length = 12 + 8 + json_chunk.size() + (binary.empty() ? 0 : 8 + binary.size());
  append_u32(kGlb, out);
  append_u32(2, out);
  append_u32(static_cast<std::uint32_t>(length), out);
  append_chunk(json_chunk, kJson, out);
  if (!binary.empty()) append_chunk(binary, kBin, out);
}

}  // namespace roomcast::recording
