// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/voices/voice_mix.h"

#include <algorithm>

namespace roomcast::recording {

namespace {

constexpr std::int64_t kBlock = voice::kPacketSamples;

}  // namespace

std::vector<float>& VoiceMix::block(std::int64_t number) {
  auto& block = blocks_[number];
  block.resize(static_cast<std::size_t>(kBlock * channels_));
  return block;
}

void VoiceMix::add(std::int64_t at, std::span<const float> samples, const Gains& gains) {
  const std::int64_t from = std::max(at, next_block_ * kBlock);
  const std::int64_t to = at + static_cast<std::int64_t>(samples.size());
  for (std::int64_t t = from; t < to;) {
    const std::int64_t number = t / kBlock;
    auto& sum = block(number);
    for (const std::int64_t end = std::min(to, (number + 1) * kBlock); t < end; ++t) {
      for (int channel = 0; channel < channels_; ++channel) {
        sum[static_cast<std::size_t>((t - number * kBlock) * channels_ + channel)] +=
            gains[static_cast<std::size_t>(channel)] * samples[static_cast<std::size_t>(t - at)];
      }
    }
  }
}

void VoiceMix::give_until(std::int64_t until) {
  const std::int64_t end = until / kBlock;
  while (next_block_ < end) {
    const auto found = blocks_.begin();
    const std::int64_t sounding = found == blocks_.end() ? end : std::min(found->first, end);
    if (sounding > next_block_) {
      out_.silence((sounding - next_block_) * kBlock * channels_);
      next_block_ = sounding;
      continue;
    }
    out_.sound(found->second);
    blocks_.erase(found);
    ++next_block_;
  }
}

void VoiceMix::finish(std::int64_t end) {
  give_until(end);
  const std::int64_t rest = (end - next_block_ * kBlock) * channels_;
  if (rest <= 0) return;
  const auto found = blocks_.find(next_block_);
  if (found == blocks_.end()) return out_.silence(rest);
  out_.sound(std::span(found->second).first(static_cast<std::size_t>(rest)));
}

}  // namespace roomcast::recording
