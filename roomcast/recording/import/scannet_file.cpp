// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/scannet_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include <zlib.h>

#include "roomcast/core/little_endian.h"
#include "roomcast/io/depth_values.h"
#include "roomcast/recording/import/color_pairs.h"
#include "roomcast/recording/import/pixel_formats.h"
#include "roomcast/recording/import/sensor_name.h"

namespace roomcast::recording {
namespace {

constexpr std::uint32_t kScanNetVersion = 4;
constexpr std::uint64_t kMaxRecordedNameBytes = 4096;
constexpr std::size_t kMatrixBytes = 64;
constexpr std::size_t kFrameHeadBytes = kMatrixBytes + 4 * 8;  // pose, two times, two sizes
constexpr std::uint64_t kMaxPictureBytes = 256U << 20U;
constexpr std::size_t kFixedBytes = 4 * kMatrixBytes + 2 * 4 + 4 * 4 + 4 + 8;
constexpr int kRaw = 0, kPngOrZlib = 1, kJpegColor = 2;

struct ScanNetFrame {
  std::uint64_t color_offset = 0, color_bytes = 0, depth_bytes = 0;
  std::uint64_t time_us = 0;
};

struct ScanNetIndex {
  std::string name;
  SensorCalibration calibration;
  int color_compression = 0, depth_compression = 0;
  double depth_scale_to_metre = 0.001;
  std::vector<ScanNetFrame> frames;
  bool is_cut = false;
};

using Matrix = std::array<double, 16>;

/// Reads numbers one after the other; the caller has checked the size.
class Numbers {
 public:
  explicit Numbers(const std::uint8_t* at) : at_(at) {}
  std::uint32_t u32() { return read_u32(std::exchange(at_, at_ + 4)); }
  std::uint64_t u64() { return read_u64(std::exchange(at_, at_ + 8)); }
  double f32() { return static_cast<double>(std::bit_cast<float>(u32())); }
  Matrix matrix() {
    Matrix m{};
    for (double& value : m) value = f32();
    return m;
  }

 private:
  const std::uint8_t* at_;
};

Result<CameraIntrinsics> straight_camera(const Matrix& m, std::uint32_t width,
                                         std::uint32_t height) {
  CameraIntrinsics camera;
  camera.width = static_cast<int>(std::min<std::uint32_t>(width, 1U << 20U));
  camera.height = static_cast<int>(std::min<std::uint32_t>(height, 1U << 20U));
  camera.fx = m[0], camera.cx = m[2], camera.fy = m[5], camera.cy = m[6];
  if (Status status = camera.check(); !status)
    return malformed("a camera of it is invalid: " + status.error().message);
  return camera;
}

Result<ScanNetIndex> read_fixed_part(const ByteSource& source, std::uint64_t at,
                                     std::uint64_t& frames) {
  std::array<std::uint8_t, kFixedBytes> bytes{};
  if (Status status = source.read(at, bytes); !status) return status.error();
  Numbers numbers(bytes.data());
  const Matrix color = numbers.matrix(), color_pose = numbers.matrix();
  const Matrix depth = numbers.matrix(), depth_pose = numbers.matrix();
  ScanNetIndex index;
  index.color_compression = static_cast<int>(numbers.u32());
  index.depth_compression = static_cast<int>(numbers.u32());
  const std::uint32_t color_width = numbers.u32(), color_height = numbers.u32();
  const std::uint32_t depth_width = numbers.u32(), depth_height = numbers.u32();
  const double shift = numbers.f32();
  frames = numbers.u64();
  if (index.color_compression < kRaw || index.color_compression > kJpegColor ||
      index.depth_compression < kRaw || index.depth_compression > kPngOrZlib)
    return Error{ErrorCode::kUnsupported,
                 "its pictures are compressed in a way that is not supported"};
  if (!(shift >= 1 && shift <= 1e6)) return malformed("its unit of depth is invalid");
  const auto depth_camera = straight_camera(depth, depth_width, depth_height);
  if (!depth_camera) return depth_camera.error();
  const auto color_camera = straight_camera(color, color_width, color_height);
  if (!color_camera) return color_camera.error();
  const auto depth_from = transform_from_row_major(depth_pose);
  const auto color_from = transform_from_row_major(color_pose);
  if (!depth_from || !color_from) return malformed("a pose of its cameras is invalid");
  index.calibration = {*depth_camera, *color_camera, *color_from * depth_from->inverse(), false};
  index.depth_scale_to_metre = 1 / shift;
  return index;
}

Status index_frames(const ByteSource& source, std::uint64_t at, std::uint64_t count,
                    ScanNetIndex& index) {
  if (count > kMaxSensorFrames) return Error{ErrorCode::kTooLarge, "it has too many frames"};
  for (std::uint64_t i = 0; i < count; ++i) {
    std::array<std::uint8_t, kFrameHeadBytes> head{};
    index.is_cut = !source.read(at, head).ok();
    if (index.is_cut) break;
    Numbers numbers(head.data() + kMatrixBytes);
    ScanNetFrame frame;
    (void)numbers.u64();  // of colour
    frame.time_us = numbers.u64();
    frame.color_bytes = numbers.u64();
    frame.depth_bytes = numbers.u64();
    frame.color_offset = at + kFrameHeadBytes;
    const std::uint64_t left = source.size() - frame.color_offset;
    const bool possible =
        frame.color_bytes <= kMaxPictureBytes && frame.depth_bytes <= kMaxPictureBytes;
    if (!possible) return Error{ErrorCode::kTooLarge, "a picture in it is too large"};
    index.is_cut = frame.color_bytes + frame.depth_bytes > left;
    if (index.is_cut) break;
    index.frames.push_back(frame);
    at = frame.color_offset + frame.color_bytes + frame.depth_bytes;
  }
  return index.frames.empty() ? Status(malformed("it has no frames")) : Status();
}

Result<ScanNetIndex> index_scannet(const ByteSource& source) {
  std::array<std::uint8_t, 12> head{};
  if (!source.read(0, head)) return malformed("it is not a recording of ScanNet");
  Numbers numbers(head.data());
  const std::uint32_t version = numbers.u32();
  const std::uint64_t name_bytes = numbers.u64();
  if (version != kScanNetVersion || name_bytes > kMaxRecordedNameBytes)
    return Error{ErrorCode::kUnsupported, "it is not a recording of ScanNet, version 4"};
  std::string name(static_cast<std::size_t>(name_bytes), '\0');
  const std::span<std::uint8_t> into(reinterpret_cast<std::uint8_t*>(name.data()), name.size());
  if (Status status = source.read(head.size(), into); !status) return status.error();
  std::uint64_t frames = 0;
  const std::uint64_t at = head.size() + name_bytes;
  auto index = read_fixed_part(source, at, frames);
  if (!index) return index.error();
  index->name = std::move(name);
  if (Status status = index_frames(source, at + kFixedBytes, frames, *index); !status)
    return status.error();
  return index;
}

/// Times in the file, or 30 frames a second where it has none.
std::vector<nanoseconds> scannet_times(const std::vector<ScanNetFrame>& frames) {
  std::vector<nanoseconds> times;
  for (const ScanNetFrame& frame : frames) {
    const auto us = static_cast<std::int64_t>(std::min<std::uint64_t>(frame.time_us, 1ULL << 52U));
    times.emplace_back(std::chrono::microseconds(us));
  }
  const bool grow = std::ranges::adjacent_find(times, std::ranges::greater_equal()) == times.end();
  for (std::size_t i = 0; !grow && i < times.size(); ++i)
    times[i] = nanoseconds(static_cast<std::int64_t>(i) * 1'000'000'000 / 30);
  return times;
}

io::DepthValues scannet_values(double depth_scale_to_metre) {
  io::RecordedCamera camera;
  camera.depth_scale_to_metre =
      std::abs(depth_scale_to_metre - 0.001) < 1e-9 ? 0.001 : depth_scale_to_metre;
  return io::DepthValues(camera);
}

class ScanNetFile final : public SensorFile {
 public:
  ScanNetFile(std::unique_ptr<ByteSource> source, std::string name, ScanNetIndex index)
      : source_(std::move(source)),
        name_(std::move(name)),
        index_(std::move(index)),
        depth_values_(scannet_values(index_.depth_scale_to_metre)) {
    info_.times = scannet_times(index_.frames);
    info_.description = {sensor_name("", name_), index_.calibration, std::nullopt,
                         fps_of_gap(median_gap(info_.times, kNominalGap))};
    if (index_.is_cut)
      info_.notes.emplace_back("it ends too early; everything before that was read");
    info_.notes.emplace_back("the poses of the moving camera are not used");
  }

  [[nodiscard]] const SensorFileInfo& info() const override { return info_; }

  [[nodiscard]] Status read_depth(std::size_t number, DepthImage& depth_mm) override {
    const ScanNetFrame& frame = index_.frames[number];
    if (Status status = read(frame.color_offset + frame.color_bytes, frame.depth_bytes); !status)
      return named(status);
    const CameraIntrinsics& camera = index_.calibration.depth;
    if (index_.depth_compression == kPngOrZlib && !inflate(camera))
      return named(malformed("a picture in it is damaged"));
    const Status status = decoder_.depth(
        {PixelFormat::kDepth16Little, camera.width, camera.height, 0, bytes_}, depth_mm);
    if (status) depth_values_.to_mm(depth_mm);
    return named(status);
  }

  [[nodiscard]] Status read_color(std::size_t number, ColorImage& color) override {
    const ScanNetFrame& frame = index_.frames[number];
    color = {};
    if (frame.color_bytes == 0) return {};
    if (Status status = read(frame.color_offset, frame.color_bytes); !status) return named(status);
    const PixelFormat format = index_.color_compression == kRaw         ? PixelFormat::kRgb8
                               : index_.color_compression == kJpegColor ? PixelFormat::kJpeg
                                                                        : PixelFormat::kPng;
    const CameraIntrinsics& camera = index_.calibration.color;
    return named(decoder_.color({format, camera.width, camera.height, 0, bytes_}, color));
  }

  [[nodiscard]] Status read_jpeg(std::size_t number, std::vector<std::uint8_t>& jpeg) override {
    const ScanNetFrame& frame = index_.frames[number];
    jpeg.clear();
    if (index_.color_compression != kJpegColor) return {};
    if (Status status = read(frame.color_offset, frame.color_bytes); !status) return named(status);
    jpeg = bytes_;
    return {};
  }

 private:
  [[nodiscard]] Status read(std::uint64_t offset, std::uint64_t size) {
    bytes_.resize(static_cast<std::size_t>(size));
    return source_->read(offset, bytes_);
  }
  /// Replaces `bytes_` by what they contain: two bytes for each pixel.
  [[nodiscard]] bool inflate(const CameraIntrinsics& camera) {
    const std::size_t wanted = std::size_t{2} * static_cast<std::size_t>(camera.width) *
                               static_cast<std::size_t>(camera.height);
    std::vector<std::uint8_t> plain(wanted);
    uLongf size = plain.size();
    if (uncompress(plain.data(), &size, bytes_.data(), bytes_.size()) != Z_OK || size != wanted)
      return false;
    bytes_ = std::move(plain);
    return true;
  }
  [[nodiscard]] Status named(Status status) const {
    if (status) return status;
    return Error{status.error().code, name_ + ": " + status.error().message};
  }

  std::unique_ptr<ByteSource> source_;
  std::string name_;
  ScanNetIndex index_;
  SensorFileInfo info_;
  io::DepthValues depth_values_;
  PictureDecoder decoder_;
  std::vector<std::uint8_t> bytes_;  // reused
};

}  // namespace

Result<std::unique_ptr<SensorFile>> read_scannet_file(std::unique_ptr<ByteSource> source,
                                                      const std::string& name) {
  auto index = index_scannet(*source);
  if (!index) return Error{index.error().code, name + ": " + index.error().message};
  return std::unique_ptr<SensorFile>(
      std::make_unique<ScanNetFile>(std::move(source), name, *std::move(index)));
}

Result<std::unique_ptr<SensorFile>> open_scannet_file(const std::filesystem::path& path) {
  auto source = open_file(path);
  if (!source) return source.error();
  return read_scannet_file(*std::move(source), path.string());
}

}  // namespace roomcast::recording
