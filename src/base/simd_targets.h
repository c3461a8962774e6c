// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// simd_targets.h: the instruction sets that files with Highway's kernels are not compiled for; include it first.
#pragma once

// Vectors whose length is known only at run time cannot be members of the kernels' structures.
#define RAYCORE_SCALABLE_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)

#ifdef RAYCORE_FEW_TARGETS  // sanitizers make compilers slow: the baseline and AVX2 are enough to find slips
#define HWY_DISABLED_TARGETS (RAYCORE_SCALABLE_TARGETS | HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL)
#else
#define HWY_DISABLED_TARGETS RAYCORE_SCALABLE_TARGETS
#endif
