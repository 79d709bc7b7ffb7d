/// Which instruction sets vector code is compiled for. Included before any header of Highway.
#pragma once

#ifdef RT_FEW_INSTRUCTION_SETS // for sanitizers, with which vector code is slow to compile
#define RTCORE_LEFT_OUT (HWY_SSE4 | HWY_AVX3)
#else
#define RTCORE_LEFT_OUT 0
#endif
// SSSE3 without SSE4 is too rare to be worth it. Vectors whose length is not known when compiling (SVE,
// RISC-V) cannot be kept in structures.
#define HWY_DISABLED_TARGETS                                                                                 \
    (RTCORE_LEFT_OUT | HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)

// Every arm64 processor has NEON; without it there is only "scalar". Highway otherwise compiles NEON for AES
// too, which not every processor has, and GCC inlines none of that into code without.
#ifdef __aarch64__
#define HWY_COMPILE_ALL_ATTAINABLE
#define TOOLCHAIN_MISS_SYS_AUXV_H
#endif
