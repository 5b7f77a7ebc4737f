// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/picture_folder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1  // Debian's library build throws exceptions
#include <toml++/toml.h>

#include "roomcast/core/text_file.h"
#include "roomcast/io/camera_json.h"
#include "roomcast/io/depth_values.h"
#include "roomcast/io/image_file.h"
#include "roomcast/recording/dataset/recording.h"
#include "roomcast/recording/dataset/rig_json.h"
#include "roomcast/recording/dataset/tum_list.h"
#include "roomcast/recording/import/color_pairs.h"
#include "roomcast/recording/import/sensor_name.h"

namespace roomcast::recording {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxTomlBytes = 1U << 20U, kMaxTimesBytes = 64U << 20U;
constexpr double kMaxFolderFps = 240;

/// Reads the fields of one table; keeps the first problem.
class TableFields {
 public:
  TableFields(const toml::table& table, std::string name, std::string& problem)
      : table_(table), name_(std::move(name)), problem_(problem) {}

  [[nodiscard]] bool has(const char* field) const { return table_.contains(field); }
  [[nodiscard]] std::string text(const char* field) {
    const auto value = table_[field].value_exact<std::string>();
    if (!value) reject(field, "must be a text");
    return value.value_or("");
  }
  [[nodiscard]] double number(const char* field, std::optional<double> otherwise = {}) {
    if (!has(field) && otherwise) return *otherwise;
    const auto value = table_[field].value<double>();
    if (!value || !std::isfinite(*value)) reject(field, "must be a number");
    return value.value_or(0);
  }
  [[nodiscard]] bool boolean(const char* field) {
    if (!has(field)) return false;
    const auto value = table_[field].value_exact<bool>();
    if (!value) reject(field, "must be true or false");
    return value.value_or(false);
  }
  [[nodiscard]] std::optional<TableFields> table(const char* field) {
    const toml::table* const inner = table_[field].as_table();
    if (inner == nullptr) {
      reject(field, "must be a table");
      return std::nullopt;
    }
    return TableFields(*inner, name_ + field + ".", problem_);
  }
  [[nodiscard]] RigidTransform transform(const char* field) {
    std::vector<double> numbers;
    const toml::array* const array = table_[field].as_array();
    for (std::size_t i = 0; array != nullptr && array->size() == 16 && i < 16; ++i)
      numbers.push_back((*array)[i].value<double>().value_or(std::nan("")));
    const auto transform = transform_from_row_major(numbers);
    if (transform) return *transform;
    reject(field, "must be the 16 numbers of a rigid transform, row by row");
    return {};
  }
  /// A path inside the folder.
  [[nodiscard]] fs::path inside(const char* field) {
    const fs::path path = text(field);
    if (!path.empty() && !stays_inside(path)) reject(field, "must stay inside the folder");
    return path;
  }
  void reject(const char* field, const std::string& what) {
    if (problem_.empty()) problem_ = name_ + field + " " + what;
  }

 private:
  const toml::table& table_;
  std::string name_;
  std::string& problem_;
};

CameraIntrinsics read_camera(TableFields fields) {
  CameraIntrinsics camera;
  const auto side = [&](const char* field) {
    const double value = fields.number(field);
    if (!(value >= 1 && value <= kMaxImageSide)) fields.reject(field, "must be 1 to 8192 pixels");
    return value >= 1 && value <= kMaxImageSide ? static_cast<int>(value) : 1;
  };
  camera.width = side("width"), camera.height = side("height");
  camera.fx = fields.number("fx"), camera.fy = fields.number("fy");
  camera.cx = fields.number("cx"), camera.cy = fields.number("cy");
  camera.k1 = fields.number("k1", 0), camera.k2 = fields.number("k2", 0);
  camera.k3 = fields.number("k3", 0);
  camera.p1 = fields.number("p1", 0), camera.p2 = fields.number("p2", 0);
  if (const Status status = camera.check(); !status) fields.reject("fx", status.error().message);
  return camera;
}

Result<std::vector<fs::path>> pictures_in(const fs::path& folder) {
  std::vector<fs::path> pictures;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string ending = at->path().extension().string();
    if (ending != ".png" && ending != ".jpg" && ending != ".jpeg") continue;
    if (pictures.size() == kMaxSensorFrames)
      return Error{ErrorCode::kTooLarge, folder.string() + " has too many pictures"};
    pictures.push_back(at->path());
  }
  if (error)
    return Error{ErrorCode::kNotFound, "cannot read " + folder.string() + ": " + error.message()};
  if (pictures.empty()) return Error{ErrorCode::kNotFound, folder.string() + " has no pictures"};
  std::ranges::sort(pictures);
  return pictures;
}

/// A time in seconds in each line.
Result<std::vector<nanoseconds>> times_in(const fs::path& file, std::size_t count) {
  const auto text = read_text_file(file, kMaxTimesBytes);
  if (!text) return text.error();
  std::vector<nanoseconds> times;
  std::string_view rest = *text;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
    if (line.empty() || line.front() == '#') continue;
    nanoseconds time{};
    if (!parse_seconds(line, time) || (!times.empty() && time <= times.back()))
      return malformed(file.string() + ": line with \"" + std::string(line.substr(0, 40)) +
                       "\" is no time in seconds after the one before");
    times.push_back(time);
  }
  if (times.size() == count) return times;
  return malformed(file.string() + " has " + std::to_string(times.size()) + " times for " +
                   std::to_string(count) + " depth pictures");
}

class PictureFolderSensor final : public SensorFile {
 public:
  PictureFolderSensor(SensorFileInfo info, io::RecordedCamera camera, std::vector<fs::path> depth,
                      std::vector<fs::path> color)
      : info_(std::move(info)),
        depth_values_(camera),
        depth_(std::move(depth)),
        color_(std::move(color)) {}

  [[nodiscard]] const SensorFileInfo& info() const override { return info_; }
  [[nodiscard]] Status read_depth(std::size_t frame, DepthImage& depth_mm) override {
    const CameraIntrinsics& camera = info_.description.calibration.depth;
    const Status status =
        reader_.read_depth(depth_[frame], {camera.width, camera.height}, depth_mm);
    if (status) depth_values_.to_mm(depth_mm);
    return status;
  }
  [[nodiscard]] Status read_color(std::size_t frame, ColorImage& color) override {
    color = {};
    if (color_.empty()) return {};
    const CameraIntrinsics& camera = info_.description.calibration.color;
    return reader_.read_color(color_[frame], {camera.width, camera.height}, color);
  }

 private:
  SensorFileInfo info_;
  io::DepthValues depth_values_;
  std::vector<fs::path> depth_, color_;
  io::ImageFileReader reader_;
};

/// The cameras of a sensor: those of a camera.json, or of the tables depth_camera and color_camera.
Result<io::RecordedCamera> cameras_of(TableFields& fields, const fs::path& folder) {
  if (fields.has("camera")) return io::read_camera_json(folder / fields.inside("camera"));
  io::RecordedCamera recorded;
  SensorCalibration& calibration = recorded.calibration;
  if (auto table = fields.table("depth_camera")) calibration.depth = read_camera(*table);
  calibration.color = calibration.depth;
  calibration.color_is_registered = true;
  recorded.has_color = fields.has("color");
  recorded.depth_scale_to_metre = fields.number("depth_scale_to_metre", 0.001);
  if (!(recorded.depth_scale_to_metre > 0 && recorded.depth_scale_to_metre <= 1))
    fields.reject("depth_scale_to_metre", "must be above 0 and at most 1");
  if (!recorded.has_color || fields.boolean("color_is_registered")) return recorded;
  if (auto table = fields.table("color_camera")) calibration.color = read_camera(*table);
  calibration.color_from_depth = fields.transform("color_from_depth");
  calibration.color_is_registered = false;
  return recorded;
}

Result<std::unique_ptr<SensorFile>> read_folder_sensor(const toml::table& table,
                                                       const std::string& label,
                                                       const fs::path& folder) {
  std::string problem;
  TableFields fields(table, label + ".", problem);
  const auto refused = [&] {
    return malformed((folder / kPictureFolderFile).string() + ": " + problem);
  };
  const fs::path depth_folder = fields.inside("depth");
  const fs::path color_folder = fields.has("color") ? fields.inside("color") : fs::path();
  const fs::path times_file = fields.has("times") ? fields.inside("times") : fs::path();
  const double fps = times_file.empty() ? fields.number("fps") : 1;
  if (!(fps > 0.001 && fps <= kMaxFolderFps)) fields.reject("fps", "must be 0.001 to 240");
  const std::string name = fields.text("name");
  auto cameras = cameras_of(fields, folder);
  if (!problem.empty()) return refused();
  if (!cameras) return cameras.error();
  auto depth = pictures_in(folder / depth_folder);
  if (!depth) return depth.error();
  std::vector<fs::path> color;
  if (!color_folder.empty()) {
    auto pictures = pictures_in(folder / color_folder);
    if (!pictures) return pictures.error();
    if (pictures->size() != depth->size())
      return malformed(folder.string() + ": " + name + " has " + std::to_string(depth->size()) +
                       " depth pictures, but " + std::to_string(pictures->size()) + " of colour");
    color = *std::move(pictures);
  }
  SensorFileInfo info;
  if (times_file.empty()) {
    for (std::size_t i = 0; i < depth->size(); ++i)
      info.times.emplace_back(std::llround(static_cast<double>(i) / fps * 1e9));
  } else {
    auto times = times_in(folder / times_file, depth->size());
    if (!times) return times.error();
    info.times = *std::move(times);
  }
  info.description = {sensor_name(name, folder.string()), cameras->calibration, std::nullopt,
                      fps_of_gap(median_gap(info.times, kNominalGap))};
  info.has_color = !color.empty();
  if (info.times.front() > kEarliestUtc) info.clock.utc_minus_device = nanoseconds(0);
  return std::unique_ptr<SensorFile>(std::make_unique<PictureFolderSensor>(
      std::move(info), *cameras, *std::move(depth), std::move(color)));
}

}  // namespace

Result<std::vector<std::unique_ptr<SensorFile>>> open_picture_folder(const fs::path& path) {
  std::error_code ignored;
  const fs::path folder = fs::is_directory(path, ignored) ? path : path.parent_path();
  const fs::path file = folder / kPictureFolderFile;
  const auto text = read_text_file(file, kMaxTomlBytes);
  if (!text) return text.error();
  const toml::parse_result parsed = toml::parse(std::string_view(*text));
  if (!parsed) {
    return malformed(file.string() + ": " + std::string(parsed.error().description()) + " (line " +
                     std::to_string(parsed.error().source().begin.line) + ")");
  }
  const toml::array* const sensors = parsed.table()["sensor"].as_array();
  if (sensors == nullptr || sensors->empty() || sensors->size() > kMaxRigSensors)
    return malformed(file.string() + ": it must have 1 to 32 tables [[sensor]]");
  std::vector<std::unique_ptr<SensorFile>> files;
  for (std::size_t i = 0; i < sensors->size(); ++i) {
    const toml::table* const table = (*sensors)[i].as_table();
    if (table == nullptr) return malformed(file.string() + ": [[sensor]] must be tables");
    auto sensor = read_folder_sensor(*table, "sensor " + std::to_string(i + 1), folder);
    if (!sensor) return sensor.error();
    files.push_back(*std::move(sensor));
  }
  return files;
}

}  // namespace roomcast::recording
