// SPDX-License-Identifier: Apache-2.0
#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "roomcast/python/bindings.h"
#include "roomcast/python/errors.h"
#include "roomcast/python/room_sets.h"
#include "roomcast/python/without_gil.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"

namespace roomcast::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

constexpr const char* kRecordingDoc =
    "An opened recording. Iterating gives its FrameSets from the beginning; every loop\n"
    "reads it anew. len() is the number of its sets, where it is known: of rigs and TUM\n"
    "recordings (undamaged), not of .mcap files, for which it raises TypeError.\n\n"
    "Threads: several may use it; each should have an iterator of its own.";
constexpr const char* kIteratorDoc =
    "Reads a recording set by set. next() raises Error at a damaged place; the next call\n"
    "goes on behind it where that is possible.";
constexpr const char* kOpenDoc =
    "Opens a recording: a file of `roomcast record` or of a hub (.mcap), or the folder of a\n"
    "rig or of a TUM recording. Recordings of other programs: `roomcast import` makes rigs\n"
    "of them.\n\n"
    "start_s: begins with the first set at this time or later, seconds after the beginning.\n"
    "Raises Error if it is missing, damaged from the beginning, or none of these.";

Error closed_recording() {
  return {ErrorCode::kClosed, "the recording was closed"};
}

/// One pass through a recording.
class SetIterator {
 public:
  SetIterator(std::unique_ptr<recording::FrameSetReader> reader,
              std::shared_ptr<const std::atomic<bool>> closed)
      : reader_(std::move(reader)),
        sensors_(std::make_shared<const RoomSensors>(reader_->sensors())),
        may_export_(recording::check_may_be_exported(*reader_)),
        closed_(std::move(closed)) {}

  /// Null at the end.
  [[nodiscard]] Result<std::shared_ptr<RoomSet>> next() {
    const std::lock_guard lock(mutex_);
    if (*closed_) return closed_recording();
    auto set = std::make_shared<RoomSet>();
    const auto more = reader_->next(set->set);
    if (!more) return more.error();
    if (!*more) return std::shared_ptr<RoomSet>();
    const nanoseconds began_at = reader_->began_at();
    set->set.time += began_at;
    for (recording::SetFrame& frame : set->set.frames) frame.time += began_at;
    set->dated = began_at.count() > 0;
    set->sensors = sensors_;
    set->sensors_sending = sensors_->list.size();
    set->may_export = may_export_;
    return set;
  }
  [[nodiscard]] const recording::FrameSetReader& reader() const { return *reader_; }

 private:
  std::mutex mutex_;  // threads may share an iterator
  const std::unique_ptr<recording::FrameSetReader> reader_;
  const std::shared_ptr<const RoomSensors> sensors_;
  const Status may_export_;
  const std::shared_ptr<const std::atomic<bool>> closed_;
};

/// All methods hold the interpreter's lock when they use members.
class OpenedRecording {
 public:
  OpenedRecording(std::filesystem::path path, double start_s)
      : path_(std::move(path)), start_(nanoseconds(std::llround(start_s * 1e9))) {
    first_ = open();
    const recording::FrameSetReader& reader = first_->reader();
    sensors_ = reader.sensors();
    length_ = reader.length();
    began_at_ = reader.began_at();
    damage_ = reader.damage();
    may_be_exported_ = reader.may_be_exported();
    set_count_ = reader.set_count();
  }

  /// The first loop uses the reader that was opened with the recording.
  [[nodiscard]] std::shared_ptr<SetIterator> begin() {
    if (*closed_) throw Failure(closed_recording());
    return first_ ? std::exchange(first_, nullptr) : open();
  }
  void close() {
    *closed_ = true;
    first_ = nullptr;
  }

  [[nodiscard]] const std::vector<recording::SetSensor>& sensors() const { return sensors_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::optional<double> duration_s() const {
    if (length_ <= nanoseconds(0)) return std::nullopt;
    return std::chrono::duration<double>(length_).count();
  }
  [[nodiscard]] std::optional<std::int64_t> began_at_ns() const {
    if (began_at_ == nanoseconds(0)) return std::nullopt;
    return began_at_.count();
  }
  [[nodiscard]] const std::optional<std::string>& damage() const { return damage_; }
  [[nodiscard]] bool may_be_exported() const { return may_be_exported_; }
  [[nodiscard]] std::uint64_t set_count() const {
    if (set_count_) return *set_count_;
    throw py::type_error("the number of frame sets of this recording is not known");
  }

 private:
  [[nodiscard]] std::shared_ptr<SetIterator> open() const {
    const WithoutGil without;
    return std::make_shared<SetIterator>(value_of(recording::open_frame_sets(path_, start_)),
                                         closed_);
  }

  const std::filesystem::path path_;
  const nanoseconds start_;
  const std::shared_ptr<std::atomic<bool>> closed_ = std::make_shared<std::atomic<bool>>(false);
  std::shared_ptr<SetIterator> first_;
  std::vector<recording::SetSensor> sensors_;
  nanoseconds length_{}, began_at_{};
  std::optional<std::string> damage_;
  bool may_be_exported_ = true;
  std::optional<std::uint64_t> set_count_;
};

constexpr double kLatestStart_s = 1e9;

std::unique_ptr<OpenedRecording> open_recording(const std::filesystem::path& path, double start_s) {
  if (!(start_s >= 0 && start_s <= kLatestStart_s))
    throw Failure(invalid_argument("start_s must be 0 to 1e9 seconds"));
  return std::make_unique<OpenedRecording>(path, start_s);
}

std::shared_ptr<RoomSet> next_set(const std::shared_ptr<SetIterator>& iterator) {
  auto set = [&] {
    const WithoutGil without;
    return value_of(iterator->next());
  }();
  if (!set) throw py::stop_iteration();
  return set;
}

}  // namespace

void add_recordings(py::module_& module) {
  py::class_<SetIterator, std::shared_ptr<SetIterator>>(module, "FrameSets", kIteratorDoc)
      .def("__iter__", [](const std::shared_ptr<SetIterator>& iterator) { return iterator; })
      .def("__next__", &next_set);
  py::class_<OpenedRecording>(module, "Recording", kRecordingDoc)
      .def("__iter__", &OpenedRecording::begin)
      .def("__len__", &OpenedRecording::set_count)
      .def("__bool__", [](const OpenedRecording&) { return true; })
      .def("__enter__", [](const py::object& recording) { return recording; })
      .def("__exit__", [](OpenedRecording& recording, const py::args&) { recording.close(); })
      .def("close", &OpenedRecording::close,
           "Ends reading. Frame sets and arrays that were read stay valid.")
      .def_property_readonly("path", &OpenedRecording::path)
      .def_property_readonly(
          "sensors", [](const OpenedRecording& recording) { return recording.sensors(); },
          "The sensors, as SensorInfo, in their order.")
      .def_property_readonly("duration_s", &OpenedRecording::duration_s,
                             "Seconds; None where it is not known without reading all of it.")
      .def_property_readonly(
          "began_at_ns", &OpenedRecording::began_at_ns,
          "Nanoseconds since 1970-01-01 UTC; None where the recording does not tell its date.")
      .def_property_readonly(
          "damage", &OpenedRecording::damage,
          "Why the end of the file is missing, as after a loss of power: what is "
          "before it is read. None: it is complete.")
      .def_property_readonly("may_be_exported", &OpenedRecording::may_be_exported,
                             "False if the room's owner did not allow exporting it.")
      .def("__repr__", [](const OpenedRecording& recording) {
        return "<roomcast.Recording of " + std::to_string(recording.sensors().size()) + " sensors>";
      });
  module.def("open", &open_recording, "path"_a, py::kw_only(), "start_s"_a = 0.0, kOpenDoc);
}

}  // namespace roomcast::python
