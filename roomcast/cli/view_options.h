// SPDX-License-Identifier: Apache-2.0
// Options of `roomcast view`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomcast/cli/token_option.h"
#include "roomcast/client/subscriber.h"
#include "roomcast/render/render_mode.h"
#include "roomcast/render/view/view_camera.h"

namespace roomcast::cli {

struct ViewOptions {
  client::SubscriberOptions subscriber;
  TokenOption token;
  bool headless = false;
  std::string png;
  std::vector<double> at, look;
  std::vector<int> size = {1280, 720};
  double fov_deg = 60;
  double seconds = 0;
  render::RenderMode mode = render::RenderMode::kBlend;
  bool json = false;
  // Window options.
  bool full_screen = false;
  bool panel = true;
  bool vr = false;
  std::string microphone = "default", loudspeaker = "default";
  bool speaks = false;  // from the start
  std::string pictures = ".";
  std::string last_picture;

  [[nodiscard]] double fov_rad() const;
  /// The requested viewpoint, if any. Takes the direction of `start` where no target was requested.
  [[nodiscard]] std::optional<RigidTransform> world_from_view(const RigidTransform& start) const;
};

/// Draws a picture without a window.
[[nodiscard]] Status view_without_window(const ViewOptions& options);
/// Shows the room in a window until the user closes it or the requested time is over.
[[nodiscard]] Status view_in_window(const ViewOptions& options);

}  // namespace roomcast::cli
