// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/codec_choice.h"

#include <algorithm>

#include <fmt/format.h>

#include "bench/codec/peers/peers.h"
#include "bench/codec/roomcast_codec.h"

namespace roomcast::bench {
namespace {

constexpr int kAv1Quality = 10;  // even finer levels smear edges
constexpr int kJpegQuality = 85;

CodecChoice near_lossless(int bound_mm) {
  return {"roomcast", "near-" + std::to_string(bound_mm) + "mm", false, bound_mm,
          [bound_mm](const BenchPicture& picture) {
            return make_roomcast_near_lossless(picture, bound_mm);
          }};
}

CodecChoice at_rate(double mbit_per_s) {
  return {"roomcast",
          fmt::format("live+color at {:g} Mbit/s", mbit_per_s),
          true,
          {},
          [mbit_per_s](const BenchPicture& picture) {
            return make_roomcast_live_at_rate(picture, mbit_per_s);
          }};
}

}  // namespace

std::vector<CodecChoice> codec_choices(const std::string& only,
                                       const std::vector<double>& target_mbit) {
  std::vector<CodecChoice> choices = {
      {"raw", "lossless", false, 0, make_raw},
      {"gzip", "lossless", false, 0, make_gzip},
      {"zstd", "lossless", false, 0, make_zstd},
      {"png16", "lossless", false, 0, make_png16},
      {"rvl", "lossless", false, 0, make_rvl},
      {"roomcast", "lossless", false, 0, make_roomcast_lossless},
      near_lossless(1),
      near_lossless(2),
      near_lossless(5),
      {"temporal-rvl",
       "10mm",
       false,
       {},
       [](const BenchPicture& picture) { return make_temporal_rvl(picture, 10); }},
      {"av1",
       "depth",
       false,
       {},
       [](const BenchPicture& picture) { return make_av1_depth(picture, kAv1Quality); }},
      {"roomcast", "live", false, {}, make_roomcast_live},
      {"jpeg",
       "color",
       true,
       {},
       [](const BenchPicture& picture) { return make_jpeg(picture, kJpegQuality); }},
      {"h264", "color", true, {}, make_h264_color},
      {"roomcast", "color", true, {}, make_roomcast_color},
      {"roomcast", "live+color", true, {}, make_roomcast_live_with_color},
  };
  for (const double mbit : target_mbit) choices.push_back(at_rate(mbit));
  if (only.empty()) return choices;
  choices.erase(std::remove_if(choices.begin(), choices.end(),
                               [&](const CodecChoice& choice) {
                                 return choice.codec != only && !choice.mode.starts_with(only);
                               }),
                choices.end());
  return choices;
}

}  // namespace roomcast::bench
