// SPDX-License-Identifier: Apache-2.0
// Lifetime of the OpenNI 2 library, which is started while it has users, and its notification of
// disconnected devices. Threading: callers run everything on OpenNI's thread (on_openni2_thread);
// OpenNI notifies of disconnections on a thread of its own.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include <OpenNI.h>

#include "roomcast/core/result.h"

namespace roomcast::source {

/// A user of OpenNI, which counts its users.
class OpenNi2Session {
 public:
  OpenNi2Session() : started_(openni::OpenNI::initialize() == openni::STATUS_OK) {}
  ~OpenNi2Session() {
    if (started_) openni::OpenNI::shutdown();
  }
  OpenNi2Session(const OpenNi2Session&) = delete;
  OpenNi2Session& operator=(const OpenNi2Session&) = delete;

  /// Returns kUnavailable if it did not start.
  [[nodiscard]] Status status() const;

 private:
  const bool started_;
};

/// Detects that the device of this URI was disconnected. Must not outlive its session.
class OpenNi2DisconnectListener final : public openni::OpenNI::DeviceDisconnectedListener {
 public:
  explicit OpenNi2DisconnectListener(std::string uri);
  ~OpenNi2DisconnectListener() override;
  void onDeviceDisconnected(const openni::DeviceInfo* device) override;
  [[nodiscard]] bool happened() const { return happened_; }

 private:
  const std::string uri_;
  std::atomic<bool> happened_{false};
};

/// Runs `work` on the one thread that calls OpenNI, and waits for it. OpenNI stores every thread
/// that ever called it, and later asks the system whether that thread still runs; for a terminated
/// thread this crashes (seen with Debian's 2.2.0.33). So this thread lives as long as the process.
void on_openni2_thread(const std::function<void()>& work);

/// Serial number of an open device; empty if it has none.
[[nodiscard]] std::string openni2_serial(const openni::Device& device);

}  // namespace roomcast::source
