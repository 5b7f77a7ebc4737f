// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/room/recording_part.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "roomcast/core/little_endian.h"
#include "roomcast/wire/audio_header.h"
#include "roomcast/wire/control.h"
#include "roomcast/wire/control_check.h"
#include "roomcast/wire/frame_header.h"
#include "roomcast/wire/limits.h"
#include "roomcast/wire/parse_message.h"

namespace roomcast::recording {

namespace pb = wire::pb;

namespace {

constexpr std::uint32_t kIsPast = 1;               // of a record
constexpr std::uint32_t kHasDamage = 1;            // of a part
constexpr std::chrono::seconds kPosesLookBack{1};  // at least
constexpr std::size_t kMarksMessageBytes = wire::kMaxControlFromHubBytes / 2;
constexpr std::size_t kMarkOverheadBytes = 8;  // of a mark in a message

/// The frames of a sensor that its last frame before a moment needs, found from the last to the
/// first.
class FrameChainBack {
 public:
  [[nodiscard]] bool is_whole() const { return is_whole_; }
  /// Whether this frame, which is older than all given before, is one of them.
  bool takes(const wire::FrameHeader& header) {
    if (is_whole_ || (needed_ && *needed_ != header.seq)) return false;
    is_whole_ = header.key;
    needed_ = header.base_seq;
    return true;
  }

 private:
  std::optional<std::uint32_t> needed_;  // nothing: any
  bool is_whole_ = false;
};

template <class T>
bool parse_checked(std::span<const std::uint8_t> bytes, pb::Control& control, T* message) {
  return wire::parse_message(bytes, *message) && wire::check_control(control).ok();
}

std::vector<std::uint8_t> encoded(const pb::Control& control) {
  std::vector<std::uint8_t> bytes;
  wire::encode_control(control, bytes);
  return bytes;
}

}  // namespace

/// Appends records, and writes the header at last.
class PlayableRecording::Builder {
 public:
  Builder(nanoseconds start, nanoseconds from) : start_(start), from_(from), until_(from) {
    out_.resize(kPartHeaderBytes);
  }

  void add(nanoseconds time, std::span<const std::uint8_t> message, std::uint32_t flags = 0) {
    const std::size_t at = out_.size();
    out_.resize(at + kPartRecordHeaderBytes);
    write_u32(&out_[at], static_cast<std::uint32_t>(message.size()));
    write_u32(&out_[at + 4], flags);
    write_u64(&out_[at + 8], microseconds_at(time));
    out_.insert(out_.end(), message.begin(), message.end());
  }
  void add_damage() { damage_ = kHasDamage; }
  void reach(nanoseconds time) { until_ = std::max(until_, time); }
  [[nodiscard]] bool is_full() const {
    return until_ - from_ >= kPartLength || out_.size() >= kPartBytes;
  }

  std::string finish(std::size_t next, std::size_t chunks) {
    write_u32(out_.data(), kPartMagic);
    write_u16(&out_[4], kPartVersion);
    write_u16(&out_[6], kPartHeaderBytes);
    write_u64(&out_[8], microseconds_at(from_));
    write_u64(&out_[16], microseconds_at(until_));
    write_u32(&out_[24], next < chunks ? static_cast<std::uint32_t>(next) : kNoPart);
    write_u32(&out_[28], damage_);
    return {out_.begin(), out_.end()};
  }

 private:
  [[nodiscard]] std::uint64_t microseconds_at(nanoseconds time) const {
    const auto since = std::chrono::duration_cast<std::chrono::microseconds>(time - start_).count();
    return static_cast<std::uint64_t>(std::max<std::int64_t>(since, 0));
  }
  nanoseconds start_, from_, until_;
  std::uint32_t damage_ = 0;
  std::vector<std::uint8_t> out_;
};

Result<PlayableRecording> PlayableRecording::open(const std::filesystem::path& path) {
  auto recording = RoomRecording::open(path);
  if (!recording) return recording.error();
  PlayableRecording playable(*std::move(recording));
  playable.read_marks();
  return playable;
}

void PlayableRecording::read_marks() {
  const auto& summary = recording_.file().summary();
  for (std::size_t i = 0; i < summary.chunks.size(); ++i) {
    const auto& offsets = summary.chunks[i].message_index_offsets;
    const bool has_marks = offsets.empty() || std::ranges::any_of(offsets, [&](const auto& entry) {
                             return recording_.kind_of(entry.first) == MessageKind::kMarks;
                           });
    if (!has_marks) continue;
    const auto chunk = recording_.file().chunk(i);
    if (!chunk) continue;
    for (const mcap::Message& message : chunk->messages) {
      pb::Control control;
      if (recording_.kind_of(message.channel) == MessageKind::kMarks &&
          parse_checked(message.data, control, control.mutable_marks()))
        marks_.push_back({message.log_time, std::move(*control.mutable_marks())});
    }
  }
}

/// All of them, as a viewer gets them that joins.
std::vector<pb::Control> PlayableRecording::marks_at(nanoseconds time) const {
  std::map<std::uint32_t, const pb::Mark*> present;
  for (const Change& change : marks_) {
    if (change.time > time) break;
    if (change.marks.all()) present.clear();
    for (const std::uint32_t removed : change.marks.removed()) present.erase(removed);
    for (const pb::Mark& mark : change.marks.marks()) present[mark.id()] = &mark;
  }
  std::vector<pb::Control> messages(1);
  messages[0].mutable_marks()->set_all(true);
  std::size_t bytes = 0;
  for (const auto& [id, mark] : present) {
    bytes += mark->ByteSizeLong() + kMarkOverheadBytes;
    if (bytes > kMarksMessageBytes) {
      messages.emplace_back();
      bytes = mark->ByteSizeLong() + kMarkOverheadBytes;
    }
    *messages.back().mutable_marks()->add_marks() = *mark;
  }
  return messages;
}

/// The last chunk that begins at `time` or before; the first one if there is none.
std::size_t PlayableRecording::chunk_at(nanoseconds time) const {
  const auto& chunks = recording_.file().summary().chunks;
  for (std::size_t i = chunks.size(); i-- > 0;)
    if (chunks[i].start_time <= time) return i;
  return 0;
}

nanoseconds PlayableRecording::within(nanoseconds since_start) const {
  const nanoseconds length = recording_.end() - recording_.start();
  return recording_.start() + std::clamp(since_start, nanoseconds(0), length);
}

std::string PlayableRecording::moment(nanoseconds time) const {
  const nanoseconds at = within(time);
  Builder part(recording_.start(), at);
  const std::size_t chunks = recording_.file().summary().chunks.size();
  if (chunks == 0) return part.finish(0, 0);
  const std::size_t chunk = chunk_at(at);
  add_past(at, chunk, part);
  add_chunk(chunk, at, part);
  return part.finish(chunk + 1, chunks);
}

Result<std::string> PlayableRecording::part(std::uint32_t chunk) const {
  const auto& chunks = recording_.file().summary().chunks;
  if (chunk >= chunks.size()) return Error{ErrorCode::kNotFound, "the recording has no such part"};
  Builder part(recording_.start(), std::max(chunks[chunk].start_time, recording_.start()));
  std::size_t next = chunk;
  do {
    add_chunk(next++, nanoseconds::min(), part);
  } while (next < chunks.size() && !part.is_full());
  return part.finish(next, chunks.size());
}

std::string PlayableRecording::key_frame(std::string_view sensor, nanoseconds time) const {
  const nanoseconds at = within(time);
  Builder part(recording_.start(), at);
  const auto& chunks = recording_.file().summary().chunks;
  const auto of = std::ranges::find(recording_.sensors(), sensor, &RecordedSensor::name);
  if (of == recording_.sensors().end() || chunks.empty())
    return part.finish(chunks.size(), chunks.size());
  std::optional<Found> found;
  std::uint64_t looked_at = 0;
  const std::size_t chunk = chunk_at(at);
  for (std::size_t i = chunk + 1; !found && i-- > 0;) {
    looked_at += chunks[i].uncompressed_size;
    if (at - chunks[i].end_time > kMaxLookBack || looked_at > kMaxLookBackBytes) break;
    found = key_frame_in(i, of->frames_channel, nanoseconds::min(), at);
  }
  for (std::size_t i = chunk; !found && i < std::min(chunk + 2, chunks.size()); ++i)
    found = key_frame_in(i, of->frames_channel, at, nanoseconds::max());
  if (found) part.add(found->time, found->message, found->time <= at ? kIsPast : 0);
  return part.finish(chunks.size(), chunks.size());
}

/// The last key frame after `from` and up to `until`.
std::optional<PlayableRecording::Found> PlayableRecording::key_frame_in(std::size_t chunk,
                                                                        mcap::ChannelId frames,
                                                                        nanoseconds from,
                                                                        nanoseconds until) const {
  std::optional<Found> found;
  const auto contents = recording_.file().chunk(chunk);
  if (!contents) return found;
  for (const mcap::Message& message : contents->messages) {
    if (message.channel != frames || message.log_time <= from || message.log_time > until) continue;
    const auto header = wire::parse_frame(message.data);
    if (header && header->key)
      found = Found{message.log_time, {message.data.begin(), message.data.end()}};
  }
  return found;
}

/// The room as it was at `time`: sensors and people, marks, where people were, and the frames of
/// each sensor that its last one needs.
void PlayableRecording::add_past(nanoseconds time, std::size_t chunk, Builder& part) const {
  const auto& chunks = recording_.file().summary().chunks;
  std::map<mcap::ChannelId, FrameChainBack> chains;
  for (const RecordedSensor& sensor : recording_.sensors()) chains[sensor.frames_channel];
  std::map<std::uint32_t, pb::ViewerPose> poses;
  std::vector<Found> frames;  // the newest first
  std::uint64_t looked_at = 0;
  const auto is_whole = [](const auto& chain) { return chain.second.is_whole(); };
  for (std::size_t i = chunk + 1; i-- > 0;) {
    const nanoseconds back = time - chunks[i].end_time;
    if (back > kPosesLookBack && std::ranges::all_of(chains, is_whole)) break;
    looked_at += chunks[i].uncompressed_size;
    if (back > kMaxLookBack || looked_at > kMaxLookBackBytes) break;
    const auto contents = recording_.file().chunk(i);
    if (!contents) break;  // what came before is of no use without it
    for (auto message = contents->messages.rbegin(); message != contents->messages.rend();
         ++message) {
      if (message->log_time > time) continue;
      pb::Control control;
      if (const auto chain = chains.find(message->channel); chain != chains.end()) {
        const auto header = wire::parse_frame(message->data);
        if (header && chain->second.takes(*header))
          frames.push_back({message->log_time, {message->data.begin(), message->data.end()}});
      } else if (recording_.kind_of(message->channel) == MessageKind::kPoses &&
                 parse_checked(message->data, control, control.mutable_viewer_poses())) {
        for (const auto& pose : control.viewer_poses().poses())
          poses.emplace(pose.viewer_id(), pose);
      }
    }
  }
  pb::Control roster, bodies;
  *roster.mutable_roster() = recording_.roster_at(time);
  part.add(time, encoded(roster), kIsPast);
  for (const pb::Control& marks : marks_at(time)) part.add(time, encoded(marks), kIsPast);
  for (const auto& [id, pose] : poses) {
    if (bodies.viewer_poses().poses_size() < wire::kMaxPosesPerMessage)
      *bodies.mutable_viewer_poses()->add_poses() = pose;
  }
  if (bodies.has_viewer_poses()) part.add(time, encoded(bodies), kIsPast);
  for (auto frame = frames.rbegin(); frame != frames.rend(); ++frame)
    part.add(frame->time, frame->message, kIsPast);
}

/// The messages of a chunk later than `after`.
void PlayableRecording::add_chunk(std::size_t chunk, nanoseconds after, Builder& part) const {
  const auto contents = recording_.file().chunk(chunk);
  part.reach(recording_.file().summary().chunks[chunk].end_time);
  if (!contents) return part.add_damage();
  for (const mcap::Message& message : contents->messages) {
    if (message.log_time <= after || !is_plausible(message.log_time)) continue;
    pb::Control control;
    switch (recording_.kind_of(message.channel)) {
      case MessageKind::kFrame:
        if (wire::parse_frame(message.data)) part.add(message.log_time, message.data);
        continue;
      case MessageKind::kVoice:
        if (wire::parse_audio(message.data)) part.add(message.log_time, message.data);
        continue;
      case MessageKind::kRoster:
        *control.mutable_roster() = recording_.roster_at(message.log_time);
        break;
      case MessageKind::kPoses:
        if (!parse_checked(message.data, control, control.mutable_viewer_poses())) continue;
        break;
      case MessageKind::kMarks:
        if (!parse_checked(message.data, control, control.mutable_marks())) continue;
        break;
      default:
        continue;
    }
    part.add(message.log_time, encoded(control));
  }
}

}  // namespace roomcast::recording
