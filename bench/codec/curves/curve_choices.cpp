// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/curves/curve_choices.h"

#include <fmt/format.h>

#include "bench/codec/peers/peers.h"
#include "bench/codec/roomcast_codec.h"

namespace roomcast::bench {
namespace {

using Make = Result<std::unique_ptr<CodecUnderTest>> (*)(const BenchPicture&);

constexpr int kAllBounds_mm[] = {1, 2, 5, 10};
constexpr int kTemporalRvl_mm[] = {5, 10, 20, 40};
constexpr int kDracoSteps_mm[] = {1, 5, 20};
constexpr int kAv1Qualities[] = {4, 10, 20, 30, 45, 60};
constexpr int kJpegQualities[] = {30, 60, 85, 95};
constexpr int kColorKbit[] = {100, 200, 400, 800, 1600, 3200};
constexpr double kTargets_mbit[] = {0.5, 0.7, 1, 1.5, 2, 3, 5};

CodecChoice at_color_rate(const char* codec, const char* curve, int kbit_per_s, Make make) {
  return {.codec = codec,
          .mode = fmt::format("color at {} kbit/s", kbit_per_s),
          .needs_color = true,
          .bound_mm = {},
          .make =
              [=](BenchPicture picture) {
                picture.color_kbit_per_s = kbit_per_s;
                return make(picture);
              },
          .curve = curve};
}

template <class Quality>
CodecChoice at_quality(const char* codec, std::string mode, bool needs_color, const char* curve,
                       PeerResult (*make)(const BenchPicture&, Quality), Quality quality) {
  return {.codec = codec,
          .mode = std::move(mode),
          .needs_color = needs_color,
          .bound_mm = {},
          .make = [=](const BenchPicture& picture) { return make(picture, quality); },
          .curve = curve};
}

}  // namespace

std::vector<CodecChoice> curve_choices() {
  std::vector<CodecChoice> choices;
  for (const double mbit : kTargets_mbit) {
    choices.push_back(at_quality("roomcast", fmt::format("live+color at {:g} Mbit/s", mbit), true,
                                 "roomcast live", make_roomcast_live_at_rate, mbit));
  }
  for (const int bound_mm : kAllBounds_mm) {
    choices.push_back(at_quality("roomcast", fmt::format("near-{}mm", bound_mm), false,
                                 "roomcast near-lossless", make_roomcast_near_lossless, bound_mm));
  }
  choices.push_back(
      {"roomcast", "lossless", false, 0, make_roomcast_lossless, "roomcast near-lossless"});
  for (const int quality : kAv1Qualities) {
    choices.push_back(at_quality("av1", fmt::format("depth at quality {}", quality), false,
                                 "AV1, 12 bit", make_av1_depth, quality));
  }
  for (const int most_mm : kTemporalRvl_mm) {
    choices.push_back(at_quality("temporal-rvl", fmt::format("{}mm", most_mm), false,
                                 "temporal RVL", make_temporal_rvl, most_mm));
  }
  choices.push_back({"rvl", "lossless", false, 0, make_rvl, "RVL"});
  for (const int step_mm : kDracoSteps_mm) {
    choices.push_back(at_quality("draco", fmt::format("points of {}mm", step_mm), false, "Draco",
                                 make_draco_depth, step_mm));
  }
  for (const int kbit : kColorKbit) {
    choices.push_back(
        at_color_rate("roomcast", "roomcast colour alone (VP9)", kbit, make_roomcast_color));
  }
  for (const int kbit : kColorKbit)
    choices.push_back(at_color_rate("h264", "H.264", kbit, make_h264_color));
  for (const int quality : kJpegQualities) {
    choices.push_back(at_quality("jpeg", fmt::format("color at quality {}", quality), true, "JPEG",
                                 make_jpeg, quality));
  }
  return choices;
}

}  // namespace roomcast::bench
