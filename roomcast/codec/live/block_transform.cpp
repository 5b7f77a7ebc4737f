// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/live/block_transform.h"

namespace roomcast::codec {
namespace {

constexpr int kFirstShift = 4, kSecondShift = 11;

constexpr std::int32_t kMatrix[kBlockSide][kBlockSide] = {
    {64, 64, 64, 64, 64, 64, 64, 64},     {89, 75, 50, 18, -18, -50, -75, -89},
    {83, 36, -36, -83, -83, -36, 36, 83}, {75, -18, -89, -50, 50, 89, 18, -75},
    {64, -64, -64, 64, 64, -64, -64, 64}, {50, -89, 18, 75, -75, -18, 89, -50},
    {36, -83, 83, -36, -36, 83, -83, 36}, {18, -50, 75, -89, 89, -75, 50, -18}};

// One row of a block: eight lanes with wrapping arithmetic. GCC and Clang split it for narrower
// machines.
typedef std::uint32_t RowU __attribute__((vector_size(32)));
typedef std::int32_t RowI __attribute__((vector_size(32)));

constexpr RowU kMatrixRows[kBlockSide] = {
    {64, 64, 64, 64, 64, 64, 64, 64},         {89, 75, 50, 18, -18u, -50u, -75u, -89u},
    {83, 36, -36u, -83u, -83u, -36u, 36, 83}, {75, -18u, -89u, -50u, 50, 89, 18, -75u},
    {64, -64u, -64u, 64, 64, -64u, -64u, 64}, {50, -89u, 18, 75, -75u, -18u, 89, -50u},
    {36, -83u, 83, -36u, -36u, 83, -83u, 36}, {18, -50u, 75, -89u, 89, -75u, 50, -18u}};

}  // namespace

const std::array<std::uint8_t, kBlockPixels> kZigzag = {
    0,  1,  8,  16, 9,  2,  3,  10, 17, 24, 32, 25, 18, 11, 4,  5,  12, 19, 26, 33, 40, 48,
    41, 34, 27, 20, 13, 6,  7,  14, 21, 28, 35, 42, 49, 56, 57, 50, 43, 36, 29, 22, 15, 23,
    30, 37, 44, 51, 58, 59, 52, 45, 38, 31, 39, 46, 53, 60, 61, 54, 47, 55, 62, 63};

void inverse_transform(const BlockCoefficients& coefficients, int rows, BlockValues& values) {
  RowU half[kBlockSide];
  for (int j = 0; j < rows; ++j) {
    RowU sum = {};
    for (int k = 0; k < kBlockSide; ++k) {
      sum += kMatrixRows[k] * static_cast<std::uint32_t>(coefficients[j * kBlockSide + k]);
    }
    half[j] = reinterpret_cast<RowU>(reinterpret_cast<RowI>(sum + (1u << (kFirstShift - 1))) >>
                                     kFirstShift);
  }
  for (int y = 0; y < kBlockSide; ++y) {
    RowU sum = {};
    for (int j = 0; j < rows; ++j) sum += half[j] * static_cast<std::uint32_t>(kMatrix[j][y]);
    const RowI row = reinterpret_cast<RowI>(sum + (1u << (kSecondShift - 1))) >> kSecondShift;
    for (int x = 0; x < kBlockSide; ++x) values[y * kBlockSide + x] = row[x];
  }
}

void inverse_transform_reference(const BlockCoefficients& coefficients, BlockValues& values) {
  std::uint32_t half[kBlockPixels];
  for (int j = 0; j < kBlockSide; ++j) {
    for (int x = 0; x < kBlockSide; ++x) {
      std::uint32_t sum = 1u << (kFirstShift - 1);
      for (int k = 0; k < kBlockSide; ++k) {
        sum += static_cast<std::uint32_t>(coefficients[j * kBlockSide + k]) *
               static_cast<std::uint32_t>(kMatrix[k][x]);
      }
      half[j * kBlockSide + x] =
          static_cast<std::uint32_t>(static_cast<std::int32_t>(sum) >> kFirstShift);
    }
  }
  for (int y = 0; y < kBlockSide; ++y) {
    for (int x = 0; x < kBlockSide; ++x) {
      std::uint32_t sum = 1u << (kSecondShift - 1);
      for (int j = 0; j < kBlockSide; ++j) {
        sum += half[j * kBlockSide + x] * static_cast<std::uint32_t>(kMatrix[j][y]);
      }
      values[y * kBlockSide + x] = static_cast<std::int32_t>(sum) >> kSecondShift;
    }
  }
}

void forward_transform(const std::array<float, kBlockPixels>& values,
                       std::array<float, kBlockPixels>& coefficients) {
  float half[kBlockPixels] = {};  // row j: sum over y of matrix[j][y] * values[y]
  for (int j = 0; j < kBlockSide; ++j) {
    for (int y = 0; y < kBlockSide; ++y) {
      const auto weight = static_cast<float>(kMatrix[j][y]);
      for (int x = 0; x < kBlockSide; ++x) half[j * 8 + x] += weight * values[y * 8 + x];
    }
  }
  constexpr float kScale = 1.0f / 32768;
  for (int j = 0; j < kBlockSide; ++j) {
    for (int k = 0; k < kBlockSide; ++k) {
      float sum = 0;
      for (int x = 0; x < kBlockSide; ++x) {
        sum += static_cast<float>(kMatrix[k][x]) * half[j * 8 + x];
      }
      coefficients[j * 8 + k] = sum * kScale;
    }
  }
}

}  // namespace roomcast::codec
