// SPDX-License-Identifier: Apache-2.0
// A recording as an input of `roomcast bench codec`: looks a few frames ahead, so that colour can
// be compared with its denoised self.
#pragma once

#include <filesystem>

#include "bench/codec/bench_input.h"

namespace roomcast::bench {

/// `source` as open_source takes it; `truth` is the folder of %06d.png by the recording's frame
/// numbers, which need not exist.
[[nodiscard]] Result<std::unique_ptr<BenchInput>> open_recorded_input(
    const std::string& source, const std::filesystem::path& truth);

}  // namespace roomcast::bench
