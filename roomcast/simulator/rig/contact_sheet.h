// SPDX-License-Identifier: Apache-2.0
// Overview pictures of the simulated rooms: per room one picture with a free view of the whole room
// next to the views of the first four sensors, at an instant when people are visible. Colour
// without noise.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"

namespace roomcast::simulator {

struct ContactSheetOptions {
  std::uint64_t seed = 1;
  int cell_width = 288;  // of one sensor's view, 64..1920 pixels; the free view is twice as wide
  int threads = 0;       // 0: all cores
};

inline constexpr int kContactSheetQuality = 74;  // of the JPEG files

/// The free view on the left, the four sensors on the right: 4 cells wide, 2 high, 16:9 each.
/// kNotFound for an unknown scene; kInvalidArgument for options out of range; kUnavailable if the
/// ray tracer does not start.
[[nodiscard]] Result<ColorImage> contact_sheet(std::string_view scene,
                                               const ContactSheetOptions& options);

/// Writes FOLDER/<scene>.jpg for every scene. `done` (may be empty) is called after each. Errors as
/// above; kUnavailable if the folder cannot be written.
[[nodiscard]] Status write_contact_sheets(const std::filesystem::path& folder,
                                          const ContactSheetOptions& options,
                                          const std::function<void(int done, int total)>& done);

}  // namespace roomcast::simulator
