// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/color/color_activity.h"

#include <algorithm>

namespace roomcast::codec {
namespace {

// In frames of layer 0: about a second.
constexpr std::uint8_t kImprovements = 16;
// The same for a still block that is coded again.
constexpr std::uint8_t kStillImprovements = 2;

bool any_changed(MaskView changed, int block_x, int block_y) {
  for (int y = 2 * block_y; y < std::min(2 * block_y + 2, changed.height); ++y) {
    for (int x = 2 * block_x; x < std::min(2 * block_x + 2, changed.width); ++x) {
      if (changed.at(x, y)) return true;
    }
  }
  return false;
}

}  // namespace

MaskView ColorActivity::update(MaskView changed, FrameRole role, MaskView left_out) {
  const int wide = (changed.width + 1) / 2, high = (changed.height + 1) / 2;
  if (active_.empty()) {
    active_.resize(wide, high, 1);
    improvements_left_.resize(wide, high, 0);
    owed_.resize(wide, high, 0);
  }
  if (role.layer == 0) improve_next_band();
  for (int y = 0; y < high; ++y) {
    for (int x = 0; x < wide; ++x) {
      std::uint8_t& owed = owed_.at(x, y);
      const bool fresh = role.key || owed != 0 || any_changed(changed, x, y);
      std::uint8_t& left = improvements_left_.at(x, y);
      active_.at(x, y) = fresh || (role.layer == 0 && left > 0);
      if (left_out.data != nullptr && left_out.at(x, y) && !role.key) {
        if (role.layer == 0) owed = fresh;
        active_.at(x, y) = 0;
        continue;
      }
      if (role.layer > 0) continue;
      owed = 0;
      if (fresh) {
        left = kImprovements;
      } else if (left > 0) {
        --left;
      }
    }
  }
  return active_;
}

void ColorActivity::improve_next_band() {
  if (!is_improving()) return;
  const int high = improvements_left_.height();
  const int from = high * next_band_ / kBands, to = high * (next_band_ + 1) / kBands;
  for (int y = from; y < to; ++y) {
    for (int x = 0; x < improvements_left_.width(); ++x) {
      std::uint8_t& left = improvements_left_.at(x, y);
      left = std::max(left, kStillImprovements);
    }
  }
  ++next_band_;
}

}  // namespace roomcast::codec
