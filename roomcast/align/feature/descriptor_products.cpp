// SPDX-License-Identifier: Apache-2.0
#include "roomcast/align/feature/descriptor_products.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace roomcast::align {

void descriptor_products_reference(const Descriptor& descriptor, std::span<const Descriptor> others,
                                   std::span<std::int32_t> products) {
  for (std::size_t i = 0; i < others.size(); ++i) {
    std::int32_t sum = 0;
    for (std::size_t k = 0; k < kDescriptorSize; ++k) sum += descriptor[k] * others[i][k];
    products[i] = sum;
  }
}

#if defined(__x86_64__)
namespace {

constexpr std::size_t kPerRegister = 16, kRegisters = kDescriptorSize / kPerRegister;

[[gnu::target("avx2")]] std::int32_t horizontal_sum(__m256i sums) {
  const __m128i four =
      _mm_add_epi32(_mm256_castsi256_si128(sums), _mm256_extracti128_si256(sums, 1));
  const __m128i two = _mm_add_epi32(four, _mm_shuffle_epi32(four, 0x4E));
  return _mm_cvtsi128_si32(_mm_add_epi32(two, _mm_shuffle_epi32(two, 0xB1)));
}

[[gnu::target("avx2")]] void products_avx2(const Descriptor& descriptor,
                                           std::span<const Descriptor> others,
                                           std::span<std::int32_t> products) {
  __m256i mine[kRegisters];
  for (std::size_t r = 0; r < kRegisters; ++r) {
    mine[r] =
        _mm256_loadu_si256(reinterpret_cast<const __m256i*>(descriptor.data() + r * kPerRegister));
  }
  for (std::size_t i = 0; i < others.size(); ++i) {
    __m256i sums = _mm256_setzero_si256();
    for (std::size_t r = 0; r < kRegisters; ++r) {
      const __m256i other =
          _mm256_loadu_si256(reinterpret_cast<const __m256i*>(others[i].data() + r * kPerRegister));
      sums = _mm256_add_epi32(sums, _mm256_madd_epi16(mine[r], other));
    }
    products[i] = horizontal_sum(sums);
  }
}

}  // namespace
#endif

void descriptor_products(const Descriptor& descriptor, std::span<const Descriptor> others,
                         std::span<std::int32_t> products) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return products_avx2(descriptor, others, products);
#endif
  descriptor_products_reference(descriptor, others, products);
}

}  // namespace roomcast::align
