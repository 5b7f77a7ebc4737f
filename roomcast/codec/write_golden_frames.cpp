// SPDX-License-Identifier: Apache-2.0
// Writes the golden frames: payloads and their decoded results, for every implementation of
// docs/spec/codec.md. Run only when the format changes: roomcast_write_golden_frames tests/golden
// The depth and mask bytes are the same on every machine; the VP9 frames depend on libvpx's
// version.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

#include "roomcast/codec/frame_codec.h"
#include "roomcast/codec/payload/payload_sections.h"
#include "roomcast/codec/testing/random_live_stream.h"
#include "roomcast/codec/testing/synthetic_color.h"
#include "roomcast/codec/testing/synthetic_motion.h"
#include "roomcast/core/crc32.h"

namespace roomcast::codec {
namespace {

using nlohmann::ordered_json;

template <class T>
std::uint32_t crc_of(const Image<T>& image) {
  return crc32(std::as_bytes(std::span(image.data(), image.view().pixel_count())));
}

ordered_json description(const std::string& file, std::span<const std::uint8_t> payload,
                         const SyntheticFrame& frame, const EncodedFrameInfo& info,
                         const DecodedFrame& decoded) {
  ordered_json entry;
  entry["file"] = file;
  entry["width"] = frame.depth_mm.width();
  entry["height"] = frame.depth_mm.height();
  entry["key"] = info.key;
  entry["layer"] = info.layer;
  entry["depth_crc32"] = crc_of(decoded.depth_mm);
  if (frame.color.empty()) return entry;
  const auto sections = parse_sections(payload, frame.depth_mm.width(), frame.depth_mm.height());
  entry["mask_crc32"] = crc_of(decoded.color_seen);
  entry["color_offset"] = sections->color.data() - payload.data();
  entry["color_length"] = sections->color.size();
  return entry;
}

FrameEncoderOptions lossless() {
  FrameEncoderOptions options;
  options.depth_mode = DepthMode::kLossless;
  return options;
}

FrameEncoderOptions near_lossless(int bound_mm) {
  FrameEncoderOptions options;
  options.depth_mode = DepthMode::kNearLossless;
  options.depth_bound_mm = bound_mm;
  return options;
}

FrameEncoderOptions live(int layers) {
  FrameEncoderOptions options;
  options.depth_mode = DepthMode::kLive;
  options.temporal_layers = layers;
  options.fps = 5;  // a key frame every 20 frames
  return options;
}

/// A ball in front of a wall, long enough for refinements, background and a second key frame to
/// occur.
std::vector<SyntheticFrame> moving_ball(int width, int height, int frames) {
  SyntheticMotion scene;
  scene.width = width;
  scene.height = height;
  std::vector<SyntheticFrame> stream;
  for (int i = 0; i < frames; ++i) stream.push_back({scene.reading(i), {}, {}});
  return stream;
}

/// Whether the decoded depth equals the depth announced by the encoder.
bool shows(DepthView expected, const DepthImage& decoded) {
  for (int y = 0; y < expected.height; ++y) {
    if (!std::equal(expected.row(y), expected.row(y) + expected.width, decoded.view().row(y))) {
      return false;
    }
  }
  return true;
}

class GoldenWriter {
 public:
  explicit GoldenWriter(std::string folder) : folder_(std::move(folder)) {}

  /// Frames of one stream, in order.
  bool write(const std::string& name, const std::vector<SyntheticFrame>& frames,
             FrameEncoderOptions options = lossless()) {
    options.width = frames[0].depth_mm.width();
    options.height = frames[0].depth_mm.height();
    auto encoder = FrameEncoder::create(options);
    auto decoder = FrameDecoder::create(options.width, options.height);
    DecodedFrame decoded;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      std::vector<std::uint8_t> payload;
      const auto info = (*encoder)->encode(
          frames[i].depth_mm, frames[i].color.empty() ? ColorView{} : ColorView(frames[i].color),
          frames[i].seen.empty() ? MaskView{} : MaskView(frames[i].seen), false, payload);
      if (!info.ok()) return false;
      const std::string file =
          "frame_" + name + (frames.size() > 1 ? std::to_string(i) : "") + ".bin";
      if (!write_file(file, payload)) return false;
      if (!(*decoder)->decode(payload, decoded).ok()) return false;
      if (!shows((*encoder)->decoded_depth(), decoded.depth_mm)) return false;
      list_.push_back(description(file, payload, frames[i], *info, decoded));
    }
    return true;
  }

  /// Random live depth, unlike an encoder's, to cover rare parts of the format.
  bool write_sections(const std::string& name, int width, int height) {
    RandomLiveStream stream(width, height, 1);
    auto decoder = FrameDecoder::create(width, height);
    DecodedFrame decoded;
    for (int i = 0; i < 10; ++i) {
      const bool key = i % 7 == 0;
      std::vector<std::uint8_t> payload;
      const std::size_t begin = begin_section(SectionKind::kDepth, kLiveDepth, payload);
      const auto section = stream.next(key, i % 3 != 2);
      payload.insert(payload.end(), section.begin(), section.end());
      end_section(begin, payload);
      if (!(*decoder)->decode(payload, decoded).ok()) return false;
      const std::string file = "frame_" + name + std::to_string(i) + ".bin";
      if (!write_file(file, payload)) return false;
      const EncodedFrameInfo info{key, static_cast<std::uint8_t>(i % 3 == 2)};
      list_.push_back(
          description(file, payload, {DepthImage(width, height), {}, {}}, info, decoded));
    }
    return true;
  }

  bool write_list() {
    std::ofstream out(folder_ + "/frames.json");
    out << list_.dump(1) << "\n";
    return out.good();
  }

 private:
  [[nodiscard]] bool write_file(const std::string& file,
                                const std::vector<std::uint8_t>& bytes) const {
    std::ofstream out(folder_ + "/" + file, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
    return out.good();
  }

  std::string folder_;
  ordered_json list_ = ordered_json::array();
};

bool write_all(GoldenWriter& writer) {
  for (NamedDepth& corner : synthetic_depths(33, 18)) {
    if (!writer.write(corner.name, {{std::move(corner.depth_mm), {}, {}}})) return false;
  }
  // Large enough for predictors with weights, and rows of more than one mask group.
  if (!writer.write("large_room", {{synthetic_room(160, 121, 9), {}, {}}})) return false;
  // Every distance occurs: coded directly, not by index.
  DepthImage dense = depth_from(
      96, 64, [](int x, int y) { return 1000 + x + y / 2 + (x * 7919 + y * 104729) % 11; });
  if (!writer.write("dense", {{std::move(dense), {}, {}}})) return false;
  std::vector<SyntheticFrame> stream;
  for (int i = 0; i < 4; ++i) stream.push_back(synthetic_frame(75, 51, i));
  if (!writer.write("color_", stream)) return false;
  for (const int bound_mm : {1, 5, 63}) {
    const std::string name = "near_" + std::to_string(bound_mm) + "_mm";
    if (!writer.write(name, {{synthetic_room(160, 121, 9), {}, {}}}, near_lossless(bound_mm)))
      return false;
  }
  const DepthImage extremes = synthetic_depths(33, 18)[4].depth_mm;
  return writer.write("near_extremes", {{extremes, {}, {}}}, near_lossless(2)) &&
         writer.write("near_disparity_room", {{synthetic_disparity_room(33, 18), {}, {}}},
                      near_lossless(2)) &&
         writer.write("near_color_", stream, near_lossless(2)) &&
         writer.write("live_1_", moving_ball(61, 50, 24), live(1)) &&
         writer.write("live_2_", moving_ball(61, 50, 24), live(2)) &&
         writer.write("live_3_", moving_ball(64, 48, 12), live(3)) &&
         writer.write_sections("live_random_", 33, 18) &&
         writer.write("live_color_", stream, live(2)) && writer.write_list();
}

}  // namespace
}  // namespace roomcast::codec

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: roomcast_write_golden_frames FOLDER\n");
    return 2;
  }
  roomcast::codec::GoldenWriter writer(argv[1]);
  if (!roomcast::codec::write_all(writer)) {
    std::fprintf(stderr, "The golden frames could not be written to %s.\n", argv[1]);
    return 1;
  }
}
