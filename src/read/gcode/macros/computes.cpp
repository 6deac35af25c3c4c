#include "read/gcode/macros/computes.h"

#include <algorithm>

#include "base/error.h"
#include "read/gcode/words/block.h"
#include "read/gcode/words/g_words.h"

namespace clearcut::read::gcode {

int first_macro_line(std::string_view text) {
  BlockReader reader(text, "");
  Block block;
  try {
    while (reader.next(block)) {
      const bool calls = std::any_of(block.m.begin(), block.m.end(), [&](int m) {
        return m == 970 || ((m == 980 || m == 990) && block.has('P'));
      });
      if (calls || has_g(block, 650)) return block.line;
    }
  } catch (const MacroError&) {
    return block.line;
  } catch (const InputError&) {
    return 0;  // told by whoever reads the program
  }
  return 0;
}

}  // namespace clearcut::read::gcode
