// SPDX-License-Identifier: Apache-2.0
// For tests: what joins a room through the C functions, and ends by itself.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "roomcast/capi/roomcast.h"

namespace roomcast::capi {

struct End {
  void operator()(roomcast_publisher* publisher) const { roomcast_stop_publishing(publisher); }
  void operator()(roomcast_viewer* viewer) const { roomcast_disconnect(viewer); }
  void operator()(roomcast_frames* frames) const { roomcast_free_frames(frames); }
  void operator()(roomcast_people* people) const { roomcast_free_people(people); }
};
using Publisher = std::unique_ptr<roomcast_publisher, End>;
using Viewer = std::unique_ptr<roomcast_viewer, End>;
using Frames = std::unique_ptr<roomcast_frames, End>;
using People = std::unique_ptr<roomcast_people, End>;

inline roomcast_options joining(const std::string& hub, const char* name) {
  return {sizeof(roomcast_options), hub.c_str(), nullptr, name, nullptr, nullptr, 0, 0};
}

inline Viewer join(const roomcast_options& options) {
  char error[300] = "";
  Viewer viewer(roomcast_connect(&options, error, sizeof(error)));
  EXPECT_NE(viewer, nullptr) << error;
  return viewer;
}

template <class Done>
bool until(Done done) {
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (!done()) {
    if (std::chrono::steady_clock::now() > give_up) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

}  // namespace roomcast::capi
