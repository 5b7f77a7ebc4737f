// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include "bench/codec/cpu_stopwatch.h"
#include "bench/codec/peers/peers.h"
#include "roomcast/io/jpeg_codec.h"

namespace roomcast::bench {
namespace {

class Jpeg final : public CodecUnderTest {
 public:
  explicit Jpeg(int quality) : quality_(quality) {}

  Result<FrameCost> run(const BenchFrame& frame, bool, BenchFrame& decoded) override {
    fill(frame);
    const CpuStopwatch encoding;
    std::string fault = jpeg_.encode(filled_, quality_, file_);
    const double encode_ms = encoding.ms();
    decoded.color.resize(frame.color.width(), frame.color.height());
    const CpuStopwatch decoding;
    if (fault.empty()) fault = jpeg_.decode(file_, decoded.color.view());
    if (!fault.empty()) return Error{ErrorCode::kUnavailable, "libjpeg: " + fault};
    decoded.seen = frame.seen;
    return FrameCost{0, file_.size(), encode_ms, decoding.ms()};
  }

 private:
  void fill(const BenchFrame& frame) {
    if (filled_.empty()) filled_ = frame.color;
    for (std::size_t i = 0; i < frame.seen.view().pixel_count(); ++i) {
      if (frame.seen.data()[i]) filled_.data()[i] = frame.color.data()[i];
    }
  }

  const int quality_;
  io::JpegCodec jpeg_;
  ColorImage filled_;
  std::vector<std::uint8_t> file_;
};

}  // namespace

PeerResult make_jpeg(const BenchPicture&, int quality) {
  return std::unique_ptr<CodecUnderTest>(std::make_unique<Jpeg>(quality));
}

}  // namespace roomcast::bench
