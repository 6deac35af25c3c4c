#include "model/options/end_position.h"

#include <cmath>
#include <cstdio>

#include "base/text/format.h"

namespace clearcut::inline model {

std::optional<EndPosition> end_position_named(std::string_view text) {
  if (text == "home") return EndPosition{EndPosition::Kind::kHome, {}};
  if (text == "none") return EndPosition{EndPosition::Kind::kStay, {}};
  EndPosition end{EndPosition::Kind::kPlace, {}};
  char rest = 0;
  const std::string plain(text);
  if (std::sscanf(plain.c_str(), "%lf,%lf%c", &end.place.x, &end.place.y, &rest) != 2) return std::nullopt;
  if (!std::isfinite(end.place.x) || !std::isfinite(end.place.y)) return std::nullopt;
  return end;
}

std::string name_of(const EndPosition& end) {
  if (end.kind == EndPosition::Kind::kHome) return "home";
  if (end.kind == EndPosition::Kind::kStay) return "none";
  if (end.kind == EndPosition::Kind::kUsual) return "";
  return trimmed(end.place.x, 6) + "," + trimmed(end.place.y, 6);
}

}  // namespace clearcut::inline model
