// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/align/recorded_views.h"

#include <set>
#include <utility>

namespace roomcast::recording {
namespace {

constexpr std::size_t kMaxDigits = 18;

Result<std::uint64_t> frame_number(const std::string& name) {
  if (!name.empty() && name.size() <= kMaxDigits &&
      name.find_first_not_of("0123456789") == std::string::npos) {
    return std::stoull(name);
  }
  return Error{ErrorCode::kInvalidArgument, name + " is no frame number of a TUM recording"};
}

}  // namespace

Result<SharedView> view_of(const RecordedBundle& recorded,
                           const alignment::SensorViewOptions& options) {
  if (!recorded.bundle) return recorded.bundle.error();
  auto view = alignment::make_sensor_view(*recorded.bundle, options);
  if (!view) return view.error();
  return SharedView(std::make_shared<const alignment::SensorView>(std::move(*view)));
}

Result<FrameViews> FrameViews::read(const std::filesystem::path& directory,
                                    const std::vector<ListedPair>& pairs,
                                    const ReadProgress& progress,
                                    const alignment::AlignmentOptions& options) {
  std::set<std::uint64_t> frames;
  for (const ListedPair& pair : pairs) {
    for (const std::string& name : {pair.a, pair.b}) {
      const auto number = frame_number(name);
      if (!number) return number.error();
      frames.insert(*number);
    }
  }
  auto bundles = read_frame_bundles(directory, frames, progress, options.bundle);
  if (!bundles) return bundles.error();
  return FrameViews(std::move(*bundles), options.view);
}

FrameViews::FrameViews(std::map<std::uint64_t, RecordedBundle> bundles,
                       const alignment::SensorViewOptions& options)
    : options_(options), bundles_(std::move(bundles)) {}

const Result<SharedView>& FrameViews::at(const std::string& name) {
  const std::uint64_t frame = *frame_number(name);
  auto found = views_.find(frame);
  if (found == views_.end())
    found = views_.emplace(frame, view_of(bundles_.at(frame), options_)).first;
  return found->second;
}

}  // namespace roomcast::recording
