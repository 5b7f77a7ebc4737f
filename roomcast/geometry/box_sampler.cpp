// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/box_sampler.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

#include "roomcast/core/assert.h"

namespace roomcast {
namespace {

constexpr int kSteps = 32;  // sub-pixel positions per pixel
static_assert(kLargestBox * kSteps * 255 <= 65535, "sums down a column are 16 bits wide");

/// Start of the averaged square along one axis: its first pixel, and the part of that pixel (in
/// steps) outside the square.
struct Start {
  int pixel;
  std::uint16_t left_out;
};

template <int N>
Start start_of(float center, int side) {
  const float first = center - 0.5F * static_cast<float>(N - 1);
  const float clamped = std::clamp(first, 0.0F, static_cast<float>(side - N));
  const int steps = static_cast<int>(clamped * kSteps + 0.5F);
  const int pixel = std::min(steps / kSteps, side - N - 1);
  return {pixel, static_cast<std::uint16_t>(steps - pixel * kSteps)};
}

// Eight values at a time, in the vector extension shared by GCC and Clang.
using Bytes = std::uint8_t __attribute__((vector_size(8)));
using Words = std::uint16_t __attribute__((vector_size(16)));
constexpr int kLanes = 8;

/// The low `Count` bytes of a word, put together in registers: reading a vector from memory to
/// which parts of it were just stored would stall the processor (no store forwarding).
template <int Count>
std::uint64_t load_bytes(const std::uint8_t* from) {
  if constexpr (Count == 8) {
    std::uint64_t word;
    std::memcpy(&word, from, 8);
    return word;
  } else if constexpr (Count >= 4) {
    std::uint32_t first, last;  // they overlap
    std::memcpy(&first, from, 4);
    std::memcpy(&last, from + Count - 4, 4);
    return first | (std::uint64_t{last} << (8 * (Count - 4)));
  } else if constexpr (Count == 3) {
    return load_bytes<2>(from) | (load_bytes<1>(from + 2) << 16);
  } else if constexpr (Count == 2) {
    std::uint16_t word;
    std::memcpy(&word, from, 2);
    return word;
  } else {
    return *from;
  }
}

/// Loads up to eight bytes and widens them.
template <int Count>
Words load(const std::uint8_t* from) {
  const std::uint64_t word = load_bytes<std::min(Count, kLanes)>(from);
  Bytes bytes;
  std::memcpy(&bytes, &word, sizeof(bytes));
  return __builtin_convertvector(bytes, Words);
}

/// Sums N + 1 rows of `Count` bytes each by column, with the first and last row weighted. `sums`
/// has space for whole vectors.
template <int N, int Count>
void sum_columns(const std::uint8_t* top, std::ptrdiff_t row_bytes, std::uint16_t left_out,
                 std::uint16_t* sums) {
  Words middle{};
  for (int row = 1; row < N; ++row) middle += load<Count>(top + row * row_bytes);
  const auto kept = static_cast<std::uint16_t>(kSteps - left_out);
  const Words sum = load<Count>(top) * kept + middle * static_cast<std::uint16_t>(kSteps) +
                    load<Count>(top + N * row_bytes) * left_out;
  std::memcpy(sums, &sum, sizeof(sum));
  if constexpr (Count > kLanes) {
    sum_columns<N, Count - kLanes>(top + kLanes, row_bytes, left_out, sums + kLanes);
  }
}

template <int N>
Rgb8 sample(ColorView picture, float u, float v) {
  const Start x = start_of<N>(u, picture.width);
  const Start y = start_of<N>(v, picture.height);
  constexpr int kBytes = (N + 1) * 3;
  std::uint16_t column[kBytes + kLanes];
  sum_columns<N, kBytes>(&picture.at(x.pixel, y.pixel).r, picture.stride * 3, y.left_out, column);
  constexpr std::uint32_t kArea = N * N * kSteps * kSteps;
  std::uint8_t rgb[3];
  for (int channel = 0; channel < 3; ++channel) {
    std::uint32_t sum =
        (kSteps - x.left_out) * column[channel] + x.left_out * column[N * 3 + channel] + kArea / 2;
    for (int i = 1; i < N; ++i) sum += kSteps * std::uint32_t{column[i * 3 + channel]};
    rgb[channel] = static_cast<std::uint8_t>(sum / kArea);
  }
  return {rgb[0], rgb[1], rgb[2]};
}

template <int N>
void sample_row(ColorView picture, const float* u, const float* v, const std::uint8_t* take,
                int count, Rgb8* color) {
  for (int i = 0; i < count; ++i) {
    color[i] = take[i] != 0 ? sample<N>(picture, u[i], v[i]) : Rgb8{};
  }
}

template <std::size_t... I>
constexpr std::array<SampleRow, sizeof...(I)> samplers(std::index_sequence<I...>) {
  return {sample_row<static_cast<int>(I) + 1>...};
}

}  // namespace

SampleRow box_sampler(int size, int picture_width, int picture_height) {
  ROOMCAST_ASSERT(picture_width >= 2 && picture_height >= 2);
  static constexpr auto kSamplers = samplers(std::make_index_sequence<kLargestBox>());
  const int fitting = std::min({size, kLargestBox, picture_width - 1, picture_height - 1});
  return kSamplers[static_cast<std::size_t>(std::max(fitting, 1) - 1)];
}

}  // namespace roomcast
