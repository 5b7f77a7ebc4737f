// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/peers/peers.h"

namespace roomcast::bench {
namespace {

class Raw final : public CodecUnderTest {
 public:
  Result<FrameCost> run(const BenchFrame& frame, bool, BenchFrame& decoded) override {
    decoded = frame;
    return FrameCost{frame.depth_mm.view().pixel_count() * sizeof(std::uint16_t),
                     frame.color.view().pixel_count() * sizeof(Rgb8)};
  }
};

}  // namespace

PeerResult make_raw(const BenchPicture&) {
  return std::unique_ptr<CodecUnderTest>(std::make_unique<Raw>());
}

}  // namespace roomcast::bench
