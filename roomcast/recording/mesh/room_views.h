// SPDX-License-Identifier: Apache-2.0
// RoomViews: what stands still in each sensor's view, gathered from the frame sets of a recording.
// A sensor that was moved begins another view; what it saw before stays. A frame that shows
// something else than the sensor's view before, without a new pose, is left out: the sensor was
// pushed, or somebody stands before it. Single-threaded.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"
#include "roomcast/model/still_view.h"
#include "roomcast/model/view_surface.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"

namespace roomcast::recording {

/// In all views; the ones of the fewest frames are given up for others.
inline constexpr std::size_t kMaxPixelsOfViews = 10'000'000;

class RoomViews {
 public:
  RoomViews(const std::vector<SetSensor>& sensors, const model::ModelOptions& options);

  /// Frames of sensors without a pose are left out, unless there is only one sensor. kNotFound if
  /// that one moves; errors of StillView::create, with the sensor's name.
  [[nodiscard]] Status add(const FrameSet& set);

  [[nodiscard]] std::size_t frames() const { return frames_; }
  [[nodiscard]] std::size_t views() const { return views_.size(); }

  /// The views for fusing. They take the place of what was gathered, to save memory.
  [[nodiscard]] std::vector<model::ViewSurface> take_surfaces();

 private:
  struct View {
    std::size_t sensor = 0;
    model::StillView still;
  };
  struct Newest {
    std::optional<std::size_t> view;
    nanoseconds time{-1};
  };
  [[nodiscard]] Status add_frame(const SetFrame& frame, bool alone);
  /// The view that the frame belongs to, perhaps a new one; nothing if the frame is left out.
  [[nodiscard]] Result<std::optional<std::size_t>> view_of(const SetFrame& frame, bool alone);
  void make_space(std::size_t pixels);

  std::vector<SetSensor> sensors_;
  model::ModelOptions options_;
  std::vector<View> views_;
  std::vector<Newest> newest_;  // by sensor
  std::size_t frames_ = 0;
};

}  // namespace roomcast::recording
