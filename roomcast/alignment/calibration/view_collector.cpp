// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/calibration/view_collector.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace roomcast::alignment::calibration {

std::optional<double> way_px(const std::vector<SeenCorner>& a, const std::vector<SeenCorner>& b) {
  constexpr int kFewest = 4;
  double sum = 0;
  int count = 0;
  for (const SeenCorner& one : a) {
    const auto same = std::find_if(
        b.begin(), b.end(), [&](const SeenCorner& other) { return other.corner == one.corner; });
    if (same == b.end()) continue;
    sum += (one.pixel - same->pixel).squaredNorm();
    ++count;
  }
  if (count < kFewest) return std::nullopt;
  return std::sqrt(sum / count);
}

ViewCollector::ViewCollector(const CharucoBoard& board) : finder_(board) {}

ViewCollector::Verdict ViewCollector::add(const source::CapturedFrame& frame) {
  const auto before = std::exchange(last_, finder_.find(frame.color));
  if (last_.size() < kMinCorners) return Verdict::kNoBoard;
  const auto moved = way_px(before, last_);
  if (!moved || *moved > kStill_px) return Verdict::kMoving;
  const double elsewhere_px = kElsewhere * frame.color.width();
  for (const BoardView& view : views_) {
    const auto way = way_px(view.corners, last_);
    if (way && *way < elsewhere_px) return Verdict::kSeenBefore;
  }
  views_.push_back({last_, frame.depth_mm});
  return Verdict::kTaken;
}

}  // namespace roomcast::alignment::calibration
