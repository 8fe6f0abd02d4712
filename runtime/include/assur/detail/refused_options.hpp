// Compile-time errors for reported compiler options under which neither error bounds nor tests for
// NaN hold. numeric/arithmetic.hpp finds the others at run time.
#pragma once

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error \
    "assur needs every operation rounded as it is written: compile without -ffast-math, -Ofast and their parts."
#endif
#if defined(__FLT_EVAL_METHOD__) && (__FLT_EVAL_METHOD__ == 2 || __FLT_EVAL_METHOD__ < 0)
#error \
    "assur needs every operation rounded once, which x87 does not: compile with -msse2 -mfpmath=sse."
#endif
