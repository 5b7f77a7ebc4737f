// SPDX-License-Identifier: Apache-2.0
// The codecs of `roomcast bench codec`, in the order of its rows.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/codec/codec_under_test.h"

namespace roomcast::bench {

struct CodecChoice {
  std::string codec, mode;
  bool needs_color = false;
  std::optional<int> bound_mm;  // maximum error of any pixel, with exact validity; 0: lossless
  std::function<Result<std::unique_ptr<CodecUnderTest>>(const BenchPicture&)> make;
  std::string curve = {};  // of which this is a point in the chart of --curves; empty: of none
};

/// All codecs, or those whose codec is `only` or whose mode begins with it. Besides fixed qualities
/// those with the given target rates, in Mbit/s: "live+color at 2 Mbit/s".
[[nodiscard]] std::vector<CodecChoice> codec_choices(const std::string& only = "",
                                                     const std::vector<double>& target_mbit = {});

}  // namespace roomcast::bench
