// SPDX-License-Identifier: Apache-2.0
#include <span>
#include <vector>

#include <zlib.h>
#include <zstd.h>

#include "bench/codec/cpu_stopwatch.h"
#include "bench/codec/peers/peers.h"

namespace roomcast::bench {
namespace {

constexpr int kPaperLevel = 6;  // zlib's default
constexpr int kZstdLevel = 3;   // zstd's default

using Bytes = std::vector<std::uint8_t>;

template <class T>
std::span<const std::uint8_t> bytes_of(const Image<T>& image) {
  return {reinterpret_cast<const std::uint8_t*>(image.data()),
          image.view().pixel_count() * sizeof(T)};
}

struct Zlib {
  static bool pack(std::span<const std::uint8_t> in, Bytes& out) {
    out.resize(compressBound(in.size()));
    uLongf length = out.size();
    const bool ok = compress2(out.data(), &length, in.data(), in.size(), kPaperLevel) == Z_OK;
    out.resize(length);
    return ok;
  }
  static bool unpack(const Bytes& in, std::uint8_t* out, std::size_t length) {
    uLongf written = length;
    return uncompress(out, &written, in.data(), in.size()) == Z_OK && written == length;
  }
};

struct Zstd {
  static bool pack(std::span<const std::uint8_t> in, Bytes& out) {
    out.resize(ZSTD_compressBound(in.size()));
    const std::size_t length =
        ZSTD_compress(out.data(), out.size(), in.data(), in.size(), kZstdLevel);
    if (ZSTD_isError(length)) return false;
    out.resize(length);
    return true;
  }
  static bool unpack(const Bytes& in, std::uint8_t* out, std::size_t length) {
    return ZSTD_decompress(out, length, in.data(), in.size()) == length;
  }
};

/// Bytes and times of one picture.
struct Packed {
  std::size_t bytes = 0;
  double encode_ms = 0, decode_ms = 0;
};

template <class Method>
class BytePacker final : public CodecUnderTest {
 public:
  explicit BytePacker(bool with_color) : with_color_(with_color) {}

  Result<FrameCost> run(const BenchFrame& frame, bool, BenchFrame& decoded) override {
    const auto depth = pack_and_unpack(frame.depth_mm, decoded.depth_mm);
    if (!depth.ok()) return depth.error();
    if (!with_color_) return FrameCost{depth->bytes, 0, depth->encode_ms, depth->decode_ms};
    const auto color = pack_and_unpack(frame.color, decoded.color);
    if (!color.ok()) return color.error();
    decoded.seen = frame.seen;
    return FrameCost{depth->bytes, color->bytes, depth->encode_ms + color->encode_ms,
                     depth->decode_ms + color->decode_ms};
  }

 private:
  template <class T>
  Result<Packed> pack_and_unpack(const Image<T>& in, Image<T>& out) {
    if (in.empty()) return Packed{};
    const CpuStopwatch encoding;
    bool ok = Method::pack(bytes_of(in), packed_);
    const double encode_ms = encoding.ms();
    out.resize(in.width(), in.height());
    const CpuStopwatch decoding;
    ok = ok &&
         Method::unpack(packed_, reinterpret_cast<std::uint8_t*>(out.data()), bytes_of(in).size());
    if (!ok) return Error{ErrorCode::kUnavailable, "A picture could not be packed."};
    return Packed{packed_.size(), encode_ms, decoding.ms()};
  }

  bool with_color_;
  Bytes packed_;
};

}  // namespace

PeerResult make_gzip(const BenchPicture&) {
  return std::unique_ptr<CodecUnderTest>(std::make_unique<BytePacker<Zlib>>(true));
}
PeerResult make_zstd(const BenchPicture&) {
  return std::unique_ptr<CodecUnderTest>(std::make_unique<BytePacker<Zstd>>(false));
}

}  // namespace roomcast::bench
