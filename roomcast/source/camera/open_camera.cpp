// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/camera/open_camera.h"

#include <charconv>
#include <optional>

#include "roomcast/source/camera/usb_device.h"

namespace roomcast::source {
namespace {

/// Accepts "" and "0" to "99"; a longer text is a serial number.
std::optional<std::size_t> position(const std::string& place) {
  if (place.empty()) return 0;
  constexpr std::size_t kMaxDigits = 2;
  std::size_t number = 0;
  const char* const end = place.data() + place.size();
  const auto [stop, error] = std::from_chars(place.data(), end, number);
  if (place.size() > kMaxDigits || error != std::errc() || stop != end) return std::nullopt;
  return number;
}

Result<CameraInfo> find_camera(CameraBackend& backend, const std::string& place) {
  if (backend.plays(place)) return CameraInfo{place, "file", ""};
  const auto cameras = backend.list();
  if (!cameras) return cameras.error();
  return choose_camera(*cameras, backend.kind(), place);
}

}  // namespace

Result<CameraInfo> choose_camera(const std::vector<CameraInfo>& cameras, const std::string& kind,
                                 const std::string& place) {
  for (const CameraInfo& camera : cameras) {
    if (!place.empty() && (camera.serial == place || camera.place == place)) return camera;
  }
  const auto index = position(place);
  if (index && *index < cameras.size()) return cameras[*index];
  if (cameras.empty()) {
    return Error{
        ErrorCode::kNotFound,
        "no " + kind +
            " camera was found; check its cable and power, roomcast devices lists cameras"};
  }
  std::string known;
  for (const CameraInfo& camera : cameras)
    known += (known.empty() ? "" : ", ") + (camera.serial.empty() ? camera.place : camera.serial);
  return Error{ErrorCode::kNotFound,
               "no " + kind + " camera \"" + place + "\" was found, only " + known};
}

Result<std::unique_ptr<Camera>> open_camera(CameraBackend& backend, const std::string& place,
                                            const CameraSettings& settings) {
  if (Status status = settings.check(); !status) return status.error();
  Status able = check_abilities(backend.kind(), backend.abilities(), settings);
  if (!able) return able.error();
  const auto found = find_camera(backend, place);
  if (!found) return found.error();
  auto camera = backend.open(*found, settings);
  if (camera || backend.plays(place)) return camera;
  if (found->obstacle) return *found->obstacle;
  if (auto obstacle = obstacle_of_kind(usb_cameras(), backend.kind())) return *std::move(obstacle);
  return camera;
}

}  // namespace roomcast::source
