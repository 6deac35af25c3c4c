// The percent signs of a tape.
#pragma once

namespace clearcut::read::gcode {

/// A tape's text lies between two '%'; a single one behind words ends it.
class TapeMarks {
 public:
  /// True when this block ends the program.
  bool ends(bool is_percent, bool has_words) {
    const bool end = is_percent && begun_;
    begun_ = begun_ || is_percent || has_words;
    return end;
  }

 private:
  bool begun_ = false;
};

}  // namespace clearcut::read::gcode
