// SPDX-License-Identifier: Apache-2.0
// roomcast export: converts a recording into the file formats of other programs.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "roomcast/cli/command.h"
#include "roomcast/cli/film_command_options.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/print.h"
#include "roomcast/cli/sound_export.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/cli/stop_on_signal.h"
#include "roomcast/recording/export/set_writer.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"
#include "roomcast/recording/mesh/mesh_writer.h"

namespace roomcast::cli {
namespace {

struct ExportOptions {
  std::string recording;
  std::string format = "ply";
  std::filesystem::path out;
  double from_s = 0;
  double to_s = 0;  // 0: to the end
  std::uint64_t every = 1;
  std::vector<float> crop;
  recording::MergedCloudOptions cloud;
  std::string up;  // empty: z in a Foxglove file
  std::vector<std::string> mesh_files = {"glb"};
  FilmCommandOptions film;
  SoundOptions sound;
  bool json = false;
};

nanoseconds seconds(double value) {
  return nanoseconds(static_cast<std::int64_t>(value * 1e9));
}

// They have writers of their own, unlike the other formats.
constexpr const char *kFilm = "video", *kMesh = "mesh", *kSound = "wav";
constexpr std::string_view kFoxglove = "foxglove";

recording::ExportFormat format_of(const std::string& name) {
  return *std::ranges::find(recording::kExportFormats, name,
                            [](recording::ExportFormat f) { return name_of(f); });
}

Result<std::unique_ptr<recording::FilmWriter>> make_film_writer(
    const ExportOptions& options, const recording::FrameSetReader& reader) {
  const double end_s =
      options.to_s > 0 ? options.to_s : std::chrono::duration<double>(reader.length()).count();
  auto film = options.film.film(end_s - options.from_s);
  if (!film) return film.error();
  return recording::make_film(options.out, reader.sensors(), *std::move(film));
}

Result<std::unique_ptr<recording::SetWriter>> make_mesh_writer(
    const ExportOptions& options, const recording::FrameSetReader& reader, StatusLine& line,
    const std::stop_token& stop) {
  recording::MeshWriterOptions mesh;
  mesh.crop_m = options.cloud.crop_m;
  if (options.cloud.voxel_m > 0) mesh.model.voxel_m = options.cloud.voxel_m;
  if (mesh.model.voxel_m < model::kMinVoxel_m || mesh.model.voxel_m > model::kMaxVoxel_m)
    return invalid_argument("--voxel of a mesh is 0.002 to 0.2 metres");
  mesh.files.clear();
  for (const std::string& name : options.mesh_files)
    mesh.files.push_back(*std::ranges::find(recording::kMeshFiles, name, recording::ending_of));
  const auto progress = [&line](std::string_view doing, std::size_t done, std::size_t total) {
    line.show_progress(doing, static_cast<int>(done), static_cast<int>(total));
  };
  return recording::make_mesh_writer(options.out, reader.sensors(), std::move(mesh), progress,
                                     stop);
}

Result<std::unique_ptr<recording::SetWriter>> make_writer(const ExportOptions& options,
                                                          const recording::FrameSetReader& reader,
                                                          StatusLine& line,
                                                          const std::stop_token& stop,
                                                          const recording::FilmWriter*& film) {
  if (options.format == kFilm) {
    auto made = make_film_writer(options, reader);
    if (!made) return made.error();
    film = made->get();
    return std::unique_ptr<recording::SetWriter>(*std::move(made));
  }
  if (options.format == kMesh) return make_mesh_writer(options, reader, line, stop);
  return recording::make_set_writer(
      format_of(options.format), options.out, {reader.sensors(), reader.began_at()}, options.cloud,
      options.up == "y" ? recording::UpAxis::kY : recording::UpAxis::kZ);
}

/// What an interrupted export leaves behind, and how to go on.
Error interrupted(std::string_view format) {
  if (format == kFilm) return {ErrorCode::kClosed, "interrupted; the film ends here"};
  if (format == kMesh) return {ErrorCode::kClosed, "interrupted; no mesh was written"};
  if (format == "ply" || format == "pcd" || format == "gltf") {
    return {ErrorCode::kClosed,
            "interrupted; run the same command again to write the missing files"};
  }
  return {ErrorCode::kClosed,
          "interrupted; the output ends here and cannot be continued: to export all of the "
          "recording, run the command again with a new --out"};
}

/// Copies every n-th set from `reader` to `writer`, until the end, `to_s`, or a signal.
Status copy_sets(const ExportOptions& options, recording::FrameSetReader& reader,
                 recording::SetWriter& writer, StatusLine& line, const std::stop_token& stop) {
  const double end_s =
      options.to_s > 0 ? options.to_s : std::chrono::duration<double>(reader.length()).count();
  recording::FrameSet set;
  int damaged_places = 0;
  while (!stop.stop_requested()) {
    const auto more = reader.next(set);
    if (!more && ++damaged_places > 1000) return more.error();
    if (!more) {
      print_err("roomcast export: {}; continuing after it\n", more.error().message);
      continue;
    }
    const double time_s = std::chrono::duration<double>(set.time).count();
    if (!*more || (options.to_s > 0 && time_s > options.to_s)) return {};
    if (set.number % options.every != 0) continue;
    if (auto status = writer.add(set); !status) return status;
    line.show(end_s > 0 ? fmt::format("{:.1f} of {:.1f} s", time_s, end_s)
                        : fmt::format("{:.1f} s", time_s));
  }
  return interrupted(options.format);
}

void report(const ExportOptions& options, const recording::ExportTotals& totals,
            const Status& status) {
  if (options.json) {
    nlohmann::json json = {{"format", options.format},   {"out", options.out.string()},
                           {"sets", totals.sets},        {"kept", totals.kept},
                           {"points", totals.points},    {"triangles", totals.triangles},
                           {"pictures", totals.pictures}};
    add_error(status, json);
    print_out("{}\n", json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace));
    return;
  }
  print_out("{}: {} sets {}", options.out.string(), totals.sets,
            options.format == kMesh ? "fused" : "written");
  if (totals.kept > 0) print_out(", {} were there already", totals.kept);
  if (totals.points > 0) print_out(", {} points", totals.points);
  if (totals.triangles > 0) print_out(", {} triangles", totals.triangles);
  if (totals.pictures > 0) print_out(", {} pictures", totals.pictures);
  print_out("\n");
}

Outcome run_export(ExportOptions options) {
  StopOnSignal stop;
  if (options.format == kSound) {
    options.sound.from = seconds(options.from_s);
    options.sound.to = seconds(options.to_s);
    return export_sound(options.recording, options.out, options.sound, options.json, stop.token());
  }
  if (!options.up.empty() && options.format != kFoxglove)
    return invalid_argument("--up is an option of --format foxglove; in the others y is up");
  if (!options.crop.empty()) {
    const auto& c = options.crop;
    const Eigen::Vector3f a(c[0], c[1], c[2]), b(c[3], c[4], c[5]);
    options.cloud.crop_m = Eigen::AlignedBox3f(a.cwiseMin(b), a.cwiseMax(b));
  }
  auto reader = recording::open_frame_sets(options.recording, seconds(options.from_s));
  if (!reader) return reader.error();
  if (auto status = recording::check_may_be_exported(**reader); !status) return status.error();
  StatusLine line;
  const recording::FilmWriter* film = nullptr;
  auto writer = make_writer(options, **reader, line, stop.token(), film);
  if (!writer) return writer.error();
  Status status = copy_sets(options, **reader, **writer, line, stop.token());
  if (auto finished = (*writer)->finish(); status && !finished) status = finished;
  if (status && film != nullptr && (*writer)->totals().pictures > 0 && !options.film.silent)
    give_film_voices(options.recording, options.out, *film, stop.token());
  if (!status && status.error().code == ErrorCode::kClosed) status = interrupted(options.format);
  const recording::ExportTotals totals = (*writer)->totals();
  if (status && totals.sets + totals.kept == 0)
    return Error{
        ErrorCode::kNotFound,
        "that part of the recording has no frames; choose other values of --from and --to"};
  const bool any = options.format != kMesh || totals.triangles > 0;
  if (any) report(options, totals, status);
  return {status, any};
}

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const recording::ExportFormat format : recording::kExportFormats)
    names.emplace_back(name_of(format));
  names.emplace_back(kMesh);
  names.emplace_back(kFilm);
  names.emplace_back(kSound);
  return names;
}

constexpr const char* kExportFooter =
    "ply and pcd: set_NNNNNN files, the merged cloud of all placed sensors with colours and "
    "normals.\n"
    "gltf: set_NNNNNN.glb, a textured mesh for each sensor. rig: a folder for each sensor.\n"
    "tum: the same with each sensor's poses in groundtruth.txt; depth in millimetres.\n"
    "mesh: room.glb, or .ply and .obj, of all that stands still: all sensors and frames fused.\n"
    "foxglove: room.mcap with point clouds, depth, VP9 video, calibrations and transforms.\n"
    "video: film.mp4 by ffmpeg, or pictures where that is not installed; --path FILE is\n"
    "{\"keys\": [{\"time_s\": 0, \"at\": [x,y,z], \"look\": [x,y,z]}, ...]}.\n"
    "wav: voices.wav, what people say, and voices.csv with who speaks when.\n"
    "After an interruption the same command continues ply, pcd and gltf and keeps complete "
    "files;\n"
    "the other formats start again and need a new folder.\n"
    "Examples:\n"
    "  roomcast export lab.mcap --format ply --out clouds --every 30 --voxel 0.01\n"
    "  roomcast export lab.mcap --format mesh --out mesh --mesh-files glb,ply\n"
    "  roomcast export lab.mcap --format video --out film --path walk.json\n"
    "  roomcast export lab.mcap --format wav --out voices --per-person";

}  // namespace

void add_export_command(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* command =
      app.add_subcommand("export", "Convert a recording into files for other programs");
  command->add_option("recording", options->recording, "FILE.mcap, or the folder of a rig")
      ->required();
  command
      ->add_option("--format", options->format,
                   "ply, pcd, gltf, mesh, rig, tum, foxglove, video or wav")
      ->check(CLI::IsMember(format_names()))
      ->capture_default_str();
  command->add_option("--out", options->out, "Folder to write to")->required();
  command->add_option("--from", options->from_s, "Begin at this second")
      ->check(seconds_from_zero());
  command->add_option("--to", options->to_s, "End at this second")->check(some_seconds());
  command->add_option("--every", options->every, "Only every n-th frame set")
      ->check(within(1, 1'000'000));
  command
      ->add_option("--crop", options->crop,
                   "Point clouds, mesh: only inside the box of two corners x,y,z,x,y,z (metres)")
      ->delimiter(',')
      ->expected(6);
  command
      ->add_option(
          "--voxel", options->cloud.voxel_m,
          "Point clouds: one point for each cube of this size; mesh: the size of its cells, "
          "0.01 by default (metres)")
      ->check(within(0.0, 1.0));
  command
      ->add_option("--mesh-files", options->mesh_files,
                   "Mesh: glb, draco.glb, ply, obj; draco.glb has the fewest bytes")
      ->delimiter(',')
      ->check(CLI::IsMember({"glb", "draco.glb", "ply", "obj"}))
      ->capture_default_str();
  command->add_flag("--keep-doubles", options->cloud.keep_doubles,
                    "Point clouds: keep duplicate points of surfaces that several sensors see");
  command
      ->add_option("--up", options->up,
                   "Foxglove: the axis of `world` that points up, z (default) or y")
      ->check(CLI::IsMember({"y", "z"}));
  add_film_options(*command, options->film);
  add_sound_options(*command, options->sound);
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(kExportFooter);
  command->callback([options, &chosen] {
    chosen = [options] { return finish("export", run_export(*options)); };
  });
}

}  // namespace roomcast::cli
