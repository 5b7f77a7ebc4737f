// SPDX-License-Identifier: Apache-2.0
// For arbitrary depth the live decoder shows the picture announced by the encoder, and both have
// the same state. Input: width - 16, height - 16, layers; then for each frame the kind of change,
// and bytes for it.
#include <algorithm>

#include "roomcast/codec/live/live_depth_decoder.h"
#include "roomcast/codec/live/live_depth_encoder.h"
#include "roomcast/codec/payload/layer_schedule.h"

namespace {

using namespace roomcast;  // NOLINT: only glue in this file

constexpr int kMaxFrames = 40;

/// Returns the input byte by byte, then zeros.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : next_(data), end_(data + size) {}
  [[nodiscard]] bool empty() const { return next_ == end_; }
  std::uint8_t next() { return next_ < end_ ? *next_++ : std::uint8_t{0}; }
  std::uint16_t next_depth() { return static_cast<std::uint16_t>(next() | next() << 8); }

 private:
  const std::uint8_t* next_;
  const std::uint8_t* end_;
};

void change(Bytes& bytes, DepthImage& depth) {
  const std::uint8_t kind = bytes.next();
  const int x0 = bytes.next() % depth.width(), y0 = bytes.next() % depth.height();
  const int x1 = std::min(depth.width(), x0 + 1 + bytes.next() % 32);
  const int y1 = std::min(depth.height(), y0 + 1 + bytes.next() % 32);
  const std::uint16_t value = bytes.next_depth();
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      std::uint16_t& pixel = depth.at(x, y);
      switch (kind % 4) {
        case 0:
          pixel = value;
          break;
        case 1:
          pixel = static_cast<std::uint16_t>(value + 7 * x - 5 * y);
          break;
        case 2:
          pixel = static_cast<std::uint16_t>(pixel + bytes.next() - 128);
          break;
        case 3:
          pixel = bytes.next_depth();
          break;
      }
    }
  }
}

bool agree(const codec::LiveState& a, const codec::LiveState& b) {
  return a.picture == b.picture && a.background == b.background && a.static_age == b.static_age &&
         a.hash == b.hash;
}

bool shows(DepthView expected, const DepthImage& shown) {
  for (int y = 0; y < expected.height; ++y) {
    if (!std::equal(expected.row(y), expected.row(y) + expected.width, shown.view().row(y))) {
      return false;
    }
  }
  return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const int width = 16 + bytes.next() % 32, height = 16 + bytes.next() % 32;
  codec::LayerSchedule schedule(1 + bytes.next() % 3, 15);
  codec::LiveDepthEncoder encoder({width, height});
  codec::LiveDepthDecoder decoder;
  DepthImage depth(width, height, 2000), shown(width, height);
  std::vector<std::uint8_t> section;
  for (int i = 0; i < kMaxFrames && !bytes.empty(); ++i) {
    change(bytes, depth);
    section.clear();
    encoder.encode(depth, schedule.next(false), section);
    if (!decoder.decode(section, shown.view()).ok()) __builtin_trap();
    if (!shows(encoder.shown_mm(), shown)) __builtin_trap();
    if (!agree(encoder.state(), decoder.state())) __builtin_trap();
  }
  return 0;
}
