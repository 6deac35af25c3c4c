// An installed face of a font: the outlines and the measures of its letters.
#pragma once

#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "geometry/edge.h"
#include "read/common/affine.h"

namespace clearcut::read {

/// Font requested by a drawing.
struct FaceRequest {
  std::vector<std::string> families;  ///< the first one wins; empty: the machine's own choice
  bool bold = false;
  bool italic = false;
  friend bool operator==(const FaceRequest&, const FaceRequest&) = default;
  friend bool operator<(const FaceRequest& a, const FaceRequest& b) {
    return std::tie(a.families, a.bold, a.italic) < std::tie(b.families, b.bold, b.italic);
  }
};

/// Found by fontconfig, read with FreeType; neither scaled to pixels nor hinted. All lengths are in em: the font's
/// size is 1. Immutable, but not to be used by several threads at once.
class Face {
 public:
  /// The installed face nearest to `request`. Throws InputError if there is none, or no library for reading fonts.
  explicit Face(const FaceRequest& request);
  ~Face();
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;

  const std::string& file_name() const;  ///< without its folder
  const std::string& name() const;       ///< its family and style, "DejaVu Sans Bold"
  const std::string& family() const;     ///< the requested family that it matches; "" if it is a substitute
  bool is_bold() const;
  bool is_italic() const;

  bool has(char32_t letter) const;
  /// From a letter's origin to the next one's.
  double advance(char32_t letter) const;
  /// Distance added between two letters by the face's table `kern`; 0 if there is none.
  double kerning(char32_t left, char32_t right) const;
  /// Extent of a letter above and below the baseline; 0 if it is missing in the face.
  double top_of(char32_t letter) const;
  double bottom_of(char32_t letter) const;
  /// Height of a capital, 'H'; 0.7 if the face has none.
  double cap_height() const;

  /// Closed loops of `letter` under `map` (em to mm), bounding it by the nonzero rule. Curves within kCurveTolerance.
  std::vector<Path> outline(char32_t letter, const Affine& map) const;

 private:
  struct Loaded;
  std::unique_ptr<Loaded> loaded_;
};

}  // namespace clearcut::read
