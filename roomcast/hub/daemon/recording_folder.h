// SPDX-License-Identifier: Apache-2.0
// RecordingFolder: the recordings in the hub's folder: FOLDER/NAME.mcap. A file belongs to the room
// that it names itself. What was read of a file is kept until the file changes, so that a list
// costs a look at the folder only. Links, hidden files and names that cannot be shown are passed
// over. Disk and damaged files can take long, so a thread of its own does all of it. Threading:
// thread-safe.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>

#include "roomcast/hub/daemon/retention.h"
#include "roomcast/hub/runtime/kept_recordings.h"
#include "roomcast/recording/room/recording_part.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub::daemon {

class RecordingFolder final : public hub::KeptRecordings {
 public:
  static constexpr std::size_t kMaxListed = 1000;
  static constexpr std::size_t kMaxNameBytes = wire::kMaxRecordingNameBytes;

  /// `is_running`: whether a file is being written just now. Called on the worker.
  RecordingFolder(std::filesystem::path folder,
                  std::function<bool(const std::filesystem::path&)> is_running);
  ~RecordingFolder() override;

  void list(hub::RecordingScope scope, hub::WhenKnown<hub::RecordingList> done) override;
  void about(hub::RecordingScope scope, std::string name,
             hub::WhenKnown<hub::KeptRecording> done) override;
  void part(hub::RecordingScope scope, std::string name, hub::WantedPart wanted,
            hub::WhenKnown<std::shared_ptr<const std::string>> done) override;
  void open(hub::RecordingScope scope, std::string name,
            hub::WhenKnown<std::shared_ptr<const net::LongBody>> done) override;
  void rename(hub::RecordingScope scope, std::string name, std::string to,
              hub::WhenKnown<hub::KeptRecording> done) override;
  void remove(hub::RecordingScope scope, std::string name,
              std::function<void(Status)> done) override;
  void settle() override;

  struct Retained {
    std::vector<AgingRecording> deleted;
    std::size_t unread = 0;  // files that could not be looked at in time: ask again
    std::string problem;     // why the disk kept a file; empty: it kept none
  };
  /// Deletes what `retention` does not keep. `now`: since 1970-01-01 UTC. `done` on the worker.
  void retain(Retention retention, nanoseconds now, std::function<void(Retained)> done);

 private:
  /// What a change of the file changes.
  struct Stamp {
    std::uint64_t bytes = 0;
    std::int64_t changed_ns = 0;
    friend bool operator==(const Stamp&, const Stamp&) = default;
  };
  struct Found {
    std::string name;
    Stamp stamp;
  };
  struct Known {
    Stamp stamp;
    hub::KeptRecording recording;
  };

  /// Being played, by whomever.
  struct Playable {
    std::string name;
    Stamp stamp;
    std::shared_ptr<const recording::PlayableRecording> recording;
  };

  // All of these on the worker.
  [[nodiscard]] std::filesystem::path path_of(const std::string& name) const;
  [[nodiscard]] static std::optional<Stamp> stamp_of(const std::filesystem::path& path);
  [[nodiscard]] std::vector<Found> look() const;
  [[nodiscard]] bool is_known(const Found& file) const;
  const hub::KeptRecording& read(const Found& file);
  hub::RecordingList list_now(const hub::RecordingScope& scope);
  Result<hub::KeptRecording> find(const hub::RecordingScope& scope, const std::string& name);
  Result<hub::KeptRecording> find_finished(const hub::RecordingScope& scope,
                                           const std::string& name);
  Result<hub::KeptRecording> rename_now(const hub::RecordingScope& scope, const std::string& name,
                                        const std::string& to);
  Result<std::shared_ptr<const std::string>> part_now(const hub::RecordingScope& scope,
                                                      const std::string& name,
                                                      const hub::WantedPart& wanted);
  Result<std::shared_ptr<const recording::PlayableRecording>> playable(const std::string& name);
  Status remove_now(const hub::RecordingScope& scope, const std::string& name);
  Status remove_file(const std::string& name);
  Retained retain_now(const Retention& retention, nanoseconds now);

  const std::filesystem::path folder_;
  const std::function<bool(const std::filesystem::path&)> is_running_;
  std::map<std::string, Known> known_;  // by name
  std::deque<Playable> playable_;       // the one that was used last first
  boost::asio::io_context orders_{1};
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> keep_open_ =
      boost::asio::make_work_guard(orders_);
  std::jthread worker_;  // last: uses all of the above
};

}  // namespace roomcast::hub::daemon
