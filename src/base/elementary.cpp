#include "base/elementary.h"

/// musl's functions under names of their own (cmake/ClearcutElementary.cmake).
extern "C" {
double clearcut_musl_sin(double);
double clearcut_musl_cos(double);
double clearcut_musl_tan(double);
double clearcut_musl_asin(double);
double clearcut_musl_acos(double);
double clearcut_musl_atan(double);
double clearcut_musl_atan2(double, double);
double clearcut_musl_exp(double);
double clearcut_musl_exp2(double);
double clearcut_musl_expm1(double);
double clearcut_musl_log(double);
double clearcut_musl_log2(double);
double clearcut_musl_log10(double);
double clearcut_musl_pow(double, double);
}

namespace clearcut::inline base {

double sin(double radians) {
  return ::clearcut_musl_sin(radians);
}
double cos(double radians) {
  return ::clearcut_musl_cos(radians);
}
double tan(double radians) {
  return ::clearcut_musl_tan(radians);
}
double asin(double sine) {
  return ::clearcut_musl_asin(sine);
}
double acos(double cosine) {
  return ::clearcut_musl_acos(cosine);
}
double atan(double slope) {
  return ::clearcut_musl_atan(slope);
}
double atan2(double y, double x) {
  return ::clearcut_musl_atan2(y, x);
}
double exp(double x) {
  return ::clearcut_musl_exp(x);
}
double exp2(double x) {
  return ::clearcut_musl_exp2(x);
}
double expm1(double x) {
  return ::clearcut_musl_expm1(x);
}
double log(double x) {
  return ::clearcut_musl_log(x);
}
double log2(double x) {
  return ::clearcut_musl_log2(x);
}
double log10(double x) {
  return ::clearcut_musl_log10(x);
}
double pow(double x, double exponent) {
  return ::clearcut_musl_pow(x, exponent);
}

}  // namespace clearcut::inline base
