// SPDX-License-Identifier: Apache-2.0
// Measures how old what a window shows is: a sensor draws the time of capture into its pictures,
// and the time is read back from the window's pixels. The viewer stands where that sensor is, so
// that the code is where its rays are.
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>
#include <utility>

#include "bench/latency/capture_clock.h"
#include "bench/latency/clock_sensors.h"
#include "bench/latency/latency_cases.h"
#include "roomcast/client/subscriber.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/hub/server/running_hub.h"
#include "roomcast/viewer/desktop_viewer.h"

namespace roomcast::bench {
namespace {

using namespace std::chrono_literals;

constexpr auto kGlassWarmUp = 4s;  // the codec and the background adapt to the room
constexpr viewer::PictureSize kWindow{800, 600};
constexpr int kAround_px = 7;  // of a square of 45, so that a missing reading does not matter

/// Where in the window the squares of the code are.
class ClockInWindow {
 public:
  ClockInWindow(const source::SensorDescription& sensor, const viewer::ViewState& view,
                double vertical_fov_rad)
      : lens_(sensor.calibration.depth),
        view_from_depth_(viewer::world_from_view(view).inverse() * *sensor.world_from_depth),
        focal_px_(0.5 * kWindow.height / std::tan(0.5 * vertical_fov_rad)) {}

  [[nodiscard]] std::optional<std::uint16_t> read(const ColorImage& window) const {
    return read_clock([&](int column, int row) { return brightness(window, column, row); });
  }

 private:
  /// 0 where the square is outside the window.
  [[nodiscard]] double brightness(const ColorImage& window, int column, int row) const {
    const auto ray = unproject(lens_, clock_square(lens_.width, lens_.height, column, row), 1);
    if (!ray) return 0;
    const Eigen::Vector3d in_view = view_from_depth_ * *ray;
    const int x = static_cast<int>(
        std::lround(0.5 * (kWindow.width - 1) - focal_px_ * in_view.x() / in_view.z()));
    const int y = static_cast<int>(
        std::lround(0.5 * (kWindow.height - 1) + focal_px_ * in_view.y() / in_view.z()));
    if (x < kAround_px || y < kAround_px || x >= window.width() - kAround_px ||
        y >= window.height() - kAround_px) {
      return 0;
    }
    double sum = 0;
    for (int v = y - kAround_px; v <= y + kAround_px; ++v) {
      for (int u = x - kAround_px; u <= x + kAround_px; ++u) sum += window.at(u, v).g;
    }
    return sum / ((2 * kAround_px + 1) * (2 * kAround_px + 1));
  }

  const CameraIntrinsics lens_;
  const RigidTransform view_from_depth_;
  const double focal_px_;
};

struct GlassRoom {
  std::unique_ptr<hub::RunningHub> hub;
  std::vector<std::unique_ptr<ReplayedSensor>> sensors;  // the first one draws the time
};

Result<GlassRoom> open_glass_room() {
  GlassRoom room;
  auto hub = hub::RunningHub::start({.port = 0});
  if (!hub) return hub.error();
  room.hub = *std::move(hub);
  auto sensors = start_clock_sensors(room.hub->url());
  if (!sensors) return sensors.error();
  room.sensors = *std::move(sensors);
  return room;
}

struct GlassAges {
  std::vector<double> first_ms;  // when a time was seen first
  int pictures = 0, unread = 0;
};

GlassAges watch_window(viewer::DesktopViewer& viewer, const ClockInWindow& clock,
                       std::chrono::milliseconds duration) {
  GlassAges ages;
  std::optional<std::uint16_t> last;
  std::uint64_t drawn = viewer.pictures_drawn();
  const auto end = std::chrono::steady_clock::now() + duration;
  while (std::chrono::steady_clock::now() < end && viewer.step()) {
    if (std::exchange(drawn, viewer.pictures_drawn()) == viewer.pictures_drawn()) continue;
    const ColorImage window = viewer.window_picture();
    const std::uint16_t now = clock_of(SteadyClock().now());
    ++ages.pictures;
    const auto shown = clock.read(window);
    if (!shown) {
      ++ages.unread;
    } else if (std::exchange(last, shown) != shown) {
      ages.first_ms.push_back(clock_ms_between(*shown, now));
    }
  }
  return ages;
}

}  // namespace

Status measure_glass(std::chrono::milliseconds duration, LatencyReport& report) {
  constexpr int kUnlessTheUserSaysSo = 0;
  ::setenv("SDL_VIDEODRIVER", "offscreen", kUnlessTheUserSaysSo);
  auto room = open_glass_room();
  if (!room) return room.error();
  auto subscriber =
      client::Subscriber::open({.hub_url = room->hub->url(), .room = {}, .name = {}, .log = {}});
  if (!subscriber) return subscriber.error();
  const source::SensorDescription& clock_sensor = room->sensors.front()->description();
  viewer::DesktopViewerOptions options;
  options.window.size = kWindow;
  options.settings.automatic_scale = false;
  // Software drivers need seconds for a blended picture; other sensors would cover the code.
  options.settings.mode = render::RenderMode::kMesh;
  for (const client::RoomSensor& sensor : (*subscriber)->snapshot()->sensors) {
    if (sensor.name != clock_sensor.name) options.settings.hidden.insert(sensor.id);
  }
  options.panel = false;
  options.write_png = [](const auto&, ColorView) { return Status{}; };
  options.start =
      viewer::view_from_pose(*clock_sensor.world_from_depth * render::optical_from_view(), 3);
  auto viewer = viewer::DesktopViewer::open(**subscriber, options);
  if (!viewer) return viewer.error();
  const ClockInWindow clock(clock_sensor, *options.start, options.settings.vertical_fov_rad);
  (void)watch_window(**viewer, clock, kGlassWarmUp);
  const GlassAges ages = watch_window(**viewer, clock, duration);
  if (ages.first_ms.empty())
    return Error{ErrorCode::kUnavailable, "the window showed no time that could be read"};
  report.rows.push_back(distribution("glass: window", "ms", ages.first_ms));
  report.figures.push_back({"glass: pictures drawn", "/s",
                            ages.pictures / std::chrono::duration<double>(duration).count()});
  report.figures.push_back(
      {"glass: pictures without a time", "%", 100.0 * ages.unread / ages.pictures});
  return {};
}

}  // namespace roomcast::bench
