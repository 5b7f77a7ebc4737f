// SPDX-License-Identifier: Apache-2.0
// One codec as `roomcast bench codec` sees it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"

namespace roomcast::bench {

/// Depth, and colour in its grid with a mask; the latter two are empty or there both.
struct BenchFrame {
  DepthImage depth_mm;
  ColorImage color;
  MaskImage seen;
};

/// Bytes and CPU milliseconds of one frame.
struct FrameCost {
  std::size_t depth_bytes = 0, color_bytes = 0;
  double encode_ms = 0, decode_ms = 0;
  double depth_encode_ms = 0, depth_decode_ms = 0;
};

class CodecUnderTest {
 public:
  virtual ~CodecUnderTest() = default;
  [[nodiscard]] virtual std::string name() const = 0;
  [[nodiscard]] virtual std::string mode() const = 0;
  /// Encodes and decodes one frame. `decoded.color` stays empty where the codec carries no colour.
  virtual Result<FrameCost> run(const BenchFrame& frame, BenchFrame& decoded) = 0;
};

/// CPU time of the calling thread, milliseconds.
[[nodiscard]] double thread_cpu_ms();

[[nodiscard]] std::unique_ptr<CodecUnderTest> make_raw();
[[nodiscard]] std::unique_ptr<CodecUnderTest> make_gzip();
[[nodiscard]] std::unique_ptr<CodecUnderTest> make_rvl();
/// Options as in CodecBenchOptions.
[[nodiscard]] Result<std::unique_ptr<CodecUnderTest>> make_roomcast(int width, int height,
                                                                    double fps,
                                                                    int color_kbit_per_s);

}  // namespace roomcast::bench
