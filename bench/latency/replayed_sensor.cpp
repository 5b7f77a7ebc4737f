// SPDX-License-Identifier: Apache-2.0
#include "bench/latency/replayed_sensor.h"

#include <utility>

#include "bench/latency/capture_clock.h"
#include "roomcast/sensor/source_factory.h"

namespace roomcast::bench {

namespace {

client::PublisherOptions publisher_options(const source::SensorDescription& sensor,
                                           const std::string& hub_url, double fps) {
  client::PublisherOptions options;
  options.hub_url = hub_url;
  options.name = sensor.name;
  options.calibration = sensor.calibration;
  options.world_from_depth = sensor.world_from_depth;
  options.fps = fps;
  return options;
}

}  // namespace

Result<std::unique_ptr<ReplayedSensor>> ReplayedSensor::start(const std::string& spec,
                                                              const std::string& hub_url,
                                                              const ReplayOptions& options) {
  sensor::SourceOptions source_options;
  source_options.pace = source::Pace::kAsFastAsPossible;
  source_options.sim_fps = options.fps;
  auto source = sensor::open_source(spec, source_options);
  if (!source) return source.error();
  auto frames = FrameLoop::capture(**source, options.frame_count);
  if (!frames) return frames.error();
  const source::SensorDescription sensor = (*source)->description();
  auto registration = Registration::create(sensor.calibration);
  if (!registration) return registration.error();
  codec::FrameEncoderOptions codec;
  codec.width = sensor.calibration.depth.width;
  codec.height = sensor.calibration.depth.height;
  codec.fps = options.fps;
  auto encoder = codec::FrameEncoder::create(codec);
  if (!encoder) return encoder.error();
  auto publisher = client::Publisher::open(publisher_options(sensor, hub_url, options.fps));
  if (!publisher) return publisher.error();
  return std::unique_ptr<ReplayedSensor>(
      new ReplayedSensor(sensor, options, *std::move(frames), *std::move(registration),
                         *std::move(encoder), *std::move(publisher)));
}

ReplayedSensor::ReplayedSensor(source::SensorDescription description, const ReplayOptions& options,
                               FrameLoop frames, Registration registration,
                               std::unique_ptr<codec::FrameEncoder> encoder,
                               std::unique_ptr<client::Publisher> publisher)
    : description_(std::move(description)),
      options_(options),
      frames_(std::move(frames)),
      registration_(std::move(registration)),
      encoder_(std::move(encoder)),
      publisher_(std::move(publisher)),
      thread_([this](const std::stop_token& stop) { play(stop); }) {}

ReplayedSensor::~ReplayedSensor() {
  (void)finish();
}

std::vector<double> ReplayedSensor::finish() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
  return std::move(encoded_ms_);
}

void ReplayedSensor::play(const std::stop_token& stop) {
  using Steady = std::chrono::steady_clock;
  const auto period =
      std::chrono::duration_cast<Steady::duration>(std::chrono::duration<double>(1 / options_.fps));
  auto due = Steady::now();
  for (std::int64_t i = 0; !stop.stop_requested(); ++i, due += period) {
    for (; due + period < Steady::now(); ++i) due += period;  // skips frames, as a camera does
    std::this_thread::sleep_until(due);
    send(frames_.at(i), HostTime(due.time_since_epoch()));
  }
}

void ReplayedSensor::send(const source::CapturedFrame& frame, HostTime captured) {
  const auto turn = publisher_->next_turn();
  if (!turn || !registration_.run(frame.depth_mm, frame.color, registered_)) return;
  if (options_.draws_clock) draw_clock(clock_of(captured), registered_.color.view());
  auto message = client::Publisher::begin_frame();
  const auto info = encoder_->encode(frame.depth_mm, registered_.color, registered_.seen,
                                     turn->want_key, message.appendable());
  if (!info) return;
  const std::chrono::duration<double, std::milli> age = SteadyClock().now() - captured;
  encoded_ms_.push_back(age.count());
  publisher_->publish(*turn, *info, captured, std::move(message));
}

}  // namespace roomcast::bench
