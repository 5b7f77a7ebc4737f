// SPDX-License-Identifier: Apache-2.0
// Settings of a sensor that an admin of its room can change from afar: codec, target rate, and the
// frame rate of a simulated sensor. Pure, but SettingsMailbox, which is thread-safe.
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "roomcast/core/result.h"
#include "roomcast/sensor/sender/codec_choice.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::sensor {

struct RemoteSettings {
  CodecChoice codec;
  std::optional<double> fps = {};  // nothing: the source's own, which cannot be set
};

[[nodiscard]] wire::pb::SensorSettings message_from(const RemoteSettings& settings);

/// `now` with the changes that are asked for. kInvalidArgument: this sensor cannot send so; the
/// sentence is for the admin who asked.
[[nodiscard]] Result<RemoteSettings> changed(RemoteSettings now,
                                             const wire::pb::SensorSettings& wanted);

/// The newest request that nobody has taken yet, and the token with which to join again where a
/// one-time code was used.
class SettingsMailbox {
 public:
  void put(wire::pb::SettingsRequest request) {
    const std::scoped_lock lock(mutex_);
    request_ = std::move(request);
  }
  [[nodiscard]] std::optional<wire::pb::SettingsRequest> take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(request_, std::nullopt);
  }
  void keep_token(std::string token) {
    const std::scoped_lock lock(mutex_);
    token_ = std::move(token);
  }
  /// Empty: none was given.
  [[nodiscard]] std::string token() {
    const std::scoped_lock lock(mutex_);
    return token_;
  }

 private:
  std::mutex mutex_;
  std::optional<wire::pb::SettingsRequest> request_;
  std::string token_;
};

}  // namespace roomcast::sensor
