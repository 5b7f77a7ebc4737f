// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/sound_export.h"

#include <chrono>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "roomcast/cli/print.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/recording/film/film_sound.h"
#include "roomcast/recording/voices/voice_export.h"

namespace roomcast::cli {
namespace {

/// x right, y up, -z ahead.
RigidTransform listener_from(const std::vector<double>& listen) {
  const Eigen::Vector3d at(listen[0], listen[1], listen[2]), look(listen[3], listen[4], listen[5]);
  RigidTransform world_from_listener = world_from_optical_looking_at(at, look);
  world_from_listener.rotation.col(1) *= -1;
  world_from_listener.rotation.col(2) *= -1;
  return world_from_listener;
}

nlohmann::json sound_json(const recording::VoiceExport& done, const std::filesystem::path& out) {
  nlohmann::json people = nlohmann::json::array();
  for (const recording::ExportedVoice& voice : done.people) {
    people.push_back({{"person", voice.person},
                      {"viewer", voice.viewer},
                      {"first_s", voice.first_s},
                      {"last_s", voice.last_s},
                      {"speech_s", voice.speech_s},
                      {"concealed_packets", voice.concealed}});
    if (!voice.file.empty()) people.back()["file"] = voice.file.string();
  }
  nlohmann::json files = nlohmann::json::array();
  for (const auto& file : done.files) files.push_back(file.string());
  return {{"format", "wav"},
          {"out", out.string()},
          {"files", files},
          {"people", people},
          {"seconds", done.seconds},
          {"began_at", 1e-9 * static_cast<double>(done.began_at.count())},
          {"damaged_parts", done.damaged_parts}};
}

void print_sound(const recording::VoiceExport& done) {
  for (const recording::ExportedVoice& voice : done.people) {
    print_out("{}: {:.1f} s of speech between {:.1f} and {:.1f} s{}\n", voice.person,
              voice.speech_s, voice.first_s, voice.last_s,
              voice.file.empty() ? "" : ", in " + voice.file.string());
  }
  print_out("{}: {:.1f} s\n", done.files.front().string(), done.seconds);
}

}  // namespace

void add_sound_options(CLI::App& command, SoundOptions& options) {
  command.add_flag("--per-person", options.per_person,
                   "Sound: also a file for each person, all of the same length");
  command
      .add_option("--listen", options.listen,
                  "Sound: in stereo, as heard at x,y,z by somebody who looks at x,y,z (metres)")
      ->delimiter(',')
      ->expected(6);
}

void give_film_voices(const std::string& recording, const std::filesystem::path& out,
                      const recording::FilmWriter& film, const std::stop_token& stop) {
  std::error_code ignored;
  const std::filesystem::path file = out / "film.mp4", sounds = out / ".voices";
  if (!std::filesystem::is_regular_file(recording, ignored) ||
      !std::filesystem::exists(file, ignored))
    return;
  const auto room = recording::RoomRecording::open(recording);
  if (!room) return;  // a recording of another program
  std::filesystem::remove_all(sounds, ignored);
  recording::VoiceExportOptions voices{
      .out = sounds, .from = film.begin(), .to = film.begin() + film.length(), .stop = stop};
  voices.listener = [&film](nanoseconds time) { return film.world_from_view(time - film.begin()); };
  const auto done = recording::export_voices(*room, voices);
  const bool has_none = !done && done.error().code == ErrorCode::kNotFound;
  const Status added = done ? recording::add_sound(file, done->files.front()) : done.error();
  std::filesystem::remove_all(sounds, ignored);
  if (!added && !has_none)
    print_err("roomcast export: the film has no sound: {}\n", one_line(added.error().message));
}

Outcome export_sound(const std::string& recording, const std::filesystem::path& out,
                     const SoundOptions& options, bool json, const std::stop_token& stop) {
  const auto room = recording::RoomRecording::open(recording);
  if (!room) return room.error();
  StatusLine line;
  recording::VoiceExportOptions voices{.out = out,
                                       .from = options.from,
                                       .to = options.to,
                                       .per_person = options.per_person,
                                       .stop = stop};
  voices.progress = [&line](nanoseconds reached) {
    line.show(fmt::format("{:.0f} s", std::chrono::duration<double>(reached).count()));
  };
  if (!options.listen.empty()) {
    const RigidTransform listener = listener_from(options.listen);
    voices.listener = [listener](nanoseconds) { return listener; };
  }
  const auto done = recording::export_voices(*room, voices);
  if (!done) return done.error();
  if (room->damage())
    print_err("roomcast export: {}; everything before it was exported\n", *room->damage());
  if (done->damaged_parts > 0)
    print_err("roomcast export: {} damaged parts of the recording were left out\n",
              done->damaged_parts);
  if (json) {
    print_out("{}\n",
              sound_json(*done, out).dump(1, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    print_sound(*done);
  }
  return {Status(), true};
}

}  // namespace roomcast::cli
