#include "model/results/condition_kinds.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace clearcut::inline model {
namespace {

constexpr std::array kRows{
    // Facts that the program leaves to the control and to the operator.
    ConditionRow{"units"}, ConditionRow{"motion-mode"}, ConditionRow{"arc-centres"},
    ConditionRow{"decimal-point"}, ConditionRow{"dialect"}, ConditionRow{"start-position"},
    ConditionRow{"g#", "g55"}, ConditionRow{"g#-p#", "g54.1-p2"}, ConditionRow{"datum-#", "datum-247"},
    ConditionRow{"g#-home", "g28-home"}, ConditionRow{"tool-in-spindle"},
    ConditionRow{"tool-length-h#", "tool-length-h5"}, ConditionRow{"tool-length-g#", "tool-length-g43.1"},
    ConditionRow{"tool-length-dl"}, ConditionRow{"tool-length-off"}, ConditionRow{"spindle-by-hand"},
    ConditionRow{"speed-by-hand"}, ConditionRow{"tool-by-hand"}, ConditionRow{"tool-change-height"},
    ConditionRow{"block-delete"}, ConditionRow{"blending"}, ConditionRow{"m#", "m6"},
    ConditionRow{"stray-word"}, ConditionRow{"dwell"}, ConditionRow{"chip-load"},
    ConditionRow{"cutting-speed"}, ConditionRow{"stated-feed"}, ConditionRow{"stated-speed"},
    ConditionRow{"rigid-tap"}, ConditionRow{"far-move"}, ConditionRow{"ends-low"},
    ConditionRow{"program-end"}, ConditionRow{"d#", "d1"}, ConditionRow{"tool-name-#", "tool-name-1"},
    ConditionRow{"parameter-#", "parameter-100"}, ConditionRow{"measured-move"},
    ConditionRow{"measured-value"}, ConditionRow{"subprogram-#", "subprogram-1"}, ConditionRow{"compressor"},
    ConditionRow{"compensation-d#", "compensation-d1"}, ConditionRow{"compensation-t#", "compensation-t1"},
    ConditionRow{"compensation-corners"}, ConditionRow{"rtliof"}, ConditionRow{"h"}, ConditionRow{"cycle800"},
    // Facts unknown without a part.
    ConditionRow{"stock"}, ConditionRow{"below-stock"}, ConditionRow{"arc-radii"},
    ConditionRow{"cuts-nothing"},
    // Shapes of the part that the program does not make, or makes differently.
    ConditionRow{"out-of-reach"}, ConditionRow{"not-parted"}, ConditionRow{"not-as-drawn"},
    ConditionRow{"left-out"}, ConditionRow{"loose-part"}, ConditionRow{"not-followed"},
    ConditionRow{"leaning-walls"}, ConditionRow{"floors-meet"}, ConditionRow{"margin"}};

/// Whether `name` is the pattern with a number in place of each `#`.
bool fits(std::string_view pattern, std::string_view name) {
  std::size_t at = 0;
  for (const char wanted : pattern) {
    if (wanted != '#') {
      if (at == name.size() || name[at] != wanted) return false;
      ++at;
      continue;
    }
    const std::size_t first = at;
    while (at < name.size() && (std::isdigit(static_cast<unsigned char>(name[at])) || name[at] == '.')) ++at;
    if (at == first) return false;
  }
  return at == name.size();
}

}  // namespace

std::span<const ConditionRow> condition_rows() {
  return kRows;
}

bool is_condition(const std::string& name) {
  return std::any_of(kRows.begin(), kRows.end(),
                     [&](const ConditionRow& row) { return fits(row.name, name); });
}

}  // namespace clearcut::inline model
