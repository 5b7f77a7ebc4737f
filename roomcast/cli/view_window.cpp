// SPDX-License-Identifier: Apache-2.0
// roomcast view: shows the room in a window.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "roomcast/cli/print.h"
#include "roomcast/cli/stop_on_signal.h"
#include "roomcast/cli/view_options.h"
#include "roomcast/io/image_file.h"
#include "roomcast/sound/wav_sound.h"
#include "roomcast/viewer/desktop_viewer.h"

namespace roomcast::cli {
namespace {

constexpr double kPivotDistance_m = 3;

viewer::DesktopViewerOptions desktop_options(const ViewOptions& options,
                                             const client::RoomSnapshot& room) {
  viewer::DesktopViewerOptions desktop;
  desktop.window.title = room.room.empty() ? "roomcast" : room.room + " - roomcast";
  desktop.window.size = {options.size[0], options.size[1]};
  desktop.window.full_screen = options.full_screen;
  desktop.settings.mode = options.mode;
  desktop.settings.vertical_fov_rad = options.fov_rad();
  if (const auto pose = options.world_from_view(viewer::world_from_start_view(room)))
    desktop.start = viewer::view_from_pose(*pose, kPivotDistance_m);
  desktop.panel = options.panel;
  desktop.pictures = options.pictures;
  desktop.write_png = io::write_color_png;
  desktop.headset = options.vr;
  desktop.model =
      client::ModelSource{options.subscriber.hub_url, options.subscriber.credential.token};
  desktop.voice = true;
  desktop.settings.voice.microphone = options.microphone;
  desktop.settings.voice.microphone_on = options.speaks;
  desktop.settings.voice.loudspeaker = options.loudspeaker;
  desktop.log = [](LogLevel, std::string_view line) { print_err("roomcast view: {}\n", line); };
  return desktop;
}

Status check_size(const ViewOptions& options) {
  render::ViewCamera camera;
  camera.width = options.size[0];
  camera.height = options.size[1];
  return camera.check();
}

/// Devices may come later, files do not.
Status check_sound_files(const ViewOptions& options) {
  std::error_code ignored;
  if (options.microphone.ends_with(".wav")) {
    if (auto sound = sound::read_wav(options.microphone); !sound) return sound.error();
  }
  if (options.loudspeaker.ends_with(".wav") &&
      std::filesystem::exists(options.loudspeaker, ignored))
    return unavailable("there is " + options.loudspeaker + " already; choose another file");
  return {};
}

/// Checks that the room's owner permits screenshots, if one was requested.
Status may_keep_last_picture(const ViewOptions& options, const client::Subscriber& hub) {
  return options.last_picture.empty() ? Status() : client::check_may_record(hub.snapshot()->rights);
}

}  // namespace

Status view_in_window(const ViewOptions& options) {
  if (auto status = check_size(options); !status) return status;
  if (auto status = check_sound_files(options); !status) return status;
  constexpr int kUnlessTheUserSaysSo = 0;
  ::setenv("XR_LOADER_DEBUG", "none", kUnlessTheUserSaysSo);  // our own message is enough
  StopOnSignal stop;
  client::SubscriberOptions subscriber = options.subscriber;
  subscriber.stop = stop.token();
  subscriber.hears = true;
  auto hub = client::Subscriber::open(std::move(subscriber));
  if (!hub) return hub.error();
  if (auto may = may_keep_last_picture(options, **hub); !may) return may;
  auto viewer = viewer::DesktopViewer::open(**hub, desktop_options(options, *(*hub)->snapshot()));
  if (!viewer) return viewer.error();
  const auto begin = std::chrono::steady_clock::now();
  const auto is_over = [&] {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    return stop.token().stop_requested() ||
           (options.seconds > 0 && elapsed.count() >= options.seconds);
  };
  while (!is_over() && (*viewer)->step()) {
  }
  if (options.last_picture.empty()) return {};
  // The viewer may have moved to another hub.
  if (auto may = may_keep_last_picture(options, **hub); !may) return may;
  return io::write_color_png(options.last_picture, (*viewer)->window_picture());
}

}  // namespace roomcast::cli
