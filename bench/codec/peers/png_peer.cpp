// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include "bench/codec/cpu_stopwatch.h"
#include "bench/codec/peers/peers.h"
#include "roomcast/io/png_codec.h"

namespace roomcast::bench {
namespace {

class Png16 final : public CodecUnderTest {
 public:
  Result<FrameCost> run(const BenchFrame& frame, bool, BenchFrame& decoded) override {
    file_.clear();
    const CpuStopwatch encoding;
    std::string fault = io::encode_depth_png(frame.depth_mm, file_);
    const double encode_ms = encoding.ms();
    decoded.depth_mm.resize(frame.depth_mm.width(), frame.depth_mm.height());
    const CpuStopwatch decoding;
    if (fault.empty()) fault = io::decode_depth_png(file_, decoded.depth_mm.view());
    if (!fault.empty()) return Error{ErrorCode::kUnavailable, "libpng: " + fault};
    return FrameCost{file_.size(), 0, encode_ms, decoding.ms()};
  }

 private:
  std::vector<std::uint8_t> file_;
};

}  // namespace

PeerResult make_png16(const BenchPicture&) {
  return std::unique_ptr<CodecUnderTest>(std::make_unique<Png16>());
}

}  // namespace roomcast::bench
