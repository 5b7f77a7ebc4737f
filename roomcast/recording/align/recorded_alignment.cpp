// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/align/recorded_alignment.h"

#include <string_view>

#include <fmt/format.h>

#include "roomcast/alignment/homography/homography_pose.h"

namespace roomcast::recording {
namespace {

alignment::SensorReport unusable_sensor(const std::string& name, const Error& error) {
  alignment::SensorReport report;
  report.id = name;
  report.reason = error.message;
  return report;
}

}  // namespace

alignment::AlignmentReport align_views(const std::vector<SharedView>& views,
                                       const std::string& method,
                                       const alignment::AlignmentOptions& options,
                                       const alignment::AlignProgress& progress,
                                       alignment::DepthScaling scaling) {
  if (method == "homography") return alignment::align_by_homography(views, options.homography);
  alignment::RigAligner aligner(options.rig, scaling);
  for (const SharedView& view : views) aligner.add(view);
  return aligner.solve(progress);
}

Result<alignment::AlignmentReport> align_recording(const std::filesystem::path& rig,
                                                   const std::string& method,
                                                   const alignment::AlignmentOptions& options,
                                                   const ReadProgress& progress,
                                                   alignment::DepthScaling scaling) {
  const auto bundles = read_rig_bundles(rig, progress, options.bundle);
  if (!bundles) return bundles.error();
  std::vector<SharedView> views;
  std::vector<alignment::SensorReport> unusable;
  for (const RecordedBundle& recorded : *bundles) {
    progress("finding features of " + recorded.name);
    auto view = view_of(recorded, options.view);
    view ? views.push_back(*view)
         : unusable.push_back(unusable_sensor(recorded.name, view.error()));
  }
  alignment::AlignmentReport report = align_views(
      views, method, options,
      [&](std::string_view step, double done) {
        progress(fmt::format("{:3.0f} %  {}", 100 * done, step));
      },
      scaling);
  report.sensors.insert(report.sensors.end(), unusable.begin(), unusable.end());
  return report;
}

}  // namespace roomcast::recording
