// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

#include <pybind11/stl.h>

#include "roomcast/python/arrays.h"
#include "roomcast/python/bindings.h"
#include "roomcast/python/errors.h"
#include "roomcast/python/waiting.h"
#include "roomcast/sensor/sender/capture_time.h"
#include "roomcast/sensor/sender/frame_sender.h"

namespace roomcast::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

constexpr const char* kSensorDoc =
    "A sensor of a room: sends depth and colour. Joins the room and waits for the hub's\n"
    "answer.\n\n"
    "url, token, room: as watch(). name: the sensor's identity; one that comes back under\n"
    "its name keeps its pose. intrinsics: of the depth camera.\n"
    "color_intrinsics, color_from_depth (4 x 4): of the colour camera; None: colour comes\n"
    "in the depth picture's grid, or color_from_depth is the identity. Colour is registered\n"
    "to depth here.\n"
    "room_from_sensor: 4 x 4, the pose of the depth camera; None: not known. fps: above 0\n"
    "to 240.\n"
    "depth_mode: 'live' (few bytes, the noise is not sent), 'near-lossless' (within\n"
    "depth_bound_mm, 1 to 63) or 'lossless'. color_kbit_per_s: 50 to 100000; None: 790.\n"
    "send_unwatched: sends while nobody watches, too; usually it does not. A broken\n"
    "connection is taken up again. Raises Error if there is no hub, or if it refuses.";
constexpr const char* kSendDoc =
    "Encodes and sends one frame, or skips it if nobody watches, or if earlier frames still\n"
    "wait for the network: the report tells which. Does not wait for the network.\n\n"
    "depth: H x W uint16, millimetres, 0: no reading. color: H x W x 3 uint8, sRGB, of the\n"
    "colour camera's size; None: no colour in this frame.\n"
    "monotonic_ns: capture time by time.monotonic_ns(), up to 10 s ago; None: now.\n"
    "Raises Error if a picture has another size or type, if the encoded frame is larger\n"
    "than a hub takes, or if the connection has ended for good.";

struct SendReport {
  bool sent = false, connected = false, watched = false;
  std::size_t frames_waiting = 0, max_frames_waiting = client::Publisher::kMaxFramesWaiting;
  std::optional<std::uint32_t> seq;
  std::uint64_t frames_sent = 0, frames_skipped = 0, bytes_sent = 0;
  double rate_share = 1;
};

/// The connection of a sensor. Threads that send share it.
struct Sending {
  SensorCalibration calibration;
  std::mutex mutex;  // one frame at a time
  std::unique_ptr<sensor::FrameSender> sender;
};

SendReport report_of(const sensor::FrameSender& sender,
                     const std::optional<client::Publisher::Published>& published) {
  const client::PublisherStats stats = sender.publisher().stats();
  SendReport report;
  report.sent = published.has_value();
  report.connected = !sender.publisher().problem();
  report.watched = sender.publisher().frames_wanted();
  report.frames_waiting = stats.frames_waiting;
  if (published) report.seq = published->seq;
  report.frames_sent = stats.frames_sent;
  report.frames_skipped = stats.frames_skipped;
  report.bytes_sent = stats.bytes_sent;
  report.rate_share = sender.rate_share();
  return report;
}

HostTime capture_time(std::optional<std::int64_t> monotonic_ns) {
  const HostTime now = SteadyClock().now();
  if (!monotonic_ns) return now;
  const HostTime time{nanoseconds(*monotonic_ns)};
  if (!sensor::is_recent(time, now))
    throw Failure(
        invalid_argument("monotonic_ns is not of the last ten seconds by time.monotonic_ns()"));
  return time;
}

template <class View>
void check_size(const char* what, const View& picture, const CameraIntrinsics& camera) {
  if (picture.width == camera.width && picture.height == camera.height) return;
  const auto size = [](const auto& of) {
    return std::to_string(of.width) + " x " + std::to_string(of.height);
  };
  throw Failure(invalid_argument(std::string(what) + " has " + size(picture) +
                                 " pixels (width x height), and its camera " + size(camera)));
}

/// Its members are used with the interpreter's lock only.
class SendingSensor {
 public:
  explicit SendingSensor(std::shared_ptr<Sending> sending) : sending_(std::move(sending)) {}
  ~SendingSensor() { close(); }
  SendingSensor(const SendingSensor&) = delete;
  SendingSensor& operator=(const SendingSensor&) = delete;

  [[nodiscard]] SendReport send(const py::object& depth, const py::object& color,
                                std::optional<std::int64_t> monotonic_ns) const {
    const std::shared_ptr<Sending> sending = get();
    const HostTime time = capture_time(monotonic_ns);
    const py::array depth_mm = depth_array(depth, "depth");
    check_size("depth", depth_view(depth_mm), sending->calibration.depth);
    const py::array rgb = color.is_none() ? py::array() : color_array(color, "color");
    const ColorView colors = color.is_none() ? ColorView() : color_view(rgb);
    if (!color.is_none()) check_size("color", colors, sending->calibration.color);
    const DepthView depths = depth_view(depth_mm);
    const WithoutGil without;
    const std::lock_guard lock(sending->mutex);
    if (const auto failure = sending->sender->publisher().failure()) throw Failure(*failure);
    return report_of(*sending->sender, value_of(sending->sender->send(depths, colors, time)));
  }
  [[nodiscard]] py::object problem() const {
    const auto problem = get()->sender->publisher().problem();
    if (!problem) return py::none();
    return py::str(problem->message);
  }
  void close() {
    auto ends = std::exchange(sending_, nullptr);
    if (!ends) return;
    const WithoutGil without;
    ends = nullptr;
  }

 private:
  [[nodiscard]] std::shared_ptr<Sending> get() const {
    if (!sending_) throw Failure({ErrorCode::kClosed, "the sensor was closed"});
    return sending_;
  }
  std::shared_ptr<Sending> sending_;
};

codec::DepthMode depth_mode_of(const std::string& name) {
  if (name == "live") return codec::DepthMode::kLive;
  if (name == "near-lossless") return codec::DepthMode::kNearLossless;
  if (name == "lossless") return codec::DepthMode::kLossless;
  throw Failure(invalid_argument("depth_mode must be live, near-lossless or lossless"));
}

SensorCalibration calibration_of(const CameraIntrinsics& depth,
                                 const std::optional<CameraIntrinsics>& color,
                                 const py::object& color_from_depth) {
  SensorCalibration calibration{
      .depth = depth, .color = depth, .color_from_depth = {}, .color_is_registered = true};
  if (!color) return calibration;
  calibration.color = *color;
  calibration.color_is_registered = false;
  if (!color_from_depth.is_none())
    calibration.color_from_depth = transform_of(color_from_depth, "color_from_depth");
  return calibration;
}

std::unique_ptr<SendingSensor> make_sensor(const std::string& url, const std::string& name,
                                           const CameraIntrinsics& intrinsics,
                                           const std::optional<CameraIntrinsics>& color_intrinsics,
                                           const py::object& color_from_depth,
                                           const py::object& room_from_sensor, double fps,
                                           const std::string& depth_mode, int depth_bound_mm,
                                           std::optional<int> color_kbit_per_s, bool send_unwatched,
                                           const std::string& token, const std::string& room) {
  client::PublisherOptions options;
  options.hub_url = url;
  options.room = room;
  options.name = name;
  if (name.empty()) throw Failure(invalid_argument("a sensor needs a name"));
  options.credential = client::credential_of(token);
  options.calibration = calibration_of(intrinsics, color_intrinsics, color_from_depth);
  if (!room_from_sensor.is_none())
    options.world_from_depth = transform_of(room_from_sensor, "room_from_sensor");
  options.fps = fps;
  options.send_unwatched = send_unwatched;
  sensor::CodecChoice codec;
  codec.depth_mode = depth_mode_of(depth_mode);
  codec.depth_bound_mm = depth_bound_mm;
  if (color_kbit_per_s && *color_kbit_per_s <= 0)
    throw Failure(invalid_argument("color_kbit_per_s must be above 0"));
  codec.color_kbit_per_s = color_kbit_per_s.value_or(0);
  auto sending = std::make_shared<Sending>();
  sending->calibration = options.calibration;
  sending->sender = value_of(interruptible([&](const std::stop_token& stop) {
    options.stop = stop;
    return sensor::FrameSender::open(std::move(options), codec);
  }));
  return std::make_unique<SendingSensor>(std::move(sending));
}

void add_report(py::module_& module) {
  py::class_<SendReport>(module, "SendReport",
                         "What became of a frame, and how the network keeps up.")
      .def_readonly(
          "sent", &SendReport::sent,
          "False: skipped, because nobody watches, because the network does not keep up, or\n"
          "because there is no connection (or no room time yet, just after joining).")
      .def_readonly("connected", &SendReport::connected)
      .def_readonly("watched", &SendReport::watched,
                    "False: nobody watches, so frames are skipped (unless send_unwatched is set).")
      .def_readonly("frames_waiting", &SendReport::frames_waiting,
                    "Frames that are not on the network yet.")
      .def_readonly("max_frames_waiting", &SendReport::max_frames_waiting,
                    "With so many waiting, the next one is skipped.")
      .def_readonly("seq", &SendReport::seq, "Number of the frame; None if it was not sent.")
      .def_readonly("frames_sent", &SendReport::frames_sent, "Since the sensor joined.")
      .def_readonly("frames_skipped", &SendReport::frames_skipped,
                    "Since the sensor joined; without those that nobody would have watched.")
      .def_readonly("bytes_sent", &SendReport::bytes_sent, "Since the sensor joined.")
      .def_readonly("rate_share", &SendReport::rate_share,
                    "Of the full colour rate, what the network carries: 0 to 1.");
}

}  // namespace

void add_sensors(py::module_& module) {
  add_report(module);
  py::class_<SendingSensor>(module, "Sensor", kSensorDoc)
      .def(py::init(&make_sensor), "url"_a, "name"_a, "intrinsics"_a, py::kw_only(),
           "color_intrinsics"_a = py::none(), "color_from_depth"_a = py::none(),
           "room_from_sensor"_a = py::none(), "fps"_a = 30.0, "depth_mode"_a = "live",
           "depth_bound_mm"_a = 2, "color_kbit_per_s"_a = py::none(), "send_unwatched"_a = false,
           "token"_a = "", "room"_a = "")
      .def("send", &SendingSensor::send, "depth"_a, "color"_a = py::none(), py::kw_only(),
           "monotonic_ns"_a = py::none(), kSendDoc)
      .def_property_readonly("problem", &SendingSensor::problem,
                             "Why there is no connection at the moment; None while there is one.")
      .def("__enter__", [](const py::object& sensor) { return sensor; })
      .def("__exit__", [](SendingSensor& sensor, const py::args&) { sensor.close(); })
      .def("close", &SendingSensor::close, "Leaves the room. Frames that still wait may be lost.");
}

}  // namespace roomcast::python
