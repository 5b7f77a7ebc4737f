// SPDX-License-Identifier: Apache-2.0
// roomcast calibrate: estimates one camera's lens, the pose of its depth camera relative to its
// colour camera and its depth error, from a printed board.
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "roomcast/alignment/calibration/residual_pictures.h"
#include "roomcast/alignment/calibration/ros_camera_info.h"
#include "roomcast/alignment/calibration/sensor_calibration.h"
#include "roomcast/alignment/calibration/view_collector.h"
#include "roomcast/cli/command.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/print.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/cli/stop_on_signal.h"
#include "roomcast/io/file_bytes.h"
#include "roomcast/io/image_file.h"
#include "roomcast/sensor/source_factory.h"

namespace roomcast::cli {
namespace {

using alignment::calibration::CalibrationReport;
using alignment::calibration::CharucoBoard;
using alignment::calibration::ViewCollector;

struct CalibrateOptions {
  std::string source, out = "calibration";
  std::string print;  // PDF file to write; then nothing else is done
  std::string paper = "a3";
  double square_mm = 0;  // 0: the nominal size of the printed board
  std::size_t views = 20;
  std::filesystem::path color_info, depth_info;  // camera_info files of ROS
  bool keep_lens = false;
  bool json = false;
};

alignment::calibration::BoardPage page_of(const CalibrateOptions& options) {
  return options.paper == "a4" ? alignment::calibration::kA4Across
                               : alignment::calibration::kA3Across;
}

CharucoBoard board_of(const CalibrateOptions& options) {
  CharucoBoard board = alignment::calibration::board_for(page_of(options));
  if (options.square_mm > 0) board.square_m = 0.001 * options.square_mm;
  return board;
}

Status print_board(const CalibrateOptions& options) {
  const auto pdf = alignment::calibration::charuco_pdf(page_of(options));
  if (!pdf) return pdf.error();
  if (Status status = io::write_file(options.print, *pdf); !status) return status;
  print_out("wrote {}: print it at 100 %; the squares have to be {:.0f} mm wide\n", options.print,
            1000 * board_of(options).square_m);
  return {};
}

const char* words_of(ViewCollector::Verdict verdict) {
  switch (verdict) {
    case ViewCollector::Verdict::kNoBoard:
      return "hold the board into the view";
    case ViewCollector::Verdict::kMoving:
      return "hold it still";
    case ViewCollector::Verdict::kSeenBefore:
      return "move the board: nearer, further, tilted";
    case ViewCollector::Verdict::kTaken:
      return "taken";
  }
  return "";
}

Status collect(source::FrameSource& source, std::size_t wanted, const std::stop_token& stop,
               ViewCollector& collector) {
  StatusLine line;
  source::CapturedFrame frame;
  while (collector.views().size() < wanted && !stop.stop_requested()) {
    const auto more = source.next(frame, stop);
    if (!more) return more.error();
    if (!*more) break;
    if (frame.color.empty()) continue;
    const auto verdict = collector.add(frame);
    line.show(fmt::format("view {} of {}, {} corners seen: {}", collector.views().size(), wanted,
                          collector.corners().size(), words_of(verdict)));
  }
  return {};
}

/// Replaces the source's lens parameters by those of the ROS camera_info files.
Status import_lenses(const CalibrateOptions& options, SensorCalibration& start) {
  for (const auto& [file, camera] :
       {std::pair{&options.color_info, &start.color}, {&options.depth_info, &start.depth}}) {
    if (file->empty()) continue;
    const auto imported = alignment::calibration::read_camera_info(*file);
    if (!imported) return imported.error();
    if (!same_size(*imported, *camera)) {
      return Error{
          ErrorCode::kInvalidArgument,
          fmt::format("{} is for pictures of {}x{}, but the camera gives {}x{}", file->string(),
                      imported->width, imported->height, camera->width, camera->height)};
    }
    *camera = *imported;
  }
  return {};
}

nlohmann::json json_of(const CalibrationReport& report) {
  const SensorCalibration& cameras = report.camera.calibration;
  nlohmann::json views = nlohmann::json::array();
  for (const alignment::calibration::PlaneError& view : report.depth.views) {
    views.push_back({{"distance_m", view.distance_m},
                     {"readings", view.readings},
                     {"mean_before_mm", view.mean_before_mm},
                     {"mean_after_mm", view.mean_after_mm},
                     {"rms_after_mm", view.rms_after_mm}});
  }
  return {{"corners", report.lens.errors.size()},
          {"corner_rms_px", report.lens.rms_px},
          {"color_fx", cameras.color.fx},
          {"color_fy", cameras.color.fy},
          {"color_from_depth", row_major_from_transform(cameras.color_from_depth)},
          {"depth_scale", 1000 * report.camera.depth_scale_to_metre},
          {"depth_bias_mm", 1000 * report.camera.depth_bias_m},
          {"translation_sigma_mm", report.depth.translation_sigma_mm},
          {"rotation_sigma_deg", report.depth.rotation_sigma_deg},
          {"bias_sigma_mm", report.depth.bias_sigma_mm},
          {"views", views}};
}

std::string text_of(const CalibrationReport& report) {
  const SensorCalibration& cameras = report.camera.calibration;
  const Eigen::Vector3d shift_mm = 1000 * cameras.color_from_depth.translation_m;
  constexpr double kLooseShift_mm = 0.5, kLooseBias_mm = 0.5;
  std::string text = fmt::format(
      "{} views, {} corners off by {:.3f} px (root mean square)\n"
      "colour lens: focal length {:.2f}, {:.2f} px; centre {:.2f}, {:.2f}\n"
      "colour from depth: {:.2f}, {:.2f}, {:.2f} mm\n"
      "depth: true = {:.5f} x reading {:+.2f} mm\n"
      "noise of depth alone leaves {:.2f} mm, {:.3f} degrees and {:.2f} mm open\n",
      report.depth.views.size(), report.lens.errors.size(), report.lens.rms_px, cameras.color.fx,
      cameras.color.fy, cameras.color.cx, cameras.color.cy, shift_mm.x(), shift_mm.y(),
      shift_mm.z(), 1000 * report.camera.depth_scale_to_metre, 1000 * report.camera.depth_bias_m,
      report.depth.translation_sigma_mm, report.depth.rotation_sigma_deg,
      report.depth.bias_sigma_mm);
  if (report.depth.translation_sigma_mm > kLooseShift_mm ||
      report.depth.bias_sigma_mm > kLooseBias_mm)
    text +=
        "the uncertainty is large: take more views, with the board tilted and at all distances\n";
  return text;
}

Status write_report(const CalibrationReport& report, const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return Error{ErrorCode::kUnavailable, "cannot make the folder " + folder.string()};
  Status status = io::write_file(folder / "camera.json", io::camera_json_text(report.camera));
  if (status) status = io::write_file(folder / "report.json", json_of(report).dump(1) + "\n");
  if (status)
    status = io::write_color_png(folder / "corners.png",
                                 alignment::calibration::corner_error_picture(report.lens));
  if (status)
    status = io::write_color_png(folder / "depth.png",
                                 alignment::calibration::depth_error_picture(report.depth));
  return status;
}

Status run_calibrate(const CalibrateOptions& options) {
  if (!options.print.empty()) return print_board(options);
  if (options.source.empty())
    return Error{ErrorCode::kInvalidArgument, "--source is required, or --print FILE.pdf"};
  const StopOnSignal stop;  // a signal ends the capture; the views captured so far are used
  sensor::SourceOptions source_options;
  source_options.loop = false;
  source_options.stop = stop.token();
  source_options.pace = source::Pace::kAsFastAsPossible;  // for recordings; cameras have their own
  auto source = sensor::open_source(options.source, source_options);
  if (!source) return source.error();
  SensorCalibration start = (*source)->description().calibration;
  if (Status status = import_lenses(options, start); !status) return status;
  const CharucoBoard board = board_of(options);
  ViewCollector collector(board);
  if (Status status = collect(**source, options.views, stop.token(), collector); !status)
    return status;
  const bool keep_lens = options.keep_lens || !options.color_info.empty();
  const auto report = alignment::calibration::calibrate(board, collector.views(), start, keep_lens);
  if (!report) return report.error();
  if (Status status = write_report(*report, options.out); !status) return status;
  if (options.json) {
    print_out("{}\n", json_of(*report).dump(1));
  } else {
    print_out(
        "{}wrote {}/camera.json; corners.png and depth.png beside it show the remaining errors\n",
        text_of(*report), options.out);
  }
  return {};
}

}  // namespace

void add_calibrate_command(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<CalibrateOptions>();
  CLI::App* command =
      app.add_subcommand("calibrate", "Calibrate a camera's lens and depth with a printed board");
  command->add_option("--source", options->source, "The camera, as for roomcast sensor");
  command->add_option("--print", options->print, "Write the board as a PDF file and end");
  command
      ->add_option("--paper", options->paper,
                   "Paper size of the board: a3, or a4 for short distances")
      ->check(CLI::IsMember({"a4", "a3"}))
      ->capture_default_str();
  command->add_option("--square-mm", options->square_mm, "Measured side of a square, if it differs")
      ->check(within(5.0, 500.0));
  command->add_option("--views", options->views, "Number of views to take")
      ->check(within(6, 200))
      ->capture_default_str();
  command->add_option("--camera-info", options->color_info,
                      "ROS YAML file of the colour lens, used unchanged");
  command->add_option("--depth-camera-info", options->depth_info,
                      "ROS YAML file of the depth lens, used unchanged");
  command->add_flag("--keep-lens", options->keep_lens,
                    "Keep the intrinsics that the camera reports");
  command->add_option("--out", options->out, "Folder for camera.json and the report")
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "Example:\n  roomcast calibrate --print board.pdf\n"
      "  roomcast calibrate --source freenect:0 --out kinect\n"
      "  roomcast sensor --source freenect:0 --calibration kinect/camera.json --hub wss://HOST\n"
      "Hold the board still for a moment at each of twenty places: near and far, tilted every "
      "way,\n"
      "in all corners of the picture.");
  command->callback([options, &chosen] {
    chosen = [options] { return finish("calibrate", run_calibrate(*options)); };
  });
}

}  // namespace roomcast::cli
