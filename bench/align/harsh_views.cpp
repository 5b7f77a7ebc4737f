// SPDX-License-Identifier: Apache-2.0
#include "bench/align/harsh_views.h"

#include <cmath>
#include <utility>

#include "roomcast/alignment/bundle/bundle_capture.h"
#include "roomcast/core/assert.h"
#include "roomcast/io/jpeg_codec.h"
#include "roomcast/simulator/sensing/harsh_unit.h"
#include "roomcast/simulator/simulated_room.h"
#include "roomcast/simulator/simulated_sensor.h"

namespace roomcast::bench {
namespace {

/// Colour as a recording has it.
class Jpeg {
 public:
  explicit Jpeg(int quality) : quality_(quality) {}
  void pass(ColorImage& color) {
    const std::string encoding = codec_.encode(color, quality_, bytes_);
    ROOMCAST_ASSERT(encoding.empty());
    const std::string decoding = codec_.decode(bytes_, color.view());
    ROOMCAST_ASSERT(decoding.empty());
  }

 private:
  int quality_;
  io::JpegCodec codec_;
  std::vector<std::uint8_t> bytes_;
};

/// The true depth where the bundle has readings.
DepthImage seen_truth(DepthImage clean_mm, const DepthImage& reported_mm) {
  for (std::size_t i = 0; i < clean_mm.view().pixel_count(); ++i) {
    if (reported_mm.data()[i] == 0) clean_mm.data()[i] = 0;
  }
  return clean_mm;
}

Result<HarshView> harsh_view(const simulator::SimulatedSensor& sensor, const std::string& name,
                             const simulator::HarshRecording& recording) {
  alignment::BundleCapture capture(name, sensor.calibration());
  Jpeg jpeg(sensor.unit().jpeg_quality);
  auto moment = sensor.make_moment();
  auto exposure = sensor.auto_exposure();
  DepthImage depth_mm, clean_mm;
  ColorImage color;
  for (int i = 0; i < recording.frames; ++i) {
    const auto frame = static_cast<std::uint64_t>(i);
    const nanoseconds time(std::llround(1e9 * i / recording.fps));
    const float gain = sensor.next_exposure(time, moment, exposure);
    sensor.look(time, moment);
    sensor.read_depth(frame, moment, depth_mm);
    sensor.read_color(frame, gain, moment, color);
    jpeg.pass(color);
    if (const auto added = capture.add(depth_mm, color, 1e-9 * double(time.count())); !added)
      return added.error();
  }
  HarshView seen{nullptr, sensor.world_from_depth(), sensor.unit().depth_scale, nullptr};
  const auto bundle = capture.finish();
  if (!bundle) return seen;
  auto view = alignment::make_sensor_view(*bundle);
  if (!view) return seen;
  seen.view = std::make_shared<const alignment::SensorView>(*std::move(view));
  seen.surface = std::make_shared<const alignment::DepthSurface>(
      alignment::depth_surface(seen_truth(sensor.clean_depth_mm(moment), bundle->depth_mm),
                               sensor.exact_calibration().depth));
  return seen;
}

}  // namespace

Result<std::vector<HarshView>> harsh_views(const HarshViewsOptions& options) {
  const auto room = simulator::SimulatedRoom::build(options.scene, options.seed);
  if (!room) return room.error();
  simulator::SensingOptions sensing;
  sensing.half_color = true;
  sensing.harsh = options.sensors;
  const auto recording = simulator::draw_harsh_recording(options.seed);
  std::vector<HarshView> views;
  for (int i = 0; i < options.count && views.size() < options.only_first; ++i) {
    const auto sensor =
        simulator::SimulatedSensor::open(*room, {i, options.count, options.seed, 1.0, 1, sensing});
    if (!sensor) return sensor.error();
    auto view = harsh_view(**sensor, "s" + std::to_string(i), recording);
    if (!view) return view.error();
    views.push_back(*std::move(view));
  }
  return views;
}

}  // namespace roomcast::bench
