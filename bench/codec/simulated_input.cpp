// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/simulated_input.h"

#include <charconv>
#include <cmath>
#include <optional>

#include "roomcast/geometry/registration.h"
#include "roomcast/source/simulator/simulated_sensor.h"

namespace roomcast::bench {
namespace {

/// sim[:scene][#n]
std::optional<SimulatedSensor::Options> parse(const std::string& source,
                                              const BenchInputOptions& options) {
  SimulatedSensor::Options sensor;
  sensor.sensor_count = options.sim_sensor_count;
  sensor.seed = options.sim_seed;
  sensor.speed = options.sim_speed;
  const std::size_t hash = std::min(source.find('#'), source.size());
  if (hash < source.size()) {
    const char *first = source.data() + hash + 1, *last = source.data() + source.size();
    const auto [end, error] = std::from_chars(first, last, sensor.sensor_index);
    if (error != std::errc() || end != last) return std::nullopt;
  }
  const std::string kind = source.substr(0, hash);
  if (kind.size() > 3) sensor.scene = kind.substr(4);
  return sensor;
}

class SimulatedInput final : public BenchInput {
 public:
  SimulatedInput(std::string name, std::unique_ptr<SimulatedSensor> sensor,
                 Registration registration, double fps)
      : name_(std::move(name)),
        sensor_(std::move(sensor)),
        registration_(std::move(registration)),
        fps_(fps) {}

  std::string name() const override { return name_; }
  double fps() const override { return fps_; }
  ColorReference color_reference() const override { return ColorReference::kClean; }

  Result<bool> next(BenchFrame& frame, BenchTruth& truth) override {
    const auto index = frame_count_++;
    const nanoseconds time(std::llround(static_cast<double>(index) / fps_ * 1e9));
    sensor_->render(time, index, frame.depth_mm, color_, true);
    if (Status s = registration_.run(frame.depth_mm, color_, registered_); !s.ok())
      return s.error();
    frame.color = registered_.color;
    frame.seen = registered_.seen;
    sensor_->render(time, index, truth.depth_mm, color_, false);
    if (Status s = registration_.run(frame.depth_mm, color_, registered_); !s.ok())
      return s.error();
    truth.color = registered_.color;
    return true;
  }

 private:
  const std::string name_;
  std::unique_ptr<SimulatedSensor> sensor_;
  Registration registration_;
  const double fps_;
  std::uint64_t frame_count_ = 0;
  ColorImage color_;
  RegisteredColor registered_;
};

}  // namespace

Result<std::unique_ptr<BenchInput>> open_simulated_input(const std::string& source,
                                                         const BenchInputOptions& options) {
  const auto wanted = parse(source, options);
  if (!wanted) {
    return Error{ErrorCode::kInvalidArgument,
                 "\"" + source +
                     "\" names no simulated sensor: sim[:scene][#n], for example "
                     "sim:livingroom#0."};
  }
  auto sensor = SimulatedSensor::open(*wanted);
  if (!sensor.ok()) return sensor.error();
  auto registration = Registration::create((*sensor)->calibration());
  if (!registration.ok()) return registration.error();
  return std::unique_ptr<BenchInput>(std::make_unique<SimulatedInput>(
      source, std::move(*sensor), std::move(*registration), options.sim_fps));
}

}  // namespace roomcast::bench
