// SPDX-License-Identifier: Apache-2.0
// Vectorisation of per-pixel loops. For integer loops only: their results do not depend on
// vectorisation.
#pragma once

/// Put before a function: it is compiled twice, for AVX2 and for any x86-64, and one version is
/// chosen when the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
#define ROOMCAST_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define ROOMCAST_VECTOR_CLONES
#endif

/// Put before a loop in which no iteration reads what another one writes. (Clang detects this
/// itself, or warns.)
#if defined(__GNUC__) && !defined(__clang__)
#define ROOMCAST_INDEPENDENT_ITERATIONS _Pragma("GCC ivdep")
#else
#define ROOMCAST_INDEPENDENT_ITERATIONS
#endif
