// SPDX-License-Identifier: Apache-2.0
// What roomcast's codec is measured beside. Each peer is one way in which others send depth or
// colour, with settings that suit a live picture. All libraries are under permissive licences
// (docs/adr/0007).
#pragma once

#include <memory>

#include "bench/codec/codec_under_test.h"

namespace roomcast::bench {

using PeerResult = Result<std::unique_ptr<CodecUnderTest>>;

// Depth and colour.
PeerResult make_raw(const BenchPicture& picture);   // depth as u16, colour as 8-bit RGB
PeerResult make_gzip(const BenchPicture& picture);  // what the paper sends: zlib, level 6

// Depth alone, without loss.
PeerResult make_zstd(const BenchPicture& picture);  // level 3
PeerResult make_png16(
    const BenchPicture& picture);  // 16-bit grey, filters as libpng likes, level 1
PeerResult make_rvl(const BenchPicture& picture);

// Depth alone, with loss.
PeerResult make_temporal_rvl(const BenchPicture& picture);  // 10 mm
/// AV1, 12 bit grey, holes filled with what was there before; the validity mask is packed by zstd
/// and counts. Real-time settings, constant quality.
PeerResult make_av1_depth(const BenchPicture& picture);

// Colour alone, 4:2:0, pixels that are not seen filled with what was there before.
PeerResult make_jpeg(const BenchPicture& picture);        // quality 85, each frame by itself
PeerResult make_h264_color(const BenchPicture& picture);  // OpenH264 at the picture's rate

}  // namespace roomcast::bench
