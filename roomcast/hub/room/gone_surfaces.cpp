// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/gone_surfaces.h"

#include <algorithm>
#include <chrono>

namespace roomcast::hub {
namespace {

using namespace std::chrono_literals;

/// The model believes in what comes before a surface after nine key frames, which take longer.
constexpr auto kStands = 20s;
constexpr auto kBetweenKeys = 700ms;
constexpr auto kBetweenLarge = 10s;
constexpr std::size_t kLargeCells = 3;  // a person beside a far wall changes one or two
constexpr std::uint32_t kLonger_cm = 15, kLongerPercent = 5;

bool is_longer(std::uint32_t than_cm, std::uint32_t cm) {
  return cm > than_cm + std::max(kLonger_cm, than_cm * kLongerPercent / 100);
}

}  // namespace

bool GoneSurfaces::update(const wire::pb::CoarseDepth& depth, RoomTime now) {
  const auto count = static_cast<std::size_t>(depth.near_cm_size());
  if (depth.far_cm_size() != depth.near_cm_size()) return false;
  if (cells_.size() != count || columns_ != depth.columns()) cells_.assign(count, Cell());
  columns_ = depth.columns();
  for (std::size_t i = 0; i < count; ++i) {
    Cell& cell = cells_[i];
    cell.new_near_cm = depth.near_cm(static_cast<int>(i));
    cell.new_far_cm = depth.far_cm(static_cast<int>(i));
    take(cell, now);
  }
  const auto gone = static_cast<std::size_t>(std::ranges::count_if(cells_, &Cell::has_gone));
  const bool is_large = gone >= kLargeCells && gone_cells_ < kLargeCells &&
                        (!last_large_ || now - *last_large_ >= kBetweenLarge);
  gone_cells_ = gone;
  if (is_large) last_large_ = now;
  return is_large;
}

void GoneSurfaces::take(Cell& cell, RoomTime now) {
  if (cell.new_far_cm == 0) return;  // it may be behind what gives no readings
  const auto stands_now = [&] {
    cell = {cell.new_near_cm, cell.new_far_cm, cell.new_near_cm, cell.new_far_cm};
  };
  if (cell.far_cm == 0) return stands_now();
  cell.has_gone =
      is_longer(cell.near_cm, cell.new_near_cm) || is_longer(cell.far_cm, cell.new_far_cm);
  const bool is_nearer = !cell.has_gone && (is_longer(cell.new_near_cm, cell.near_cm) ||
                                            is_longer(cell.new_far_cm, cell.far_cm));
  if (!is_nearer) return cell.nearer_since.reset();
  if (!cell.nearer_since) cell.nearer_since = now;
  if (now - *cell.nearer_since >= kStands) stands_now();
}

void GoneSurfaces::key_frame_came(RoomTime now) {
  last_key_ = now;
  expected_keys_ = std::max(0, expected_keys_ - 1);
  for (Cell& cell : cells_) {
    if (cell.has_gone && ++cell.keys >= kKeysToForget)
      cell = {cell.new_near_cm, cell.new_far_cm, cell.new_near_cm, cell.new_far_cm};
  }
}

bool GoneSurfaces::wants_key(RoomTime now) const {
  if (last_key_ && now - *last_key_ < kBetweenKeys) return false;
  return expected_keys_ > 0 || std::ranges::any_of(cells_, &Cell::has_gone);
}

}  // namespace roomcast::hub
