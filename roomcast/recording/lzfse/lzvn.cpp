// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/lzfse/lzvn.h"

namespace roomcast::recording {
namespace {

constexpr std::uint8_t kEnd = 0x06;
constexpr std::size_t kShortestMatch = 3, kLongCountStart = 16;

struct LzvnStep {
  std::size_t opcode_bytes = 1, literals = 0, match = 0;
  std::size_t distance = 0;  // 0: that of the match before
  bool is_known = true;
};

bool has_bytes(std::span<const std::uint8_t> payload, std::size_t count) {
  return payload.size() >= count;
}

/// LLMMMxxx: up to three literals and a match of up to ten bytes; the distance follows.
LzvnStep short_match(std::span<const std::uint8_t> payload) {
  const std::size_t opcode = payload[0];
  LzvnStep step{1, opcode >> 6U, (opcode >> 3U & 7U) + kShortestMatch, 0, true};
  const std::size_t kind = opcode & 7U;
  if (kind == 6) return step;
  step.opcode_bytes = kind == 7 ? 3 : 2;
  step.is_known = has_bytes(payload, step.opcode_bytes);
  if (!step.is_known) return step;
  step.distance = kind == 7 ? payload[1] | std::size_t{payload[2]} << 8U : kind << 8U | payload[1];
  step.is_known = step.distance > 0;
  return step;
}

/// 101LLMMM DDDDDDMM DDDDDDDD.
LzvnStep medium_match(std::span<const std::uint8_t> payload) {
  if (!has_bytes(payload, 3)) return {.is_known = false};
  const std::size_t opcode = payload[0], rest = payload[1] | std::size_t{payload[2]} << 8U;
  LzvnStep step{3, opcode >> 3U & 3U, ((opcode & 7U) << 2U | (rest & 3U)) + kShortestMatch,
                rest >> 2U, true};
  step.is_known = step.distance > 0;
  return step;
}

/// 111xCCCC, or 111x0000 and a byte: literals alone, or a match alone.
LzvnStep lone_count(std::span<const std::uint8_t> payload) {
  const std::size_t short_count = payload[0] & 15U;
  LzvnStep step;
  step.opcode_bytes = short_count > 0 ? 1 : 2;
  step.is_known = has_bytes(payload, step.opcode_bytes);
  if (!step.is_known) return step;
  const std::size_t count = short_count > 0 ? short_count : payload[1] + kLongCountStart;
  (payload[0] < 0xF0 ? step.literals : step.match) = count;
  return step;
}

LzvnStep step_of(std::span<const std::uint8_t> payload) {
  const std::uint8_t opcode = payload[0];
  if (opcode >= 0xE0) return lone_count(payload);
  if (opcode >= 0xA0 && opcode < 0xC0) return medium_match(payload);
  const bool is_undefined = (opcode >= 0x70 && opcode < 0x80) || opcode >= 0xD0;
  if (is_undefined) return {.is_known = false};
  if (opcode < 0x40 && (opcode & 7U) == 6) {
    const bool is_nothing = opcode == 0x0E || opcode == 0x16;
    return {.is_known = is_nothing};
  }
  return short_match(payload);
}

}  // namespace

bool decode_lzvn(std::span<const std::uint8_t> payload, LzOutput& out) {
  std::size_t distance = 0;
  while (!payload.empty() && payload[0] != kEnd) {
    const LzvnStep step = step_of(payload);
    if (!step.is_known || payload.size() < step.opcode_bytes + step.literals) return false;
    if (!out.append(payload.subspan(step.opcode_bytes, step.literals))) return false;
    payload = payload.subspan(step.opcode_bytes + step.literals);
    if (step.distance > 0) distance = step.distance;
    if (step.match > 0 && !out.repeat(distance, step.match)) return false;
  }
  return !payload.empty();
}

}  // namespace roomcast::recording
