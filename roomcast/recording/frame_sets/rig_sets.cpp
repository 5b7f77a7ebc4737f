// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/frame_sets/rig_sets.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "roomcast/geometry/registration.h"
#include "roomcast/recording/playback/recording_source.h"

namespace roomcast::recording {
namespace {

/// The frames of one sensor, with the next one read ahead.
class Track {
 public:
  static Result<Track> open(Result<Recording> recording) {
    if (!recording) return recording.error();
    auto registration = Registration::create(recording->description.calibration);
    if (!registration) return registration.error();
    const nanoseconds start = recording->start;
    const double expected_error_m = 0.001 * recording->expected_error_mm;
    const double scale_error = recording->scale_error;
    Track track(*std::move(recording), std::move(*registration));
    track.start_ = start;
    track.expected_error_m_ = expected_error_m;
    track.scale_error_ = scale_error;
    if (auto status = track.advance(); !status) return status.error();
    return track;
  }

  [[nodiscard]] const source::SensorDescription& description() const {
    return source_->description();
  }
  [[nodiscard]] bool ended() const { return ended_; }
  /// Of all its frames.
  [[nodiscard]] const std::vector<nanoseconds>& times() const { return times_; }
  /// True time from which the tracks of a recording count, the same for all.
  [[nodiscard]] nanoseconds start() const { return start_; }
  [[nodiscard]] SetSensor sensor() const {
    const source::SensorDescription& sensor = source_->description();
    return {sensor.name, sensor.calibration.depth, sensor.fps, expected_error_m_, scale_error_};
  }
  /// The next frame's colour, if it is in the depth grid as it was recorded; else empty.
  [[nodiscard]] std::filesystem::path color_file() const {
    const auto found = color_files_.find(captured_.index);
    return found == color_files_.end() ? std::filesystem::path() : found->second;
  }
  [[nodiscard]] nanoseconds time() const { return captured_.capture_time.time_since_epoch(); }

  /// Returns the frame that was read ahead, and reads the next.
  Result<std::shared_ptr<const codec::DecodedFrame>> take() {
    auto frame = std::make_shared<codec::DecodedFrame>();
    if (!captured_.color.empty()) {
      if (auto status = registration_.run(captured_.depth_mm, captured_.color, registered_);
          !status)
        return status.error();
      frame->color = registered_.color;
      frame->color_seen = registered_.seen;
    }
    frame->depth_mm = captured_.depth_mm;
    if (auto status = advance(); !status) return status.error();
    return std::shared_ptr<const codec::DecodedFrame>(std::move(frame));
  }

 private:
  Track(Recording recording, Registration registration) : registration_(std::move(registration)) {
    constexpr source::PlaybackOptions kOnce{.pace = source::Pace::kAsFastAsPossible, .loop = false};
    const bool is_in_grid = recording.description.calibration.color_is_registered;
    for (const RecordedFrame& frame : recording.frames) {
      times_.push_back(frame.true_time - recording.start);
      if (is_in_grid && !frame.color.empty()) color_files_[frame.index] = frame.color;
    }
    source_ = std::make_unique<RecordingSource>(std::move(recording), kOnce, HostTime());
  }
  Status advance() {
    const auto more = source_->next(captured_, {});
    if (!more) return more.error();
    ended_ = !*more;
    return {};
  }

  nanoseconds start_{};
  double expected_error_m_ = 0, scale_error_ = 0;
  std::vector<nanoseconds> times_;
  std::map<std::uint64_t, std::filesystem::path> color_files_;  // by the number of the frame
  std::unique_ptr<source::FrameSource> source_;
  Registration registration_;
  RegisteredColor registered_;
  source::CapturedFrame captured_;
  bool ended_ = false;
};

class FolderSets final : public FrameSetReader {
 public:
  FolderSets(std::vector<Track> tracks, nanoseconds from)
      : tracks_(std::move(tracks)), newest_(tracks_.size()), from_(from) {
    for (const Track& track : tracks_) {
      sensors_.push_back(track.sensor());
      fps_ = std::max(fps_, sensors_.back().fps);
    }
  }

  const std::vector<SetSensor>& sensors() const override { return sensors_; }
  nanoseconds length() const override { return {}; }
  nanoseconds began_at() const override {
    const nanoseconds start = tracks_.front().start();
    return start > kEarliestUtc ? start : nanoseconds(0);
  }

  std::optional<std::uint64_t> set_count() const override {
    // By instant: the sets' times. Frames of one track at the same instant are in different sets.
    std::map<std::int64_t, std::vector<nanoseconds>> sets;
    for (const Track& track : tracks_) {
      std::map<std::int64_t, std::size_t> taken;
      for (const nanoseconds time : track.times()) {
        std::vector<nanoseconds>& at_instant = sets[instant_of(time)];
        const std::size_t number = taken[instant_of(time)]++;
        if (at_instant.size() <= number) at_instant.resize(number + 1);
        at_instant[number] = std::max(at_instant[number], time);
      }
    }
    std::uint64_t count = 0;
    for (const auto& [instant, times] : sets)
      count += static_cast<std::uint64_t>(
          std::ranges::count_if(times, [&](nanoseconds time) { return time >= from_; }));
    return count;
  }

  Result<bool> next(FrameSet& set) override {
    for (;;) {
      if (std::ranges::all_of(tracks_, &Track::ended)) return false;
      auto taken = take_instant();
      if (!taken) return taken.error();
      if (*taken < from_) continue;
      set.time = *taken;
      set.number = count_++;
      set.frames.clear();
      for (const SetFrame& frame : newest_) {
        if (frame.pictures && set.time - frame.time <= kOldestInSet) set.frames.push_back(frame);
      }
      return true;
    }
  }

 private:
  [[nodiscard]] std::int64_t instant_of(nanoseconds time) const {
    return std::llround(std::chrono::duration<double>(time).count() * fps_);
  }

  /// Reads the frames of the next instant into `newest_`; returns the newest capture time.
  Result<nanoseconds> take_instant() {
    std::int64_t instant = std::numeric_limits<std::int64_t>::max();
    for (const Track& track : tracks_) {
      if (!track.ended()) instant = std::min(instant, instant_of(track.time()));
    }
    nanoseconds time{};
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
      Track& track = tracks_[i];
      if (track.ended() || instant_of(track.time()) != instant) continue;
      const nanoseconds taken = track.time();
      const std::filesystem::path color_file = track.color_file();
      auto pictures = track.take();
      if (!pictures) return pictures.error();
      newest_[i] = {i, std::move(*pictures), track.description().world_from_depth, taken,
                    color_file};
      time = std::max(time, taken);
    }
    return time;
  }

  std::vector<Track> tracks_;
  std::vector<SetFrame> newest_;
  const nanoseconds from_;
  std::vector<SetSensor> sensors_;
  double fps_ = 0;
  std::uint64_t count_ = 0;
};

Result<std::vector<Track>> open_tracks(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::vector<Track> tracks;
  if (std::filesystem::exists(folder / "depth.txt", ignored)) {
    auto track = Track::open(read_tum_recording(folder));
    if (!track) return track.error();
    tracks.push_back(std::move(*track));
    return tracks;
  }
  if (!std::filesystem::exists(folder / "rig.json", ignored)) {
    return Error{ErrorCode::kNotFound,
                 folder.string() + " is not a recording: it has neither rig.json nor depth.txt"};
  }
  const auto names = rig_sensor_names(folder);
  if (!names) return names.error();
  for (const std::string& name : *names) {
    auto track = Track::open(read_rig_recording(folder, name));
    if (!track) return track.error();
    tracks.push_back(std::move(*track));
  }
  return tracks;
}

}  // namespace

Result<std::unique_ptr<FrameSetReader>> open_folder_sets(const std::filesystem::path& folder,
                                                         nanoseconds from) {
  auto tracks = open_tracks(folder);
  if (!tracks) return tracks.error();
  return std::unique_ptr<FrameSetReader>(std::make_unique<FolderSets>(std::move(*tracks), from));
}

}  // namespace roomcast::recording
