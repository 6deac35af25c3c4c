// Letters of drawings as outlines: the faces that stand for what was asked for, lines of letters, and what is to be said of them.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "read/drawing/drawing.h"
#include "read/lettering/face.h"
#include "read/repair/repair.h"

namespace clearcut::read {

/// A letter of a line, and how far from the line's start its origin lies, em.
struct SetLetter {
  char32_t letter = 0;
  double x = 0;
};

/// Letters side by side with their kerning; em.
struct SetLine {
  std::vector<SetLetter> letters;
  double width = 0;  ///< to where a next letter would begin
};

class Lettering {
 public:
  /// The face for `request`, loaded once.
  const Face& face(const FaceRequest& request);

  /// Letters that the face has not are left out, and counted.
  SetLine set_line(const Face& face, std::u32string_view text);

  /// How far the next letter is from one; 0 where the face has it not, which is counted.
  double advance(const Face& face, char32_t letter);

  /// Says which faces stand for which, and what is missing.
  void report(Diagnostics& diagnostics, const std::string& file) const;

 private:
  std::map<FaceRequest, std::unique_ptr<Face>> faces_;
  std::map<std::string, std::set<char32_t>> missing_;  ///< by the file of the face
  std::set<char32_t> unshaped_;
};

/// Loops of one text that fill an area together: united by the nonzero rule, whichever way round the face draws its letters.
class TextLoops {
 public:
  /// Adds `letter` of `face` under `map` (em to mm).
  void add(const Face& face, char32_t letter, const Affine& map);
  void add(const Face& face, const SetLine& line, const Affine& map);

  /// All that was added; without a compound they are outlines like any others.
  std::vector<RawCurve> take(const std::string& source, std::optional<Compound> compound);

 private:
  std::vector<Path> loops_;
};

}  // namespace clearcut::read
