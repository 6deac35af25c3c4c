// Sizes: coarse pitches of ISO 261, unified sizes of ASME B1.1. A thread's basic profile is given in ISO 68-1: its
// height is H = 0.866 P, and the minor radius is 5/8 H below the major one.
#include "model/hole.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include "base/elementary.h"

namespace clearcut::inline model {

namespace {

constexpr double kMmPerInch = 25.4;
/// 2 * 5/8 * sqrt(3)/2.
constexpr double kMinorBelowMajor = 1.0825317547305484;

struct CoarsePitch {
  double diameter, pitch;
};
constexpr CoarsePitch kMetric[] = {
    {1, 0.25},   {1.1, 0.25}, {1.2, 0.25}, {1.4, 0.3}, {1.6, 0.35}, {1.8, 0.35}, {2, 0.4}, {2.2, 0.45},
    {2.5, 0.45}, {3, 0.5},    {3.5, 0.6},  {4, 0.7},   {4.5, 0.75}, {5, 0.8},    {6, 1},   {7, 1},
    {8, 1.25},   {9, 1.25},   {10, 1.5},   {11, 1.5},  {12, 1.75},  {14, 2},     {16, 2},  {18, 2.5},
    {20, 2.5},   {22, 2.5},   {24, 3},     {27, 3},    {30, 3.5},   {33, 3.5},   {36, 4},  {39, 4},
    {42, 4.5},   {45, 4.5},   {48, 5},     {52, 5},    {56, 5.5},   {60, 5.5},   {64, 6},  {68, 6}};

/// Diameter in inches, threads an inch; 0: the size is missing in that series.
struct UnifiedSize {
  double inch;
  int coarse, fine;
};
constexpr UnifiedSize kUnified[] = {
    {0.06, 0, 80},   {0.073, 64, 72},  {0.086, 56, 64}, {0.099, 48, 56},  {0.112, 40, 48}, {0.125, 40, 44},
    {0.138, 32, 40}, {0.164, 32, 36},  {0.19, 24, 32},  {0.216, 24, 28},  {0.25, 20, 28},  {0.3125, 18, 24},
    {0.375, 16, 24}, {0.4375, 14, 20}, {0.5, 13, 20},   {0.5625, 12, 18}, {0.625, 11, 18}, {0.75, 10, 16},
    {0.875, 9, 14},  {1, 8, 12},       {1.125, 7, 12},  {1.25, 7, 12},    {1.375, 6, 12},  {1.5, 6, 12}};

/// The number at the start of `text`; removes it from `text`.
std::optional<double> take_number(std::string_view& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || !(value > 0)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

bool take(std::string_view& text, std::string_view what) {
  if (text.substr(0, what.size()) != what) return false;
  text.remove_prefix(what.size());
  return true;
}

std::optional<Thread> metric(std::string_view text) {
  const auto diameter = take_number(text);
  if (!diameter) return std::nullopt;
  Thread thread;
  thread.diameter = *diameter;
  if (take(text, "X")) {
    const auto pitch = take_number(text);
    if (!pitch || *pitch > *diameter / 2) return std::nullopt;
    thread.pitch = *pitch;
  } else {
    const auto* const known = std::find_if(std::begin(kMetric), std::end(kMetric),
                                           [&](const CoarsePitch& one) { return one.diameter == *diameter; });
    if (known == std::end(kMetric)) return std::nullopt;
    thread.pitch = known->pitch;
  }
  return text.empty() ? std::optional(thread) : std::nullopt;
}

/// Inches: "#10", "1/4", "1-4" if `dashed`, "1", "0.25".
std::optional<double> take_inches(std::string_view& text, bool dashed) {
  if (take(text, "#")) {
    const auto number = take(text, "0") && (text.empty() || text[0] == '-') ? 0.0 : take_number(text);
    return number ? std::optional(0.06 + 0.013 * *number) : std::nullopt;
  }
  const auto value = take_number(text);
  if (!value) return std::nullopt;
  if (!take(text, "/") && !(dashed && take(text, "-"))) return value;
  const auto under = take_number(text);
  return under ? std::optional(*value / *under) : std::nullopt;
}

const UnifiedSize* unified_size(double inch) {
  const auto* const known =
      std::find_if(std::begin(kUnified), std::end(kUnified),
                   [&](const UnifiedSize& one) { return std::abs(one.inch - inch) < 1e-6; });
  return known == std::end(kUnified) ? nullptr : known;
}

std::optional<Thread> in_inches(double inch, double turns) {
  if (!(turns > 0)) return std::nullopt;
  Thread thread;
  thread.diameter = inch * kMmPerInch;
  thread.pitch = kMmPerInch / turns;
  return thread;
}

/// "UNC1/4" by its table, "1/4-20" by its threads an inch.
std::optional<Thread> unified(std::string_view text) {
  const bool coarse = take(text, "UNC"), fine = !coarse && take(text, "UNF");
  const bool named = coarse || fine;
  const auto inch = take_inches(text, named);
  if (!inch) return std::nullopt;
  const UnifiedSize* size = unified_size(*inch);
  if (named) {
    if (!size || !text.empty()) return std::nullopt;
    return in_inches(*inch, coarse ? size->coarse : size->fine);
  }
  if (!take(text, "-")) return std::nullopt;
  const auto turns = take_number(text);
  return turns && text.empty() && size ? in_inches(*inch, *turns) : std::nullopt;
}

}  // namespace

const char* name_of(HoleKind kind) {
  constexpr std::array kNames{"drill", "spot", "ream", "bore", "counterbore", "countersink", "tap", "thread"};
  return kNames.at(static_cast<std::size_t>(kind));
}

std::optional<Thread> thread_named(std::string_view text) {
  std::string capitals(text);
  std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  std::string_view rest = capitals;
  const bool left = rest.ends_with("LH");
  if (left) rest.remove_suffix(2);
  const std::string name(rest);
  auto thread = take(rest, "M") ? metric(rest) : unified(rest);
  if (!thread) return std::nullopt;
  thread->left_hand = left;
  thread->name = name + (left ? "LH" : "");
  return thread;
}

double minor_diameter(const Thread& thread) {
  return thread.diameter - kMinorBelowMajor * thread.pitch;
}

/// ISO 965-1: 433 P - 190 P^1.22 um up to a pitch of 0.8 mm, 230 P^0.7 um above.
double minor_tolerance(const Thread& thread) {
  const double p = thread.pitch;
  return (p <= 0.8 ? 433 * p - 190 * base::pow(p, 1.22) : 230 * base::pow(p, 0.7)) / 1000;
}

double root_diameter(const Thread& thread) {
  constexpr double kRootBelowMajor = 1.226869;  // 2 * 17/24 * sqrt(3)/2
  return thread.diameter - kRootBelowMajor * thread.pitch;
}

/// ISO 965-1: es = -(15 + 11 P) um, Td = 180 P^(2/3) - 3.15 / sqrt(P) um.
double crest_tolerance(const Thread& thread) {
  const double p = thread.pitch;
  return (15 + 11 * p + 180 * base::pow(p, 2.0 / 3) - 3.15 / std::sqrt(p)) / 1000;
}

double approach_beside(const Thread& thread) {
  constexpr double kBesideCrest = 1;  // mm
  return 0.75 * (thread.diameter - root_diameter(thread)) + kBesideCrest;
}

}  // namespace clearcut::inline model
