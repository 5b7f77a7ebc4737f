// SPDX-License-Identifier: Apache-2.0
#include "roomcast/voice/jitter_buffer.h"

#include <cstdlib>
#include <utility>

namespace roomcast::voice {
namespace {

constexpr std::int64_t kFarApart = 25;  // packets: others were nearer meanwhile, or it began anew

}  // namespace

/// Numbers on the wire begin again after 2^32.
std::int64_t JitterBuffer::unwrapped(std::uint32_t seq) const {
  if (!newest_) return seq;
  const auto step = static_cast<std::int32_t>(seq - static_cast<std::uint32_t>(*newest_));
  return *newest_ + step;
}

void JitterBuffer::push(SpokenBlock block, nanoseconds now) {
  std::int64_t number = unwrapped(block.seq);
  if (newest_ && std::abs(number - *newest_) > kFarApart) {
    restart();
    number = block.seq;
  }
  delay_.arrived(block.capture, now);
  if (is_playing_ && number < next_) {
    ++figures_.skipped;
    return;
  }
  newest_ = newest_ ? std::max(*newest_, number) : number;
  waiting_.insert_or_assign(number, std::move(block));
  if (waiting_.size() > kMaxWaiting) skip_first();
}

/// Beyond the shortest way.
double JitterBuffer::late_ms(nanoseconds capture, nanoseconds now) const {
  return std::chrono::duration<double, std::milli>(now - capture).count() - delay_.shortest_ms();
}

void JitterBuffer::skip_first() {
  const auto first = waiting_.begin();
  if (is_playing_) next_ = first->first + 1;
  waiting_.erase(first);
  ++figures_.skipped;
}

void JitterBuffer::restart() {
  figures_.skipped += waiting_.size();
  waiting_.clear();
  newest_.reset();
  is_playing_ = false;
}

/// Begins when the first packet has waited for its target.
bool JitterBuffer::begin(nanoseconds now) {
  if (waiting_.empty()) return false;
  if (late_ms(waiting_.begin()->second.capture, now) < delay_.target_ms()) return false;
  next_ = waiting_.begin()->first;
  is_playing_ = true;
  concealed_ = 0;
  decoder_.restart();
  return true;
}

std::optional<JitterBuffer::Block> JitterBuffer::pull(nanoseconds now) {
  while (waiting_.size() > 1 &&
         late_ms(waiting_.begin()->second.capture, now) > delay_.target_ms() + kMaxBehind_ms)
    skip_first();
  if (!is_playing_ && !begin(now)) return std::nullopt;
  const auto found = waiting_.find(next_);
  if (found == waiting_.end()) return conceal();
  Block out{};
  decoder_.decode(found->second.opus, out);
  if (found->second.ends) is_playing_ = false;
  waiting_.erase(found);
  ++next_;
  concealed_ = 0;
  ++figures_.played;
  return out;
}

/// A packet that is missing, although a later one is there, is lost; else it may still come, and
/// what is heard meanwhile adds to its delay.
std::optional<JitterBuffer::Block> JitterBuffer::conceal() {
  if (++concealed_ > kMaxConcealed) {
    is_playing_ = false;
    return std::nullopt;
  }
  if (!waiting_.empty()) ++next_;
  Block out{};
  decoder_.conceal(out);
  ++figures_.concealed;
  return out;
}

}  // namespace roomcast::voice
