// SPDX-License-Identifier: Apache-2.0
// The decoder against tests/golden: payloads once written must always decode to the same result,
// natively and in WebAssembly.
#include <fstream>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "roomcast/codec/frame_codec.h"
#include "roomcast/core/crc32.h"

namespace roomcast::codec {
namespace {

const std::string kFolder = ROOMCAST_GOLDEN_FOLDER;

std::vector<std::uint8_t> bytes_of(const std::string& file) {
  std::ifstream in(kFolder + "/" + file, std::ios::binary);
  EXPECT_TRUE(in) << file << " is missing";
  return {std::istreambuf_iterator<char>(in), {}};
}

template <class T>
std::uint32_t crc_of(const Image<T>& image) {
  return crc32(std::as_bytes(std::span(image.data(), image.view().pixel_count())));
}

TEST(GoldenFrames, decode_to_their_sources) {
  std::ifstream in(kFolder + "/frames.json");
  const nlohmann::json list = nlohmann::json::parse(in);
  ASSERT_GE(list.size(), 10u);
  std::unique_ptr<FrameDecoder> decoder;
  for (const auto& entry : list) {
    const std::string file = entry["file"];
    if (entry["key"]) {
      decoder = std::move(FrameDecoder::create(entry["width"], entry["height"])).value();
    }
    DecodedFrame out;
    const Status status = decoder->decode(bytes_of(file), out);
    ASSERT_TRUE(status.ok()) << file << ": " << status.error().message;
    EXPECT_EQ(crc_of(out.depth_mm), entry["depth_crc32"]) << file;
    EXPECT_EQ(out.color.empty(), !entry.contains("mask_crc32")) << file;
    if (entry.contains("mask_crc32")) {
      EXPECT_EQ(crc_of(out.color_seen), entry["mask_crc32"]) << file;
    }
  }
}

}  // namespace
}  // namespace roomcast::codec
