// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/descriptor_products.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace roomcast::alignment {

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

/// Descriptors whose sums are reduced together, because a reduction costs as much as the products.
constexpr std::size_t kTogether = 4;

[[gnu::target("avx2")]] __m256i part_avx2(const Descriptor& descriptor, std::size_t part) {
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(descriptor.data() + 16 * part));
}

/// Reduces the eight sums in each of four registers to one.
[[gnu::target("avx2")]] __m128i folded(__m256i a, __m256i b, __m256i c, __m256i d) {
  const __m256i four = _mm256_hadd_epi32(_mm256_hadd_epi32(a, b), _mm256_hadd_epi32(c, d));
  return _mm_add_epi32(_mm256_castsi256_si128(four), _mm256_extracti128_si256(four, 1));
}

[[gnu::target("avx2")]] void products_avx2(const Descriptor& descriptor,
                                           std::span<const Descriptor> others,
                                           std::span<std::int32_t> products) {
  std::size_t i = 0;
  for (; i + kTogether <= others.size(); i += kTogether) {
    __m256i sums[kTogether] = {};
    for (std::size_t part = 0; part < kDescriptorSize / 16; ++part) {
      const __m256i mine = part_avx2(descriptor, part);
      for (std::size_t k = 0; k < kTogether; ++k) {
        sums[k] =
            _mm256_add_epi32(sums[k], _mm256_madd_epi16(mine, part_avx2(others[i + k], part)));
      }
    }
    _mm_storeu_si128(reinterpret_cast<__m128i*>(products.data() + i),
                     folded(sums[0], sums[1], sums[2], sums[3]));
  }
  descriptor_products_reference(descriptor, others.subspan(i), products.subspan(i));
}

[[gnu::target("avx2,avx512vl,avx512vnni")]] void products_vnni(const Descriptor& descriptor,
                                                               std::span<const Descriptor> others,
                                                               std::span<std::int32_t> products) {
  std::size_t i = 0;
  for (; i + kTogether <= others.size(); i += kTogether) {
    __m256i sums[kTogether] = {};
    for (std::size_t part = 0; part < kDescriptorSize / 16; ++part) {
      const __m256i mine = part_avx2(descriptor, part);
      for (std::size_t k = 0; k < kTogether; ++k)
        sums[k] = _mm256_dpwssd_epi32(sums[k], mine, part_avx2(others[i + k], part));
    }
    _mm_storeu_si128(reinterpret_cast<__m128i*>(products.data() + i),
                     folded(sums[0], sums[1], sums[2], sums[3]));
  }
  descriptor_products_reference(descriptor, others.subspan(i), products.subspan(i));
}

}  // namespace
#endif

void descriptor_products(const Descriptor& descriptor, std::span<const Descriptor> others,
                         std::span<std::int32_t> products) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512vnni") && __builtin_cpu_supports("avx512vl"))
    return products_vnni(descriptor, others, products);
  if (__builtin_cpu_supports("avx2")) return products_avx2(descriptor, others, products);
#endif
  descriptor_products_reference(descriptor, others, products);
}

}  // namespace roomcast::alignment
