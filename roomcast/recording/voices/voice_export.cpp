// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/voices/voice_export.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "roomcast/core/csv_field.h"
#include "roomcast/io/file_bytes.h"
#include "roomcast/io/new_folder.h"
#include "roomcast/recording/voices/recorded_speaker.h"
#include "roomcast/recording/voices/voice_mix.h"
#include "roomcast/recording/voices/voice_track.h"
#include "roomcast/sound/listener_gains.h"
#include "roomcast/sound/wav_file.h"
#include "roomcast/wire/audio_header.h"
#include "roomcast/wire/control_check.h"
#include "roomcast/wire/parse_message.h"

namespace roomcast::recording {
namespace {

constexpr std::size_t kMaxPeople = 500;                          // each has an open file
constexpr nanoseconds kLongestDelay = std::chrono::seconds(10);  // from a mouth to the recorder
constexpr nanoseconds kProgressEvery = std::chrono::seconds(5);

std::int64_t samples_in(nanoseconds time) {
  return std::llround(std::chrono::duration<double>(time).count() * voice::kVoiceRate_hz);
}

double seconds_of(std::int64_t samples) {
  return static_cast<double>(samples) / voice::kVoiceRate_hz;
}

/// A WAV file and the sum of what is heard in it.
class SoundFile {
 public:
  SoundFile(sound::WavFile file, int channels)
      : file_(std::move(file)),
        mix_(channels,
             {.sound = [this](std::span<const float> samples) { file_.append(samples); },
              .silence = [this](std::int64_t samples) { file_.append_silence(samples); }}) {}

  VoiceMix& mix() { return mix_; }
  Status finish(std::int64_t end) {
    mix_.finish(end);
    return file_.finish();
  }
  const std::filesystem::path& path() const { return file_.path(); }

 private:
  sound::WavFile file_;
  VoiceMix mix_;
};

Result<std::unique_ptr<SoundFile>> create_sound(const std::filesystem::path& path, int channels) {
  auto file = sound::WavFile::create(path, channels);
  if (!file) return file.error();
  return std::make_unique<SoundFile>(*std::move(file), channels);
}

/// A name that every system takes.
std::string file_name_of(std::string person) {
  constexpr std::string_view kNotInNames = "/\\:*?\"<>|";
  for (char& c : person) {
    if (kNotInNames.find(c) != std::string_view::npos || static_cast<unsigned char>(c) < ' ')
      c = '-';
  }
  if (person.starts_with('.')) person.front() = '-';
  return person;
}

class VoiceExporter {
 public:
  VoiceExporter(const RoomRecording& recording, const VoiceExportOptions& options)
      : recording_(recording), options_(options) {}

  Result<VoiceExport> run();

 private:
  struct Person {
    ExportedVoice voice;
    VoiceTrack track;
    std::unique_ptr<SoundFile> file;
  };

  [[nodiscard]] bool is_wanted(const mcap::ChunkIndex& chunk) const;
  Status read(const mcap::Message& message);
  void read_poses(const mcap::Message& message);
  Status read_voice(const mcap::Message& message);
  Result<Person*> person(std::uint32_t viewer, nanoseconds log_time);
  [[nodiscard]] std::optional<Eigen::Vector3d> place_of(std::uint32_t speaker,
                                                        nanoseconds time) const;
  std::filesystem::path free_file(const std::string& person);
  void hear(Person& person, std::int64_t at, std::span<const float> samples);
  void give_until(nanoseconds time);
  Status finish();
  [[nodiscard]] Status write_list() const;

  const RoomRecording& recording_;
  const VoiceExportOptions& options_;
  std::int64_t begin_ = 0, end_ = 0;  // samples since the recording began
  std::unique_ptr<SoundFile> all_;
  std::map<std::uint32_t, Person> people_;
  std::set<std::string> names_;  // of files
  std::map<std::uint32_t, Eigen::Vector3d> heads_;
  VoiceExport done_;
};

/// Also those that say nothing of what they contain.
bool VoiceExporter::is_wanted(const mcap::ChunkIndex& chunk) const {
  const auto& offsets = chunk.message_index_offsets;
  if (offsets.empty()) return true;
  return std::ranges::any_of(offsets, [this](const auto& entry) {
    const MessageKind kind = recording_.kind_of(entry.first);
    return kind == MessageKind::kVoice || (kind == MessageKind::kPoses && options_.listener);
  });
}

Result<VoiceExport> VoiceExporter::run() {
  const nanoseconds origin = recording_.origin();
  const nanoseconds length = recording_.end() - origin;
  const nanoseconds to = options_.to.count() > 0 ? std::min(options_.to, length) : length;
  begin_ = samples_in(options_.from);
  end_ = std::max(samples_in(to), begin_);
  const int channels = options_.listener ? 2 : 1;
  if ((end_ - begin_) * channels > sound::WavFile::kMaxSamples) return sound::WavFile::too_long();
  auto all = create_sound(options_.out / "voices.wav", channels);
  if (!all) return all.error();
  all_ = *std::move(all);
  names_.insert("voices");
  const auto& chunks = recording_.file().summary().chunks;
  nanoseconds told{};
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    if (options_.stop.stop_requested())
      return Error{ErrorCode::kClosed, "interrupted; no sound was written"};
    if (chunks[i].start_time > origin + to + kLongestDelay) break;
    if (!is_wanted(chunks[i])) continue;
    const auto chunk = recording_.file().chunk(i);
    if (!chunk) {
      ++done_.damaged_parts;
      continue;
    }
    for (const mcap::Message& message : chunk->messages) {
      if (auto status = read(message); !status) return status.error();
    }
    const nanoseconds reached = chunks[i].end_time - origin;
    give_until(reached - kLongestDelay);
    if (options_.progress && reached - told > kProgressEvery) {
      told = reached;
      options_.progress(reached);
    }
  }
  if (auto status = finish(); !status) return status.error();
  return std::move(done_);
}

Status VoiceExporter::read(const mcap::Message& message) {
  if (!is_plausible(message.log_time) || !is_plausible(message.publish_time)) return {};
  switch (recording_.kind_of(message.channel)) {
    case MessageKind::kPoses:
      if (options_.listener) read_poses(message);
      return {};
    case MessageKind::kVoice:
      return read_voice(message);
    default:
      return {};
  }
}

void VoiceExporter::read_poses(const mcap::Message& message) {
  wire::pb::Control control;
  if (!wire::parse_message(message.data, *control.mutable_viewer_poses()) ||
      !wire::check_control(control))
    return;
  for (const auto& pose : control.viewer_poses().poses())
    heads_[pose.viewer_id()] = {pose.head().x(), pose.head().y(), pose.head().z()};
}

/// A sensor's microphone is where the sensor stood at that time.
std::optional<Eigen::Vector3d> VoiceExporter::place_of(std::uint32_t speaker,
                                                       nanoseconds time) const {
  if (const auto sensor = wire::sensor_of(ViewerId{speaker}))
    return recorded_place(recording_, *sensor, recording_.origin() + time);
  const auto head = heads_.find(speaker);
  return head == heads_.end() ? std::nullopt : std::optional(head->second);
}

Status VoiceExporter::read_voice(const mcap::Message& message) {
  const auto header = wire::parse_audio(message.data);
  if (!header || header->codec != wire::kAudioCodecOpus) return {};
  const nanoseconds delay = message.log_time - message.publish_time;
  if (delay > kLongestDelay || delay < -kLongestDelay) return {};
  const nanoseconds time = message.publish_time - recording_.origin();
  const std::int64_t at = samples_in(time);
  if (at >= end_ || at + static_cast<std::int64_t>(voice::kPacketSamples) <= begin_) return {};
  const auto found = person(header->speaker.value, message.log_time);
  if (!found) return found.error();
  Person& person = **found;
  const VoicePacket packet{.seq = header->seq,
                           .ends = header->ends,
                           .time = time,
                           .opus = message.data.subspan(header->header_length)};
  person.track.take(packet, [&](std::int64_t place, std::span<const float> samples) {
    hear(person, place - begin_, samples);
  });
  return {};
}

Result<VoiceExporter::Person*> VoiceExporter::person(std::uint32_t viewer, nanoseconds log_time) {
  if (const auto known = people_.find(viewer); known != people_.end()) return &known->second;
  if (people_.size() == kMaxPeople) {
    return Error{
        ErrorCode::kTooLarge,
        "more than 500 people speak in this recording; choose a part with --from and --to"};
  }
  Person added;
  added.voice.viewer = viewer;
  added.voice.person = recorded_name(recording_, ViewerId{viewer}, log_time);
  if (options_.per_person) {
    auto file = create_sound(free_file(added.voice.person), 1);
    if (!file) return file.error();
    added.file = *std::move(file);
    added.voice.file = added.file->path();
  }
  return &people_.emplace(viewer, std::move(added)).first->second;
}

std::filesystem::path VoiceExporter::free_file(const std::string& person) {
  const std::string name = file_name_of(person);
  std::string free = name;
  for (int n = 2; !names_.insert(free).second; ++n) free = fmt::format("{}-{}", name, n);
  return options_.out / (free + ".wav");
}

void VoiceExporter::hear(Person& person, std::int64_t at, std::span<const float> samples) {
  ExportedVoice& voice = person.voice;
  const double begin_s = std::max(0.0, seconds_of(at));
  const double end_s = std::min(seconds_of(at + static_cast<std::int64_t>(samples.size())),
                                seconds_of(end_ - begin_));
  if (end_s <= begin_s) return;
  if (voice.speech_s == 0) voice.first_s = begin_s;
  voice.last_s = std::max(voice.last_s, end_s);
  voice.speech_s += end_s - begin_s;
  if (person.file) person.file->mix().add(at, samples, {1, 0});
  Gains gains = {1, 0};
  if (options_.listener) {
    const auto time = nanoseconds(std::llround(1e9 * seconds_of(begin_ + at)));
    gains = sound::listener_gains(options_.listener(time), place_of(voice.viewer, time));
  }
  all_->mix().add(at, samples, gains);
}

void VoiceExporter::give_until(nanoseconds time) {
  const std::int64_t until = std::min(samples_in(time), end_) - begin_;
  if (until <= 0) return;
  all_->mix().give_until(until);
  for (auto& [viewer, person] : people_)
    if (person.file) person.file->mix().give_until(until);
}

Status VoiceExporter::finish() {
  const auto is_heard = [](const auto& entry) { return entry.second.voice.speech_s > 0; };
  if (std::ranges::none_of(people_, is_heard)) {
    return Error{ErrorCode::kNotFound,
                 "nobody is heard in that part of the recording: nobody spoke, or voices were "
                 "left out when it was made"};
  }
  const std::int64_t length = end_ - begin_;
  if (auto status = all_->finish(length); !status) return status;
  done_.files.push_back(all_->path());
  for (auto& [viewer, person] : people_) {
    if (person.file) {
      if (auto status = person.file->finish(length); !status) return status;
      done_.files.push_back(person.file->path());
    }
    person.voice.concealed = person.track.figures().concealed;
    done_.people.push_back(std::move(person.voice));
  }
  done_.seconds = seconds_of(length);
  done_.began_at = recording_.origin() + options_.from;
  return write_list();
}

Status VoiceExporter::write_list() const {
  std::string text = "file,person,viewer,first_s,last_s,speech_s,concealed_packets\n";
  for (const ExportedVoice& voice : done_.people) {
    text += fmt::format("{},{},{},{:.3f},{:.3f},{:.3f},{}\n",
                        quoted_csv_field(voice.file.filename().string()),
                        quoted_csv_field(voice.person), voice.viewer, voice.first_s, voice.last_s,
                        voice.speech_s, voice.concealed);
  }
  return io::write_file(options_.out / "voices.csv", text);
}

}  // namespace

Result<VoiceExport> export_voices(const RoomRecording& recording,
                                  const VoiceExportOptions& options) {
  if (auto status = check_may_be_exported(recording); !status) return status.error();
  if (auto status = io::make_folder(options.out); !status) return status.error();
  return VoiceExporter(recording, options).run();
}

}  // namespace roomcast::recording
