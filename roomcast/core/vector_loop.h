// SPDX-License-Identifier: Apache-2.0
// How per-pixel loops become vector code. Integer loops only: with and without
// it the results are the same.
#pragma once

/// Before a function: compiled twice, for AVX2 and for any x86-64, and chosen
/// when the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
#define ROOMCAST_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define ROOMCAST_VECTOR_CLONES
#endif

/// Before a loop: no iteration reads what another writes. (Clang finds out by itself, or warns.)
#if defined(__GNUC__) && !defined(__clang__)
#define ROOMCAST_INDEPENDENT_ITERATIONS _Pragma("GCC ivdep")
#else
#define ROOMCAST_INDEPENDENT_ITERATIONS
#endif
