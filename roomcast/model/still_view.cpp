// SPDX-License-Identifier: Apache-2.0
#include "roomcast/model/still_view.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace roomcast::model {
namespace {

/// Which share of the readings of a surface another one needs to be believed in its place.
constexpr float kFartherShare = 0.3F, kNearerShare = 2;
constexpr int kMinFartherCount = 3;
/// A surface that was read in nearly all frames until it was read no more: dark and glossy ones,
/// which are read now and then, have a lower count.
constexpr int kReliableCount = 6, kMaxReliableCount = 9, kPerMissed = 2;
/// Neighbouring pixels show one surface when they differ by less.
constexpr float kJoined_mm = 10, kJoinedShare = 0.02F;
constexpr int kMinCount = 3;
constexpr int kNoiseFrames = 30;  // the noise law is taken over in these, then every 30th
constexpr int kAgreementStep = 4;
constexpr double kMinAgreement = 0.6;
constexpr float kSameStand = 0.02F;  // of the depth: the sensor has not moved

void count_up(std::uint8_t& count) {
  if (count < std::numeric_limits<std::uint8_t>::max()) ++count;
}

Status check_pose(const RigidTransform& pose) {
  if (!pose.rotation.allFinite() || !pose.translation_m.allFinite())
    return invalid_argument("a sensor's pose has numbers that are not finite");
  if (pose.translation_m.cwiseAbs().maxCoeff() > kMaxRoom_m)
    return invalid_argument("a sensor stands more than 500 m from the room's origin");
  return {};
}

}  // namespace

Result<StillView> StillView::create(const CameraIntrinsics& camera,
                                    const RigidTransform& world_from_depth,
                                    const ModelOptions& options) {
  if (auto status = camera.check(); !status) return status.error();
  if (auto status = check_pose(world_from_depth); !status) return status.error();
  if (auto status = options.check(); !status) return status.error();
  const auto pixels =
      static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
  if (pixels > kMaxViewPixels)
    return Error{ErrorCode::kTooLarge,
                 "depth pictures of more than 4 million pixels are not fused"};
  return StillView(camera, world_from_depth, options);
}

StillView::StillView(const CameraIntrinsics& camera, const RigidTransform& world_from_depth,
                     const ModelOptions& options)
    : camera_(camera),
      world_from_depth_(world_from_depth),
      options_(options),
      pixels_(camera.width, camera.height) {}

Status StillView::set_pose(const RigidTransform& world_from_depth) {
  if (auto status = check_pose(world_from_depth); !status) return status;
  world_from_depth_ = world_from_depth;
  return {};
}

float StillView::sigma_mm(float depth_mm) const {
  return sigma_mm_[static_cast<std::size_t>(codec::sigma_knot_of(static_cast<int>(depth_mm)))];
}

bool StillView::is_same(float a_mm, float b_mm) const {
  return std::abs(a_mm - b_mm) <= options_.same_surface_sigmas * sigma_mm(std::min(a_mm, b_mm)) +
                                      1000 * options_.same_surface_m;
}

void StillView::add(DepthView depth_mm, ColorView color, MaskView color_seen) {
  ROOMCAST_ASSERT(depth_mm.width == camera_.width && depth_mm.height == camera_.height);
  ROOMCAST_ASSERT(color.data == nullptr || same_size(color, depth_mm));
  noise_.observe(depth_mm);
  if (frames_ < kNoiseFrames || frames_ % kNoiseFrames == 0) {
    const codec::SigmaCodes codes = noise_.table();
    std::ranges::transform(codes, sigma_mm_.begin(), [](std::uint8_t code) {
      return static_cast<float>(codec::sigma_of_code(code)) / 256;
    });
  }
  ++frames_;
  const bool has_seen = color_seen.data != nullptr && same_size(color_seen, depth_mm);
  const float farthest_mm = 1000 * options_.max_range_m;
  for (int y = 0; y < depth_mm.height; ++y) {
    for (int x = 0; x < depth_mm.width; ++x) {
      const auto z_mm = static_cast<float>(depth_mm.at(x, y));
      Pixel& pixel = pixels_.at(x, y);
      if (z_mm == 0) count_up(pixel.missed_count);
      if (z_mm == 0 || z_mm > farthest_mm) continue;
      const float before_mm = pixel.mean_mm;
      if (add_reading(z_mm, pixel)) gone_.push_back({x, y, before_mm});
      const bool has_color = color.data != nullptr && (!has_seen || color_seen.at(x, y) != 0);
      if (has_color && is_same(z_mm, pixel.mean_mm)) add_color(color.at(x, y), pixel);
    }
  }
  forget_around_gone();
}

/// Forgets the rest of a thing that has gone: the pixels beside those that see through it which
/// give no reading any more, because the surface behind the thing is too dark or too far there.
void StillView::forget_around_gone() {
  while (!gone_.empty()) {
    const Gone gone = gone_.back();
    gone_.pop_back();
    for (int y = std::max(gone.y - 1, 0); y <= std::min(gone.y + 1, camera_.height - 1); ++y) {
      for (int x = std::max(gone.x - 1, 0); x <= std::min(gone.x + 1, camera_.width - 1); ++x) {
        Pixel& pixel = pixels_.at(x, y);
        const float near_mm = std::min(pixel.mean_mm, gone.before_mm);
        if (pixel.count == 0 || !is_missed(pixel)) continue;
        if (std::abs(pixel.mean_mm - gone.before_mm) > kJoined_mm + kJoinedShare * near_mm)
          continue;
        gone_.push_back({x, y, pixel.mean_mm});
        pixel = {};
      }
    }
  }
}

/// True: a farther surface has taken the place of the one that was there.
bool StillView::add_reading(float z_mm, Pixel& pixel) const {
  if (pixel.count > 0 && !is_same(z_mm, pixel.mean_mm)) return add_other_reading(z_mm, pixel);
  add_same_reading(z_mm, pixel);
  return false;
}

void StillView::join(float z_mm, float& mean_mm, std::uint8_t& count) const {
  count = static_cast<std::uint8_t>(std::min(count + 1, options_.memory_frames));
  mean_mm += (z_mm - mean_mm) / static_cast<float>(count);
}

/// The surface that stands there is seen again, or the first one is.
void StillView::add_same_reading(float z_mm, Pixel& pixel) const {
  join(z_mm, pixel.mean_mm, pixel.count);
  const int reliable = std::max(0, pixel.reliable_count - kPerMissed * pixel.missed_count) + 1;
  pixel.reliable_count = static_cast<std::uint8_t>(std::min(reliable, kMaxReliableCount));
  pixel.through_count = pixel.missed_count = 0;
  // A person who walks past many times must not be believed in the end.
  if (pixel.other_count > 0 && pixel.other_mm < pixel.mean_mm) --pixel.other_count;
}

/// Something else is seen there. Returns as add_reading.
bool StillView::add_other_reading(float z_mm, Pixel& pixel) const {
  const bool farther = z_mm > pixel.mean_mm;
  if (farther) {
    count_up(pixel.through_count);
    count_up(pixel.missed_count);
  }
  if (pixel.other_count == 0 || is_same(z_mm, pixel.other_mm)) {
    join(z_mm, pixel.other_mm, pixel.other_count);
  } else {
    --pixel.other_count;
  }
  if (farther && (is_outvoted(pixel, pixel.through_count) || is_missed(pixel))) {
    // The newest reading counts: those of a far or dark surface differ from each other.
    if (pixel.other_count == 0 || !is_same(z_mm, pixel.other_mm)) {
      pixel.other_mm = z_mm;
      pixel.other_count = 1;
    }
    take_other(pixel);
    return true;
  }
  if (pixel.other_count == 0 || !is_same(z_mm, pixel.other_mm)) return false;
  const bool is_believed =
      farther ? is_outvoted(pixel, pixel.other_count)
              : static_cast<float>(pixel.other_count) > enough(kNearerShare, pixel.count);
  if (is_believed) take_other(pixel);
  return is_believed && farther;
}

/// After so many readings of something else; a full count says no more than "for long".
float StillView::enough(float share, int count) const {
  return std::min(share * static_cast<float>(count),
                  static_cast<float>(options_.memory_frames) - 1);
}

bool StillView::is_outvoted(const Pixel& pixel, int frames) const {
  return frames >= kMinFartherCount &&
         static_cast<float>(frames) > enough(kFartherShare, pixel.count);
}

/// It was always read, and is no more, although nothing is before it.
bool StillView::is_missed(const Pixel& pixel) const {
  return pixel.reliable_count >= kReliableCount && is_outvoted(pixel, pixel.missed_count);
}

void StillView::take_other(Pixel& pixel) {
  std::swap(pixel.mean_mm, pixel.other_mm);
  std::swap(pixel.count, pixel.other_count);
  pixel.other_count = std::min<std::uint8_t>(pixel.other_count, pixel.count);
  pixel.reliable_count = std::min<std::uint8_t>(pixel.count, kMaxReliableCount);
  pixel.through_count = pixel.missed_count = 0;
  pixel.color_count = 0;
}

void StillView::add_color(Rgb8 color, Pixel& pixel) const {
  pixel.color_count =
      static_cast<std::uint8_t>(std::min(pixel.color_count + 1, options_.memory_frames));
  const std::array<int, 3> levels = {color.r, color.g, color.b};
  for (std::size_t i = 0; i < 3; ++i) {
    const int mean = pixel.color[i];
    pixel.color[i] =
        static_cast<std::uint16_t>(mean + (256 * levels[i] - mean) / pixel.color_count);
  }
}

Rgb8 StillView::color(int x, int y) const {
  const auto level = [&](std::size_t i) {
    return static_cast<std::uint8_t>(std::min((pixels_.at(x, y).color[i] + 128) / 256, 255));
  };
  return {level(0), level(1), level(2)};
}

bool StillView::is_sure(int x, int y) const {
  return pixels_.at(x, y).count >= std::min(kMinCount, frames_);
}

float StillView::depth_mm(int x, int y) const {
  return pixels_.at(x, y).mean_mm;
}

bool StillView::agrees(DepthView depth_mm) const {
  if (depth_mm.width != camera_.width || depth_mm.height != camera_.height) return false;
  int compared = 0, same = 0;
  for (int y = 0; y < camera_.height; y += kAgreementStep) {
    for (int x = 0; x < camera_.width; x += kAgreementStep) {
      const Pixel& pixel = pixels_.at(x, y);
      const auto z_mm = static_cast<float>(depth_mm.at(x, y));
      if (pixel.count == 0 || z_mm == 0) continue;
      ++compared;
      same += std::abs(z_mm - pixel.mean_mm) <= kSameStand * pixel.mean_mm ||
              is_same(z_mm, pixel.mean_mm);
    }
  }
  return same >= kMinAgreement * compared;
}

}  // namespace roomcast::model
