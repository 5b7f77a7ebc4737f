// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/cwipc_config.h"

#include <array>
#include <cmath>

#include "roomcast/io/json_fields.h"

namespace roomcast::recording {
namespace {

namespace fs = std::filesystem;

std::string cwipc_text(const nlohmann::json& object, const char* field) {
  const auto found = object.find(field);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

bool cwipc_flag(const nlohmann::json& object, const char* field) {
  const auto found = object.find(field);
  return found != object.end() && found->is_boolean() && found->get<bool>();
}

/// Whether depth is mapped to colour; in "filtering", and in files of version 3 in "system".
bool maps_depth_to_color(const nlohmann::json& config) {
  for (const char* group : {"filtering", "system"}) {
    const auto settings = config.find(group);
    if (settings == config.end() || !settings->is_object()) continue;
    const auto setting = settings->find("map_color_to_depth");
    if (setting == settings->end()) continue;
    if (setting->is_boolean()) return !setting->get<bool>();
    if (setting->is_number_integer()) return setting->get<int>() == 0;
  }
  return false;
}

/// 16 numbers of four rows; nothing if it is something else.
std::optional<std::array<double, 16>> matrix_of(const nlohmann::json& trafo) {
  std::array<double, 16> matrix{};
  if (!trafo.is_array() || trafo.size() != 4) return std::nullopt;
  for (std::size_t y = 0; y < 4; ++y) {
    if (!trafo[y].is_array() || trafo[y].size() != 4) return std::nullopt;
    for (std::size_t x = 0; x < 4; ++x) {
      if (!trafo[y][x].is_number()) return std::nullopt;
      matrix[4 * y + x] = trafo[y][x].get<double>();
    }
  }
  return matrix;
}

bool is_unplaced(const RigidTransform& transform) {
  constexpr double kSame = 1e-9;
  return transform.rotation.isIdentity(kSame) && transform.translation_m.isZero(kSame);
}

void read_place(const nlohmann::json& camera, CwipcCamera& out) {
  const auto trafo = camera.find("trafo");
  if (trafo == camera.end() || trafo->is_null()) return;
  const auto matrix = matrix_of(*trafo);
  const auto transform = matrix ? transform_from_row_major(*matrix)
                                : Result<RigidTransform>(malformed("not a matrix"));
  if (!transform) {
    out.note = std::string("its pose in ") + kCwipcFile +
               " is not used, because it is no rotation "
               "and translation";
  } else if (!is_unplaced(*transform)) {
    out.world_from_camera = *transform;
  }
}

}  // namespace

Result<std::vector<CwipcCamera>> read_cwipc_config(const fs::path& file) {
  const auto config = io::read_json_object(file);
  if (!config) return config.error();
  const auto list = config->find("camera");
  if (list == config->end() || !list->is_array())
    return malformed(file.string() + " has no list \"camera\"");
  if (list->size() > kMaxCwipcCameras)
    return Error{ErrorCode::kTooLarge, file.string() + " has too many cameras"};
  const bool is_mapped = maps_depth_to_color(*config);
  std::vector<CwipcCamera> cameras;
  for (const nlohmann::json& entry : *list) {
    if (!entry.is_object()) return malformed(file.string() + ": a camera is not an object");
    if (cwipc_flag(entry, "disabled")) continue;
    CwipcCamera camera;
    camera.serial = cwipc_text(entry, "serial");
    camera.file = cwipc_text(entry, entry.contains("filename") ? "filename" : "playback_filename");
    // The folder may have been copied from another computer.
    camera.file = camera.file.substr(camera.file.find_last_of("/\\") + 1);
    camera.is_color_camera = is_mapped || !cwipc_text(entry, "type").starts_with("realsense");
    read_place(entry, camera);
    cameras.push_back(std::move(camera));
  }
  return cameras;
}

}  // namespace roomcast::recording
