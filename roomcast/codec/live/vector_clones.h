// SPDX-License-Identifier: Apache-2.0
// Marks a per-pixel loop that is compiled twice, for AVX2 and for any x86-64, and chosen when the
// program starts. Integer loops only: both give the same results.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define ROOMCAST_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define ROOMCAST_VECTOR_CLONES
#endif
