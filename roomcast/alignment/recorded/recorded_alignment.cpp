// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/recorded/recorded_alignment.h"

#include <string_view>

#include <fmt/format.h>

#include "roomcast/alignment/homography/homography_pose.h"

namespace roomcast::alignment {
namespace {

SensorReport unusable_sensor(const std::string& name, const Error& error) {
  SensorReport report;
  report.id = name;
  report.reason = error.message;
  return report;
}

}  // namespace

AlignmentReport align_views(const std::vector<SharedView>& views, const std::string& method,
                            const AlignmentOptions& options, const AlignProgress& progress,
                            DepthScaling scaling) {
  if (method == "homography") return align_by_homography(views, options.homography);
  RigAligner aligner(options.rig, scaling);
  for (const SharedView& view : views) aligner.add(view);
  return aligner.solve(progress);
}

Result<AlignmentReport> align_recording(const std::filesystem::path& rig, const std::string& method,
                                        const AlignmentOptions& options,
                                        const ReadProgress& progress, DepthScaling scaling) {
  const auto bundles = read_rig_bundles(rig, progress, options.bundle);
  if (!bundles) return bundles.error();
  std::vector<SharedView> views;
  std::vector<SensorReport> unusable;
  for (const RecordedBundle& recorded : *bundles) {
    progress("finding features of " + recorded.name);
    auto view = view_of(recorded, options.view);
    view ? views.push_back(*view)
         : unusable.push_back(unusable_sensor(recorded.name, view.error()));
  }
  AlignmentReport report = align_views(
      views, method, options,
      [&](std::string_view step, double done) {
        progress(fmt::format("{:3.0f} %  {}", 100 * done, step));
      },
      scaling);
  report.sensors.insert(report.sensors.end(), unusable.begin(), unusable.end());
  return report;
}

}  // namespace roomcast::alignment
