/// Which instruction sets vector code is compiled for. Included before any header of Highway.
#pragma once

// SSSE3 without SSE4 is too rare to be worth it. Vectors whose length is not known when compiling (SVE,
// RISC-V) cannot be kept in structures.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
