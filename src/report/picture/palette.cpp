#include "report/picture/palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace clearcut::report::palette {

namespace {

using Rgb = std::array<double, 3>;
constexpr std::array<Rgb, 5> kDepths{
    {{234, 240, 244}, {189, 214, 231}, {122, 170, 207}, {61, 117, 168}, {27, 69, 116}}};

}  // namespace

std::string depth_color(double fraction) {
  const double position = std::clamp(fraction, 0.0, 1.0) * (kDepths.size() - 1);
  const std::size_t low = std::min(static_cast<std::size_t>(position), kDepths.size() - 2);
  const double t = position - static_cast<double>(low);
  std::array<long, 3> mixed{};
  for (std::size_t i = 0; i < 3; ++i)
    mixed[i] = std::lround(kDepths[low][i] * (1 - t) + kDepths[low + 1][i] * t);
  return fmt::format("#{:02x}{:02x}{:02x}", mixed[0], mixed[1], mixed[2]);
}

std::string line_color_on_depth(double fraction) {
  return fraction > 0.5 ? "#ffffff" : "#14406e";
}

std::string tool_color(int i) {
  static const std::array<const char*, 5> kColors{kCut, "#6b2fa0", "#00818a", "#8a4b08", "#3d4650"};
  return kColors[static_cast<std::size_t>(std::max(i, 0)) % kColors.size()];
}

}  // namespace clearcut::report::palette
