// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/open_recording.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include "roomcast/recording/bytes/byte_source.h"
#include "roomcast/recording/import/azure_kinect_file.h"
#include "roomcast/recording/import/cwipc_config.h"
#include "roomcast/recording/import/foxglove_recording.h"
#include "roomcast/recording/import/picture_folder.h"
#include "roomcast/recording/import/placed_sensor_file.h"
#include "roomcast/recording/import/record3d_file.h"
#include "roomcast/recording/import/ros_recording.h"
#include "roomcast/recording/import/scannet_file.h"
#include "roomcast/recording/playback/replay_source.h"

namespace roomcast::recording {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFilesOfFolder = 4096;

Result<SensorFiles> alone(Result<std::unique_ptr<SensorFile>> file) {
  if (!file) return file.error();
  SensorFiles files;
  files.push_back(*std::move(file));
  return files;
}

Result<SensorFiles> open_cwipc_folder(const fs::path& folder);

using Open = Result<SensorFiles> (*)(const fs::path&);

struct Kind {
  std::string_view name;
  std::string_view magic;   // its files begin so
  std::string_view ending;  // and their names end so
  Open open;
  bool (*accepts)(const fs::path&) = nullptr;  // where several kinds begin and end so
};

const std::array<Kind, 9> kKinds = {{
    {"mkv", "\x1A\x45\xDF\xA3", "",
     [](const fs::path& p) { return alone(open_azure_kinect_file(p)); }},
    {"bag", "#ROSBAG V", "", open_ros1_bag},
    {"foxglove", "\x89MCAP", "", open_foxglove_recording, is_foxglove_recording},
    {"ros2", "\x89MCAP", "", open_ros2_recording},
    {"ros2", "SQLite format 3", "", open_ros2_recording},
    {"sens", std::string_view("\4\0\0\0", 4), ".sens",
     [](const fs::path& p) { return alone(open_scannet_file(p)); }},
    {"r3d", "PK\3\4", ".r3d", [](const fs::path& p) { return alone(open_record3d_file(p)); }},
    {"cwipc", "", kCwipcFile, open_cwipc_folder},
    {"pictures", "", kPictureFolderFile, open_picture_folder},
}};

const Kind* kind_of_name(std::string_view name) {
  const auto found = std::ranges::find(kKinds, name, &Kind::name);
  return found == kKinds.end() ? nullptr : &*found;
}

const Kind* kind_of_file(const fs::path& path) {
  const auto source = open_file(path);
  if (!source) return nullptr;
  std::array<std::uint8_t, 16> start{};
  const auto size =
      static_cast<std::size_t>(std::min<std::uint64_t>(start.size(), (*source)->size()));
  if (!(*source)->read(0, std::span(start.data(), size))) return nullptr;
  const std::string_view text(reinterpret_cast<const char*>(start.data()), size);
  for (const Kind& kind : kKinds) {
    if (kind.magic.empty() || !text.starts_with(kind.magic)) continue;
    if (path.string().ends_with(kind.ending) && (kind.accepts == nullptr || kind.accepts(path)))
      return &kind;
  }
  return nullptr;
}

Error no_format(const fs::path& path) {
  return {ErrorCode::kUnsupported,
          path.string() +
              " is in no format that roomcast imports (docs/guides/recordings.md lists "
              "them)"};
}

/// The error for a file or folder that roomcast itself wrote, which says what to do; `otherwise`
/// for all others.
Error own_format(const fs::path& path, Error otherwise) {
  std::error_code ignored;
  if (fs::exists(path / "rig.json", ignored) || fs::exists(path / "depth.txt", ignored))
    return {ErrorCode::kUnsupported, path.string() + " is a rig or a TUM folder already"};
  if (fs::is_regular_file(path, ignored) && replay_sensor_names(path).ok())
    return {ErrorCode::kUnsupported, path.string() +
                                         " is a recording of roomcast itself; make a rig of it by "
                                         "roomcast export --format rig"};
  return otherwise;
}

Result<SensorFiles> open_as(const Kind& kind, const fs::path& path) {
  auto files = kind.open(path);
  if (!files && files.error().code == ErrorCode::kUnsupported)
    return own_format(path, files.error());
  return files;
}

Result<std::vector<fs::path>> files_in(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (files.size() == kMaxFilesOfFolder)
      return Error{ErrorCode::kTooLarge, folder.string() + " has too many files"};
    files.push_back(at->path());
  }
  if (error)
    return Error{ErrorCode::kNotFound, "cannot read " + folder.string() + ": " + error.message()};
  std::ranges::sort(files);
  return files;
}

/// The recording of a camera of cwipc: of the name that its configuration says, else of its serial
/// number, as cwipc writes them.
Result<fs::path> cwipc_recording(const fs::path& folder, const CwipcCamera& camera) {
  if (!camera.file.empty()) return folder / camera.file;
  for (const char* ending : {".mkv", ".bag"}) {
    std::error_code ignored;
    const fs::path path = folder / (camera.serial + ending);
    if (!camera.serial.empty() && fs::exists(path, ignored)) return path;
  }
  return Error{ErrorCode::kNotFound, (folder / kCwipcFile).string() + " has a camera \"" +
                                         camera.serial + "\" without a recording beside it"};
}

std::unique_ptr<SensorFile> placed(std::unique_ptr<SensorFile> file, const CwipcCamera& camera) {
  const SensorCalibration& calibration = file->info().description.calibration;
  std::optional<RigidTransform> world_from_depth = camera.world_from_camera;
  if (world_from_depth && camera.is_color_camera)
    world_from_depth = *world_from_depth * calibration.color_from_depth;
  std::vector<std::string> notes;
  if (!camera.note.empty()) notes.push_back(camera.note);
  if (!world_from_depth && camera.note.empty())
    notes.push_back(std::string(kCwipcFile) + " does not say where it is");
  return std::make_unique<PlacedSensorFile>(std::move(file), world_from_depth, notes);
}

Result<SensorFiles> open_cwipc_folder(const fs::path& folder) {
  const auto cameras = read_cwipc_config(folder / kCwipcFile);
  if (!cameras) return cameras.error();
  SensorFiles all;
  for (const CwipcCamera& camera : *cameras) {
    const auto path = cwipc_recording(folder, camera);
    if (!path) return path.error();
    std::error_code ignored;
    if (!fs::exists(*path, ignored))
      return Error{ErrorCode::kNotFound, path->string() + " does not exist"};
    const Kind* const kind = kind_of_file(*path);
    if (kind == nullptr) return no_format(*path);
    auto files = kind->open(*path);
    if (!files) return files.error();
    for (auto& file : *files) all.push_back(placed(std::move(file), camera));
  }
  if (all.empty()) return no_format(folder);
  return all;
}

Result<SensorFiles> open_folder(const fs::path& folder) {
  const auto paths = files_in(folder);
  if (!paths) return paths.error();
  SensorFiles all;
  if (std::ranges::find(*paths, folder / kPictureFolderFile) != paths->end())
    return open_picture_folder(folder);
  if (std::ranges::find(*paths, folder / kCwipcFile) != paths->end())
    return open_cwipc_folder(folder);
  for (const fs::path& path : *paths) {
    const Kind* const kind = kind_of_file(path);
    if (kind == nullptr) continue;
    auto files = open_as(*kind, path);
    if (!files) return files.error();
    std::ranges::move(*files, std::back_inserter(all));
  }
  if (all.empty()) return own_format(folder, no_format(folder));
  return all;
}

std::string names_of(const SensorFiles& files) {
  std::string names;
  for (const auto& file : files)
    names += (names.empty() ? "" : ", ") + file->info().description.name;
  return names;
}

}  // namespace

bool is_import_kind(std::string_view kind) {
  return kind_of_name(kind) != nullptr;
}

std::string_view import_kind_of(const fs::path& file) {
  const Kind* const kind = kind_of_file(file);
  return kind != nullptr ? kind->name : std::string_view();
}

Result<SensorFiles> open_recording(std::string_view kind, const fs::path& path) {
  const Kind* const known = kind_of_name(kind);
  if (known == nullptr)
    return invalid_argument("\"" + std::string(kind) + "\" is no kind of recording");
  return known->open(path);
}

Result<std::unique_ptr<SensorFile>> open_sensor(std::string_view kind, const fs::path& path,
                                                const std::string& sensor) {
  auto files = open_recording(kind, path);
  if (!files) return files.error();
  if (sensor.empty() && files->size() == 1) return std::move(files->front());
  for (auto& file : *files) {
    if (file->info().description.name == sensor) return std::move(file);
  }
  const std::string what = sensor.empty() ? " has several sensors" : " has no sensor " + sensor;
  return Error{ErrorCode::kNotFound,
               path.string() + what + "; choose one of " + names_of(*files) + " after a #"};
}

Result<SensorFiles> open_any(const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored))
    return Error{ErrorCode::kNotFound, path.string() + " does not exist"};
  if (fs::is_directory(path, ignored)) return open_folder(path);
  const Kind* const kind = kind_of_file(path);
  return kind != nullptr ? open_as(*kind, path) : Result<SensorFiles>(no_format(path));
}

}  // namespace roomcast::recording
