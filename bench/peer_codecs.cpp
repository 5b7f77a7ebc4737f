// SPDX-License-Identifier: Apache-2.0
#include <ctime>

#include <zlib.h>

#include "bench/codec_under_test.h"
#include "bench/rvl.h"

namespace roomcast::bench {
namespace {

constexpr int kPaperLevel = 6;  // zlib's default

template <class T>
std::span<const T> pixels_of(const Image<T>& image) {
  return {image.data(), image.view().pixel_count()};
}

class Raw final : public CodecUnderTest {
 public:
  std::string name() const override { return "raw"; }
  std::string mode() const override { return "lossless"; }
  Result<FrameCost> run(const BenchFrame& frame, BenchFrame& decoded) override {
    decoded = frame;
    FrameCost cost;
    cost.depth_bytes = pixels_of(frame.depth_mm).size_bytes();
    cost.color_bytes = pixels_of(frame.color).size_bytes();
    return cost;
  }
};

class Rvl final : public CodecUnderTest {
 public:
  std::string name() const override { return "rvl"; }
  std::string mode() const override { return "lossless"; }
  Result<FrameCost> run(const BenchFrame& frame, BenchFrame& decoded) override {
    decoded.depth_mm.resize(frame.depth_mm.width(), frame.depth_mm.height());
    bytes_.clear();
    const double start = thread_cpu_ms();
    encode_rvl(pixels_of(frame.depth_mm), bytes_);
    const double encoded = thread_cpu_ms();
    decode_rvl(bytes_, {decoded.depth_mm.data(), decoded.depth_mm.view().pixel_count()});
    FrameCost cost;
    cost.depth_bytes = bytes_.size();
    cost.encode_ms = cost.depth_encode_ms = encoded - start;
    cost.decode_ms = cost.depth_decode_ms = thread_cpu_ms() - encoded;
    return cost;
  }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// Bytes and times of one picture.
struct Deflated {
  std::size_t bytes = 0;
  double encode_ms = 0, decode_ms = 0;
};

class Gzip final : public CodecUnderTest {
 public:
  std::string name() const override { return "gzip"; }
  std::string mode() const override { return "lossless"; }
  Result<FrameCost> run(const BenchFrame& frame, BenchFrame& decoded) override {
    const auto depth = deflate_and_inflate(frame.depth_mm, decoded.depth_mm);
    if (!depth.ok()) return depth.error();
    const auto color = deflate_and_inflate(frame.color, decoded.color);
    if (!color.ok()) return color.error();
    decoded.seen = frame.seen;
    FrameCost cost{depth->bytes, color->bytes};
    cost.depth_encode_ms = depth->encode_ms;
    cost.depth_decode_ms = depth->decode_ms;
    cost.encode_ms = depth->encode_ms + color->encode_ms;
    cost.decode_ms = depth->decode_ms + color->decode_ms;
    return cost;
  }

 private:
  template <class T>
  Result<Deflated> deflate_and_inflate(const Image<T>& in, Image<T>& out) {
    if (in.empty()) return Deflated{};
    const std::size_t raw = pixels_of(in).size_bytes();
    bytes_.resize(compressBound(raw));
    uLongf packed = bytes_.size();
    const double start = thread_cpu_ms();
    int code = compress2(bytes_.data(), &packed, reinterpret_cast<const Bytef*>(in.data()), raw,
                         kPaperLevel);
    const double encoded = thread_cpu_ms();
    out.resize(in.width(), in.height());
    uLongf unpacked = raw;
    if (code == Z_OK) {
      code = uncompress(reinterpret_cast<Bytef*>(out.data()), &unpacked, bytes_.data(), packed);
    }
    if (code != Z_OK) return Error{ErrorCode::kUnavailable, "zlib failed to pack a picture."};
    return Deflated{packed, encoded - start, thread_cpu_ms() - encoded};
  }

  std::vector<std::uint8_t> bytes_;
};

}  // namespace

double thread_cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

std::unique_ptr<CodecUnderTest> make_raw() {
  return std::make_unique<Raw>();
}
std::unique_ptr<CodecUnderTest> make_gzip() {
  return std::make_unique<Gzip>();
}
std::unique_ptr<CodecUnderTest> make_rvl() {
  return std::make_unique<Rvl>();
}

}  // namespace roomcast::bench
