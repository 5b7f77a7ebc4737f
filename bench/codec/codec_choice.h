// SPDX-License-Identifier: Apache-2.0
// The codecs that `roomcast bench codec` knows, in the order of its rows.
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
  std::optional<int> bound_mm;  // no pixel may be off by more, validity exact; 0: without loss
  std::function<Result<std::unique_ptr<CodecUnderTest>>(const BenchPicture&)> make;
};

/// All, or those whose codec or mode is `only`.
[[nodiscard]] std::vector<CodecChoice> codec_choices(const std::string& only = "");

}  // namespace roomcast::bench
