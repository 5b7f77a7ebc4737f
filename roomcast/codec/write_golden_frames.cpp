// SPDX-License-Identifier: Apache-2.0
// Writes the golden frames: payloads, and what they decode to, for every implementation of
// docs/spec/codec.md. Run only when the format changes:  roomcast_write_golden_frames tests/golden
// The depth and mask bytes are the same on every machine; the VP9 frames depend on libvpx's
// version.
#include <cstdio>
#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

#include "roomcast/codec/frame_codec.h"
#include "roomcast/codec/payload_sections.h"
#include "roomcast/codec/synthetic_color.h"
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
                         DepthView decoded_mm) {
  ordered_json entry;
  entry["file"] = file;
  entry["width"] = frame.depth_mm.width();
  entry["height"] = frame.depth_mm.height();
  entry["key"] = info.key;
  entry["layer"] = info.layer;
  entry["depth_crc32"] = crc32(std::as_bytes(std::span(decoded_mm.data, decoded_mm.pixel_count())));
  if (frame.color.empty()) return entry;
  const auto sections = parse_sections(payload, frame.depth_mm.width(), frame.depth_mm.height());
  entry["mask_crc32"] = crc_of(frame.seen);
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

class GoldenWriter {
 public:
  explicit GoldenWriter(std::string folder) : folder_(std::move(folder)) {}

  /// Frames of one stream, in order.
  bool write(const std::string& name, const std::vector<SyntheticFrame>& frames,
             FrameEncoderOptions options = lossless()) {
    options.width = frames[0].depth_mm.width();
    options.height = frames[0].depth_mm.height();
    auto encoder = FrameEncoder::create(options);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      std::vector<std::uint8_t> payload;
      const auto info = (*encoder)->encode(
          frames[i].depth_mm, frames[i].color.empty() ? ColorView{} : ColorView(frames[i].color),
          frames[i].seen.empty() ? MaskView{} : MaskView(frames[i].seen), false, payload);
      if (!info.ok()) return false;
      const std::string file =
          "frame_" + name + (frames.size() > 1 ? std::to_string(i) : "") + ".bin";
      std::ofstream out(folder_ + "/" + file, std::ios::binary);
      out.write(reinterpret_cast<const char*>(payload.data()),
                static_cast<std::streamsize>(payload.size()));
      if (!out) return false;
      list_.push_back(description(file, payload, frames[i], *info, (*encoder)->decoded_depth()));
    }
    return true;
  }

  bool write_list() {
    std::ofstream out(folder_ + "/frames.json");
    out << list_.dump(1) << "\n";
    return out.good();
  }

 private:
  std::string folder_;
  ordered_json list_ = ordered_json::array();
};

bool write_all(GoldenWriter& writer) {
  for (NamedDepth& corner : synthetic_depths(33, 18)) {
    if (!writer.write(corner.name, {{std::move(corner.depth_mm), {}, {}}})) return false;
  }
  // Large enough for predictors with weights, and rows of more than one mask group.
  if (!writer.write("large_room", {{synthetic_room(160, 121, 9), {}, {}}})) return false;
  // Every distance occurs: coded as it is, not by index.
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
         writer.write("near_color_", stream, near_lossless(2)) && writer.write_list();
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
