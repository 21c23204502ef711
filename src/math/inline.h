// SPDX-License-Identifier: Apache-2.0
#pragma once

/// For functions that lane code calls: a copy of one that is compiled for special registers must not be shared with
/// code for all machines, so none is ever left outside its caller.
#define PARHELION_INLINE inline __attribute__((always_inline))

/// For functions that loop over lanes and call nothing but what is inlined: they are compiled for AVX2, too, and the
/// machine picks. The bits are the same.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define PARHELION_ALSO_AVX2 __attribute__((target_clones("avx2", "default")))
#else
#define PARHELION_ALSO_AVX2
#endif
