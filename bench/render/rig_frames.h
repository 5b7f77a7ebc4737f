// SPDX-License-Identifier: Apache-2.0
// The frames of a rig as a viewer receives them from sensors that send live depth, but not coded:
// depth, with the holes of large planes filled, and colour registered to it. A sensor's frames must
// be read in their order.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "bench/render/truth_view.h"
#include "bench/render/view_classes.h"
#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/hole_registration.h"
#include "roomcast/io/depth_values.h"
#include "roomcast/io/image_file.h"
#include "roomcast/recording/dataset/recording.h"
#include "roomcast/sensor/hole_completion.h"

namespace roomcast::bench {

struct RegisteredFrame {
  DepthImage depth_mm;
  RegisteredColor color;
};

class RigFrames {
 public:
  /// kNotFound, kMalformed as read_rig_recording; kInvalidArgument: a sensor has no pose.
  /// `color_scale` as in RegistrationOptions. Without `fill_holes` depth is as recorded.
  static Result<RigFrames> open(const std::filesystem::path& folder,
                                const recording::RigDescription& rig, int color_scale,
                                bool fill_holes = true);

  struct Sensor {
    recording::Recording recording;
    RigidTransform world_from_depth;
    io::DepthValues depth_values;  // with factors on readings, of the rig and of alignment
    // Remember what they have seen; see restart.
    std::optional<HoleRegistration> registration;
    std::optional<sensor::HoleCompletion> completion;  // none: depth as recorded
    std::filesystem::path truth;                       // folder with its noise-free depth
  };
  [[nodiscard]] std::vector<Sensor>& sensors() { return sensors_; }

  /// Forgets all frames that were read. Errors as HoleRegistration::create.
  [[nodiscard]] Status restart();

  /// Multiplies the sensor's depth by a factor that alignment has found.
  static void scale_depth(Sensor& sensor, double factor);

  /// Reads the frame with this number. kNotFound: the frame was lost.
  [[nodiscard]] Status read(Sensor& sensor, std::uint64_t number, RegisteredFrame& out);
  /// The frames that have noise-free depth, also lost ones, in their order.
  [[nodiscard]] static std::vector<std::uint64_t> truth_numbers(const Sensor& sensor);
  [[nodiscard]] Result<TrueSensor> truth(const Sensor& sensor, std::uint64_t number);

 private:
  RigFrames(int color_scale, bool fill_holes)
      : color_scale_(color_scale), fill_holes_(fill_holes) {}

  int color_scale_;
  bool fill_holes_;
  io::ImageFileReader reader_;
  ColorImage color_;
  std::vector<Sensor> sensors_;
};

}  // namespace roomcast::bench
