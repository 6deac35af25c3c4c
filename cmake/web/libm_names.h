/* Read before each of glibc's mathematical functions (-include), in the place of glibc's own headers: their names are those of the C
   library, rounding is to nearest, errno and exceptions are left alone. */
#pragma once

#include <math.h>
#include <stdint.h>
#include <string.h>

#define __sin sin
#define __cos cos
#define __tan tan
#define __atan atan
#define __atan2 atan2
#define __ieee754_atan2 atan2
#define __ieee754_asin asin
#define __ieee754_acos acos
#define __hypot hypot
#define __ieee754_log10 log10
#define __ieee754_log log
#define __branred clearcut_branred
#define __sincostab clearcut_sincostab

#define strong_alias(from, to)
#define libm_alias_double(from, to)
#define libm_alias_finite(from, to)
#define libm_alias_double_compat(from, to)
#define libm_alias_double_narrow(from, to)
#define SET_RESTORE_ROUND(mode)
#define SET_RESTORE_ROUND_53BIT(mode)
#define math_opt_barrier(x) (x)
#define math_force_eval(x) ((void)(x))
#define math_check_force_underflow(x)
#define math_check_force_underflow_nonneg(x)
#define math_narrow_eval(x) (x)
#define __set_errno(x)
#define __glibc_unlikely(x) __builtin_expect((x) != 0, 0)
#define __glibc_likely(x) __builtin_expect((x) != 0, 1)
#define attribute_hidden
#define __always_inline inline __attribute__((always_inline))
#define LITTLE_ENDI 1
#define HIGH_HALF 1
#define LOW_HALF 0
#define HIGH_ORDER_BIT_IS_SET_FOR_SNAN 0
#define USE_HYPOT_BUILTIN 0
#define USE_FMAX_BUILTIN 1
#define USE_FMIN_BUILTIN 1
#define FIX_INT_FP_CONVERT_ZERO 0

int clearcut_branred(double x, double* a, double* aa);
double atan2(double, double);

static inline int64_t clearcut_bits(double x) {
  int64_t bits;
  memcpy(&bits, &x, sizeof bits);
  return bits;
}
static inline double clearcut_double(int64_t bits) {
  double x;
  memcpy(&x, &bits, sizeof x);
  return x;
}
#define EXTRACT_WORDS64(to, x) ((to) = clearcut_bits(x))
#define INSERT_WORDS64(to, bits) ((to) = clearcut_double(bits))
#define EXTRACT_WORDS(high, low, x) \
  ((high) = (int32_t)(clearcut_bits(x) >> 32), (low) = (uint32_t)clearcut_bits(x))
#define GET_HIGH_WORD(to, x) ((to) = (int32_t)(clearcut_bits(x) >> 32))
#define SET_HIGH_WORD(x, bits) \
  ((x) = clearcut_double(((int64_t)(bits) << 32) | (clearcut_bits(x) & 0xffffffff)))
