// SPDX-License-Identifier: Apache-2.0
// The project's own codec modes for `roomcast bench codec`: whole payloads of docs/spec/codec.md
// through FrameEncoder and FrameDecoder.
#pragma once

#include <memory>

#include "bench/codec/codec_under_test.h"

namespace roomcast::bench {

// Depth only.
Result<std::unique_ptr<CodecUnderTest>> make_roomcast_lossless(const BenchPicture& picture);
/// No reading is off by more than `bound_mm`.
Result<std::unique_ptr<CodecUnderTest>> make_roomcast_near_lossless(const BenchPicture& picture,
                                                                    int bound_mm);
Result<std::unique_ptr<CodecUnderTest>> make_roomcast_live(const BenchPicture& picture);

/// The default of `roomcast sensor`: depth and colour in one payload, two temporal layers.
Result<std::unique_ptr<CodecUnderTest>> make_roomcast_live_with_color(const BenchPicture& picture);

/// The same with a target rate, as `roomcast sensor --mbit` without its control of the frame rate.
Result<std::unique_ptr<CodecUnderTest>> make_roomcast_live_at_rate(const BenchPicture& picture,
                                                                   double mbit_per_s);

/// Colour only: VP9 at the picture's rate. (The mask needs depth, and counts as depth where both
/// are measured.)
Result<std::unique_ptr<CodecUnderTest>> make_roomcast_color(const BenchPicture& picture);

}  // namespace roomcast::bench
