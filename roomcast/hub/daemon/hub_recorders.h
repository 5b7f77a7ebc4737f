// SPDX-License-Identifier: Apache-2.0
// The recorders that come with a hub: one for each room that is being kept, in the same process,
// clients of the hub like any other. Opening and ending a file waits for hub and disk, so a thread
// of their own does it. Threading: thread-safe.
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

#include "roomcast/core/log.h"
#include "roomcast/hub/daemon/hub_aligners.h"
#include "roomcast/hub/runtime/room_recordings.h"
#include "roomcast/recording/recorder/recorder.h"

namespace roomcast::hub::daemon {

class HubRecorders final : public hub::RoomRecordings {
 public:
  /// Files go into `folder`, which is made when it is needed.
  HubRecorders(std::filesystem::path folder, LogSink log);
  /// Ends what is being recorded.
  ~HubRecorders() override;

  /// The hub is open, and takes this token. Call it before it runs.
  void serve(OwnHub hub, std::string token);
  /// The hub's certificate was renewed.
  void trust(const net::Fingerprint& certificate);

  Status start(const std::string& room) override;
  Status stop(const std::string& room) override;
  [[nodiscard]] hub::RoomRecording now(const std::string& room) const override;

 private:
  struct Recording {
    hub::RoomRecording said;  // all of it while there is no recorder
    std::unique_ptr<recording::Recorder> recorder;
    std::chrono::steady_clock::time_point since;
  };

  [[nodiscard]] static hub::RoomRecording as_it_is(const Recording& recording);

  // On the worker.
  void open(const std::string& room);
  void finish(const std::string& room, recording::Recorder& recorder);
  Result<std::unique_ptr<recording::Recorder>> open_recorder(const std::string& room,
                                                  const std::filesystem::path& file) const;

  const std::filesystem::path folder_;
  const LogSink log_;
  mutable std::mutex mutex_;
  OwnHub hub_;
  std::string token_;
  std::map<std::string, Recording> recordings_;  // by room
  boost::asio::io_context orders_{1};            // at most one of each room
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> keep_open_ =
      boost::asio::make_work_guard(orders_);
  std::jthread worker_;  // last: uses all of the above
};

}  // namespace roomcast::hub::daemon
