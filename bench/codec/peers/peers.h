// SPDX-License-Identifier: Apache-2.0
// Peers for comparison with roomcast's codec. Each peer is one way in which other systems send
// depth or colour, with settings for live video. All libraries have permissive licences
// (docs/adr/0007).
#pragma once

#include <memory>

#include "bench/codec/codec_under_test.h"

namespace roomcast::bench {

using PeerResult = Result<std::unique_ptr<CodecUnderTest>>;

// Depth and colour.
PeerResult make_raw(const BenchPicture& picture);   // depth as u16, colour as 8-bit RGB
PeerResult make_gzip(const BenchPicture& picture);  // as in the paper: zlib, level 6

// Depth only, lossless.
PeerResult make_zstd(const BenchPicture& picture);  // level 3
PeerResult make_png16(
    const BenchPicture& picture);  // 16-bit grey, filters as libpng likes, level 1
PeerResult make_rvl(const BenchPicture& picture);

// Depth only, lossy.
/// No change above `max_error_mm` is lost.
PeerResult make_temporal_rvl(const BenchPicture& picture, int max_error_mm);
/// AV1, 12 bit grey. Holes are filled with the previous values; the validity mask is packed by zstd
/// and included in the size. Real-time settings, constant quality: 0, the finest, to 63.
PeerResult make_av1_depth(const BenchPicture& picture, int quality);
/// Draco's points (k-d tree, each frame coded independently) in steps of `step_mm`.
PeerResult make_draco_depth(const BenchPicture& picture, int step_mm);

// Colour only, 4:2:0. Unseen pixels are filled with the previous values.
/// Each frame coded independently; quality 1 to 100, the finest.
PeerResult make_jpeg(const BenchPicture& picture, int quality);
PeerResult make_h264_color(const BenchPicture& picture);  // OpenH264 at the picture's rate

}  // namespace roomcast::bench
