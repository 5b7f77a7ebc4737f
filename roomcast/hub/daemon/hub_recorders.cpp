// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/hub_recorders.h"

#include <algorithm>
#include <utility>

#include <boost/asio/post.hpp>

#include "roomcast/io/numbered_files.h"
#include "roomcast/io/private_folder.h"
#include "roomcast/recording/recorder/unix_clock.h"

namespace roomcast::hub::daemon {

namespace {

using hub::RecordingState;

constexpr std::chrono::minutes kBetweenLooks{10};
constexpr std::chrono::seconds kUntilTheRest{1};  // many files are read a few at a time

}  // namespace

HubRecorders::HubRecorders(const OwnHub& hub, std::filesystem::path folder, LogSink log,
                           Retention retention)
    : hub_(hub),
      folder_(std::move(folder)),
      retention_(retention),
      log_(std::move(log)),
      worker_([this] { orders_.run(); }),
      kept_(folder_, [this](const std::filesystem::path& file) { return is_running(file); }) {
  if (retention_.any()) boost::asio::post(orders_, [this] { retain(); });
}

HubRecorders::~HubRecorders() {
  boost::asio::post(orders_, [this] {
    ending_ = true;
    next_look_.cancel();
  });
  keep_open_.reset();
  worker_.join();
}

/// The recording's state with the recorder's current counters.
hub::RoomRecording HubRecorders::current_status(const Recording& recording) {
  hub::RoomRecording status = recording.status;
  if (!recording.recorder) return status;
  const recording::RecorderStats stats = recording.recorder->stats();
  status.frames = stats.frames;
  status.bytes = stats.file_bytes;
  const auto length = std::chrono::steady_clock::now() - recording.since;
  status.seconds = std::chrono::duration<double>(length).count();
  if (const auto failure = recording.recorder->failure()) {
    status.state = RecordingState::kFailed;
    status.problem = failure->message;
  }
  return status;
}

hub::RoomRecording HubRecorders::now(const std::string& room) const {
  const std::lock_guard lock(mutex_);
  const auto found = recordings_.find(room);
  return found == recordings_.end() ? hub::RoomRecording{} : current_status(found->second);
}

bool HubRecorders::is_running(const std::filesystem::path& file) const {
  const std::lock_guard lock(mutex_);
  return std::ranges::any_of(recordings_, [&](const auto& entry) {
    const hub::RoomRecording status = current_status(entry.second);
    return status.state != RecordingState::kOff && status.state != RecordingState::kFailed &&
           status.file == file.string();
  });
}

Status HubRecorders::start(const std::string& room, const std::string& by) {
  const std::lock_guard lock(mutex_);
  Recording& recording = recordings_[room];
  const RecordingState state = current_status(recording).state;
  if (state != RecordingState::kOff && state != RecordingState::kFailed) {
    return Error{ErrorCode::kInvalidArgument, "the room " + room + " is being recorded already"};
  }
  recording.status = {.state = RecordingState::kStarting, .file = {}, .problem = {}};
  // A failed recorder is destroyed on the worker, too, because that may wait for the disk.
  std::shared_ptr<recording::Recorder> before = std::move(recording.recorder);
  boost::asio::post(orders_, [this, room, by, before = std::move(before)]() mutable {
    before.reset();
    open(room, by);
  });
  return {};
}

Status HubRecorders::stop(const std::string& room) {
  const std::lock_guard lock(mutex_);
  Recording& recording = recordings_[room];
  recording.status = current_status(recording);
  if (recording.status.state != RecordingState::kOn) {
    return Error{ErrorCode::kInvalidArgument, "the room " + room + " is not being recorded"};
  }
  recording.status.state = RecordingState::kStopping;
  const std::shared_ptr<recording::Recorder> recorder = std::move(recording.recorder);
  boost::asio::post(orders_, [this, room, recorder] { finish(room, *recorder); });
  return {};
}

Result<std::unique_ptr<recording::Recorder>> HubRecorders::open_recorder(
    const std::string& room, const std::string& by, const std::filesystem::path& file) const {
  recording::RecorderOptions options;
  OwnHub::Access access = hub_.access();
  options.hub_url = std::move(access.url);
  options.credential.token = std::move(access.token);
  options.room = room;
  options.path = file;
  options.by = by;
  options.log = log_;
  return recording::Recorder::open(std::move(options));
}

void HubRecorders::open(const std::string& room, const std::string& by) {
  std::error_code error;
  if (!std::filesystem::exists(folder_, error)) (void)io::make_private_folder(folder_, {});
  const auto file = io::next_free_path(folder_, io::file_stem(room), ".mcap");
  auto recorder = file ? open_recorder(room, by, *file)
                       : Result<std::unique_ptr<recording::Recorder>>(file.error());
  const std::lock_guard lock(mutex_);
  Recording& recording = recordings_[room];
  if (!recorder) {
    recording.status.state = RecordingState::kFailed;
    recording.status.problem = recorder.error().message;
    return;
  }
  recording.status.state = RecordingState::kOn;
  recording.status.file = file->string();
  recording.since = std::chrono::steady_clock::now();
  recording.recorder = *std::move(recorder);
}

void HubRecorders::finish(const std::string& room, recording::Recorder& recorder) {
  const Status finished = recorder.finish();
  const std::lock_guard lock(mutex_);
  hub::RoomRecording& status = recordings_[room].status;
  status.bytes = recorder.stats().file_bytes;
  status.state = finished ? RecordingState::kOff : RecordingState::kFailed;
  if (!finished) status.problem = finished.error().message;
  if (retention_.any()) retain_in(std::chrono::seconds(0));
}

void HubRecorders::retain_in(std::chrono::seconds time) {
  if (ending_) return;
  next_look_.expires_after(time);  // replaces the one that was planned
  next_look_.async_wait([this](boost::system::error_code cancelled) {
    if (!cancelled) retain();
  });
}

void HubRecorders::retain() {
  // Files are as old as the calendar says; a clock that is read once would not follow it.
  kept_.retain(retention_, recording::UnixClock().now(),
               [this](const RecordingFolder::Retained& retained) {
                 tell_of(retained);
                 const bool more = retained.unread > 0;
                 boost::asio::post(orders_, [this, more] {
                   retain_in(more ? kUntilTheRest : std::chrono::seconds(kBetweenLooks));
                 });
               });
}

void HubRecorders::tell_of(const RecordingFolder::Retained& retained) const {
  if (!log_) return;
  for (const AgingRecording& recording : retained.deleted) {
    log_(LogLevel::kInfo, "deleted the recording " + recording.name + ", which is not kept longer",
         {{"room", recording.room}});
  }
  if (!retained.problem.empty()) log_(LogLevel::kWarning, retained.problem);
}

}  // namespace roomcast::hub::daemon
