// SPDX-License-Identifier: Apache-2.0
// The models of a hub's rooms: one RoomModeler for each room that has had a sensor, or of which a
// model is on disk. They run in the hub's process but connect as clients. Threading: thread-safe.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "roomcast/core/log.h"
#include "roomcast/hub/daemon/own_hub.h"
#include "roomcast/hub/runtime/room_models.h"
#include "roomcast/recording/modeler/room_modeler.h"

namespace roomcast::hub::daemon {

class HubModels final : public hub::RoomModels {
 public:
  /// `hub` must outlive the models. `folder`: for what is kept of the rooms; nothing: nothing is
  /// kept.
  HubModels(const OwnHub& hub, std::optional<std::filesystem::path> folder, LogSink log)
      : hub_(hub), folder_(std::move(folder)), log_(std::move(log)) {}

  /// The hub is open: the models on disk begin.
  void start_kept();
  /// A room has its first sensor.
  void start(const std::string& room);

  [[nodiscard]] std::shared_ptr<const std::string> changes_after(
      const std::string& room, std::uint64_t known) const override;

 private:
  const OwnHub& hub_;
  const std::optional<std::filesystem::path> folder_;
  const LogSink log_;
  mutable std::mutex mutex_;
  std::map<std::string, std::unique_ptr<recording::RoomModeler>> modelers_;  // by room
};

}  // namespace roomcast::hub::daemon
