// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/modeler/model_pieces.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "roomcast/model/pieces/draco_mesh.h"
#include "roomcast/model/pieces/model_message.h"

namespace roomcast::recording {
namespace {

constexpr float kLookStep_m = 0.05F;  // of the cubes by which pieces are compared
constexpr double kSameLook = 0.02;    // share of these cubes that may differ
/// So many of them may be where the other piece has nothing nearby: 0.1 m2. More is a thing that
/// came or went, also in a piece that is full of others.
constexpr int kSameThings = 40;
/// Where something came or went just now, what is left of it is no noise.
constexpr int kSameThingsAfterChange = 6;
constexpr double kSameLevel = 4;         // of 0 to 255
constexpr std::uint64_t kAxisBits = 21;  // of a cube's place on one axis
constexpr std::int64_t kAxisOffset = 1 << 20;

std::int32_t cell(float at_m, float edge_m) {
  return static_cast<std::int32_t>(std::floor(at_m / edge_m));
}

model::GridPlace place_of(const Eigen::Vector3f& at_m, float edge_m) {
  return {cell(at_m.x(), edge_m), cell(at_m.y(), edge_m), cell(at_m.z(), edge_m)};
}

std::uint64_t key_of(const model::GridPlace& place) {
  const auto axis = [](std::int32_t value) {
    return static_cast<std::uint64_t>(value + kAxisOffset) & ((1ULL << kAxisBits) - 1);
  };
  return (axis(place.x) << (2 * kAxisBits)) | (axis(place.y) << kAxisBits) | axis(place.z);
}

/// A surface on the border of two cubes may be in either, so those around count, too.
bool is_near(std::uint64_t key, const std::vector<std::uint64_t>& sorted_keys) {
  constexpr std::uint64_t kOneY = 1ULL << kAxisBits, kOneX = 1ULL << (2 * kAxisBits);
  for (std::uint64_t x = 0; x <= 2; ++x) {
    for (std::uint64_t y = 0; y <= 2; ++y) {
      const std::uint64_t first = key + x * kOneX + y * kOneY - kOneX - kOneY - 1;
      const auto found = std::ranges::lower_bound(sorted_keys, first);
      if (found != sorted_keys.end() && *found <= first + 2) return true;
    }
  }
  return false;
}

}  // namespace

std::map<model::GridPlace, model::RoomMesh> cut_mesh(const model::RoomMesh& mesh, float edge_m) {
  struct Part {
    model::RoomMesh mesh;
    std::unordered_map<std::uint32_t, std::uint32_t> numbers;  // of its points, by those before
  };
  std::map<model::GridPlace, Part> parts;
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3f middle_m =
        (mesh.points_m[triangle[0]] + mesh.points_m[triangle[1]] + mesh.points_m[triangle[2]]) / 3;
    Part& part = parts[place_of(middle_m, edge_m)];
    std::array<std::uint32_t, 3> renumbered{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto next = static_cast<std::uint32_t>(part.mesh.points_m.size());
      const auto [number, is_new] = part.numbers.try_emplace(triangle[i], next);
      renumbered[i] = number->second;
      if (!is_new) continue;
      part.mesh.points_m.push_back(mesh.points_m[triangle[i]]);
      if (!mesh.colors.empty()) part.mesh.colors.push_back(mesh.colors[triangle[i]]);
    }
    part.mesh.triangles.push_back(renumbered);
  }
  std::map<model::GridPlace, model::RoomMesh> meshes;
  for (auto& [place, part] : parts) meshes.emplace(place, std::move(part.mesh));
  return meshes;
}

ModelPieces::Look ModelPieces::look_of(const model::RoomMesh& mesh) {
  Look look;
  for (const Eigen::Vector3f& point_m : mesh.points_m)
    look.places.push_back(key_of(place_of(point_m, kLookStep_m)));
  std::ranges::sort(look.places);
  look.places.erase(std::ranges::unique(look.places).begin(), look.places.end());
  for (const Rgb8 color : mesh.colors) look.level += (color.r + color.g + color.b) / 3.0;
  look.level /= std::max<double>(1, static_cast<double>(mesh.colors.size()));
  return look;
}

bool ModelPieces::look_alike(const Look& a, const Look& b, std::int64_t same_things) {
  std::vector<std::uint64_t> different;
  std::ranges::set_symmetric_difference(a.places, b.places, std::back_inserter(different));
  const auto size = static_cast<double>(a.places.size() + b.places.size());
  if (static_cast<double>(different.size()) > kSameLook * size ||
      std::abs(a.level - b.level) > kSameLevel)
    return false;
  const auto things = std::ranges::count_if(different, [&](std::uint64_t key) {
    return !is_near(key, a.places) || !is_near(key, b.places);
  });
  return things <= same_things;
}

bool ModelPieces::update(const model::RoomMesh& mesh, std::uint64_t version) {
  ++updates_;
  bool is_different = false;
  auto meshes = cut_mesh(mesh, kPieceEdge_m);
  for (auto& [place, piece] : pieces_) {
    if (piece.draco.empty() || meshes.contains(place)) continue;
    piece = {version, updates_, {}, {}};
    is_different = true;
  }
  for (const auto& [place, part] : meshes) {
    Look look = look_of(part);
    const auto known = pieces_.find(place);
    const bool is_known = known != pieces_.end() && !known->second.draco.empty();
    if (is_known) {
      const bool has_just_changed = known->second.update + 1 == updates_;
      const int same_things = has_just_changed ? kSameThingsAfterChange : kSameThings;
      if (look_alike(known->second.look, look, same_things)) continue;
    }
    auto coded = model::encode_draco(part);
    if (!coded) continue;  // nothing of it has an area
    pieces_[place] = {version, updates_, std::move(coded->bytes), std::move(look)};
    is_different = true;
  }
  if (!is_different) return false;
  if (first_version_ == 0) first_version_ = version;
  version_ = version;
  return true;
}

std::size_t ModelPieces::bytes() const {
  std::size_t bytes = 0;
  for (const auto& [place, piece] : pieces_) bytes += piece.draco.size();
  return bytes;
}

std::string ModelPieces::changes_after(std::uint64_t known) const {
  model::ModelMessage message{.is_whole = known < first_version_, .version = version_};
  for (const auto& [place, piece] : pieces_) {
    if (message.is_whole ? !piece.draco.empty() : piece.version > known)
      message.pieces.push_back({place, piece.draco});
  }
  return model::write_model_message(message);
}

}  // namespace roomcast::recording
