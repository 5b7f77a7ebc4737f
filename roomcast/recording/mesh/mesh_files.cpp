// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/mesh/mesh_files.h"

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "roomcast/core/assert.h"
#include "roomcast/core/srgb.h"
#include "roomcast/model/pieces/draco_mesh.h"
#include "roomcast/recording/export/glb_document.h"
#include "roomcast/recording/export/little_endian_bytes.h"

namespace roomcast::recording {
namespace {

constexpr const char* kDracoExtension = "KHR_draco_mesh_compression";

/// 16 bits: at 8, dark colours of linear light would be too far apart.
std::uint16_t level_of_16_bits(float linear) {
  return static_cast<std::uint16_t>(std::lround(65535 * linear));
}

std::size_t add_normals(const model::RoomMesh& mesh, GlbDocument& document) {
  const std::size_t begin = document.binary.size();
  for (const Eigen::Vector3f& normal : model::point_normals(mesh))
    append_floats(normal, document.binary);
  return document.add_list(begin, kGlbArrayBuffer, {kGlbFloat, mesh.points_m.size(), "VEC3"});
}

std::size_t add_colors(const model::RoomMesh& mesh, GlbDocument& document) {
  const auto linear = linear_levels();
  const std::size_t begin = document.binary.size();
  for (const Rgb8 color : mesh.colors) {
    for (const std::uint8_t level : {color.r, color.g, color.b})
      append_u16(level_of_16_bits(linear[level]), document.binary);
    append_u16(0xFFFF, document.binary);  // opaque; also keeps every point on a multiple of 4 bytes
  }
  return document.add_list(begin, kGlbArrayBuffer,
                           {kGlbUnsignedShort, mesh.colors.size(), "VEC4", true});
}

std::size_t add_triangles(const model::RoomMesh& mesh, GlbDocument& document) {
  const std::size_t begin = document.binary.size();
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t point : triangle) append_u32(point, document.binary);
  return document.add_list(begin, kGlbElementArray,
                           {kGlbUnsignedInt, 3 * mesh.triangles.size(), "SCALAR"});
}

void append_glb_mesh(const model::RoomMesh& mesh, std::vector<std::uint8_t>& out) {
  GlbDocument document;
  const nlohmann::json primitive = {{"attributes",
                                     {{"POSITION", document.add_positions(mesh.points_m)},
                                      {"NORMAL", add_normals(mesh, document)},
                                      {"COLOR_0", add_colors(mesh, document)}}},
                                    {"indices", add_triangles(mesh, document)},
                                    {"material", document.add_unlit_material({})}};
  document.root["meshes"].push_back({{"name", "room"}, {"primitives", {primitive}}});
  document.add_node({{"name", "room"}});
  document.append_to(out);
}

Status append_draco_mesh(const model::RoomMesh& mesh, std::vector<std::uint8_t>& out) {
  const auto coded = model::encode_draco(mesh);
  if (!coded) return coded.error();
  GlbDocument document;
  const std::size_t begin = document.binary.size();
  document.binary.insert(document.binary.end(), coded->bytes.begin(), coded->bytes.end());
  const std::size_t view = document.add_view(begin, 0);
  const nlohmann::json extension = {
      {"bufferView", view},
      {"attributes", {{"POSITION", model::kDracoPositions}, {"COLOR_0", model::kDracoColors}}}};
  const nlohmann::json primitive = {
      {"attributes",
       {{"POSITION", document.add_coded_positions(mesh.points_m, coded->points)},
        {"COLOR_0", document.add_coded_list({kGlbFloat, coded->points, "VEC3"})}}},
      {"indices", document.add_coded_list({kGlbUnsignedInt, 3 * coded->triangles, "SCALAR"})},
      {"material", document.add_unlit_material({})},
      {"extensions", {{kDracoExtension, extension}}}};
  document.root["extensionsUsed"].push_back(kDracoExtension);
  document.root["extensionsRequired"] = {kDracoExtension};
  document.root["meshes"].push_back({{"name", "room"}, {"primitives", {primitive}}});
  document.add_node({{"name", "room"}});
  document.append_to(out);
  return {};
}

void append_ply_mesh(const model::RoomMesh& mesh, std::vector<std::uint8_t>& out) {
  append_text(fmt::format("ply\nformat binary_little_endian 1.0\ncomment roomcast, metres, y up\n"
                          "element vertex {}\n"
                          "property float x\nproperty float y\nproperty float z\n"
                          "property float nx\nproperty float ny\nproperty float nz\n"
                          "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                          "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                          mesh.points_m.size(), mesh.triangles.size()),
              out);
  out.reserve(out.size() + 27 * mesh.points_m.size() + 13 * mesh.triangles.size());
  const auto normals = model::point_normals(mesh);
  for (std::size_t i = 0; i < mesh.points_m.size(); ++i) {
    append_floats(mesh.points_m[i], out);
    append_floats(normals[i], out);
    out.insert(out.end(), {mesh.colors[i].r, mesh.colors[i].g, mesh.colors[i].b});
  }
  for (const auto& triangle : mesh.triangles) {
    out.push_back(3);
    for (const std::uint32_t point : triangle) append_u32(point, out);
  }
}

void append_obj_mesh(const model::RoomMesh& mesh, std::vector<std::uint8_t>& out) {
  append_text("# roomcast, metres, y up; x y z red green blue\no room\n", out);
  for (std::size_t i = 0; i < mesh.points_m.size(); ++i) {
    const Eigen::Vector3f& at = mesh.points_m[i];
    const Rgb8 color = mesh.colors[i];
    append_text(fmt::format("v {:.4f} {:.4f} {:.4f} {:.3f} {:.3f} {:.3f}\n", at.x(), at.y(), at.z(),
                            color.r / 255.0, color.g / 255.0, color.b / 255.0),
                out);
  }
  for (const Eigen::Vector3f& normal : model::point_normals(mesh))
    append_text(fmt::format("vn {:.3f} {:.3f} {:.3f}\n", normal.x(), normal.y(), normal.z()), out);
  for (const auto& [a, b, c] : mesh.triangles)
    append_text(fmt::format("f {0}//{0} {1}//{1} {2}//{2}\n", a + 1, b + 1, c + 1), out);
}

}  // namespace

std::string_view ending_of(MeshFile file) {
  switch (file) {
    case MeshFile::kGlb:
      return "glb";
    case MeshFile::kDracoGlb:
      return "draco.glb";
    case MeshFile::kPly:
      return "ply";
    case MeshFile::kObj:
      return "obj";
  }
  return "";
}

Status append_mesh(const model::RoomMesh& mesh, MeshFile file, std::vector<std::uint8_t>& out) {
  ROOMCAST_ASSERT(mesh.colors.size() == mesh.points_m.size() && !mesh.triangles.empty());
  switch (file) {
    case MeshFile::kGlb:
      append_glb_mesh(mesh, out);
      break;
    case MeshFile::kDracoGlb:
      return append_draco_mesh(mesh, out);
    case MeshFile::kPly:
      append_ply_mesh(mesh, out);
      break;
    case MeshFile::kObj:
      append_obj_mesh(mesh, out);
      break;
  }
  return {};
}

}  // namespace roomcast::recording
