// SPDX-License-Identifier: Apache-2.0
// KeptViews: what stands still in the views of a running room's sensors, one view for each sensor
// at the place where it stands. When a sensor leaves, its view stays; when it is moved, its view is
// given up. Says when the views differ so much from those that were fused last that it is worth
// fusing them anew. Depth in millimetres, poses in metres. Single-threaded.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/model/still_view.h"
#include "roomcast/model/view_surface.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"

namespace roomcast::recording {

class KeptViews {
 public:
  explicit KeptViews(const model::ModelOptions& options) : options_(options) {}

  /// Takes the pictures that are new since the last call. Sensors without a pose are left out.
  /// Errors of StillView::create, with the sensor's name; the other sensors' pictures are taken.
  Status add(const std::vector<SetSensor>& sensors, const FrameSet& set);
  /// The sensor was moved, or is of this room no longer.
  void forget(const std::string& sensor);
  [[nodiscard]] std::vector<std::string> sensors() const;
  /// This sensor's view was seen, but in too few pictures to be fused.
  [[nodiscard]] bool needs_more_of(const std::string& sensor) const;

  /// Something noticeable is different since surfaces(). Just after a change less is noticeable:
  /// what is left of a thing that has gone.
  [[nodiscard]] bool are_worth_fusing(bool after_change = false) const;
  /// The views for fusing: those that were seen in enough frames.
  [[nodiscard]] std::vector<model::ViewSurface> surfaces();

  /// The views as one frame of each sensor, to be written to disk; add_saved() takes it back.
  struct Saved {
    std::vector<SetSensor> sensors;
    FrameSet set;
  };
  [[nodiscard]] Saved saved() const;
  /// As if the pictures had been seen in several frames. Errors as add().
  Status add_saved(const Saved& saved);

 private:
  struct View {
    model::StillView still;
    nanoseconds newest{-1};  // time of the newest picture
    int strange = 0;         // pictures in a row that showed something else
    DepthImage fused_mm{};   // as it was fused last; empty: it was not
    ColorImage fused_color{};
  };
  [[nodiscard]] Status add_picture(const SetSensor& sensor, const SetFrame& frame);
  [[nodiscard]] static bool is_known(const View& view);
  [[nodiscard]] static bool has_changed(const View& view, double noticed_share);

  model::ModelOptions options_;
  std::map<std::string, View> views_;  // by the sensor's name
  bool is_one_gone_ = false;           // since surfaces()
};

}  // namespace roomcast::recording
