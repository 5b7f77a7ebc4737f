// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "roomcast/io/file_bytes.h"
#include "roomcast/python/arrays.h"
#include "roomcast/python/bindings.h"
#include "roomcast/python/errors.h"
#include "roomcast/python/room_sets.h"
#include "roomcast/python/without_gil.h"
#include "roomcast/recording/export/cloud_files.h"

namespace roomcast::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

/// One sensor's part of a set.
struct Frame {
  SharedSet set;
  std::size_t index = 0;

  [[nodiscard]] const recording::SetFrame& get() const { return set->set.frames[index]; }
  [[nodiscard]] const codec::DecodedFrame& pictures() const { return *get().pictures; }
  [[nodiscard]] const recording::SetSensor& sensor() const {
    return set->sensors->list[get().sensor];
  }
};

struct Cloud {
  std::shared_ptr<const recording::PointCloud> points;
  nanoseconds captured{};  // since 1970-01-01 UTC; 0: unknown
  Status may_export;
};

using Corner = std::array<float, 3>;
using Crop = std::optional<std::pair<Corner, Corner>>;

constexpr const char* kFrameDoc =
    "One sensor's part of a frame set. Its arrays are read-only views without a copy; they\n"
    "stay valid as long as they are used, also after the recording or the room is closed.";
constexpr const char* kDepthDoc =
    "H x W uint16, millimetres along the optical axis (z), 0: no reading. The depth scale\n"
    "of the sensor is applied.";
constexpr const char* kColorDoc =
    "H x W x 3 uint8, sRGB, in the depth picture's grid: color[y, x] belongs to depth[y,\n"
    "x]. None: the frame has no colour.";
constexpr const char* kSeenDoc =
    "H x W uint8, 0 where the colour camera did not see the point and the colour is filled\n"
    "in. None: the frame has no colour.";
constexpr const char* kPoseDoc =
    "4 x 4 float64: maps points of the depth camera (x right, y down, z forward) to the\n"
    "room (y up, floor at y = 0), metres. None: the pose of the sensor is not known.";
constexpr const char* kTimeDoc =
    "Capture time, nanoseconds since 1970-01-01 UTC; since the recording began where the\n"
    "recording does not tell its date (Recording.began_at_ns is None).";
constexpr const char* kFramePointsDoc =
    "A point for each reading on a surface, with normals and colours (see PointCloud).\n\n"
    "In the room's frame, or in the sensor's where room_from_sensor is None. Pixels on the\n"
    "edge of a depth step, which sensors mix, are left out.\n"
    "voxel_m: above 0, one point for each cube of this size, the mean of its points.\n"
    "crop: two opposite corners (x, y, z) of a box; points outside it are left out.";
constexpr const char* kSetPointsDoc =
    "The points of all placed sensors in the room's frame: the same as `roomcast export`\n"
    "writes.\n\n"
    "Where several sensors see the same surface, the points of the sensor that sees it most\n"
    "clearly. Sensors without a pose are left out, but for a single one, whose frame is\n"
    "used then.\n"
    "voxel_m: above 0, one point for each cube of this size, the mean of its points.\n"
    "crop: two opposite corners (x, y, z) of a box; points outside it are left out.\n"
    "keep_doubles: all points of all sensors.";

recording::MergedCloudOptions cloud_options(float voxel_m, const Crop& crop, bool keep_doubles) {
  recording::MergedCloudOptions options;
  options.voxel_m = voxel_m;
  options.keep_doubles = keep_doubles;
  if (!crop) return options;
  options.crop_m.emplace();
  for (const Corner& corner : {crop->first, crop->second})
    options.crop_m->extend(Eigen::Vector3f(corner[0], corner[1], corner[2]));
  return options;
}

Cloud points_of_frame(const Frame& frame, float voxel_m, const Crop& crop) {
  const auto options = cloud_options(voxel_m, crop, false);
  const WithoutGil without;
  return {value_of(cloud_of(*frame.set, frame.index, options)),
          frame.set->dated ? frame.get().time : nanoseconds(0), frame.set->may_export};
}

Cloud points_of_set(const SharedSet& set, float voxel_m, const Crop& crop, bool keep_doubles) {
  const auto options = cloud_options(voxel_m, crop, keep_doubles);
  const WithoutGil without;
  return {value_of(cloud_of(*set, options)), set->dated ? set->set.time : nanoseconds(0),
          set->may_export};
}

void write_ply(const Cloud& cloud, const std::filesystem::path& path) {
  check(cloud.may_export);
  const WithoutGil without;
  std::vector<std::uint8_t> bytes;
  recording::append_ply(*cloud.points, cloud.captured, bytes);
  check(io::write_file(path, bytes));
}

Frame frame_at(const SharedSet& set, py::ssize_t index) {
  const auto count = static_cast<py::ssize_t>(set->set.frames.size());
  if (index < -count || index >= count) throw py::index_error("no such frame in the set");
  return {set, static_cast<std::size_t>(index < 0 ? index + count : index)};
}

Frame frame_named(const SharedSet& set, const std::string& sensor) {
  const recording::SetFrame* frame = set->frame_of(sensor);
  if (frame == nullptr) throw py::key_error(sensor);
  return {set, static_cast<std::size_t>(frame - set->set.frames.data())};
}

py::object iterator_of(const SharedSet& set) {
  py::list frames;
  for (std::size_t i = 0; i < set->set.frames.size(); ++i) frames.append(Frame{set, i});
  return py::iter(frames);
}

std::vector<std::string> names_in(const SharedSet& set) {
  std::vector<std::string> names;
  for (const recording::SetFrame& frame : set->set.frames)
    names.push_back(set->sensors->list[frame.sensor].name);
  return names;
}

py::object color_of(const Frame& frame) {
  if (frame.pictures().color.empty()) return py::none();
  return array_of(frame.pictures().color.view(), frame.get().pictures);
}

py::object color_seen_of(const Frame& frame) {
  if (frame.pictures().color_seen.empty()) return py::none();
  return array_of(frame.pictures().color_seen.view(), frame.get().pictures);
}

void add_frame(py::module_& module) {
  py::class_<Frame>(module, "Frame", kFrameDoc)
      .def_property_readonly(
          "sensor", [](const Frame& frame) { return frame.sensor().name; }, "Name of the sensor.")
      .def_property_readonly(
          "intrinsics", [](const Frame& frame) { return frame.sensor().depth; },
          "Of both pictures.")
      .def_property_readonly(
          "depth",
          [](const Frame& frame) {
            return array_of(frame.pictures().depth_mm.view(), frame.get().pictures);
          },
          kDepthDoc)
      .def_property_readonly("color", &color_of, kColorDoc)
      .def_property_readonly("color_seen", &color_seen_of, kSeenDoc)
      .def_property_readonly(
          "room_from_sensor",
          [](const Frame& frame) { return array_or_none(frame.get().world_from_depth); }, kPoseDoc)
      .def_property_readonly(
          "time_ns", [](const Frame& frame) { return frame.get().time.count(); }, kTimeDoc)
      .def("points", &points_of_frame, py::kw_only(), "voxel_m"_a = 0.0F, "crop"_a = py::none(),
           kFramePointsDoc)
      .def("__repr__",
           [](const Frame& frame) { return "<roomcast.Frame of " + frame.sensor().name + ">"; });
}

void add_frame_set(py::module_& module) {
  py::class_<RoomSet, std::shared_ptr<RoomSet>>(
      module, "FrameSet",
      "The frames of all sensors at one instant. A sensor that missed it has its last frame.\n\n"
      "frames[0] and frames[\"s0\"] are Frames; iterating gives all of them.")
      .def("__len__", [](const RoomSet& set) { return set.set.frames.size(); })
      .def("__iter__", [](const std::shared_ptr<RoomSet>& set) { return iterator_of(set); })
      .def("__getitem__", [](const std::shared_ptr<RoomSet>& set,
                             py::ssize_t index) { return frame_at(set, index); })
      .def("__getitem__", [](const std::shared_ptr<RoomSet>& set,
                             const std::string& name) { return frame_named(set, name); })
      .def("__contains__", [](const RoomSet& set,
                              const std::string& name) { return set.frame_of(name) != nullptr; })
      .def_property_readonly(
          "sensors", [](const std::shared_ptr<RoomSet>& set) { return names_in(set); },
          "Names of the sensors that are in this set.")
      .def_property_readonly(
          "complete",
          [](const RoomSet& set) { return set.set.frames.size() >= set.sensors_sending; },
          "False while frames of some sensors are missing, as just after joining a room.")
      .def_property_readonly(
          "number", [](const RoomSet& set) { return set.set.number; },
          "Of a recording: 0, 1, 2...; of a room: grows, with gaps.")
      .def_property_readonly(
          "time_ns", [](const RoomSet& set) { return set.set.time.count(); },
          "Of its newest frame, as Frame.time_ns.")
      .def(
          "points",
          [](const std::shared_ptr<RoomSet>& set, float voxel_m, const Crop& crop, bool doubles) {
            return points_of_set(set, voxel_m, crop, doubles);
          },
          py::kw_only(), "voxel_m"_a = 0.0F, "crop"_a = py::none(), "keep_doubles"_a = false,
          kSetPointsDoc)
      .def("__repr__", [](const RoomSet& set) {
        return "<roomcast.FrameSet " + std::to_string(set.set.number) + " of " +
               std::to_string(set.set.frames.size()) + " frames>";
      });
}

void add_cloud(py::module_& module) {
  py::class_<Cloud>(
      module, "PointCloud",
      "A coloured point cloud with normals: N points. Its arrays are read-only views\n"
      "without a copy. numpy.asarray(cloud) is cloud.xyz.")
      .def("__len__", [](const Cloud& cloud) { return cloud.points->size(); })
      .def_property_readonly(
          "xyz", [](const Cloud& cloud) { return array_of(cloud.points->points_m, cloud.points); },
          "N x 3 float32, metres.")
      .def_property_readonly(
          "normals",
          [](const Cloud& cloud) { return array_of(cloud.points->normals, cloud.points); },
          "N x 3 float32, of length 1, towards the sensor.")
      .def_property_readonly(
          "colors", [](const Cloud& cloud) { return array_of(cloud.points->colors, cloud.points); },
          "N x 3 uint8, sRGB; grey where the sensor has no colour.")
      .def(
          "__array__",
          [](const Cloud& cloud, const py::object& type) -> py::object {
            const py::array xyz = array_of(cloud.points->points_m, cloud.points);
            if (type.is_none()) return xyz;
            return xyz.attr("astype")(type);
          },
          "dtype"_a = py::none())
      .def("write_ply", &write_ply, "path"_a,
           "Writes a PLY file as `roomcast export` does: binary, positions, normals, colours.\n\n"
           "Raises Error if the room's owner does not allow exporting, or on a disk error.")
      .def("__repr__", [](const Cloud& cloud) {
        return "<roomcast.PointCloud of " + std::to_string(cloud.points->size()) + " points>";
      });
}

}  // namespace

void add_frames(py::module_& module) {
  add_frame(module);
  add_frame_set(module);
  add_cloud(module);
}

}  // namespace roomcast::python
