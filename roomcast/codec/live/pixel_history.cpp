// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/live/pixel_history.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "roomcast/core/vector_loop.h"

namespace roomcast::codec {
namespace {

using u16 = std::uint16_t;
using s16 = std::int16_t;

constexpr int kSupportReach = 6 * kLevelsPerSigma + 4;  // of neighbours on the same surface
constexpr int kMinSupport = 2;                          // of eight neighbours
constexpr u16 kHeld = 64;  // in first_flags_: kept without a reading, support not checked yet
constexpr u16 kAnyChange = kJumped | kVanished | kUnsupported;
constexpr int kBasePersistence = 5;
constexpr u16 kPersistenceDecay = 6;  // persistence that a frame without the difference takes back
constexpr int kMaxPersistence = 200;
constexpr int kOverdueFrames = 14;
constexpr int kHoldReach = 2;   // pixels; radius in which readings may support a missing one
constexpr int kMinCluster = 4;  // changed pixels of 3x3
constexpr u16 kFlickerClusterBonus = 2;  // added to kMinCluster where a pixel is known to flicker
constexpr int kMovingNeighbours = 6;     // jumped pixels of 5x5: a moving outline
constexpr u16 kFirstDeviation = 6 << kNoiseShift;

// All bits set where true, else 0.
constexpr u16 mask(bool condition) {
  return static_cast<u16>(-static_cast<int>(condition));
}
constexpr u16 distance(u16 a, u16 b) {
  return static_cast<u16>(a > b ? a - b : b - a);
}
constexpr u16 sigma_of(u16 deviation) {
  const u16 measured = static_cast<u16>(static_cast<u16>(deviation * 5) >> (kNoiseShift + 2));
  return measured < kLevelsPerSigma ? static_cast<u16>(kLevelsPerSigma) : measured;
}

ROOMCAST_VECTOR_CLONES
void drop_flying_row(const u16* above, const u16* here, const u16* below, int width, u16* out) {
  ROOMCAST_INDEPENDENT_ITERATIONS
  for (int x = 1; x < width - 1; ++x) {
    const u16 v = here[x];
    const auto near = [v](u16 q) { return static_cast<u16>(distance(q, v) < kSupportReach); };
    const u16 support = static_cast<u16>(near(above[x - 1]) + near(above[x]) + near(above[x + 1]) +
                                         near(here[x - 1]) + near(here[x + 1]) +
                                         near(below[x - 1]) + near(below[x]) + near(below[x + 1]));
    out[x] = support >= kMinSupport ? v : static_cast<u16>(0);
  }
}

struct ComparedRow {
  const u16* reading;
  const u16* reference;
  u16* deviation;
  s16* sum;
  u16* count;
  u16* missing;
  u16* flags;
  s16* off;
  u16* close;
};

// Branch-free and in 16-bit lanes, so that the compiler vectorises it.
ROOMCAST_VECTOR_CLONES
void compare_pixels(const ComparedRow& row, int n) {
  const u16* reading = row.reading;
  const u16* reference = row.reference;
  u16* deviation = row.deviation;
  s16* sum = row.sum;
  u16* count = row.count;
  u16* missing = row.missing;
  u16* flags = row.flags;
  s16* off = row.off;
  u16* close = row.close;
  ROOMCAST_INDEPENDENT_ITERATIONS
  for (int i = 0; i < n; ++i) {
    const u16 v = reading[i], r = reference[i];
    const u16 has_v = mask(v != 0), has_r = mask(r != 0), both = has_v & has_r;
    const u16 apart = std::min<u16>(distance(v, r), 16000);
    const u16 limit = static_cast<u16>(7 * std::min<u16>(sigma_of(deviation[i]), 4000));
    const u16 big = mask(static_cast<u16>(2 * apart) > limit);
    const u16 sample = both & mask(apart < kSampleReach);
    const s16 difference = static_cast<s16>(v - r);
    const s16 learn = static_cast<s16>(
        static_cast<s16>(static_cast<u16>(apart << kNoiseShift) - deviation[i]) >> 5);
    deviation[i] = static_cast<u16>(deviation[i] + (learn & static_cast<s16>(sample)));
    const u16 full = mask(count[i] >= kMaxSamples);
    const s16 kept_sum = static_cast<s16>((full & (sum[i] >> 1)) | (~full & sum[i]));
    const u16 kept_count = static_cast<u16>((full & (count[i] >> 1)) | (~full & count[i]));
    sum[i] = static_cast<s16>(kept_sum + (difference & static_cast<s16>(sample)));
    count[i] = static_cast<u16>(kept_count + (sample & 1));
    const u16 gone =
        std::min<u16>(static_cast<u16>(missing[i] + (has_r & 1)), 250) & static_cast<u16>(~has_v);
    missing[i] = gone;
    const u16 jumped = static_cast<u16>(((both & big) | (has_v & ~has_r)) & kJumped);
    const u16 held = has_r & static_cast<u16>(~has_v);
    const u16 long_gone = mask(gone >= kMaxMissingFrames);
    flags[i] = static_cast<u16>(jumped | (held & ((long_gone & kVanished) | (~long_gone & kHeld))));
    const u16 near = both & mask(apart < 6 * kLevelsPerSigma);
    off[i] = static_cast<s16>(difference & static_cast<s16>(near));
    close[i] = near & 1;
  }
}

ROOMCAST_VECTOR_CLONES
void sum_three(const u16* flags, const s16* off, const u16* close, int width, u16* flag_count,
               s16* off_sum, u16* close_sum) {
  const auto changed = [](u16 f) { return static_cast<u16>((f & kAnyChange) != 0); };
  ROOMCAST_INDEPENDENT_ITERATIONS
  for (int x = 1; x < width - 1; ++x) {
    flag_count[x] =
        static_cast<u16>(changed(flags[x - 1]) + changed(flags[x]) + changed(flags[x + 1]));
    off_sum[x] = static_cast<s16>(off[x - 1] + off[x] + off[x + 1]);
    close_sum[x] = static_cast<u16>(close[x - 1] + close[x] + close[x + 1]);
  }
}

struct ClassifiedRow {
  const u16* first_flags;
  const u16* row_flags;
  const s16* row_off;
  const u16* row_close;
  std::ptrdiff_t stride;
  const u16* reading;
  const u16* close;
  const u16* deviation;
  const u16* patience;
  u16* persistence;
  u16* flags;
};

ROOMCAST_VECTOR_CLONES
void classify_row(const ClassifiedRow& row, int width) {
  const u16* first = row.first_flags;
  const u16 *f0 = row.row_flags - row.stride, *f1 = row.row_flags, *f2 = row.row_flags + row.stride;
  const s16 *o0 = row.row_off - row.stride, *o1 = row.row_off, *o2 = row.row_off + row.stride;
  const u16 *c0 = row.row_close - row.stride, *c1 = row.row_close, *c2 = row.row_close + row.stride;
  const u16* reading = row.reading;
  const u16* close = row.close;
  const u16* deviation = row.deviation;
  const u16* patience = row.patience;
  u16* persistence = row.persistence;
  u16* flags = row.flags;
  ROOMCAST_INDEPENDENT_ITERATIONS
  for (int x = 0; x < width; ++x) {
    const u16 change = first[x] & kAnyChange;
    const u16 changed = mask(change != 0);
    const u16 cluster = static_cast<u16>(f0[x] + f1[x] + f2[x]);
    const u16 samples = static_cast<u16>(c0[x] + c1[x] + c2[x]);
    const s16 bias = static_cast<s16>(o0[x] + o1[x] + o2[x]);
    const u16 size = static_cast<u16>(bias < 0 ? -bias : bias);
    const u16 limit = static_cast<u16>(8 * std::min<u16>(sigma_of(deviation[x]), 800) * samples);
    const u16 biased =
        mask(samples >= 6) & mask(static_cast<u16>(size * 5) > limit) & mask(close[x] != 0);
    const u16 before = persistence[x];
    const u16 calmer = static_cast<u16>(
        before - (std::min<u16>(before, kPersistenceDecay) & mask(reading[x] != 0)));
    const u16 lasting = std::min<u16>(
        static_cast<u16>((changed & (before + 1)) | (~changed & calmer)), kMaxPersistence);
    persistence[x] = lasting;
    const u16 persists =
        changed & mask(lasting >= static_cast<u16>(kBasePersistence + patience[x]));
    const u16 least_cluster =
        static_cast<u16>(kMinCluster + (mask(patience[x] != 0) & kFlickerClusterBonus));
    const u16 counts = changed & (mask(cluster >= least_cluster) | persists);
    flags[x] = static_cast<u16>((counts & change) | (persists & kPersistent) |
                                (changed & mask(lasting >= kOverdueFrames) & kOverdue) |
                                (~changed & biased & kBiased));
  }
}

}  // namespace

void PixelHistory::resize(std::size_t pixels) {
  sum.assign(pixels, 0);
  deviation.assign(pixels, kFirstDeviation);
  for (auto* plane : {&count, &missing, &persistence, &patience}) plane->assign(pixels, 0);
}

void FrameChange::resize(std::size_t pixels) {
  off.assign(pixels, 0);
  for (auto* plane : {&reading, &flags, &close}) plane->assign(pixels, 0);
}

void ChangeAnalysis::resize(int width, int height) {
  width_ = width;
  height_ = height;
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  for (auto* plane : {&levels_, &first_flags_, &row_flags_, &row_close_}) plane->assign(pixels, 0);
  row_off_.assign(pixels, 0);
}

void ChangeAnalysis::take_reading(DepthView depth_mm, const DepthDomain& domain,
                                  FrameChange& change) {
  const std::uint16_t* const level_of = domain.level_table();
  u16* to = levels_.data();
  for (int y = 0; y < height_; ++y, to += width_) {
    const u16* row = depth_mm.row(y);
    for (int x = 0; x < width_; ++x) to[x] = level_of[row[x]];
  }
  drop_flying_pixels(change.reading.data());
}

// A reading with fewer than two similar neighbours is a flying pixel between two surfaces.
void ChangeAnalysis::drop_flying_pixels(u16* out) const {
  const std::size_t stride = static_cast<std::size_t>(width_);
  std::memcpy(out, levels_.data(), levels_.size() * sizeof(u16));
  for (int y = 1; y < height_ - 1; ++y) {
    const u16* here = levels_.data() + static_cast<std::size_t>(y) * stride;
    drop_flying_row(here - stride, here, here + stride, width_,
                    out + static_cast<std::size_t>(y) * stride);
  }
}

void ChangeAnalysis::compare(const LiveState& reference, PixelHistory& history,
                             FrameChange& change) {
  compare_pixels({change.reading.data(), reference.picture.data(), history.deviation.data(),
                  history.sum.data(), history.count.data(), history.missing.data(),
                  first_flags_.data(), change.off.data(), change.close.data()},
                 width_ * height_);
  drop_unsupported_holds(reference, change);
  sum_rows(change);
  settle(history, change);
}

// A missing reading is kept only while a neighbour resembles it and no outline moves past: at
// moving outlines sensors give no readings.
void ChangeAnalysis::drop_unsupported_holds(const LiveState& reference, const FrameChange& change) {
  constexpr int kAtOnce = 4;
  constexpr std::uint64_t kAnyHeld = kHeld * 0x0001000100010001u;
  for (int y = kHoldReach; y < height_ - kHoldReach; ++y) {
    u16* flags = first_flags_.data() + static_cast<std::ptrdiff_t>(y) * width_;
    for (int begin = 0; begin < width_; begin += kAtOnce) {
      const int end = std::min(begin + kAtOnce, width_);
      std::uint64_t word = kAnyHeld;
      if (end - begin == kAtOnce) std::memcpy(&word, flags + begin, sizeof word);
      if ((word & kAnyHeld) == 0) continue;
      for (int x = std::max(begin, kHoldReach); x < std::min(end, width_ - kHoldReach); ++x) {
        if (!(flags[x] & kHeld)) continue;
        flags[x] = held_without_support(reference, change, x, y) ? u16{kUnsupported} : u16{0};
      }
    }
  }
}

bool ChangeAnalysis::held_without_support(const LiveState& reference, const FrameChange& change,
                                          int x, int y) const {
  constexpr int kMinReadings = 4;
  const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(y) * width_ + x;
  const int old = reference.picture[static_cast<std::size_t>(at)];
  int readings = 0, like_old = 0, moved = 0;
  for (int dy = -kHoldReach; dy <= kHoldReach; ++dy) {
    const std::ptrdiff_t row = at + static_cast<std::ptrdiff_t>(dy) * width_;
    const u16* near = change.reading.data() + row;
    const u16* flags = first_flags_.data() + row;
    for (int dx = -kHoldReach; dx <= kHoldReach; ++dx) {
      if (near[dx] == 0) continue;
      like_old += std::abs(near[dx] - old) < 6 * kLevelsPerSigma;
      moved += (flags[dx] & kJumped) != 0;
      ++readings;
    }
  }
  return readings >= kMinReadings && (like_old == 0 || moved >= kMovingNeighbours);
}

void ChangeAnalysis::sum_rows(const FrameChange& change) {
  for (int y = 0; y < height_; ++y) {
    const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
    sum_three(&first_flags_[at], &change.off[at], &change.close[at], width_, &row_flags_[at],
              &row_off_[at], &row_close_[at]);
  }
}

void ChangeAnalysis::settle(PixelHistory& history, FrameChange& change) const {
  for (int y = 1; y < height_ - 1; ++y) {
    const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
    classify_row({&first_flags_[at], &row_flags_[at], &row_off_[at], &row_close_[at], width_,
                  &change.reading[at], &change.close[at], &history.deviation[at],
                  &history.patience[at], &history.persistence[at], &change.flags[at]},
                 width_);
  }
}

}  // namespace roomcast::codec
