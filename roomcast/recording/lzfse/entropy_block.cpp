// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/lzfse/entropy_block.h"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "roomcast/core/little_endian.h"

namespace roomcast::recording {
namespace {

using ByteSpan = std::span<const std::uint8_t>;

constexpr std::size_t kCountSymbols = 20, kDistanceSymbols = 64, kLiteralSymbols = 256;
constexpr std::uint32_t kCountStates = 64, kDistanceStates = 256, kLiteralStates = 1024;
constexpr std::size_t kFrequencies = 2 * kCountSymbols + kDistanceSymbols + kLiteralSymbols;
constexpr std::uint32_t kMaxLiterals = 40'000, kMaxMatches = 10'000;
constexpr std::size_t kHeadV1Bytes = 52 + 2 * kFrequencies, kHeadV2Bytes = 32;
constexpr std::uint32_t kMagicV1 = 0x31787662;  // "bvx1"

/// A symbol stands for a base value and as many more bits.
struct ValueCode {
  std::uint32_t base = 0;
  unsigned bits = 0;
};

template <std::size_t kCount>
constexpr std::array<ValueCode, kCount> codes_of(const std::array<unsigned, kCount>& bits) {
  std::array<ValueCode, kCount> codes{};
  std::uint32_t base = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    codes[i] = {base, bits[i]};
    base += 1U << bits[i];
  }
  return codes;
}

constexpr auto kLiteralCounts =
    codes_of<kCountSymbols>({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 3, 5, 8});
constexpr auto kMatchLengths =
    codes_of<kCountSymbols>({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 5, 8, 11});
constexpr auto kDistances = [] {
  std::array<unsigned, kDistanceSymbols> bits{};
  for (unsigned i = 0; i < kDistanceSymbols; ++i) bits[i] = i / 4;
  return codes_of(bits);
}();
static_assert(kLiteralCounts.back().base == 60 && kMatchLengths.back().base == 312 &&
              kDistances.back().base == 229'372);  // as in the reference

struct EntropyHead {
  std::size_t head_bytes = 0;
  std::uint32_t raw_bytes = 0, literals = 0, matches = 0;
  std::uint32_t literal_bytes = 0, match_bytes = 0;         // of the two parts
  unsigned literal_unused_bits = 0, match_unused_bits = 0;  // at their ends
  std::array<std::uint32_t, 4> literal_states{};
  std::uint32_t count_state = 0, length_state = 0, distance_state = 0;
  std::array<std::uint16_t, kFrequencies> frequencies{};

  [[nodiscard]] bool is_possible(std::size_t block_bytes) const {
    const bool has_states = std::ranges::all_of(
        literal_states, [](std::uint32_t state) { return state < kLiteralStates; });
    return has_states && count_state < kCountStates && length_state < kCountStates &&
           distance_state < kDistanceStates && literals <= kMaxLiterals && literals % 4 == 0 &&
           matches <= kMaxMatches && literal_unused_bits <= 7 && match_unused_bits <= 7 &&
           head_bytes + literal_bytes + match_bytes <= block_bytes;
  }
};

/// Bits `begin` to `begin + count` of a packed field.
std::uint32_t field(std::uint64_t packed, unsigned begin, unsigned count) {
  return static_cast<std::uint32_t>(packed >> begin & ((std::uint64_t{1} << count) - 1));
}

/// Frequencies in a code of 2 to 14 bits, the lowest bits first. False: damaged.
bool read_frequencies(ByteSpan bytes, std::array<std::uint16_t, kFrequencies>& frequencies) {
  std::uint32_t waiting = 0;
  unsigned count = 0;
  const auto take = [&](unsigned bits) {
    const std::uint32_t value = waiting & ((1U << bits) - 1);
    waiting >>= bits;
    count -= bits;
    return static_cast<std::uint16_t>(value);
  };
  for (std::uint16_t& frequency : frequencies) {
    for (; !bytes.empty() && count <= 24; bytes = bytes.subspan(1), count += 8)
      waiting |= std::uint32_t{bytes[0]} << count;
    // 00: 0, 10: 1, x01: 2 or 3, xx011: 4 to 7, xxxx0111: 8 and more, x..x1111: 24 and more.
    const std::uint32_t low = waiting & 15U;
    const unsigned bits = (low & 1U) == 0   ? 2
                          : (low & 2U) == 0 ? 3
                          : (low & 4U) == 0 ? 5
                          : low == 7        ? 8
                                            : 14;
    if (bits > count) return false;
    const std::uint16_t code = take(bits);
    switch (bits) {
      case 2:
        frequency = code >> 1U;
        break;
      case 3:
        frequency = 2 + (code >> 2U);
        break;
      case 5:
        frequency = 4 + (code >> 3U);
        break;
      default:
        frequency = static_cast<std::uint16_t>((bits == 8 ? 8 : 24) + (code >> 4U));
    }
  }
  return bytes.empty() && count < 8;
}

std::optional<EntropyHead> read_head_v1(ByteSpan bytes) {
  if (bytes.size() < kHeadV1Bytes) return std::nullopt;
  const std::uint8_t* const at = bytes.data();
  const auto unused = [](std::uint32_t bits) { return 0U - bits; };
  EntropyHead head;
  head.head_bytes = kHeadV1Bytes;
  head.raw_bytes = read_u32(at + 4);
  head.literals = read_u32(at + 12);
  head.matches = read_u32(at + 16);
  head.literal_bytes = read_u32(at + 20);
  head.match_bytes = read_u32(at + 24);
  head.literal_unused_bits = unused(read_u32(at + 28));
  for (std::size_t i = 0; i < 4; ++i) head.literal_states[i] = read_u16(at + 32 + 2 * i);
  head.match_unused_bits = unused(read_u32(at + 40));
  head.count_state = read_u16(at + 44);
  head.length_state = read_u16(at + 46);
  head.distance_state = read_u16(at + 48);
  for (std::size_t i = 0; i < kFrequencies; ++i) head.frequencies[i] = read_u16(at + 50 + 2 * i);
  return head;
}

std::optional<EntropyHead> read_head_v2(ByteSpan bytes) {
  if (bytes.size() < kHeadV2Bytes) return std::nullopt;
  const std::uint64_t a = read_u64(bytes.data() + 8), b = read_u64(bytes.data() + 16),
                      c = read_u64(bytes.data() + 24);
  EntropyHead head;
  head.raw_bytes = read_u32(bytes.data() + 4);
  head.literals = field(a, 0, 20);
  head.literal_bytes = field(a, 20, 20);
  head.matches = field(a, 40, 20);
  head.literal_unused_bits = 7 - field(a, 60, 3);
  for (unsigned i = 0; i < 4; ++i) head.literal_states[i] = field(b, 10 * i, 10);
  head.match_bytes = field(b, 40, 20);
  head.match_unused_bits = 7 - field(b, 60, 3);
  head.head_bytes = field(c, 0, 32);
  head.count_state = field(c, 32, 10);
  head.length_state = field(c, 42, 10);
  head.distance_state = field(c, 52, 10);
  if (head.head_bytes < kHeadV2Bytes || head.head_bytes > bytes.size()) return std::nullopt;
  const ByteSpan packed = bytes.subspan(kHeadV2Bytes, head.head_bytes - kHeadV2Bytes);
  if (!packed.empty() && !read_frequencies(packed, head.frequencies)) return std::nullopt;
  return head;
}

/// What a state means: its symbol, and the next state is `next` and `bits` more.
struct EntropyState {
  std::uint16_t symbol = 0, next = 0;
  std::uint8_t bits = 0;
};
using EntropyTable = std::vector<EntropyState>;

/// Empty: the frequencies are more than the states.
EntropyTable table_of(std::span<const std::uint16_t> frequencies, std::uint32_t states) {
  EntropyTable table;
  table.reserve(states);
  for (std::size_t symbol = 0; symbol < frequencies.size(); ++symbol) {
    const std::uint32_t frequency = frequencies[symbol];
    if (frequency == 0) continue;
    if (frequency > states - table.size()) return {};
    // A symbol's states split `states` evenly: the first `wide` of them need one bit more.
    const auto bits = static_cast<unsigned>(std::bit_width(states) - std::bit_width(frequency));
    const std::uint32_t wide = ((2 * states) >> bits) - frequency;
    for (std::uint32_t i = 0; i < frequency; ++i) {
      const bool is_wide = i < wide;
      const std::uint32_t next =
          is_wide ? ((frequency + i) << bits) - states : (i - wide) << (bits - 1);
      table.push_back({static_cast<std::uint16_t>(symbol), static_cast<std::uint16_t>(next),
                       static_cast<std::uint8_t>(is_wide ? bits : bits - 1)});
    }
  }
  table.resize(states);
  return table;
}

/// Bits of a part, from its end to its beginning.
class BackwardBits {
 public:
  BackwardBits(ByteSpan bytes, unsigned unused)
      : bytes_(bytes), left_(8 * bytes.size() - std::min<std::size_t>(unused, 8 * bytes.size())) {}

  [[nodiscard]] bool ok() const { return ok_; }

  /// At most 32; zero after the beginning, when ok() is false.
  std::uint32_t take(unsigned count) {
    if (count > left_) ok_ = false;
    if (!ok_) return 0;
    left_ -= count;
    std::uint64_t window = 0;
    const std::size_t first = left_ / 8, end = std::min(first + 8, bytes_.size());
    for (std::size_t i = first; i < end; ++i)
      window |= std::uint64_t{bytes_[i]} << (8 * (i - first));
    return static_cast<std::uint32_t>(window >> (left_ % 8) & ((std::uint64_t{1} << count) - 1));
  }

 private:
  ByteSpan bytes_;
  std::size_t left_;
  bool ok_ = true;
};

/// A table with its current state.
class EntropyDecoder {
 public:
  EntropyDecoder(const EntropyTable& table, std::uint32_t state) : table_(table), state_(state) {}

  std::uint16_t symbol(BackwardBits& bits) {
    const EntropyState& now = table_[state_];
    state_ = now.next + bits.take(now.bits);
    if (state_ >= table_.size()) state_ = 0;  // only where frequencies leave states over
    return now.symbol;
  }
  std::uint32_t value(BackwardBits& bits, std::span<const ValueCode> codes) {
    const ValueCode& code = codes[symbol(bits)];
    return code.base + bits.take(code.bits);
  }

 private:
  const EntropyTable& table_;
  std::uint32_t state_;
};

bool read_literals(const EntropyHead& head, ByteSpan part, const EntropyTable& table,
                   std::vector<std::uint8_t>& literals) {
  BackwardBits bits(part, head.literal_unused_bits);
  std::array<EntropyDecoder, 4> decoders = {
      EntropyDecoder(table, head.literal_states[0]), EntropyDecoder(table, head.literal_states[1]),
      EntropyDecoder(table, head.literal_states[2]), EntropyDecoder(table, head.literal_states[3])};
  literals.resize(head.literals);
  for (std::size_t i = 0; i < literals.size(); ++i)
    literals[i] = static_cast<std::uint8_t>(decoders[i % 4].symbol(bits));
  return bits.ok();
}

}  // namespace

std::optional<std::size_t> decode_entropy_block(ByteSpan bytes, LzOutput& out) {
  if (bytes.size() < 4) return std::nullopt;
  const auto head = read_u32(bytes.data()) == kMagicV1 ? read_head_v1(bytes) : read_head_v2(bytes);
  if (!head || !head->is_possible(bytes.size()) || head->raw_bytes > out.left())
    return std::nullopt;
  std::span<const std::uint16_t> frequencies = head->frequencies;
  const auto next_table = [&frequencies](std::size_t symbols, std::uint32_t states) {
    const EntropyTable table = table_of(frequencies.first(symbols), states);
    frequencies = frequencies.subspan(symbols);
    return table;
  };
  const EntropyTable counts = next_table(kCountSymbols, kCountStates);
  const EntropyTable lengths = next_table(kCountSymbols, kCountStates);
  const EntropyTable distances = next_table(kDistanceSymbols, kDistanceStates);
  const EntropyTable of_literals = next_table(kLiteralSymbols, kLiteralStates);
  if (counts.empty() || lengths.empty() || distances.empty() || of_literals.empty())
    return std::nullopt;
  std::vector<std::uint8_t> literals;
  const ByteSpan literal_part = bytes.subspan(head->head_bytes, head->literal_bytes);
  if (!read_literals(*head, literal_part, of_literals, literals)) return std::nullopt;

  BackwardBits bits(bytes.subspan(head->head_bytes + head->literal_bytes, head->match_bytes),
                    head->match_unused_bits);
  EntropyDecoder count(counts, head->count_state), length(lengths, head->length_state),
      distance(distances, head->distance_state);
  const std::size_t begin = out.size();
  std::size_t last_distance = 0;
  ByteSpan unused = literals;
  for (std::uint32_t i = 0; i < head->matches; ++i) {
    const std::uint32_t literal_count = count.value(bits, kLiteralCounts);
    const std::uint32_t match_length = length.value(bits, kMatchLengths);
    const std::uint32_t match_distance = distance.value(bits, kDistances);
    if (!bits.ok() || literal_count > unused.size()) return std::nullopt;
    if (match_distance > 0) last_distance = match_distance;
    if (!out.append(unused.first(literal_count))) return std::nullopt;
    if (match_length > 0 && !out.repeat(last_distance, match_length)) return std::nullopt;
    unused = unused.subspan(literal_count);
  }
  if (out.size() - begin != head->raw_bytes) return std::nullopt;
  return head->head_bytes + head->literal_bytes + head->match_bytes;
}

}  // namespace roomcast::recording
