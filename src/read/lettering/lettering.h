// Letters of drawings as outlines: the faces used for the requested ones, lines of letters, and diagnostics.
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

/// A letter of a line, and the distance of its origin from the line's start, em.
struct SetLetter {
  char32_t letter = 0;
  double x = 0;
};

/// Letters side by side with their kerning; em.
struct SetLine {
  std::vector<SetLetter> letters;
  double width = 0;  ///< up to the beginning of a next letter
};

class Lettering {
 public:
  /// The face for `request`, loaded once.
  const Face& face(const FaceRequest& request);

  /// Letters missing in the face are left out and counted.
  SetLine set_line(const Face& face, std::u32string_view text);

  /// Advance from a letter to the next; 0 if it is missing in the face; missing letters are counted.
  double advance(const Face& face, char32_t letter);

  /// Reports substituted faces and missing letters.
  void report(Diagnostics& diagnostics, const std::string& file) const;

 private:
  std::map<FaceRequest, std::unique_ptr<Face>> faces_;
  std::map<std::string, std::set<char32_t>> missing_;  ///< missing letters by the file of the face
  std::set<char32_t> unshaped_;
};

/// Loops of one text filling an area together: united by the nonzero rule, for either orientation of the face's
/// letters.
class TextLoops {
 public:
  /// Adds `letter` of `face` under `map` (em to mm).
  void add(const Face& face, char32_t letter, const Affine& map);
  void add(const Face& face, const SetLine& line, const Affine& map);

  /// All added loops; without a compound they are ordinary outlines.
  std::vector<RawCurve> take(const std::string& source, std::optional<Compound> compound);

 private:
  std::vector<Path> loops_;
};

}  // namespace clearcut::read
