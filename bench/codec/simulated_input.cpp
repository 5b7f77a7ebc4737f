// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/simulated_input.h"

#include <charconv>
#include <cmath>
#include <optional>

#include "roomcast/geometry/registration.h"
#include "roomcast/simulator/simulated_sensor.h"
#include "roomcast/simulator/simulated_spec.h"

namespace roomcast::bench {
namespace {

/// Parses sim[:scene[,option...]][#n] into the part between "sim:" and '#', and n.
struct Place {
  std::string spec;
  int index = 0;
};

std::optional<Place> parse(const std::string& source) {
  Place place;
  const std::size_t hash = std::min(source.find('#'), source.size());
  if (hash < source.size()) {
    const char *first = source.data() + hash + 1, *last = source.data() + source.size();
    const auto [end, error] = std::from_chars(first, last, place.index);
    if (error != std::errc() || end != last) return std::nullopt;
  }
  const std::string kind = source.substr(0, hash);
  if (kind.size() > 3) place.spec = kind.substr(4);
  return place;
}

Result<std::unique_ptr<simulator::SimulatedSensor>> open_sensor(const Place& place,
                                                                const BenchInputOptions& options) {
  const auto spec = simulator::parse_simulated_spec(place.spec);
  if (!spec) return spec.error();
  auto room = simulator::SimulatedRoom::build(spec->scene, options.sim_seed);
  if (!room) return std::move(room).error();
  simulator::SimulatedSensor::Options sensor;
  sensor.index = place.index;
  sensor.count = options.sim_sensor_count;
  sensor.seed = options.sim_seed;
  sensor.speed = options.sim_speed;
  sensor.sensing = spec->sensing;
  return simulator::SimulatedSensor::open(*std::move(room), sensor);
}

class SimulatedInput final : public BenchInput {
 public:
  SimulatedInput(std::string name, std::unique_ptr<simulator::SimulatedSensor> sensor,
                 Registration registration, double fps)
      : name_(std::move(name)),
        sensor_(std::move(sensor)),
        moment_(sensor_->make_moment()),
        exposure_(sensor_->auto_exposure()),
        registration_(std::move(registration)),
        fps_(fps) {}

  std::string name() const override { return name_; }
  double fps() const override { return fps_; }
  ColorReference color_reference() const override { return ColorReference::kClean; }

  Result<bool> next(BenchFrame& frame, BenchTruth& truth) override {
    const auto index = frame_count_++;
    const nanoseconds time(std::llround(static_cast<double>(index) / fps_ * 1e9));
    const float exposure = sensor_->next_exposure(time, moment_, exposure_);
    sensor_->look(time, moment_);
    sensor_->read_depth(index, moment_, frame.depth_mm);
    sensor_->read_color(index, exposure, moment_, color_);
    if (Status s = registration_.run(frame.depth_mm, color_, registered_); !s.ok())
      return s.error();
    frame.color = registered_.color;
    frame.seen = registered_.seen;
    truth.depth_mm = sensor_->clean_depth_mm(moment_);
    sensor_->expected_depth(moment_, truth.noise_free_mm);
    sensor_->clean_color(exposure, moment_, color_);
    if (Status s = registration_.run(frame.depth_mm, color_, registered_); !s.ok())
      return s.error();
    truth.color = registered_.color;
    return true;
  }

 private:
  const std::string name_;
  std::unique_ptr<simulator::SimulatedSensor> sensor_;
  simulator::SimulatedSensor::Moment moment_;
  simulator::AutoExposure exposure_;
  Registration registration_;
  const double fps_;
  std::uint64_t frame_count_ = 0;
  ColorImage color_;
  RegisteredColor registered_;
};

}  // namespace

Result<std::unique_ptr<BenchInput>> open_simulated_input(const std::string& source,
                                                         const BenchInputOptions& options) {
  const auto place = parse(source);
  if (!place) {
    return Error{ErrorCode::kInvalidArgument,
                 "\"" + source +
                     "\" names no simulated sensor: sim[:scene][#n], for example "
                     "sim:livingroom#0."};
  }
  auto sensor = open_sensor(*place, options);
  if (!sensor.ok()) return sensor.error();
  auto registration = Registration::create((*sensor)->calibration());
  if (!registration.ok()) return registration.error();
  return std::unique_ptr<BenchInput>(std::make_unique<SimulatedInput>(
      source, std::move(*sensor), std::move(*registration), options.sim_fps));
}

}  // namespace roomcast::bench
