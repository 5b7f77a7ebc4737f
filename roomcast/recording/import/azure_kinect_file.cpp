// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/azure_kinect_file.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

#include "roomcast/core/little_endian.h"
#include "roomcast/recording/import/azure_kinect_calibration.h"
#include "roomcast/recording/import/color_pairs.h"
#include "roomcast/recording/import/pixel_formats.h"
#include "roomcast/recording/import/sensor_name.h"
#include "roomcast/recording/matroska/file_index.h"

namespace roomcast::recording {
namespace {

using matroska::Block;
using matroska::FileIndex;
using matroska::Track;

/// The file states when it was made, to the second, and the first picture comes after that.
constexpr nanoseconds kUtcError = std::chrono::seconds(2);
constexpr std::int64_t kMaxTag_ns = std::int64_t{1} << 60;
constexpr double kNotedLensError_px = 0.25;

std::string tag_of(const FileIndex& index, const std::string& name) {
  const auto found = index.tags.find(name);
  return found == index.tags.end() ? std::string() : found->second;
}

/// A tag in nanoseconds; 0 if it is absent or not a number.
nanoseconds time_tag(const FileIndex& index, const std::string& name) {
  const std::string text = tag_of(index, name);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool valid = error == std::errc() && value > -kMaxTag_ns && value < kMaxTag_ns;
  return nanoseconds(valid ? value : 0);
}

std::optional<std::uint32_t> track_named(const FileIndex& index, std::string_view name) {
  for (std::size_t i = 0; i < index.tracks.size(); ++i) {
    if (index.tracks[i].is_video && index.tracks[i].name == name)
      return static_cast<std::uint32_t>(i);
  }
  return std::nullopt;
}

/// The format of a track: the four characters in its BITMAPINFOHEADER.
std::optional<PixelFormat> format_of(const Track& track) {
  constexpr std::size_t kCompressionAt = 16;
  if (track.codec == "V_MJPEG" && !track.is_encoded)
    return PixelFormat::kJpeg;  // of other programs
  if (track.is_encoded || track.codec_private.size() < kCompressionAt + 4) return std::nullopt;
  const std::string_view four(
      reinterpret_cast<const char*>(track.codec_private.data()) + kCompressionAt, 4);
  if (four == "MJPG") return PixelFormat::kJpeg;
  if (four == "NV12") return PixelFormat::kNv12;
  if (four == "YUY2") return PixelFormat::kYuy2;
  if (four == "BGRA") return PixelFormat::kBgra8;
  if (four == "b16g") return PixelFormat::kDepth16Big;
  return std::nullopt;
}

/// The blocks of a track in order of time, each time once.
std::vector<Block> blocks_of(const FileIndex& index, std::uint32_t track) {
  std::vector<Block> blocks;
  std::ranges::copy_if(index.blocks, std::back_inserter(blocks),
                       [&](const Block& block) { return block.track == track; });
  std::ranges::stable_sort(blocks, {}, &Block::time);
  const auto same = [](const Block& a, const Block& b) { return a.time == b.time; };
  blocks.erase(std::unique(blocks.begin(), blocks.end(), same), blocks.end());
  return blocks;
}

std::vector<nanoseconds> times_of(const std::vector<Block>& blocks, nanoseconds later) {
  std::vector<nanoseconds> times(blocks.size());
  std::ranges::transform(blocks, times.begin(), [&](const Block& b) { return b.time + later; });
  return times;
}

struct Tracks {
  std::vector<Block> depth, color;
  std::vector<std::optional<std::size_t>> color_of_depth;
  PixelFormat color_format = PixelFormat::kJpeg;
};

class AzureKinectFile final : public SensorFile {
 public:
  AzureKinectFile(std::unique_ptr<ByteSource> source, std::string name, SensorFileInfo info,
                  Tracks tracks)
      : source_(std::move(source)),
        name_(std::move(name)),
        info_(std::move(info)),
        tracks_(std::move(tracks)) {}

  [[nodiscard]] const SensorFileInfo& info() const override { return info_; }

  [[nodiscard]] Status read_depth(std::size_t frame, DepthImage& depth_mm) override {
    if (Status status = read(tracks_.depth[frame]); !status) return status;
    return named(decoder_.depth(
        picture(PixelFormat::kDepth16Big, info_.description.calibration.depth), depth_mm));
  }

  [[nodiscard]] Status read_color(std::size_t frame, ColorImage& color) override {
    color = {};
    if (!tracks_.color_of_depth[frame]) return {};
    if (Status status = read(tracks_.color[*tracks_.color_of_depth[frame]]); !status) return status;
    return named(
        decoder_.color(picture(tracks_.color_format, info_.description.calibration.color), color));
  }

  [[nodiscard]] Status read_jpeg(std::size_t frame, std::vector<std::uint8_t>& jpeg) override {
    jpeg.clear();
    if (tracks_.color_format != PixelFormat::kJpeg || !tracks_.color_of_depth[frame]) return {};
    if (Status status = read(tracks_.color[*tracks_.color_of_depth[frame]]); !status) return status;
    jpeg = bytes_;
    return {};
  }

 private:
  [[nodiscard]] StoredPicture picture(PixelFormat format, const CameraIntrinsics& camera) const {
    return {format, camera.width, camera.height, 0, bytes_};
  }
  [[nodiscard]] Status read(const Block& block) {
    bytes_.resize(block.size);
    return named(source_->read(block.offset, bytes_));
  }
  [[nodiscard]] Status named(Status status) const {
    if (status) return status;
    return Error{status.error().code, name_ + ": " + status.error().message};
  }

  std::unique_ptr<ByteSource> source_;
  std::string name_;
  SensorFileInfo info_;
  Tracks tracks_;
  PictureDecoder decoder_;
  std::vector<std::uint8_t> bytes_;  // reused
};

Error unsupported(std::string why) {
  return {ErrorCode::kUnsupported, std::move(why)};
}

Result<Tracks> find_tracks(const FileIndex& index) {
  const auto depth = track_named(index, "DEPTH");
  if (!depth) {
    return unsupported(
        "it has no track DEPTH; roomcast reads recordings of k4arecorder with depth");
  }
  if (format_of(index.tracks[*depth]) != PixelFormat::kDepth16Big)
    return unsupported("its depth has an unknown format");
  Tracks tracks;
  tracks.depth = blocks_of(index, *depth);
  if (tracks.depth.empty())
    return malformed(index.damage ? *index.damage + " and has no depth before that"
                                  : "it has no depth picture");
  const auto color = track_named(index, "COLOR");
  if (!color) return tracks;
  const auto format = format_of(index.tracks[*color]);
  if (!format || is_depth(*format)) return unsupported("its colour has an unknown format");
  tracks.color_format = *format;
  tracks.color = blocks_of(index, *color);
  return tracks;
}

/// The height at the end of a colour mode, "MJPG_720P"; 0 for none.
int height_of_mode(const FileIndex& index) {
  if (!track_named(index, "COLOR")) return 0;
  const std::string mode = tag_of(index, "K4A_COLOR_MODE");
  const std::size_t underscore = mode.find('_');
  int height = -1;
  if (underscore != std::string::npos)
    std::from_chars(mode.data() + underscore + 1, mode.data() + mode.size(), height);
  return height == 0 ? -1 : height;
}

Result<AzureKinectCalibration> calibration_of(const FileIndex& index) {
  const auto file =
      std::ranges::find(index.attachments, "calibration.json", &matroska::Attachment::name);
  if (file == index.attachments.end())
    return unsupported("it has no calibration.json; roomcast reads recordings of k4arecorder");
  return read_azure_kinect_calibration(file->bytes, tag_of(index, "K4A_DEPTH_MODE"),
                                       height_of_mode(index));
}

Status check_sizes(const FileIndex& index, const SensorCalibration& cameras) {
  const auto fits = [&](std::string_view name, const CameraIntrinsics& camera) {
    const auto track = track_named(index, name);
    return !track || (index.tracks[*track].width == static_cast<std::uint64_t>(camera.width) &&
                      index.tracks[*track].height == static_cast<std::uint64_t>(camera.height));
  };
  if (fits("DEPTH", cameras.depth) && fits("COLOR", cameras.color)) return {};
  return malformed("its pictures have another size than its mode");
}

SensorClock azure_clock(const FileIndex& index, nanoseconds start_offset) {
  SensorClock clock;
  const std::string mode = tag_of(index, "K4A_WIRED_SYNC_MODE");
  clock.is_cable_primary = mode == "MASTER";
  clock.is_cable_secondary = mode == "SUBORDINATE";
  if (index.began_utc) clock.utc_minus_device = *index.began_utc - start_offset;
  clock.utc_error = kUtcError;
  return clock;
}

std::vector<std::string> notes_of(const FileIndex& index,
                                  const AzureKinectCalibration& calibration) {
  std::vector<std::string> notes;
  if (index.damage) notes.push_back(*index.damage + "; everything before that was read");
  const auto note = [&](const char* camera, double error_px) {
    if (error_px < kNotedLensError_px) return;
    char text[160];
    std::snprintf(text, sizeof(text),
                  "the %s lens has eight coefficients and was converted to five, with an error of "
                  "up to %.1f pixels at the edge",
                  camera, error_px);
    notes.emplace_back(text);
  };
  note("depth", calibration.depth_error_px);
  note("colour", calibration.color_error_px);
  return notes;
}

/// The parts of a file that become a sensor.
struct Parts {
  SensorFileInfo info;
  Tracks tracks;
};

Result<Parts> parts_of(const FileIndex& index, const std::string& name) {
  auto tracks = find_tracks(index);
  if (!tracks) return tracks.error();
  const auto calibration = calibration_of(index);
  if (!calibration) return calibration.error();
  if (Status status = check_sizes(index, calibration->cameras); !status) return status.error();
  const nanoseconds start_offset = time_tag(index, "K4A_START_OFFSET_NS");
  const nanoseconds depth_delay = time_tag(index, "K4A_DEPTH_DELAY_NS");
  SensorFileInfo info;
  info.times = times_of(tracks->depth, start_offset);
  tracks->color_of_depth =
      nearest_colors(info.times, times_of(tracks->color, start_offset + depth_delay));
  info.description = {sensor_name(tag_of(index, "K4A_DEVICE_SERIAL_NUMBER"), name),
                      calibration->cameras, std::nullopt,
                      fps_of_gap(median_gap(info.times, kNominalGap))};
  info.clock = azure_clock(index, start_offset);
  info.has_color = !tracks->color.empty();
  info.notes = notes_of(index, *calibration);
  return Parts{std::move(info), *std::move(tracks)};
}

}  // namespace

Result<std::unique_ptr<SensorFile>> read_azure_kinect_file(std::unique_ptr<ByteSource> source,
                                                           const std::string& name) {
  const auto named = [&](const Error& error) {
    return Error{error.code, name + ": " + error.message};
  };
  const auto index = matroska::read_file_index(*source);
  if (!index) return named(index.error());
  auto parts = parts_of(*index, name);
  if (!parts) return named(parts.error());
  return std::unique_ptr<SensorFile>(std::make_unique<AzureKinectFile>(
      std::move(source), name, std::move(parts->info), std::move(parts->tracks)));
}

Result<std::unique_ptr<SensorFile>> open_azure_kinect_file(const std::filesystem::path& path) {
  auto source = open_file(path);
  if (!source) return source.error();
  return read_azure_kinect_file(*std::move(source), path.string());
}

}  // namespace roomcast::recording
