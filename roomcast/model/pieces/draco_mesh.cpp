// SPDX-License-Identifier: Apache-2.0
#include "roomcast/model/pieces/draco_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include <Eigen/Geometry>
#include <draco/compression/decode.h>
#include <draco/compression/encode.h>

#include "roomcast/core/srgb.h"

namespace roomcast::model {
namespace {

constexpr int kColorBits = 9;  // of linear light: with 8, dark colours would be too far apart
constexpr int kMaxPositionBits = 20;
constexpr std::uint32_t kMaxElements = 20'000'000;  // points, triangles: more are of no room
constexpr int kSpeed = 0;                           // 0: smallest, 10: fastest

/// So many that the grid is as fine as kDracoStep_m.
int position_bits(const RoomMesh& mesh) {
  Eigen::AlignedBox3f box_m;
  for (const Eigen::Vector3f& point : mesh.points_m) box_m.extend(point);
  const float steps = std::max(1.0F, box_m.sizes().maxCoeff() / kDracoStep_m);
  return static_cast<int>(std::ceil(std::log2(steps + 1)));
}

template <class Value>
void add_attribute(draco::GeometryAttribute::Type type, std::size_t count, Value value,
                   draco::Mesh& mesh) {
  draco::GeometryAttribute kind;
  kind.Init(type, nullptr, 3, draco::DT_FLOAT32, false, 3 * sizeof(float), 0);
  const int id = mesh.AddAttribute(kind, true, static_cast<std::uint32_t>(count));
  draco::PointAttribute& attribute = *mesh.attribute(id);
  for (std::size_t i = 0; i < count; ++i) {
    const std::array<float, 3> numbers = value(i);
    attribute.SetAttributeValue(draco::AttributeValueIndex(static_cast<std::uint32_t>(i)),
                                numbers.data());
  }
}

/// In the order of kDracoPositions, kDracoColors.
void copy(const RoomMesh& from, draco::Mesh& to) {
  const std::array<float, 256> linear = linear_levels();
  to.set_num_points(static_cast<std::uint32_t>(from.points_m.size()));
  add_attribute(
      draco::GeometryAttribute::POSITION, from.points_m.size(),
      [&](std::size_t i) {
        const Eigen::Vector3f& at = from.points_m[i];
        return std::array{at.x(), at.y(), at.z()};
      },
      to);
  add_attribute(
      draco::GeometryAttribute::COLOR, from.colors.size(),
      [&](std::size_t i) {
        const Rgb8 color = from.colors[i];
        return std::array{linear[color.r], linear[color.g], linear[color.b]};
      },
      to);
  for (const auto& [a, b, c] : from.triangles)
    to.AddFace({draco::PointIndex(a), draco::PointIndex(b), draco::PointIndex(c)});
}

/// Of linear light; what is not within 0..1 is brought there, and what is no number becomes 0.
std::uint8_t nearest_level(float linear) {
  const float within = std::isnan(linear) ? 0.0F : std::clamp(linear, 0.0F, 1.0F);
  return static_cast<std::uint8_t>(std::lround(level_from_linear(within)));
}

Error damaged() {
  return {ErrorCode::kMalformed, "this is no mesh of a room in Draco's format, or it is damaged"};
}

std::array<float, 3> numbers_of(const draco::PointAttribute& attribute, std::uint32_t point) {
  std::array<float, 3> numbers{};
  attribute.ConvertValue(attribute.mapped_index(draco::PointIndex(point)), 3, numbers.data());
  return numbers;
}

}  // namespace

Result<DracoMesh> encode_draco(const RoomMesh& mesh) {
  const int bits = position_bits(mesh);
  if (bits > kMaxPositionBits)
    return invalid_argument("this room is too wide for a small file; use --crop");
  draco::Mesh coded;
  copy(mesh, coded);
  draco::Encoder encoder;
  encoder.SetSpeedOptions(kSpeed, kSpeed);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, bits);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::COLOR, kColorBits);
  encoder.SetTrackEncodedProperties(true);
  draco::EncoderBuffer buffer;
  if (const draco::Status status = encoder.EncodeMeshToBuffer(coded, &buffer); !status.ok())
    return invalid_argument(std::string("this mesh cannot be coded: ") + status.error_msg());
  return DracoMesh{{buffer.data(), buffer.data() + buffer.size()},
                   encoder.num_encoded_points(),
                   encoder.num_encoded_faces()};
}

Result<RoomMesh> decode_draco(std::span<const std::uint8_t> bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) return damaged();
  const std::unique_ptr<draco::Mesh> coded = std::move(decoded).value();
  const draco::PointAttribute* const positions = coded->GetAttributeByUniqueId(kDracoPositions);
  const draco::PointAttribute* const colors = coded->GetAttributeByUniqueId(kDracoColors);
  if (positions == nullptr || colors == nullptr) return damaged();
  const std::uint32_t points = coded->num_points(), triangles = coded->num_faces();
  if (points > kMaxElements || triangles > kMaxElements) return damaged();
  RoomMesh mesh;
  for (std::uint32_t i = 0; i < points; ++i) {
    const auto [x, y, z] = numbers_of(*positions, i);
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) return damaged();
    mesh.points_m.emplace_back(x, y, z);
    const auto [r, g, b] = numbers_of(*colors, i);
    mesh.colors.push_back({nearest_level(r), nearest_level(g), nearest_level(b)});
  }
  for (std::uint32_t i = 0; i < triangles; ++i) {
    const draco::Mesh::Face& face = coded->face(draco::FaceIndex(i));
    if (std::ranges::any_of(face, [&](const auto corner) { return corner.value() >= points; }))
      return damaged();
    mesh.triangles.push_back({face[0].value(), face[1].value(), face[2].value()});
  }
  return mesh;
}

}  // namespace roomcast::model
