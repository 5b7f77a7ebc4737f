// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/camera/camera_source.h"

#include <algorithm>
#include <random>
#include <utility>

#include "roomcast/core/interruptible_wait.h"
#include "roomcast/source/camera/open_camera.h"

namespace roomcast::source {
namespace {

constexpr std::chrono::milliseconds kPatience{100};  // within this time a stop takes effect
constexpr std::size_t kLongestName = 40;

/// "freenect-A00367813501053A": independent of the port of the camera.
std::string sensor_name(const std::string& kind, const CameraDescription& camera) {
  std::string name = kind;
  if (!camera.serial.empty()) name += "-" + camera.serial;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c <= ' ' || c > '~' || c == '/'; }, '_');
  return name.substr(0, kLongestName);
}

/// The place for reopening: a serial number finds the camera in any port; without one, the user's
/// place.
std::string place_again(const std::string& place, const CameraDescription& camera) {
  return camera.serial.empty() ? place : camera.serial;
}

}  // namespace

Result<std::unique_ptr<FrameSource>> CameraSource::open(std::shared_ptr<CameraBackend> backend,
                                                        const std::string& place,
                                                        CameraSourceOptions options) {
  auto camera = open_camera(*backend, place, options.settings);
  if (!camera) return camera.error();
  return std::unique_ptr<FrameSource>(
      new CameraSource(std::move(backend), place, *std::move(camera), std::move(options)));
}

CameraSource::CameraSource(std::shared_ptr<CameraBackend> backend, const std::string& place,
                           std::unique_ptr<Camera> camera, CameraSourceOptions options)
    : backend_(std::move(backend)),
      options_(std::move(options)),
      camera_(std::move(camera)),
      place_(place_again(place, camera_->description())),
      pairing_(camera_->description().fps, camera_->description().has_color,
               [this](CapturedFrame& frame) { hand_over(frame); }),
      pace_(std::random_device{}()) {
  const CameraDescription& opened = camera_->description();
  description_ = {options_.name.empty() ? sensor_name(backend_->kind(), opened) : options_.name,
                  opened.calibration, std::nullopt, opened.fps};
  thread_ = std::jthread([this](const std::stop_token& stop) { capture(stop); });
}

CameraSource::~CameraSource() {
  thread_.request_stop();
  thread_.join();
}

void CameraSource::capture(const std::stop_token& stop) {
  last_picture_at_ = SteadyClock().now();
  while (!stop.stop_requested() && !has_ended_) {
    const Status status = take_pictures();
    if (status) {
      lock_when_converged();
    } else if (status.error().code == ErrorCode::kClosed) {
      hand_over_end({});
    } else if (status.error().code == ErrorCode::kMalformed) {
      hand_over_end(status);
    } else {
      wait_for_reconnection(status, stop);
    }
  }
}

Status CameraSource::take_pictures() {
  Status status = camera_->wait(pairing_, kPatience);
  unpaired_ = pairing_.unpaired_count();
  if (!status) return status;
  if (SteadyClock().now() - last_picture_at_ > options_.silence)
    return Error{ErrorCode::kUnavailable, "it has stopped sending pictures"};
  return {};
}

void CameraSource::hand_over(CapturedFrame& frame) {
  last_picture_at_ = SteadyClock().now();
  ++frames_since_open_;
  Taken taken;
  if (auto memory = spare_.try_take()) taken.frame = *std::move(memory);
  std::swap(taken.frame, frame);
  taken.frame.capture_time = clock_.capture_time(taken.frame.device_time, last_picture_at_);
  if (auto unread = newest_.put(std::move(taken))) {
    if (is_idle_) ++unread_while_idle_;
    spare_.put(std::move(unread->frame));
  }
}

void CameraSource::hand_over_end(Status end) {
  has_ended_ = true;
  Taken last;
  if (auto unread = newest_.try_take()) last = *std::move(unread);
  last.is_last = true;
  last.end = std::move(end);
  newest_.put(std::move(last));
}

void CameraSource::lock_when_converged() {
  if (is_locked_ || frames_since_open_ < options_.frames_until_lock) return;
  is_locked_ = true;
  const CameraSettings& wanted = options_.settings;
  if (!wanted.lock_exposure && !wanted.lock_white_balance) return;
  const Status status = camera_->lock_color(wanted.lock_exposure, wanted.lock_white_balance);
  if (!status) say(LogLevel::kWarning, status.error().message);
}

void CameraSource::wait_for_reconnection(const Status& loss, const std::stop_token& stop) {
  is_there_ = false;
  ++losses_;
  camera_.reset();
  pairing_.forget();
  say(LogLevel::kWarning, "the camera is lost: " + loss.error().message + "; waiting for it");
  pace_.succeeded();
  do wait_for(pace_.next(), stop);
  while (!stop.stop_requested() && !reopen());
}

bool CameraSource::reopen() {
  auto camera = open_camera(*backend_, place_, options_.settings);
  if (!camera) return false;
  camera_ = *std::move(camera);
  last_picture_at_ = SteadyClock().now();
  frames_since_open_ = 0;
  is_locked_ = false;
  clock_ = {};
  is_there_ = true;
  say(LogLevel::kWarning, "the camera is back");
  return true;
}

void CameraSource::say(LogLevel level, const std::string& sentence) const {
  if (options_.log) options_.log(level, description_.name + ": " + sentence);
}

Result<bool> CameraSource::next(CapturedFrame& frame, std::stop_token stop) {
  if (reached_end_) return after_end();
  auto taken = newest_.take(std::move(stop));
  if (!taken) return false;
  reached_end_ = taken->is_last;
  if (reached_end_) end_ = std::move(taken->end);
  if (taken->frame.depth_mm.empty()) return after_end();
  std::swap(frame, taken->frame);
  spare_.put(std::move(taken->frame));
  return true;
}

Result<bool> CameraSource::after_end() const {
  if (end_) return false;
  return end_.error();
}

SourceHealth CameraSource::health() const {
  const std::uint64_t expected = unread_while_idle_;  // before the count that contains it
  return {newest_.dropped_count() - expected + unpaired_, losses_, is_there_};
}

}  // namespace roomcast::source
