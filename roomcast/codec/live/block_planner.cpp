// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/live/block_planner.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "roomcast/codec/live/picture_pass.h"

namespace roomcast::codec {
namespace {

constexpr int kPersistentUrgency = 3;
constexpr int kMinMoved = 24;  // pixels on coded surfaces, in a block that counts as moved
constexpr int kMinUrgency = 10, kMinUrgencyNonReference = 9;  // of 64
constexpr int kMinUrgencyInMotion = 3;                        // while the sensor itself moves
constexpr int kSameSurface = 2;  // standard deviations of noise between readings of one surface
constexpr int kReach = 6 * kLevelsPerSigma;
constexpr int kMaxPatience = 9;  // frames; a change is delayed by half a second at most

constexpr int kRefinementsPerFrame = 200;
constexpr unsigned kRefinementTurns = 4;  // each block is examined in one of so many frames
constexpr int kFirstRefinement = 10,
              kNextRefinement = 48;  // samples per pixel before a refinement
constexpr float kRefinementGain = 0.68f * kLevelsPerSigma;
constexpr float kRefinementRounding = 0.25f;

/// Sums over the 3x3 neighbourhoods of an 8x8 block, without the centre; pixels outside count as 0.
struct Neighbourhoods {
  float count[kBlockPixels] = {}, value[kBlockPixels] = {};
};

Neighbourhoods surfaces_around(const BlockCode& code, const BlockTarget& target) {
  constexpr int kSide = kBlockSide + 2;
  float count[kSide][kSide] = {}, value[kSide][kSide] = {};
  for (int k = 0; k < kBlockPixels; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const float on = code.labels[i] == PixelLabel::kFirst ? 1.0f : 0.0f;
    count[k / 8 + 1][k % 8 + 1] = on;
    value[k / 8 + 1][k % 8 + 1] = on * target[i];
  }
  float row_count[kSide][kBlockSide], row_value[kSide][kBlockSide];
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kBlockSide; ++x) {
      row_count[y][x] = count[y][x] + count[y][x + 1] + count[y][x + 2];
      row_value[y][x] = value[y][x] + value[y][x + 1] + value[y][x + 2];
    }
  }
  Neighbourhoods sums;
  for (int y = 0; y < kBlockSide; ++y) {
    for (int x = 0; x < kBlockSide; ++x) {
      sums.count[y * 8 + x] =
          row_count[y][x] + row_count[y + 1][x] + row_count[y + 2][x] - count[y + 1][x + 1];
      sums.value[y * 8 + x] =
          row_value[y][x] + row_value[y + 1][x] + row_value[y + 2][x] - value[y + 1][x + 1];
    }
  }
  return sums;
}

/// Tests eight flags at once, because most rows have none.
bool all_zero(const std::uint16_t* flags) {
  std::uint64_t words[2];
  std::memcpy(words, flags, sizeof words);
  return (words[0] | words[1]) == 0;
}

/// Number of a pixel's neighbours within its block.
float neighbours_in_block(std::size_t k) {
  const std::size_t x = k % kBlockSide, y = k / kBlockSide;
  return static_cast<float>((x == 0 || x == 7 ? 2 : 3) * (y == 0 || y == 7 ? 2 : 3) - 1);
}

}  // namespace

void BlockPlanner::resize() {
  refined_.assign(state_.grid.block_count(), 0);
}

void BlockPlanner::begin_frame(bool reference) {
  reference_ = reference;
  refinements_left_ = reference ? kRefinementsPerFrame : 0;
  if (reference) ++frame_;
  sensor_moves_ = 2 * labelled_blocks_ > state_.grid.block_count();
  labelled_blocks_ = 0;
}

void BlockPlanner::plan(const BlockView& here, BlockDrift drift, BlockCode& code,
                        BlockTarget& target) {
  code.mode = BlockMode::kSkip;

  if (urgency(here, drift) >= min_urgency()) {
    if (plan_labels(here, drift, code, target)) {
      code.mode = BlockMode::kLabels;
      ++labelled_blocks_;
    }
  } else if (refinements_left_ > 0 && (here.index() + frame_) % kRefinementTurns == 0 &&
             plan_refinement(here, code)) {
    --refinements_left_;
    code.mode = BlockMode::kRefine;
  }
}

int BlockPlanner::min_urgency() const {
  if (sensor_moves_) return kMinUrgencyInMotion;
  return reference_ ? kMinUrgency : kMinUrgencyNonReference;
}

int BlockPlanner::urgency(const BlockView& here, BlockDrift drift) const {
  const int columns = here.columns(), rows = here.rows();
  const unsigned reasons = drift.shares_noise ? kAllChanges & ~unsigned{kBiased} : kAllChanges;
  int urgency = 0;
  for (int y = 0; y < rows; ++y) {
    const std::uint16_t* flags = &change_.flags[here.row(y)];
    if (!drift.drifts && columns == kBlockSide && all_zero(flags)) continue;
    const std::uint16_t* close = &change_.close[here.row(y)];
    for (int x = 0; x < columns; ++x) {
      if (flags[x] & kPersistent) {
        if (reference_) urgency += flags[x] & kOverdue ? kMinUrgency : kPersistentUrgency;
      } else {
        urgency += (flags[x] & reasons) != 0 || (drift.drifts && close[x]);
      }
    }
  }
  return urgency;
}

bool BlockPlanner::plan_labels(const BlockView& here, BlockDrift drift, BlockCode& code,
                               BlockTarget& target) {
  code.labels.fill(PixelLabel::kUnchanged);
  target.fill(0);
  here.for_each_pixel([&](const BlockPixel& p) {
    const bool biased = (change_.flags[p.at] == kBiased && !drift.shares_noise) ||
                        (drift.drifts && change_.close[p.at]);
    target[p.k] = change_.reading[p.at];
    code.labels[p.k] = label_of(p, biased);
  });
  constexpr int kRounds = 2;
  for (int round = 0; round < kRounds && smooth_labels(here, code, target); ++round) {
  }
  return std::any_of(code.labels.begin(), code.labels.end(),
                     [](PixelLabel label) { return label != PixelLabel::kUnchanged; });
}

PixelLabel BlockPlanner::label_of(const BlockPixel& pixel, bool biased) const {
  const std::size_t at = pixel.at;
  const int reading = change_.reading[at], old = state_.picture[at], back = state_.background[at];
  if (reading == 0) return label_of_missing(pixel);
  const int same = kSameSurface * history_.sigma(at);
  const auto near = [same, reading](int value) {
    return value != 0 && std::abs(reading - value) <= same;
  };
  if (near(old) && !biased) return PixelLabel::kUnchanged;
  const bool back_is_old = std::abs(back - old) < 4 * kLevelsPerSigma;
  if (near(back) && !(biased && back_is_old)) return PixelLabel::kBackground;
  return PixelLabel::kFirst;
}

PixelLabel BlockPlanner::label_of_missing(const BlockPixel& pixel) const {
  const int x = pixel.x, y = pixel.y;
  const std::size_t at = pixel.at;
  const BlockGrid& grid = state_.grid;
  const int old = state_.picture[at], back = state_.background[at];
  if (old == 0) return PixelLabel::kUnchanged;
  if (history_.missing[at] >= kMaxMissingFrames) return PixelLabel::kVanished;
  int readings = 0, like_old = 0, like_back = 0;
  for (int yy = std::max(0, y - 2); yy <= std::min(grid.height - 1, y + 2); ++yy) {
    for (int xx = std::max(0, x - 2); xx <= std::min(grid.width - 1, x + 2); ++xx) {
      const int near = change_.reading[grid.pixel(xx, yy)];
      if (near == 0) continue;
      ++readings;
      like_old += std::abs(near - old) < kReach;
      like_back += back != 0 && std::abs(near - back) < kReach;
    }
  }
  const bool unsupported = like_old == 0 || (change_.flags[at] & kUnsupported);
  if (readings < 4 || !unsupported) return PixelLabel::kUnchanged;
  const int enough = like_old == 0 ? 1 : readings / 2 + 1;
  return like_back >= enough ? PixelLabel::kBackground : PixelLabel::kVanished;
}

// An unchanged pixel among new ones at its distance joins their surface, which shortens contours.
// An isolated new pixel becomes unchanged again.
bool BlockPlanner::smooth_labels(const BlockView& here, BlockCode& code,
                                 const BlockTarget& target) const {
  if (std::all_of(code.labels.begin(), code.labels.end(), on_surface)) return false;
  bool any = false;
  const Neighbourhoods around = surfaces_around(code, target);
  here.for_each_pixel([&](const BlockPixel& p) {
    const float all = neighbours_in_block(p.k), fresh = around.count[p.k], value = target[p.k];
    PixelLabel& label = code.labels[p.k];
    if (label == PixelLabel::kUnchanged && fresh > 0) {
      const bool joins = value > 0
                             ? fresh * 3 >= all && std::abs(value * fresh - around.value[p.k]) <
                                                       static_cast<float>(kReach) * fresh
                             : fresh * 4 >= all * 3 && state_.picture[p.at] != 0;
      if (joins) label = PixelLabel::kFirst;
      any |= joins;
    } else if (label == PixelLabel::kFirst && fresh <= 1 && all >= 5 && state_.picture[p.at] != 0 &&
               !(change_.flags[p.at] & kPersistent)) {
      label = PixelLabel::kUnchanged;
      any = true;
    }
  });
  return any;
}

// Refines once the averaged difference from the reference exceeds the noise that remains in the
// average.
bool BlockPlanner::plan_refinement(const BlockView& here, BlockCode& code) const {
  const bool again = refined_[here.index()] != 0;
  const int least = again ? kNextRefinement : kFirstRefinement;
  std::array<float, kBlockPixels> mean{};
  float energy = 0, noise = 0;
  int pixels = 0;
  bool enough = true;
  here.for_each_pixel([&](const BlockPixel& p) {
    const int count = history_.count[p.at];
    if (!enough || state_.picture[p.at] == 0 || count < 8) return;
    enough = count >= least;
    const auto sigma = static_cast<float>(history_.deviation[p.at]) * (1.25f / (1 << kNoiseShift));
    const float off = static_cast<float>(history_.sum[p.at]) / static_cast<float>(count);
    mean[p.k] = off;
    energy += off * off;
    noise += sigma * sigma / static_cast<float>(count);
    ++pixels;
  });
  if (!enough || pixels < 16 ||
      energy - noise <= kRefinementGain * kRefinementGain * static_cast<float>(pixels))
    return false;
  std::array<float, kBlockPixels> coefficients;
  forward_transform(mean, coefficients);
  bool any = false;
  for (std::size_t k = 0; k + 1 < kBlockPixels; ++k) {
    code.refinement[k] = quantised(coefficients[k], kRefinementStep, kRefinementRounding);
    any |= code.refinement[k] != 0;
  }
  code.refinement[kBlockPixels - 1] = 0;
  return any;
}

bool BlockPlanner::coded(const BlockView& here, const BlockCode& code,
                         const std::array<std::uint16_t, kBlockPixels>& before) {
  const bool refined = code.mode == BlockMode::kRefine;

  const bool moved = std::count_if(code.labels.begin(), code.labels.end(), on_surface) >= kMinMoved;
  refined_[here.index()] = refined;
  here.for_each_pixel([&](const BlockPixel& p) {
    if (refined) {
      history_.follow(p.at, state_.picture[p.at] - before[p.k]);
    } else if (code.labels[p.k] != PixelLabel::kUnchanged) {
      restart_history(p.at, moved && on_surface(code.labels[p.k]));
    }
  });
  return moved && !refined;
}

void BlockPlanner::restart_history(std::size_t at, bool moved) {
  const unsigned flags = change_.flags[at];
  if (flags & kPersistent) {
    history_.patience[at] =
        static_cast<std::uint16_t>(std::min(history_.patience[at] * 2 + 4, kMaxPatience));
    history_.persistence[at] = 0;
  } else if (flags != 0) {
    history_.patience[at] /= 2;
  }
  history_.sum[at] = 0;
  history_.count[at] = 0;
  if (!moved) return;
  constexpr int kFresh = 6 << kNoiseShift;
  history_.deviation[at] = static_cast<std::uint16_t>((history_.deviation[at] + 3 * kFresh) / 4);
}

}  // namespace roomcast::codec
