// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/interference_meter.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace roomcast::sensor {
namespace {

constexpr int kGrid_px = 2;              // every second pixel is measured, in both directions
constexpr std::uint8_t kSteady = 8;      // readings that make a still surface
constexpr std::uint8_t kMaxSteady = 32;  // readings that are averaged
constexpr int kMinMissing = 3, kMaxMissing = 60;  // frames of the second that a surface stays
constexpr std::uint8_t kMaxOdd = 3;  // readings of another surface replace the still one
constexpr float kSame = 5;           // standard deviations
constexpr float kOutlier = 20;       // likewise; readings beyond are no noise of any kind
constexpr int kTableEvery = 15;      // frames
constexpr float kMinDeviation_mm = 0.5F;
constexpr int kInside_px = 6;         // distance to the next outline
constexpr float kSlopeShare = 0.03F;  // depth inside a surface changes by less over kInside_px
constexpr float kMinReadings = 100;   // of a distance in a frame, to say something on its noise
constexpr int kBlock_px = 16;
constexpr int kMinInside = 500;  // measured pixels, to say something on flicker
constexpr int kKnownAfter = 20;  // frames
constexpr double kFlickerWeight = 1.0 / 60;
constexpr float kPeakDecay = 0.9977F;           // halves in ten seconds at 30 frames/s
constexpr float kFall = 0.1F, kRise = 0.0005F;  // of the quiet noise, per frame
constexpr int kLearningFrames = 15;

}  // namespace

InterferenceMeter::InterferenceMeter(double fps)
    : max_missing_(static_cast<int>(std::clamp(fps, double{kMinMissing}, double{kMaxMissing}))) {}

void InterferenceMeter::begin(DepthView depth_mm) {
  pixels_.resize(depth_mm.width, depth_mm.height);
  shown_.resize(depth_mm.width, depth_mm.height);
  quiet_mm_ = {};
  ratio_now_ = ratio_peak_ = 1;
  flickering_ = 0;
  frames_ = known_frames_ = 0;
}

void InterferenceMeter::add(DepthView depth_mm) {
  if (!same_size(depth_mm, pixels_.view())) begin(depth_mm);
  noise_.observe(depth_mm);
  if (frames_ % kTableEvery == 0) {
    const codec::SigmaCodes table = noise_.table();
    for (std::size_t knot = 0; knot < law_mm_.size(); ++knot)
      law_mm_[knot] = static_cast<float>(codec::sigma_of_code(table[knot])) / 256;
  }
  measure_noise(depth_mm);
  for (int y = 0; y < depth_mm.height; ++y) {
    const std::uint16_t* readings = depth_mm.row(y);
    Pixel* pixels = pixels_.view().row(y);
    Shown* shown = shown_.view().row(y);
    for (int x = 0; x < depth_mm.width; ++x) shown[x] = see(readings[x], pixels[x]);
  }
  ++frames_;
  count_flicker();
}

float InterferenceMeter::same_mm(std::uint16_t depth_mm) const {
  return kSame * ratio_now_ * law_mm_[static_cast<std::size_t>(codec::sigma_knot_of(depth_mm))];
}

// The mean deviation of steady pixels from their still surface, at each distance, without outliers.
void InterferenceMeter::measure_noise(DepthView depth_mm) {
  ByDistance sum_mm{}, count{};
  for (int y = 0; y < depth_mm.height; y += kGrid_px) {
    for (int x = 0; x < depth_mm.width; x += kGrid_px) {
      const Pixel& pixel = pixels_.at(x, y);
      const std::uint16_t reading = depth_mm.at(x, y);
      if (reading == 0 || pixel.steady < kSteady) continue;
      const float still_mm = static_cast<float>(pixel.still) / 16;
      const auto knot = static_cast<std::size_t>(codec::sigma_knot_of(static_cast<int>(still_mm)));
      const float deviation_mm = std::abs(static_cast<float>(reading) - still_mm);
      if (deviation_mm > kOutlier * law_mm_[knot]) continue;
      sum_mm[knot] += deviation_mm;
      ++count[knot];
    }
  }
  float ratios = 0, weight = 0;
  for (std::size_t knot = 0; knot < count.size(); ++knot) {
    if (count[knot] < kMinReadings) continue;
    sum_mm[knot] = std::max(kMinDeviation_mm, sum_mm[knot] / count[knot]);
    if (quiet_mm_[knot] == 0) continue;
    ratios += count[knot] * sum_mm[knot] / quiet_mm_[knot];
    weight += count[knot];
  }
  ratio_now_ = weight > 0 && frames_ >= kLearningFrames ? std::max(1.0F, ratios / weight) : 1.0F;
  ratio_peak_ = std::max(1 + (ratio_peak_ - 1) * kPeakDecay, ratio_now_);
  learn_quiet_noise(sum_mm, count);
}

// Falls quickly and rises slowly, so that it is the noise of quiet moments.
void InterferenceMeter::learn_quiet_noise(const ByDistance& deviation_mm, const ByDistance& count) {
  for (std::size_t knot = 0; knot < count.size(); ++knot) {
    if (count[knot] < kMinReadings) continue;
    float& quiet = quiet_mm_[knot];
    const float rate = frames_ < kLearningFrames || deviation_mm[knot] < quiet ? kFall : kRise;
    quiet += (quiet == 0 ? 1 : rate) * (deviation_mm[knot] - quiet);
  }
}

InterferenceMeter::Shown InterferenceMeter::see(std::uint16_t reading_mm, Pixel& pixel) const {
  if (reading_mm == 0) {
    if (pixel.steady == 0) return Shown::kUnknown;
    if (++pixel.missing > max_missing_) pixel = {};
    return pixel.steady >= kSteady ? Shown::kMissing : Shown::kUnknown;
  }
  pixel.missing = 0;
  const std::uint32_t reading = 16U * reading_mm;
  const auto change = static_cast<std::int32_t>(reading) - static_cast<std::int32_t>(pixel.still);
  const auto still_mm = static_cast<std::uint16_t>(std::min(pixel.still / 16, 65535U));
  const auto same = static_cast<std::int32_t>(16 * same_mm(still_mm));
  if (pixel.steady == 0 || std::abs(change) > same) {
    const bool was_steady = pixel.steady >= kSteady;
    if (pixel.steady == 0 || ++pixel.odd >= kMaxOdd) pixel = {reading, 1, 0, 0};
    if (!was_steady) return Shown::kUnknown;
    return change < 0 ? Shown::kNearer : Shown::kFarther;
  }
  pixel.odd = 0;
  pixel.steady = std::min<std::uint8_t>(pixel.steady + 1, kMaxSteady);
  pixel.still = static_cast<std::uint32_t>(static_cast<std::int32_t>(pixel.still) +
                                           change / static_cast<std::int32_t>(pixel.steady));
  return pixel.steady >= kSteady ? Shown::kStill : Shown::kUnknown;
}

/// Whether the surface at a pixel goes on around it, and nothing moves there. Wide holes are the
/// shadows of what moves rather than interference, so three of four sides must have readings.
bool InterferenceMeter::is_inside(int x, int y) const {
  constexpr int kMinSides = 3;
  const auto here = static_cast<float>(pixels_.at(x, y).still);
  int sides = 0;
  for (const auto& [dx, dy] :
       {std::pair{-kInside_px, 0}, {kInside_px, 0}, {0, -kInside_px}, {0, kInside_px}}) {
    const Shown shown = shown_.at(x + dx, y + dy);
    if (shown != Shown::kStill && shown != Shown::kMissing) return false;
    const float step = static_cast<float>(pixels_.at(x + dx, y + dy).still) - here;
    if (std::abs(step) > kSlopeShare * here) return false;
    sides += shown == Shown::kStill;
  }
  return sides >= kMinSides;
}

int InterferenceMeter::missing_neighbours(int x, int y) const {
  int missing = 0;
  for (int j = y - 1; j <= y + 1; ++j) {
    for (int i = x - 1; i <= x + 1; ++i) missing += shown_.at(i, j) == Shown::kMissing;
  }
  return missing - (shown_.at(x, y) == Shown::kMissing);
}

/// Where little light returns, pixels lose their readings one by one.
void InterferenceMeter::find_weak_blocks() {
  constexpr int kAlone = 2;  // neighbours that are missing, too; of eight
  const int wide = (shown_.width() + kBlock_px - 1) / kBlock_px;
  const int high = (shown_.height() + kBlock_px - 1) / kBlock_px;
  alone_.resize(wide, high, 0);
  for (int y = kInside_px; y < shown_.height() - kInside_px; y += kGrid_px) {
    for (int x = kInside_px; x < shown_.width() - kInside_px; x += kGrid_px) {
      if (shown_.at(x, y) == Shown::kMissing && missing_neighbours(x, y) <= kAlone)
        ++alone_.at(x / kBlock_px, y / kBlock_px);
    }
  }
}

void InterferenceMeter::count_flicker() {
  constexpr int kPatch = 5;     // neighbours of a missing pixel that are missing, too
  constexpr int kMaxAlone = 1;  // pixels of a block, of 64 that are measured
  find_weak_blocks();
  int inside = 0, missing = 0;
  for (int y = kInside_px; y < shown_.height() - kInside_px; y += kGrid_px) {
    for (int x = kInside_px; x < shown_.width() - kInside_px; x += kGrid_px) {
      const Shown shown = shown_.at(x, y);
      if (shown != Shown::kStill && shown != Shown::kMissing) continue;
      if (alone_.at(x / kBlock_px, y / kBlock_px) > kMaxAlone || !is_inside(x, y)) continue;
      ++inside;
      missing += shown == Shown::kMissing && missing_neighbours(x, y) >= kPatch;
    }
  }
  if (inside < kMinInside) return;
  const double now = static_cast<double>(missing) / inside;
  ++known_frames_;
  flickering_ += std::max(kFlickerWeight, 1.0 / known_frames_) * (now - flickering_);
}

InterferenceFigures InterferenceMeter::figures() const {
  return {flickering_, static_cast<double>(ratio_peak_), known_frames_ >= kKnownAfter};
}

}  // namespace roomcast::sensor
