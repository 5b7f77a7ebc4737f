// SPDX-License-Identifier: Apache-2.0
// StillView: what stands still in the view of one sensor at one place, gathered from its frames.
// For each pixel the mean of the readings of the surface that stands there, the number of these
// readings, and their mean colour. Something that moves is forgotten: where a farther surface is
// seen often enough, the nearer one has gone; so has a nearer one beside it that was always read
// and is no longer, although nothing is behind it that gives readings. A nearer surface is believed
// only when it has been there for twice as long. Hence a person who walks past is not in the view,
// and furniture that was moved is after a few seconds. Depth in millimetres. Single-threaded.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "roomcast/codec/live/sensor_noise.h"
#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/model/model_options.h"

namespace roomcast::model {

/// Larger pictures are refused; a view takes 24 bytes a pixel.
inline constexpr std::size_t kMaxViewPixels = 4'000'000;

class StillView {
 public:
  /// kInvalidArgument for a camera or pose that no sensor of a room has; kTooLarge above
  /// kMaxViewPixels.
  static Result<StillView> create(const CameraIntrinsics& camera,
                                  const RigidTransform& world_from_depth,
                                  const ModelOptions& options = {});

  /// `depth_mm` has the camera's size; `color` and `color_seen` have it, too, or are empty.
  void add(DepthView depth_mm, ColorView color, MaskView color_seen);

  /// Whether the sensor still stands where it stood: most readings are of the surfaces of this
  /// view. True before the first frame.
  [[nodiscard]] bool agrees(DepthView depth_mm) const;

  /// For a pose that is known better now; the sensor was not moved. Errors as above.
  [[nodiscard]] Status set_pose(const RigidTransform& world_from_depth);

  [[nodiscard]] const CameraIntrinsics& camera() const { return camera_; }
  [[nodiscard]] const RigidTransform& world_from_depth() const { return world_from_depth_; }
  [[nodiscard]] int frames() const { return frames_; }
  /// Mean of the still surface, 0 for none.
  [[nodiscard]] float depth_mm(int x, int y) const;
  /// False for a surface that was read in fewer than three of more frames: it may be stray light.
  [[nodiscard]] bool is_sure(int x, int y) const;
  /// Readings in that mean, at most ModelOptions::memory_frames.
  [[nodiscard]] int count(int x, int y) const { return pixels_.at(x, y).count; }
  [[nodiscard]] bool has_color(int x, int y) const { return pixels_.at(x, y).color_count > 0; }
  [[nodiscard]] Rgb8 color(int x, int y) const;
  /// The sensor's noise law: standard deviation of a reading.
  [[nodiscard]] float sigma_mm(float depth_mm) const;

 private:
  struct Pixel {
    float mean_mm = 0, other_mm = 0;  // the surface, and another one that may be there instead
    std::uint8_t count = 0, other_count = 0, color_count = 0;
    // Frames since the surface was read: with farther readings, and those without any as well.
    std::uint8_t through_count = 0, missed_count = 0;
    std::uint8_t reliable_count = 0;       // frames before these in which it was read
    std::array<std::uint16_t, 3> color{};  // mean, 1/256 levels
  };
  StillView(const CameraIntrinsics& camera, const RigidTransform& world_from_depth,
            const ModelOptions& options);
  [[nodiscard]] bool is_same(float a_mm, float b_mm) const;
  bool add_reading(float z_mm, Pixel& pixel) const;
  void add_same_reading(float z_mm, Pixel& pixel) const;
  bool add_other_reading(float z_mm, Pixel& pixel) const;
  void join(float z_mm, float& mean_mm, std::uint8_t& count) const;
  [[nodiscard]] float enough(float share, int count) const;
  [[nodiscard]] bool is_outvoted(const Pixel& pixel, int frames) const;
  [[nodiscard]] bool is_missed(const Pixel& pixel) const;
  void forget_around_gone();
  static void take_other(Pixel& pixel);
  void add_color(Rgb8 color, Pixel& pixel) const;

  CameraIntrinsics camera_;
  RigidTransform world_from_depth_;
  ModelOptions options_;
  Image<Pixel> pixels_;
  codec::SensorNoise noise_;
  std::array<float, codec::kSigmaKnotCount> sigma_mm_{};
  int frames_ = 0;
  struct Gone {
    int x = 0, y = 0;
    float before_mm = 0;
  };
  std::vector<Gone> gone_;  // in this frame; empty between calls
};

}  // namespace roomcast::model
