// SPDX-License-Identifier: Apache-2.0
// Fixture: the whole desktop viewer in a window without a display (SDL_VIDEODRIVER=offscreen), with
// a fake hub and, if wanted, the test runtime's headset.
#pragma once

#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <SDL2/SDL.h>
#include <gtest/gtest.h>

#include "roomcast/client/hub_fixture.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/core/temporary_folder.h"
#include "roomcast/viewer/desktop_viewer.h"
#include "roomcast/viewer/xr/test_runtime/test_runtime.h"

namespace roomcast::viewer {

class DesktopViewerTest : public testing::Test {
 protected:
  static constexpr PictureSize kSize = {320, 240};

  void SetUp() override {
    ::setenv("SDL_VIDEODRIVER", "offscreen", 1);
    network.start();
    auto joined =
        client::Subscriber::open({.hub_url = hub->url(), .room = {}, .name = "Ada", .log = {}});
    ASSERT_TRUE(joined.ok()) << joined.error().message;
    subscriber = std::move(*joined);
    options.window.size = kSize;
    options.settings.mode = render::RenderMode::kMesh;
    options.panel = false;
    options.pictures = folder.path();
    options.write_png = [this](const auto& path, ColorView picture) {
      written.push_back(path.filename().string());
      written_size = {picture.width, picture.height};
      return Status{};
    };
    open();
  }
  void open() {
    viewer.reset();
    auto opened = DesktopViewer::open(*subscriber, options);
    ASSERT_TRUE(opened.ok()) << opened.error().message;
    viewer = std::move(*opened);
  }
  void open_with_headset() {
    runtime.reset();
    ::setenv("XR_RUNTIME_JSON", ROOMCAST_TEST_OPENXR, 1);
    options.headset = true;
    open();
  }
  void TearDown() override {
    viewer.reset();
    subscriber.reset();
    network.finish([this] { hub.reset(); });
  }

  template <class Action>
  void on_hub(Action action) {
    network.run([&] { action(*hub); });
  }

  /// The hub disconnects and sends the new permission to reconnecting viewers.
  void reconnect_with_recording(bool lets) {
    on_hub([lets](client::FakeHub& h) {
      h.lets_record = lets;
      h.hang_up();
    });
    EXPECT_TRUE(steps_until([&] {
      const auto room = subscriber->snapshot();
      return room->connected && room->rights.may_record == lets;
    }));
  }

  /// Calls step() until `wanted` is true.
  template <class Wanted>
  bool steps_until(Wanted wanted) {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(5);
    while (!wanted() && std::chrono::steady_clock::now() < give_up) {
      if (!viewer->step()) return wanted();
    }
    return wanted();
  }

  static void press(SDL_Keycode key, bool down = true) {
    SDL_Event event{};
    event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
    event.key.keysym.sym = key;
    event.key.keysym.scancode = SDL_GetScancodeFromKey(key);
    SDL_PushEvent(&event);
  }

  bool says(const std::string& words) {
    for (const Toast& toast : viewer->toasts()) {
      if (toast.sentence.find(words) != std::string::npos) return true;
    }
    return false;
  }

  client::NetworkThread network;
  std::optional<client::FakeHub> hub{std::in_place, network.io()};
  std::unique_ptr<client::Subscriber> subscriber;
  TemporaryFolder folder;
  DesktopViewerOptions options;
  std::vector<std::string> written;
  PictureSize written_size;
  std::unique_ptr<DesktopViewer> viewer;
  xr::TestRuntime& runtime = xr::TestRuntime::instance();
};

}  // namespace roomcast::viewer
