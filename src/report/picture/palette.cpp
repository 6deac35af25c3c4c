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

/// How a material looks where light falls on it.
struct Look {
  const char* material;
  Rgb color;
};
constexpr std::array<Look, 12> kLooks{{{"aluminium", {214, 218, 222}},
                                       {"brass", {224, 190, 98}},
                                       {"steel", {178, 186, 194}},
                                       {"alloy-steel", {164, 172, 182}},
                                       {"stainless", {196, 202, 206}},
                                       {"cast-iron", {138, 142, 146}},
                                       {"titanium", {182, 178, 172}},
                                       {"plastic", {232, 236, 240}},
                                       {"softwood", {232, 202, 156}},
                                       {"hardwood", {190, 140, 92}},
                                       {"mdf", {198, 166, 128}},
                                       {"plywood", {224, 190, 140}}}};
/// Share of the light that the deepest floor has lost.
constexpr double kShadow = 0.5;

std::string hex_of(const Rgb& color) {
  return fmt::format("#{:02x}{:02x}{:02x}", std::lround(color[0]), std::lround(color[1]),
                     std::lround(color[2]));
}

}  // namespace

std::string material_color(const std::string& material, double fraction) {
  for (const Look& look : kLooks) {
    if (material != look.material) continue;
    const double light = 1 - kShadow * std::clamp(fraction, 0.0, 1.0);
    return hex_of({look.color[0] * light, look.color[1] * light, look.color[2] * light});
  }
  return depth_color(fraction);
}

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
