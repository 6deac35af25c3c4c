// The text of SVG elements: numbers, attributes, nesting, and paths with real arcs.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/region.h"

namespace clearcut::report {

/// Three decimals, trailing zeros removed; "0" for what is not finite.
std::string svg_number(double value);

/// False for points that no picture can hold: not finite, or farther than 10 km from the origin.
bool drawable(Vec2 p);
bool drawable(const Edge& edge);

/// Data of a <path>: lines and true arcs, in the frame of the edges (x right, y up).
class PathData {
 public:
  /// Continues the curve when `edge` begins where the last one ended. What is not drawable is left out.
  void add(const Edge& edge);
  void add(const Loop& closed);
  void add(const Region& region);
  void add(const Regions& regions);
  /// A point: a disc when it is stroked with round caps.
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
  /// An element with words in it, such as <title>.
  void words(std::string_view element, std::string_view content, const Attributes& attributes = {});
  /// Elements that another writer has written.
  void raw(const std::string& elements) { text_ += elements; }
  /// A name that no other call returns.
  std::string new_id(std::string_view stem);
  const std::string& str() const { return text_; }

 private:
  void begin(std::string_view element, const Attributes& attributes);
  std::string text_;
  std::vector<std::string> open_;
  int ids_ = 0;
};

}  // namespace clearcut::report
