// A part as whoever made it up describes it: how deep cutters may go at each place, and how deep they have to. The description is text, so
// that the maker of random parts, which is a script, and the judge share nothing with the product.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "support/independent/profile_field.h"

namespace clearcut::test_support {

/// A shape in the plane: how far a place lies within it, mm, negative outside.
struct MadeShape {
  enum class Kind { kAll, kDisc, kBox, kPath, kPolygon } kind = Kind::kAll;
  double x = 0, y = 0;           ///< centre
  double width = 0, height = 0;  ///< kBox
  double round = 0;              ///< radius of a disc, of the corners of a box, half the width of a path
  double angle = 0;              ///< radians that a box is turned
  std::vector<std::pair<double, double>> path;  ///< corners of its middle line, of kPolygon of its outline

  double inside(double px, double py) const;
};

/// Heights over how far a place lies inside: a jump at the first point, straight between points.
struct HeightCurve {
  std::vector<std::pair<double, double>> points;

  /// Nothing where the place lies before the first point.
  std::optional<double> at(double inside) const;
};

/// One thing that is cut into the part.
struct MadeElement {
  std::string name;
  MadeShape shape;
  std::vector<MadeShape> islands;
  std::optional<double> band;           ///< only within this distance of the shape's outline
  HeightCurve low, high;                ///< cutters may come down to, have to come down to
  std::optional<double> undercut_roof;  ///< its room from `low` to here lies under material
  struct Reach {
    double radius = 0, flat = 0, foot = 0;
  };
  std::optional<Reach> reach;  ///< of a cutter that comes to all places where it fits; else all is asked

  double inside(double x, double y) const;
  /// Whether that cutter certainly comes down there.
  bool is_reached(double x, double y) const;
};

struct MadeThread {
  double x = 0, y = 0;
  double crest = 0, root = 0;  ///< radii; the root of an inner thread is the wider
  double pitch = 0, top = 0, bottom = 0;
  int hand = 1;  ///< 1: right

  bool is_inner() const { return root > crest; }
};

/// A tool of this kind comes down on the axis to this height.
struct MadeVisit {
  std::string kind;
  double x = 0, y = 0, z = 0;
};

struct MadeCutter {
  std::string kind;
  TurnedBody body;
  double pitch = 0;   ///< of taps and thread mills
  double length = 0;  ///< of the rows of a thread mill, 0: one row
  bool may_plunge = true;
};

struct MadePart {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0, bottom = 0;
  double zero_x = 0, zero_y = 0, zero_z = 0;  ///< where programs have the origin of the description
  std::map<int, MadeCutter> cutters;
  std::vector<MadeElement> elements;
  std::vector<MadeThread> threads;
  std::vector<MadeVisit> visits;
};

/// Lines of words, as tests/campaign/parts.py writes them. Throws std::runtime_error for a word that it does not know.
MadePart made_part(const std::string& description);

}  // namespace clearcut::test_support
