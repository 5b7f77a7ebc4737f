// SPDX-License-Identifier: Apache-2.0
// RoomModeler: joins a hub and keeps the model of what stands still in a running room: gathers the
// sensors' key frames, fuses them when something noticeable has changed, and gives the model and
// its changes. While nobody watches the room no frames come, and it does nothing. The views are
// kept on disk, so that the model is there again after a restart. Threading: has two threads of its
// own, of low priority, one of which fuses; thread-safe.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "roomcast/core/log.h"
#include "roomcast/model/model_options.h"

namespace roomcast::recording {

/// Cells of 2 cm, and a memory of some seconds: key frames come every few seconds.
[[nodiscard]] model::ModelOptions running_room_options();

struct RoomModelerOptions {
  std::string hub_url;
  std::string room;
  std::string token;                  // an admin's
  std::filesystem::path folder = {};  // for the views; empty: they are not kept
  model::ModelOptions model = running_room_options();
  LogSink log = {};
};

class RoomModeler {
 public:
  /// Returns at once; connects in the background, and again whenever it must.
  explicit RoomModeler(RoomModelerOptions options);
  /// Writes the views to disk.
  ~RoomModeler();

  /// docs/spec/model.md, for a viewer who has the model of version `known` (0: none). Null: there
  /// is nothing newer.
  [[nodiscard]] std::shared_ptr<const std::string> changes_after(std::uint64_t known) const;

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace roomcast::recording
