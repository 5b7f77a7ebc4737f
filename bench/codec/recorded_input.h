// SPDX-License-Identifier: Apache-2.0
// A recording as an input of `roomcast bench codec`. Reads a few frames ahead, so that colour can
// be compared with denoised colour.
#pragma once

#include <filesystem>

#include "bench/codec/bench_input.h"

namespace roomcast::bench {

/// `source` is a source for open_source. `truth` is the folder of %06d.png, numbered like the
/// recording's frames; it may be missing.
[[nodiscard]] Result<std::unique_ptr<BenchInput>> open_recorded_input(
    const std::string& source, const std::filesystem::path& truth);

}  // namespace roomcast::bench
