// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/record3d_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "roomcast/recording/import/color_pairs.h"
#include "roomcast/recording/import/pixel_formats.h"
#include "roomcast/recording/import/sensor_name.h"
#include "roomcast/recording/lzfse/lzfse.h"
#include "roomcast/recording/zip/zip_archive.h"

namespace roomcast::recording {
namespace {

constexpr const char* kMetadata = "metadata";
constexpr std::string_view kFrameFolder = "rgbd/", kDepthEnding = ".depth";
constexpr std::size_t kMaxMetadataBytes = 512U << 20U;  // poses of hours
constexpr std::size_t kMaxR3dPictureBytes = 256U << 20U;
constexpr double kMaxRecordedSeconds = 1e9;
/// Depth of files that do not tell its size: LiDAR upright and lying, TrueDepth likewise.
constexpr std::array<std::pair<int, int>, 4> kKnownDepthSizes = {
    {{192, 256}, {256, 192}, {480, 640}, {640, 480}}};

struct Record3dFrame {
  std::uint32_t number = 0;
  const ZipEntry* depth = nullptr;
  const ZipEntry* color = nullptr;  // null: none
};

struct Record3dMetadata {
  CameraIntrinsics color;
  int depth_width = 0, depth_height = 0;  // 0: not told
  double fps = 30;
  std::vector<double> times_s;  // by the frame's number; may be fewer, or none
};

/// A finite number of an object; nothing if there is none.
std::optional<double> r3d_number(const nlohmann::json& object, const char* field) {
  const auto found = object.find(field);
  if (found == object.end() || !found->is_number()) return std::nullopt;
  const double value = found->get<double>();
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::vector<double> r3d_numbers(const nlohmann::json& object, const char* field) {
  std::vector<double> numbers;
  const auto found = object.find(field);
  if (found == object.end() || !found->is_array()) return numbers;
  for (const nlohmann::json& value : *found) {
    if (!value.is_number() || !std::isfinite(value.get<double>())) return {};
    numbers.push_back(value.get<double>());
  }
  return numbers;
}

int r3d_side(const nlohmann::json& object, const char* field) {
  const double side = r3d_number(object, field).value_or(0);
  return side >= 1 && side <= kMaxImageSide ? static_cast<int>(side) : 0;
}

Result<Record3dMetadata> parse_record3d(const std::vector<std::uint8_t>& text) {
  const auto fields = nlohmann::json::parse(text, nullptr, false);
  if (!fields.is_object()) return malformed("its metadata is not a JSON object");
  Record3dMetadata metadata;
  metadata.color.width = r3d_side(fields, "w");
  metadata.color.height = r3d_side(fields, "h");
  const std::vector<double> k = r3d_numbers(fields, "K");
  if (k.size() != 9) return malformed("its metadata lacks the camera's matrix \"K\"");
  metadata.color.fx = k[0], metadata.color.fy = k[4];
  metadata.color.cx = k[6], metadata.color.cy = k[7];
  if (Status status = metadata.color.check(); !status)
    return malformed("the camera of it is invalid: " + status.error().message);
  metadata.depth_width = r3d_side(fields, "dw");
  metadata.depth_height = r3d_side(fields, "dh");
  metadata.fps = r3d_number(fields, "fps").value_or(30);
  if (!(metadata.fps >= 0.001 && metadata.fps <= 240)) metadata.fps = 30;
  metadata.times_s = r3d_numbers(fields, "frameTimestamps");
  return metadata;
}

/// "rgbd/12.depth": 12; nothing for another name.
std::optional<std::uint32_t> frame_number(std::string_view name) {
  if (!name.starts_with(kFrameFolder) || !name.ends_with(kDepthEnding)) return std::nullopt;
  name.remove_prefix(kFrameFolder.size());
  name.remove_suffix(kDepthEnding.size());
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (error != std::errc() || end != name.data() + name.size()) return std::nullopt;
  return number;
}

Result<std::vector<Record3dFrame>> frames_in(const ZipArchive& archive) {
  std::vector<Record3dFrame> frames;
  for (const auto& [name, entry] : archive.entries()) {
    const auto number = frame_number(name);
    if (!number) continue;
    if (frames.size() == kMaxSensorFrames)
      return Error{ErrorCode::kTooLarge, "it has too many frames"};
    frames.push_back({*number, &entry, archive.find("rgbd/" + std::to_string(*number) + ".jpg")});
  }
  if (frames.empty()) return malformed("it has no frames");
  std::ranges::sort(frames, {}, &Record3dFrame::number);
  return frames;
}

/// Times in the file, or the frames' numbers at its rate where they are missing or do not grow.
std::vector<nanoseconds> record3d_times(const Record3dMetadata& metadata,
                                        const std::vector<Record3dFrame>& frames) {
  const auto at_rate = [&](std::uint32_t number) { return number / metadata.fps; };
  bool are_told = !metadata.times_s.empty();
  for (std::size_t i = 0; i < frames.size() && are_told; ++i) {
    const std::uint32_t number = frames[i].number;
    are_told = number < metadata.times_s.size() && metadata.times_s[number] >= 0 &&
               metadata.times_s[number] <= kMaxRecordedSeconds &&
               (i == 0 || metadata.times_s[number] > metadata.times_s[frames[i - 1].number]);
  }
  std::vector<nanoseconds> times;
  for (const Record3dFrame& frame : frames) {
    const double time_s = are_told ? metadata.times_s[frame.number] : at_rate(frame.number);
    times.push_back(nanoseconds(std::llround(1e9 * time_s)));
  }
  return times;
}

/// The camera of a picture of another size: pixel centres are at integers, so that the picture
/// begins half a pixel before zero.
CameraIntrinsics scaled_camera(const CameraIntrinsics& camera, int width, int height) {
  const double x = static_cast<double>(width) / camera.width;
  const double y = static_cast<double>(height) / camera.height;
  return {.width = width,
          .height = height,
          .fx = camera.fx * x,
          .fy = camera.fy * y,
          .cx = (camera.cx + 0.5) * x - 0.5,
          .cy = (camera.cy + 0.5) * y - 0.5};
}

class Record3dFile final : public SensorFile {
 public:
  Record3dFile(ZipArchive archive, std::string name)
      : archive_(std::move(archive)), name_(std::move(name)) {}

  /// Errors do not name the file.
  [[nodiscard]] Status open() {
    const ZipEntry* const entry = archive_.find(kMetadata);
    if (entry == nullptr)
      return Error{ErrorCode::kUnsupported, "it is not a recording of Record3D: no metadata"};
    if (Status status = archive_.extract(*entry, kMaxMetadataBytes, bytes_); !status) return status;
    auto metadata = parse_record3d(bytes_);
    if (!metadata) return metadata.error();
    auto frames = frames_in(archive_);
    if (!frames) return frames.error();
    frames_ = *std::move(frames);
    const auto depth = depth_camera(*metadata);
    if (!depth) return depth.error();
    info_.times = record3d_times(*metadata, frames_);
    info_.has_color = std::ranges::any_of(
        frames_, [](const Record3dFrame& frame) { return frame.color != nullptr; });
    info_.description = {sensor_name("", name_),
                         {*depth, metadata->color, {}, *depth == metadata->color},
                         std::nullopt,
                         fps_of_gap(median_gap(info_.times, kNominalGap))};
    info_.notes.emplace_back("the poses of the moving camera are not used");
    return {};
  }

  [[nodiscard]] const SensorFileInfo& info() const override { return info_; }

  [[nodiscard]] Status read_depth(std::size_t frame, DepthImage& depth_mm) override {
    const CameraIntrinsics& camera = info_.description.calibration.depth;
    return named(read_values(*frames_[frame].depth, camera.width, camera.height, depth_mm));
  }

  [[nodiscard]] Status read_color(std::size_t frame, ColorImage& color) override {
    color = {};
    if (frames_[frame].color == nullptr) return {};
    const CameraIntrinsics& camera = info_.description.calibration.color;
    if (Status status = archive_.extract(*frames_[frame].color, kMaxR3dPictureBytes, bytes_);
        !status)
      return named(status);
    return named(
        decoder_.color({PixelFormat::kJpeg, camera.width, camera.height, 0, bytes_}, color));
  }

  [[nodiscard]] Status read_jpeg(std::size_t frame, std::vector<std::uint8_t>& jpeg) override {
    jpeg.clear();
    if (frames_[frame].color == nullptr) return {};
    return named(archive_.extract(*frames_[frame].color, kMaxR3dPictureBytes, jpeg));
  }

 private:
  [[nodiscard]] Result<CameraIntrinsics> depth_camera(const Record3dMetadata& metadata) {
    if (metadata.depth_width > 0 && metadata.depth_height > 0)
      return scaled_camera(metadata.color, metadata.depth_width, metadata.depth_height);
    DepthImage ignored;
    for (const auto& [width, height] : kKnownDepthSizes) {
      const bool is_upright = height > width;
      if (is_upright == (metadata.color.height > metadata.color.width) &&
          read_values(*frames_.front().depth, width, height, ignored))
        return scaled_camera(metadata.color, width, height);
    }
    return Error{ErrorCode::kUnsupported,
                 "its metadata lacks the size of depth (\"dw\", \"dh\"), and it is none that is "
                 "known"};
  }

  /// Some programs write the values without compression.
  [[nodiscard]] Status read_values(const ZipEntry& entry, int width, int height,
                                   DepthImage& depth_mm) {
    const std::size_t wanted =
        sizeof(float) * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (Status status = archive_.extract(entry, kMaxR3dPictureBytes, bytes_); !status)
      return status;
    if (bytes_.size() != wanted && !decode_lzfse(bytes_, wanted, values_))
      return malformed("a depth picture in it is damaged, or of another size");
    if (bytes_.size() == wanted) std::swap(bytes_, values_);
    return decoder_.depth({PixelFormat::kDepthFloat, width, height, 0, values_}, depth_mm);
  }

  [[nodiscard]] Status named(Status status) const {
    if (status) return status;
    return Error{status.error().code, name_ + ": " + status.error().message};
  }

  ZipArchive archive_;
  std::string name_;
  std::vector<Record3dFrame> frames_;  // point into archive_
  SensorFileInfo info_;
  PictureDecoder decoder_;
  std::vector<std::uint8_t> bytes_, values_;  // reused
};

}  // namespace

Result<std::unique_ptr<SensorFile>> read_record3d_file(std::unique_ptr<ByteSource> source,
                                                       const std::string& name) {
  auto archive = ZipArchive::read(std::move(source));
  if (!archive) return Error{archive.error().code, name + ": " + archive.error().message};
  auto file = std::make_unique<Record3dFile>(*std::move(archive), name);
  if (Status status = file->open(); !status)
    return Error{status.error().code, name + ": " + status.error().message};
  return std::unique_ptr<SensorFile>(std::move(file));
}

Result<std::unique_ptr<SensorFile>> open_record3d_file(const std::filesystem::path& path) {
  auto source = open_file(path);
  if (!source) return source.error();
  return read_record3d_file(*std::move(source), path.string());
}

}  // namespace roomcast::recording
