// SPDX-License-Identifier: Apache-2.0
// The hub's built-in recorders: one for each room that is recorded. They run in the hub's process
// but connect as clients. Opening and finishing a file waits for hub and disk, so a separate thread
// does it. Threading: thread-safe.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>

#include "roomcast/core/log.h"
#include "roomcast/hub/daemon/own_hub.h"
#include "roomcast/hub/daemon/recording_folder.h"
#include "roomcast/hub/runtime/room_recordings.h"
#include "roomcast/recording/recorder/recorder.h"

namespace roomcast::hub::daemon {

class HubRecorders final : public hub::RoomRecordings {
 public:
  /// `hub` must outlive the recorders. Files go into `folder`, which is created when needed.
  /// `retention` is looked to at the start, every ten minutes, and after each recording.
  HubRecorders(const OwnHub& hub, std::filesystem::path folder, LogSink log,
               Retention retention = {});
  /// Finishes all recordings.
  ~HubRecorders() override;

  Status start(const std::string& room, const std::string& by) override;
  Status stop(const std::string& room) override;
  [[nodiscard]] hub::RoomRecording now(const std::string& room) const override;
  [[nodiscard]] hub::KeptRecordings& kept() override { return kept_; }

 private:
  struct Recording {
    hub::RoomRecording status;  // the whole state while there is no recorder
    std::unique_ptr<recording::Recorder> recorder;
    std::chrono::steady_clock::time_point since;
  };

  [[nodiscard]] static hub::RoomRecording current_status(const Recording& recording);

  // Called on the worker.
  void open(const std::string& room, const std::string& by);
  void finish(const std::string& room, recording::Recorder& recorder);
  Result<std::unique_ptr<recording::Recorder>> open_recorder(
      const std::string& room, const std::string& by, const std::filesystem::path& file) const;
  [[nodiscard]] bool is_running(const std::filesystem::path& file) const;
  void retain();
  void retain_in(std::chrono::seconds time);
  void tell_of(const RecordingFolder::Retained& retained) const;

  const OwnHub& hub_;
  const std::filesystem::path folder_;
  const Retention retention_;
  const LogSink log_;
  mutable std::mutex mutex_;
  std::map<std::string, Recording> recordings_;  // by room
  boost::asio::io_context orders_{1};            // tasks of the worker; at most one per room
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> keep_open_ =
      boost::asio::make_work_guard(orders_);
  boost::asio::steady_timer next_look_{orders_};  // on the worker
  bool ending_ = false;                           // the same
  std::jthread worker_;                           // uses all of the above
  RecordingFolder kept_;
};

}  // namespace roomcast::hub::daemon
