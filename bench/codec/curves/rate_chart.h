// SPDX-License-Identifier: Apache-2.0
// A chart of what codecs lose over the rate that they take, as SVG: the error of depth that stands
// still, the error of depth that moves, and PSNR of colour, each over Mbit/s of its own part of the
// stream, on a logarithmic axis. Pure.
#pragma once

#include <string>
#include <vector>

#include "bench/codec/codec_bench.h"

namespace roomcast::bench {

struct RatePoint {
  double mbit_per_s = 0, value = 0;
};

/// One codec at several qualities, by rate.
struct RateCurve {
  std::string name;
  std::vector<RatePoint> points;
};

struct RatePanel {
  std::string title, unit;
  std::vector<RateCurve> curves;
};

/// The panels of a report whose rows have curves. Rates are those of the input's frame rate. A
/// panel without a figure is left out.
[[nodiscard]] std::vector<RatePanel> rate_panels(const CodecBenchReport& report);

/// One SVG document. `caption` says what was measured.
[[nodiscard]] std::string rate_chart(const std::vector<RatePanel>& panels,
                                     const std::string& caption);

}  // namespace roomcast::bench
