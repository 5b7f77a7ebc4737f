// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/remote_settings.h"

#include <array>
#include <string_view>

namespace roomcast::sensor {

namespace {

constexpr std::array<std::pair<std::string_view, codec::DepthMode>, 3> kCodecNames = {
    {{"live", codec::DepthMode::kLive},
     {"near-lossless", codec::DepthMode::kNearLossless},
     {"lossless", codec::DepthMode::kLossless}}};
constexpr double kMinSetFps = 1, kMaxSetFps = 60;

std::optional<codec::DepthMode> codec_named(std::string_view name) {
  for (const auto& [text, mode] : kCodecNames) {
    if (text == name) return mode;
  }
  return std::nullopt;
}

}  // namespace

wire::pb::SensorSettings message_from(const RemoteSettings& settings) {
  wire::pb::SensorSettings message;
  for (const auto& [text, mode] : kCodecNames) {
    if (mode == settings.codec.depth_mode) message.set_codec(std::string(text));
  }
  message.set_mbit(settings.codec.target_mbit_per_s);
  message.set_fits_line(settings.codec.fits_line);
  if (settings.fps) message.set_fps(*settings.fps);
  return message;
}

Result<RemoteSettings> changed(RemoteSettings now, const wire::pb::SensorSettings& wanted) {
  if (wanted.has_codec()) {
    const auto mode = codec_named(wanted.codec());
    if (!mode)
      return invalid_argument("this sensor has the codecs live, near-lossless and lossless");
    now.codec.depth_mode = *mode;
  }
  if (wanted.has_mbit()) now.codec.target_mbit_per_s = wanted.mbit();
  if (wanted.has_fits_line()) now.codec.fits_line = wanted.fits_line();
  if (auto status = now.codec.check(); !status) return status.error();
  if (!wanted.has_fps()) return now;
  if (!now.fps)
    return invalid_argument(
        "only a simulated sensor takes another frame rate; this one has its own");
  if (!(wanted.fps() >= kMinSetFps && wanted.fps() <= kMaxSetFps))
    return invalid_argument("a frame rate is 1 to 60 per second");
  now.fps = wanted.fps();
  return now;
}

}  // namespace roomcast::sensor
