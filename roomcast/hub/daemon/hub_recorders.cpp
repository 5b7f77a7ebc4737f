// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/hub_recorders.h"

#include <utility>

#include <boost/asio/post.hpp>

#include "roomcast/io/numbered_files.h"

namespace roomcast::hub::daemon {

namespace {

using hub::RecordingState;

}  // namespace

HubRecorders::HubRecorders(std::filesystem::path folder, LogSink log)
    : folder_(std::move(folder)), log_(std::move(log)), worker_([this] { orders_.run(); }) {}

HubRecorders::~HubRecorders() {
  keep_open_.reset();
  worker_.join();
}

void HubRecorders::serve(OwnHub hub, std::string token) {
  const std::lock_guard lock(mutex_);
  hub_ = std::move(hub);
  token_ = std::move(token);
}

void HubRecorders::trust(const net::Fingerprint& certificate) {
  const std::lock_guard lock(mutex_);
  hub_.certificate = certificate;
}

/// The recording's state with the recorder's current counters.
hub::RoomRecording HubRecorders::as_it_is(const Recording& recording) {
  hub::RoomRecording said = recording.said;
  if (!recording.recorder) return said;
  const recording::RecorderStats stats = recording.recorder->stats();
  said.frames = stats.frames;
  said.bytes = stats.file_bytes;
  const auto length = std::chrono::steady_clock::now() - recording.since;
  said.seconds = std::chrono::duration<double>(length).count();
  if (const auto failure = recording.recorder->failure()) {
    said.state = RecordingState::kFailed;
    said.problem = failure->message;
  }
  return said;
}

hub::RoomRecording HubRecorders::now(const std::string& room) const {
  const std::lock_guard lock(mutex_);
  const auto found = recordings_.find(room);
  return found == recordings_.end() ? hub::RoomRecording{} : as_it_is(found->second);
}

Status HubRecorders::start(const std::string& room) {
  const std::lock_guard lock(mutex_);
  Recording& recording = recordings_[room];
  const RecordingState state = as_it_is(recording).state;
  if (state != RecordingState::kOff && state != RecordingState::kFailed) {
    return Error{ErrorCode::kInvalidArgument, "the room " + room + " is being recorded already"};
  }
  recording.said = {.state = RecordingState::kStarting, .file = {}, .problem = {}};
  // A failed recorder is destroyed on the worker, too, because that may wait for the disk.
  std::shared_ptr<recording::Recorder> before = std::move(recording.recorder);
  boost::asio::post(orders_, [this, room, before = std::move(before)]() mutable {
    before.reset();
    open(room);
  });
  return {};
}

Status HubRecorders::stop(const std::string& room) {
  const std::lock_guard lock(mutex_);
  Recording& recording = recordings_[room];
  recording.said = as_it_is(recording);
  if (recording.said.state != RecordingState::kOn) {
    return Error{ErrorCode::kInvalidArgument, "the room " + room + " is not being recorded"};
  }
  recording.said.state = RecordingState::kStopping;
  const std::shared_ptr<recording::Recorder> recorder = std::move(recording.recorder);
  boost::asio::post(orders_, [this, room, recorder] { finish(room, *recorder); });
  return {};
}

Result<std::unique_ptr<recording::Recorder>> HubRecorders::open_recorder(
    const std::string& room, const std::filesystem::path& file) const {
  recording::RecorderOptions options;
  {
    const std::lock_guard lock(mutex_);
    options.hub_url = own_hub_url(hub_);
    options.credential.token = token_;
  }
  options.room = room;
  options.path = file;
  options.log = log_;
  return recording::Recorder::open(std::move(options));
}

void HubRecorders::open(const std::string& room) {
  const auto file = io::next_free_path(folder_, io::file_stem(room), ".mcap");
  auto recorder = file ? open_recorder(room, *file)
                       : Result<std::unique_ptr<recording::Recorder>>(file.error());
  const std::lock_guard lock(mutex_);
  Recording& recording = recordings_[room];
  if (!recorder) {
    recording.said.state = RecordingState::kFailed;
    recording.said.problem = recorder.error().message;
    return;
  }
  recording.said.state = RecordingState::kOn;
  recording.said.file = file->string();
  recording.since = std::chrono::steady_clock::now();
  recording.recorder = *std::move(recorder);
}

void HubRecorders::finish(const std::string& room, recording::Recorder& recorder) {
  const Status finished = recorder.finish();
  const std::lock_guard lock(mutex_);
  hub::RoomRecording& said = recordings_[room].said;
  said.bytes = recorder.stats().file_bytes;
  said.state = finished ? RecordingState::kOff : RecordingState::kFailed;
  if (!finished) said.problem = finished.error().message;
}

}  // namespace roomcast::hub::daemon
