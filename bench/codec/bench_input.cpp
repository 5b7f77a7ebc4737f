// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/bench_input.h"

#include <filesystem>

#include "bench/codec/back_and_forth_input.h"
#include "bench/codec/recorded_input.h"
#include "bench/codec/simulated_input.h"
#include "roomcast/recording/dataset/recording.h"
#include "roomcast/sensor/source_factory.h"

namespace roomcast::bench {
namespace {

namespace fs = std::filesystem;

bool starts_with(const std::string& text, const char* prefix) {
  return text.rfind(prefix, 0) == 0;
}

bool is_simulator(const std::string& input) {
  return input == "sim" || starts_with(input, "sim:") || starts_with(input, "sim#");
}

/// Maps a folder as given on the command line to the source in it.
std::string source_of(const std::string& input) {
  std::error_code ignored;
  if (is_simulator(input) || !fs::is_directory(input, ignored)) return input;
  return (fs::exists(fs::path(input) / "rig.json", ignored) ? "rig:" : "tum:") + input;
}

Result<std::unique_ptr<BenchInput>> open_rig(const std::string& place) {
  const std::size_t hash = place.rfind('#');
  const std::string directory = place.substr(0, hash);
  std::string sensor = hash == std::string::npos ? std::string() : place.substr(hash + 1);
  if (sensor.empty()) {
    const auto names = recording::rig_sensor_names(directory);
    if (!names.ok()) return names.error();
    if (names->empty()) return Error{ErrorCode::kNotFound, directory + " has no sensor."};
    sensor = names->front();
  }
  return open_recorded_input("rig:" + directory + "#" + sensor,
                             fs::path(directory) / "truth" / sensor);
}

Result<std::unique_ptr<BenchInput>> open_recording(const std::string& source) {
  if (starts_with(source, "rig:")) return open_rig(source.substr(4));
  const bool is_tum = starts_with(source, "tum:");
  return open_recorded_input(source, is_tum ? fs::path(source.substr(4)) / "truth" : fs::path());
}

}  // namespace

Result<std::unique_ptr<BenchInput>> open_bench_input(const std::string& input,
                                                     const BenchInputOptions& options) {
  const std::string source = source_of(input);
  if (is_simulator(source)) return open_simulated_input(source, options);
  auto recording = open_recording(source);
  if (!recording.ok() || options.back_and_forth_fps == 0) return recording;
  return play_back_and_forth(std::move(*recording), options.back_and_forth_fps);
}

}  // namespace roomcast::bench
