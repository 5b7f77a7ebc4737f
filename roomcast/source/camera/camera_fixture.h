// SPDX-License-Identifier: Apache-2.0
// For tests: a kind of camera whose pictures, losses and errors are set by the test. Thread-safe.
#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "roomcast/source/camera/camera.h"

namespace roomcast::source {

class ScriptedBackend : public CameraBackend {
 public:
  static constexpr int kWidth = 8, kHeight = 6;

  [[nodiscard]] std::string kind() const override { return "scripted"; }
  [[nodiscard]] std::string library() const override { return "none"; }
  [[nodiscard]] CameraAbilities abilities() const override { return {.lock_exposure = true}; }
  [[nodiscard]] Result<std::vector<CameraInfo>> list() override {
    std::lock_guard lock(mutex_);
    if (unplugged_) return std::vector<CameraInfo>{};
    return std::vector<CameraInfo>{{"port-a", "Scripted", "41"}, {"port-b", "Scripted", "42"}};
  }
  [[nodiscard]] Result<std::unique_ptr<Camera>> open(const CameraInfo& camera,
                                                     const CameraSettings& settings) override;

  /// Makes the open camera deliver a wall at `depth_mm`, with colour if `in_color`.
  void show(std::uint16_t depth_mm, bool in_color = true) { say({depth_mm, in_color, {}}); }
  /// Sets the next result of the open camera: kUnavailable, it was disconnected; kClosed, a file
  /// ended.
  void fail(ErrorCode code) { say({0, false, code}); }
  void unplug(bool unplugged) {
    std::lock_guard lock(mutex_);
    unplugged_ = unplugged;
  }

  std::vector<std::string> opened_places() {
    std::lock_guard lock(mutex_);
    return places_;
  }
  int times_locked() {
    std::lock_guard lock(mutex_);
    return times_locked_;
  }

 private:
  struct Event {
    std::uint16_t depth_mm = 0;
    bool in_color = true;
    std::optional<ErrorCode> failure;
  };
  class Scripted;

  void say(Event event) {
    {
      std::lock_guard lock(mutex_);
      events_.push_back(event);
    }
    ready_.notify_one();
  }
  std::optional<Event> hear(std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    if (!ready_.wait_for(lock, patience, [this] { return !events_.empty(); })) return std::nullopt;
    const Event event = events_.front();
    events_.pop_front();
    return event;
  }

  std::mutex mutex_;
  std::condition_variable ready_;
  std::deque<Event> events_;
  std::vector<std::string> places_;
  bool unplugged_ = false;
  int times_locked_ = 0;
};

class ScriptedBackend::Scripted final : public Camera {
 public:
  Scripted(ScriptedBackend& backend, const std::string& serial) : backend_(backend) {
    description_.serial = serial;
    description_.calibration.depth = {kWidth, kHeight, 10, 10, 3.5, 2.5};
    description_.calibration.color = description_.calibration.depth;
  }
  [[nodiscard]] const CameraDescription& description() const override { return description_; }
  [[nodiscard]] Status wait(FramePairing& pictures, std::chrono::milliseconds patience) override {
    const auto event = backend_.hear(patience);
    if (!event) return {};
    if (event->failure) return Error{*event->failure, "it was unplugged"};
    time_ += std::chrono::milliseconds(33);
    DepthImage depth(kWidth, kHeight, event->depth_mm);
    pictures.depth(time_, depth);
    ColorImage color(kWidth, kHeight);
    if (event->in_color) pictures.color(time_, color);
    return {};
  }
  [[nodiscard]] Status lock_color(bool, bool) override {
    std::lock_guard lock(backend_.mutex_);
    ++backend_.times_locked_;
    return {};
  }

 private:
  ScriptedBackend& backend_;
  CameraDescription description_;
  nanoseconds time_{};
};

inline Result<std::unique_ptr<Camera>> ScriptedBackend::open(const CameraInfo& camera,
                                                             const CameraSettings&) {
  std::lock_guard lock(mutex_);
  places_.push_back(camera.place);
  return std::unique_ptr<Camera>(std::make_unique<Scripted>(*this, camera.serial));
}

}  // namespace roomcast::source
