// SPDX-License-Identifier: Apache-2.0
// Random live depth sections that cover the whole format, unlike an encoder's: all block modes,
// labels, candidates, steps from small to extreme. The same bytes on every machine. Used by tests,
// golden files and fuzz seeds only.
#pragma once

#include <random>
#include <vector>

#include "roomcast/codec/live/live_section.h"
#include "roomcast/codec/live/picture_pass.h"
#include "roomcast/core/little_endian.h"

namespace roomcast::codec {

class RandomLiveStream {
 public:
  RandomLiveStream(int width, int height, std::uint32_t seed) : random_(seed) {
    state_.resize(width, height);
    scratch_.resize(state_);
  }

  /// Returns a section's bytes. The first one must be a key frame.
  std::vector<std::uint8_t> next(bool key, bool reference) {
    LiveSectionHead head{key, key || reference, any_step(), any_step(), {}};
    for (std::uint8_t& code : head.sigma) code = static_cast<std::uint8_t>(40 + random_() % 60);
    std::vector<std::uint8_t> section;
    write_live_head(head, section);
    LiveWriter writer(section);
    if (key) {
      state_.begin_anew(head.sigma);
      write_pass(writer, state_.contexts, head.key_step, true);
      state_.remember_picture_as_background();
    }
    LiveContexts passing = state_.contexts;
    scratch_.shown_mm = state_.picture_mm;
    const std::uint32_t hash =
        write_pass(writer, head.reference ? state_.contexts : passing, head.step, head.reference);
    writer.finish();
    write_u32(&section[kLiveHashOffset], hash);
    shown_mm_ = head.reference ? state_.picture_mm : scratch_.shown_mm;
    return section;
  }
  /// The depth that a decoder shows for the newest section.
  [[nodiscard]] const std::vector<std::uint16_t>& shown_mm() const { return shown_mm_; }

 private:
  using Pass = PicturePass<LiveWriter>;

  std::uint8_t any_step() { return static_cast<std::uint8_t>(4 + random_() % 252); }

  std::uint32_t write_pass(LiveWriter& writer, LiveContexts& contexts, int step, bool reference) {
    Pass pass(state_, scratch_, contexts, writer, step, reference, scratch_.shown_mm.data());
    state_.grid.for_each_block([&](const BlockView& here) {
      BlockCode code = any_block(pass, here);
      pass.block(here, code);
    });
    pass.finish();
    return pass.hash();
  }

  BlockCode any_block(const Pass& pass, const BlockView& here) {
    BlockCode code;
    const auto dice = random_() % 10;
    code.mode = dice < 4   ? BlockMode::kSkip
                : dice < 8 ? BlockMode::kLabels
                : dice < 9 ? BlockMode::kRefine
                           : BlockMode::kRaw;
    fill_steps(code.refinement);
    std::uint16_t reading = 1000;
    for (std::uint16_t& level : code.readings) {
      reading = static_cast<std::uint16_t>(reading + random_() % 41 - 20);
      level = random_() % 8 ? reading : static_cast<std::uint16_t>(random_() % 3 * 32767);
    }
    code.surface_count = static_cast<std::uint8_t>(random_() % 3);
    for (std::size_t which = 0; which < 2; ++which) choose_surface(pass, here, which, code);
    here.for_each_pixel([&](const BlockPixel& p) { code.labels[p.k] = any_label(p.at, code); });
    return code;
  }

  void choose_surface(const Pass& pass, const BlockView& here, std::size_t which, BlockCode& code) {
    SurfaceCode& surface = code.surfaces[which];
    fill_steps(surface.steps);
    surface.finer = static_cast<std::uint8_t>(random_() % 3);
    const SurfaceCandidates candidates = pass.candidates(here, which);
    for (std::uint8_t i = 0; i < kSurfaceCandidates; ++i) {
      if (candidates[i].known && (!candidates[surface.candidate].known || random_() % 2)) {
        surface.candidate = i;
      }
    }
  }

  // Mostly a few small coefficients, sometimes nearly all, sometimes the largest values.
  void fill_steps(BlockCoefficients& steps) {
    const auto count = random_() % 16 ? random_() % 10 : 63u;
    for (std::uint32_t i = 0; i < count; ++i) {
      steps[kZigzag[i]] = static_cast<std::int32_t>(random_() % 9) - 4;
    }
    if (random_() % 2) steps[0] = static_cast<std::int32_t>(random_() % 900);
    if (random_() % 64 == 0) steps[kZigzag[random_() % 63]] = 1 << (10 + random_() % 9);
  }

  PixelLabel any_label(std::size_t at, const BlockCode& code) {
    const int old = state_.picture[at], back = state_.background[at];
    const auto dice = random_() % 6;
    if (dice < 2 && code.surface_count > 0) return PixelLabel::kFirst;
    if (dice == 2 && code.surface_count > 1) return PixelLabel::kSecond;
    if (dice == 3 && back != 0 && back != old) return PixelLabel::kBackground;
    if (dice == 4 && old != 0) return PixelLabel::kVanished;
    return PixelLabel::kUnchanged;
  }

  std::mt19937 random_;
  LiveState state_;
  PassScratch scratch_;
  std::vector<std::uint16_t> shown_mm_;
};

}  // namespace roomcast::codec
