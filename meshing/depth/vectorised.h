#pragma once

/// Compiles a function a second time for AVX2 and picks at run time. Only for loops whose results
/// cannot differ between the two: integers, and floating point without fused or reordered steps.
/// Left out under the sanitizers, whose start-up does not survive the run-time choice.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define LUMI_VECTORISED __attribute__((target_clones("avx2", "default")))
#else
#define LUMI_VECTORISED
#endif
