// The text of SVG elements: numbers, attributes, nesting, and paths with real arcs.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/region.h"

namespace clearcut::report {

/// Three decimals, trailing zeros removed; "0" for non-finite numbers.
std::string svg_number(double value);

/// False for points outside of any picture: not finite, or farther than 10 km from the origin.
bool drawable(Vec2 p);
bool drawable(const Edge& edge);

/// Data of a <path>: lines and true arcs, in the frame of the edges (x right, y up).
class PathData {
 public:
  /// Continues the curve if `edge` begins at the end of the last one. Undrawable edges are left out.
  void add(const Edge& edge);
  void add(const Loop& closed);
  void add(const Region& region);
  void add(const Regions& regions);
  /// A point: a disc if stroked with round caps.
  void add(Vec2 point);
  const std::string& text() const { return text_; }
  bool empty() const { return text_.empty(); }

 private:
  void line_to(Vec2 p);
  void arc_to(const Edge& arc);
  std::string text_;
  Vec2 pen_;
  bool down_ = false;
};

/// Writes elements in order; every text and attribute value is escaped here and nowhere else.
class SvgWriter {
 public:
  using Attributes = std::vector<std::pair<std::string_view, std::string>>;
  void open(std::string_view element, const Attributes& attributes);
  void close();
  void leaf(std::string_view element, const Attributes& attributes);
  void text(Vec2 at, std::string_view content, const Attributes& attributes);
  /// An element with text content, such as <title>.
  void words(std::string_view element, std::string_view content, const Attributes& attributes = {});
  /// Appends elements written by another writer.
  void raw(const std::string& elements) { text_ += elements; }
  /// A unique name.
  std::string new_id(std::string_view stem);
  const std::string& str() const { return text_; }

 private:
  void begin(std::string_view element, const Attributes& attributes);
  std::string text_;
  std::vector<std::string> open_;
  int ids_ = 0;
};

}  // namespace clearcut::report
