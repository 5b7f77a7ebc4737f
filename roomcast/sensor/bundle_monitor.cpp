// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/bundle_monitor.h"

#include <algorithm>
#include <utility>

#include "roomcast/alignment/service/bundle_message.h"

namespace roomcast::sensor {
namespace {

/// Share of the readings that may be unsteady in a bundle after a move. Above it the sensor is
/// still moving.
constexpr double kMaxUnsteady = 0.3;

bool is_stationary(const alignment::CalibrationBundle& bundle) {
  const auto depth = bundle.depth_mm.view();
  const auto moving = std::as_const(bundle.moving).view();
  const std::size_t pixels = depth.pixel_count();
  const auto steady =
      pixels - static_cast<std::size_t>(std::count(depth.data, depth.data + pixels, 0));
  const auto unsteady =
      static_cast<std::size_t>(std::count(moving.data, moving.data + pixels, 255));
  return static_cast<double>(unsteady) <= kMaxUnsteady * static_cast<double>(steady + unsteady);
}

}  // namespace

BundleMonitor::BundleMonitor(std::string name, const SensorCalibration& calibration,
                             double depth_scale)
    : name_(std::move(name)),
      calibration_(calibration),
      depth_scale_(depth_scale),
      capture_(name_, calibration_) {}

Result<BundleUpdate> BundleMonitor::add(const source::CapturedFrame& frame) {
  if (!watch_) return capture(frame);
  if (!same_size(frame.depth_mm.view(), calibration_.depth) ||
      !watch_->moved(frame.depth_mm, frame.capture_time)) {
    return BundleUpdate{};
  }
  watch_.reset();
  bundle_.reset();
  was_moved_ = true;
  return BundleUpdate{.moved = true, .bundle = {}};
}

Result<BundleUpdate> BundleMonitor::capture(const source::CapturedFrame& frame) {
  if (frame.color.empty()) return BundleUpdate{};
  const auto enough = capture_.add(frame.depth_mm, frame.color);
  if (enough && !*enough) return BundleUpdate{};
  auto news = enough ? finish() : Result<BundleUpdate>(enough.error());
  capture_ = alignment::BundleCapture(name_, calibration_);
  return news;
}

Result<BundleUpdate> BundleMonitor::finish() {
  auto bundle = capture_.finish();
  if (!bundle) return bundle.error();
  if (was_moved_ && !is_stationary(*bundle)) return BundleUpdate{};
  bundle->depth_scale = depth_scale_;
  auto message = message_from_bundle(*bundle);
  if (!message) return message.error();
  watch_.emplace(*bundle);
  bundle_ = *std::move(bundle);
  return BundleUpdate{.moved = false, .bundle = *std::move(message)};
}

}  // namespace roomcast::sensor
