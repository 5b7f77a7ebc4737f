// SPDX-License-Identifier: Apache-2.0
// OpenNI 2 as a library: started while somebody uses it, and what it says of devices that come and
// go. Threading: everything on OpenNI's thread (on_openni2_thread), which it asks for itself;
// OpenNI tells of departures on a thread of its own.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include <OpenNI.h>

#include "roomcast/core/result.h"

namespace roomcast::source {

/// OpenNI counts who uses it.
class OpenNi2Session {
 public:
  OpenNi2Session() : started_(openni::OpenNI::initialize() == openni::STATUS_OK) {}
  ~OpenNi2Session() {
    if (started_) openni::OpenNI::shutdown();
  }
  OpenNi2Session(const OpenNi2Session&) = delete;
  OpenNi2Session& operator=(const OpenNi2Session&) = delete;

  /// kUnavailable when it did not start.
  [[nodiscard]] Status status() const;

 private:
  const bool started_;
};

/// Notices that the device of this URI is gone. Lives within a session.
class OpenNi2Departure final : public openni::OpenNI::DeviceDisconnectedListener {
 public:
  explicit OpenNi2Departure(std::string uri);
  ~OpenNi2Departure() override;
  void onDeviceDisconnected(const openni::DeviceInfo* device) override;
  [[nodiscard]] bool happened() const { return happened_; }

 private:
  const std::string uri_;
  std::atomic<bool> happened_{false};
};

/// Does `work` on the one thread that calls OpenNI, and waits for it. OpenNI remembers every thread
/// that ever called it, and later asks the system whether it still runs; for one that has ended
/// this crashes (seen with Debian's 2.2.0.33). So that thread lives as long as the process does.
void on_openni2_thread(const std::function<void()>& work);

/// Of an open device; empty where it does not tell.
[[nodiscard]] std::string openni2_serial(const openni::Device& device);

}  // namespace roomcast::source
