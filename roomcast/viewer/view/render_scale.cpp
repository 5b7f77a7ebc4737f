// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/view/render_scale.h"

#include <algorithm>

namespace roomcast::viewer {

void RenderScale::judge(nanoseconds drawing, HostTime now) {
  draws_.push_back(drawing);
  if (draws_.size() < kDrawsToJudge) return;
  std::ranges::nth_element(draws_, draws_.begin() + kDrawsToJudge / 2);
  const nanoseconds median = draws_[kDrawsToJudge / 2];
  draws_.clear();
  if (median > kTooSlow && rung_ + 1 < kScales.size()) return fall(now);
  if (median > kQuick || rung_ == 0 || now < may_rise_) return;
  --rung_;
  rose_last_ = true;
}

/// After a failed attempt at a finer scale, doubles the wait before the next one.
void RenderScale::fall(HostTime now) {
  ++rung_;
  if (rose_last_) patience_ = std::min(2 * patience_, kLongestPatience);
  rose_last_ = false;
  may_rise_ = now + patience_;
}

}  // namespace roomcast::viewer
