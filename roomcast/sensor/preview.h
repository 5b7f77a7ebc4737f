// SPDX-License-Identifier: Apache-2.0
// Preview: the view of a sensor without a screen, as a JPEG file that is replaced about once a
// second: colour in the depth grid on the left, distance as colour on the right (near red, far
// blue, black where there is no reading). Any picture viewer or web server can show it.
// Single-threaded.
#pragma once

#include <filesystem>

#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"
#include "roomcast/core/result.h"

namespace roomcast::sensor {

class Preview {
 public:
  static constexpr std::chrono::seconds kPeriod{1};

  explicit Preview(std::filesystem::path file) : file_(std::move(file)) {}

  /// Writes the file if a period has passed since the last time. `color` may be empty.
  /// kUnavailable: the file cannot be written.
  [[nodiscard]] Status show(DepthView depth_mm, ColorView color, HostTime now);

 private:
  std::filesystem::path file_;
  HostTime written_{};
  ColorImage picture_;  // reused
};

/// The colour of a distance: from red at 0.5 m over yellow, green and cyan to blue at 5 m.
[[nodiscard]] Rgb8 color_of_depth(std::uint16_t depth_mm);

}  // namespace roomcast::sensor
