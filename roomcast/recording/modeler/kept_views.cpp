// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/modeler/kept_views.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

#include "roomcast/recording/mesh/pose_change.h"

namespace roomcast::recording {
namespace {

constexpr int kEnoughFrames = 3;  // a person who walks past is in fewer
/// So many pictures in a row that show something else: the view is gathered anew.
constexpr int kMaxStrange = 6;
/// A surface is noticeably another one when it is farther off than this.
constexpr float kSame_mm = 20, kSameShare = 0.015F;
constexpr double kNoticedShare = 0.004, kNoticedShareAfterChange = 0.001;  // of a view's surfaces
constexpr double kNoticedColor = 8;  // mean difference, levels
constexpr int kColorStep = 4;        // pixels from one that is compared to the next

int rounded_mm(const model::StillView& still, int x, int y) {
  return still.is_sure(x, y) ? static_cast<int>(std::lround(still.depth_mm(x, y))) : 0;
}

DepthImage depth_of(const model::StillView& still) {
  DepthImage depth_mm(still.camera().width, still.camera().height);
  for (int y = 0; y < depth_mm.height(); ++y) {
    for (int x = 0; x < depth_mm.width(); ++x)
      depth_mm.at(x, y) = static_cast<std::uint16_t>(rounded_mm(still, x, y));
  }
  return depth_mm;
}

ColorImage color_of(const model::StillView& still) {
  ColorImage color(still.camera().width, still.camera().height);
  for (int y = 0; y < color.height(); ++y) {
    for (int x = 0; x < color.width(); ++x) {
      if (still.has_color(x, y)) color.at(x, y) = still.color(x, y);
    }
  }
  return color;
}

/// Black is what color_of() gives where no colour is known; JPEG makes it a little brighter.
MaskImage known_colors(const ColorImage& color) {
  constexpr int kBlack = 12;  // sum of three levels
  MaskImage known(color.width(), color.height(), 0);
  for (std::size_t i = 0; i < color.view().pixel_count(); ++i) {
    const Rgb8 level = color.data()[i];
    known.data()[i] = level.r + level.g + level.b > kBlack ? 255 : 0;
  }
  return known;
}

int difference(Rgb8 a, Rgb8 b) {
  return (std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b)) / 3;
}

}  // namespace

Status KeptViews::add(const std::vector<SetSensor>& sensors, const FrameSet& set) {
  Status result;
  for (const SetFrame& frame : set.frames) {
    if (!frame.world_from_depth) continue;
    if (auto status = add_picture(sensors[frame.sensor], frame); !status)
      result = Error{status.error().code,
                     "sensor " + sensors[frame.sensor].name + ": " + status.error().message};
  }
  return result;
}

Status KeptViews::add_picture(const SetSensor& sensor, const SetFrame& frame) {
  const codec::DecodedFrame& pictures = *frame.pictures;
  if (pictures.depth_mm.width() != sensor.depth.width ||
      pictures.depth_mm.height() != sensor.depth.height)
    return {};
  const RigidTransform& pose = *frame.world_from_depth;
  auto found = views_.find(sensor.name);
  if (found != views_.end()) {
    View& view = found->second;
    if (view.newest == frame.time) return {};
    view.newest = frame.time;
    const PoseChange change = pose_change(view.still.world_from_depth(), pose);
    const bool agrees = view.still.camera() == sensor.depth && view.still.agrees(pictures.depth_mm);
    view.strange = agrees ? 0 : view.strange + 1;
    if (agrees && change == PoseChange::kRefined) {
      if (auto status = view.still.set_pose(pose); !status) return status;
      view.fused_mm = {};
    } else if (change == PoseChange::kNone && !agrees && view.strange < kMaxStrange) {
      return {};  // somebody stands before it
    } else if (!agrees || change == PoseChange::kMoved) {
      forget(sensor.name);
      found = views_.end();
    }
  }
  if (found == views_.end()) {
    auto still = model::StillView::create(sensor.depth, pose, options_);
    if (!still) return still.error();
    found = views_.insert({sensor.name, View{*std::move(still)}}).first;
    found->second.newest = frame.time;
  }
  const bool has_color = same_size(pictures.color.view(), pictures.depth_mm.view());
  found->second.still.add(pictures.depth_mm, has_color ? pictures.color.view() : ColorView(),
                          pictures.color_seen);
  return {};
}

void KeptViews::forget(const std::string& sensor) {
  const auto found = views_.find(sensor);
  if (found == views_.end()) return;
  is_one_gone_ |= !found->second.fused_mm.empty();
  views_.erase(found);
}

std::vector<std::string> KeptViews::sensors() const {
  std::vector<std::string> names;
  for (const auto& [name, view] : views_) names.push_back(name);
  return names;
}

bool KeptViews::needs_more_of(const std::string& sensor) const {
  const auto found = views_.find(sensor);
  return found != views_.end() && !is_known(found->second);
}

bool KeptViews::are_worth_fusing(bool after_change) const {
  if (is_one_gone_) return true;
  const double noticed_share = after_change ? kNoticedShareAfterChange : kNoticedShare;
  return std::ranges::any_of(views_, [&](const auto& named) {
    return is_known(named.second) && has_changed(named.second, noticed_share);
  });
}

bool KeptViews::is_known(const View& view) {
  return view.still.frames() >= kEnoughFrames;
}

bool KeptViews::has_changed(const View& view, double noticed_share) {
  if (view.fused_mm.empty()) return true;
  const CameraIntrinsics& camera = view.still.camera();
  std::int64_t surfaces = 0, changed = 0, colors = 0, color_change = 0;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const int before = view.fused_mm.at(x, y), now = rounded_mm(view.still, x, y);
      if (before == 0 && now == 0) continue;
      ++surfaces;
      const float gate = kSame_mm + kSameShare * static_cast<float>(std::min(before, now));
      changed += static_cast<float>(std::abs(before - now)) > gate;
      if (y % kColorStep != 0 || x % kColorStep != 0 || !view.still.has_color(x, y)) continue;
      ++colors;
      color_change += difference(view.fused_color.at(x, y), view.still.color(x, y));
    }
  }
  return static_cast<double>(changed) > noticed_share * static_cast<double>(surfaces) ||
         static_cast<double>(color_change) > kNoticedColor * static_cast<double>(colors);
}

std::vector<model::ViewSurface> KeptViews::surfaces() {
  is_one_gone_ = false;
  std::vector<model::ViewSurface> surfaces;
  surfaces.reserve(views_.size());
  for (auto& [name, view] : views_) {
    if (!is_known(view)) continue;
    view.fused_mm = depth_of(view.still);
    view.fused_color = color_of(view.still);
    surfaces.emplace_back(view.still, options_);
  }
  return surfaces;
}

KeptViews::Saved KeptViews::saved() const {
  Saved saved;
  for (const auto& [name, view] : views_) {
    auto pictures = std::make_shared<codec::DecodedFrame>();
    pictures->depth_mm = depth_of(view.still);
    pictures->color = color_of(view.still);
    SetFrame frame;
    frame.sensor = saved.sensors.size();
    frame.pictures = std::move(pictures);
    frame.world_from_depth = view.still.world_from_depth();
    saved.sensors.push_back({.name = name, .depth = view.still.camera(), .fps = 1});
    saved.set.frames.push_back(std::move(frame));
  }
  return saved;
}

Status KeptViews::add_saved(const Saved& saved) {
  FrameSet set = saved.set;
  for (SetFrame& frame : set.frames) {
    auto pictures = std::make_shared<codec::DecodedFrame>(*frame.pictures);
    pictures->color_seen = known_colors(pictures->color);
    frame.pictures = std::move(pictures);
  }
  for (int i = 0; i < kEnoughFrames; ++i) {
    for (SetFrame& frame : set.frames) frame.time = nanoseconds(i);
    if (auto status = add(saved.sensors, set); !status) return status;
  }
  return {};
}

}  // namespace roomcast::recording
