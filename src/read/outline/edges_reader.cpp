#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

#include "base/elementary.h"
#include "base/error.h"
#include "base/text.h"
#include "base/tolerances.h"
#include "base/units.h"
#include "geometry/side_list.h"
#include "read/common/text.h"
#include "read/drawing/drawing.h"
#include "read/outline/outline_reader.h"
#include "read/repair/repair.h"

namespace clearcut::read {
namespace {

constexpr std::size_t kMostEdges = 1'000'000;
/// mm. Closing error of ordinary drawings with rounded lengths and angles.
constexpr double kClosing = 0.05;
/// rad. Printed angles add up to (N - 2) pi within this; beyond it the input is not as intended.
constexpr double kAngleExcess = 0.02;
/// mm. Straight pieces between two arcs may be this much too short by rounding.
constexpr double kTouching = 1e-6;

const char* const kKeys = "name, unit, start, orientation, lengths, top, depth, closing";

/// The words of one line, up to its comment.
struct Line {
  int number = 0;
  std::vector<std::string> words;
};

/// Content of the file, numbers in its own unit and in degrees.
struct Draft {
  std::optional<std::string> name;
  std::optional<std::string> unit;
  Vec2 start;
  double orientation = 0;
  bool to_corners = true;  ///< lengths extend to the corners, not only to the beginning of arcs
  std::optional<double> top;
  std::optional<double> depth;
  std::optional<double> closing;
  std::vector<Side> sides;
  std::vector<int> line_of_side;
};

std::vector<Line> lines_of(std::string_view text) {
  std::vector<Line> lines;
  const char line_end = line_end_of(text);
  int number = 0;
  while (!text.empty()) {
    const auto end = text.find(line_end);
    std::string_view rest = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    rest = rest.substr(0, rest.find('#'));
    Line line{++number, {}};
    constexpr std::string_view kBlanks = " \t\r,;\xEF\xBB\xBF";
    for (auto from = rest.find_first_not_of(kBlanks); from != std::string_view::npos;
         from = rest.find_first_not_of(kBlanks)) {
      rest.remove_prefix(from);
      const auto word = rest.substr(0, rest.find_first_of(kBlanks));
      line.words.emplace_back(word);
      rest.remove_prefix(word.size());
    }
    if (!line.words.empty()) lines.push_back(std::move(line));
  }
  return lines;
}

std::optional<double> number_in(const std::string& word) {
  double value = 0;
  const char* first = word.data() + (word.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(first, word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  Draft read(std::string_view text) {
    for (const auto& line : lines_of(text)) {
      line_ = line.number;
      const char first = line.words.front().front();
      const bool is_number = (first >= '0' && first <= '9') || first == '+' || first == '-' || first == '.';
      is_number ? read_edge(line) : read_key(line);
    }
    if (draft_.sides.size() < 3) {
      fail(fmt::format("{} edges enclose nothing; give at least three lines LENGTH ANGLE",
                       draft_.sides.size()));
    }
    return std::move(draft_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}:{}", file_, std::max(line_, 1)), what);
  }

  double number(const Line& line, std::size_t word, const char* what) const {
    const auto value = number_in(line.words[word]);
    if (!value) fail(fmt::format("'{}' is no number; give {}", printable(line.words[word]), what));
    return *value;
  }

  void read_edge(const Line& line) {
    if (line.words.size() < 2 || line.words.size() > 3)
      fail("an edge is LENGTH ANGLE or LENGTH ANGLE RADIUS");
    if (draft_.sides.size() == kMostEdges) fail("more than a million edges; divide the outline");
    Side side;
    side.length = number(line, 0, "a length");
    side.angle = number(line, 1, "an interior angle in degrees") * kPi / 180;
    if (line.words.size() == 3) side.radius = number(line, 2, "the radius of the arc at the edge's end");
    if (!(side.length > 0)) fail("the length must be above 0");
    if (!(side.angle > kSameAngleRad && side.angle < 2 * kPi - kSameAngleRad)) {
      fail("the interior angle must lie between 0 and 360 degrees");
    }
    if (!(side.radius >= 0)) fail("the radius must be 0 or more");
    if (side.radius > 0 && std::abs(side.angle - kPi) < kSameAngleRad)
      fail("a corner of 180 degrees has no arc");
    draft_.sides.push_back(side);
    draft_.line_of_side.push_back(line.number);
  }

  const std::string& value_of(const Line& line) const {
    if (line.words.size() != 2) fail("'" + printable(line.words[0]) + "' takes one value");
    return line.words[1];
  }

  double number_of(const Line& line) const {
    value_of(line);
    return number(line, 1, "one");
  }

  void read_key(const Line& line) {
    const std::string key = capitals(line.words[0]);
    if (key == "NAME") {
      if (line.words.size() < 2) fail("'name' takes a name");
      draft_.name = fmt::format("{}", fmt::join(line.words.begin() + 1, line.words.end(), " "));
    } else if (key == "UNIT") {
      draft_.unit = value_of(line);
      require_unit(*draft_.unit, fmt::format("{}:{}", file_, line.number));
    } else if (key == "START") {
      if (line.words.size() != 3) fail("'start' takes x and y");
      draft_.start = {number(line, 1, "x"), number(line, 2, "y")};
    } else if (key == "ORIENTATION") {
      draft_.orientation = number_of(line) * kPi / 180;
    } else if (key == "TOP") {
      draft_.top = number_of(line);
    } else if (key == "DEPTH") {
      draft_.depth = number_of(line);
    } else if (key == "CLOSING") {
      draft_.closing = number_of(line);
      if (!(*draft_.closing >= 0)) fail("'closing' must be 0 or more");
    } else if (key == "LENGTHS") {
      read_meaning_of_lengths(capitals(value_of(line)));
    } else {
      fail(fmt::format("'{}' is unknown; use {}, or begin an edge with its length", printable(line.words[0]),
                       kKeys));
    }
  }

  void read_meaning_of_lengths(const std::string& value) {
    if (value != "CORNERS" && value != "TANGENTS") fail("'lengths' is corners or tangents");
    draft_.to_corners = value == "CORNERS";
  }

  const std::string& file_;
  int line_ = 0;
  Draft draft_;
};

void scale(Draft& draft, double unit, const std::string& file) {
  draft.start = draft.start * unit;
  for (std::size_t i = 0; i < draft.sides.size(); ++i) {
    auto& side = draft.sides[i];
    side.length *= unit;
    side.radius *= unit;
    if (side.length > kLargestCoordinate || side.radius > kLargestCoordinate) {
      throw InputError(fmt::format("{}:{}", file, draft.line_of_side[i]),
                       "the edge is longer than 1000 m; check its number and unit");
    }
  }
}

/// The outline in mm with straight lengths between arcs. (x0, y0) is the first corner, rounded or not.
SideList side_list_of(const Draft& draft, const std::string& file) {
  SideList list{draft.start, draft.orientation, draft.sides};
  const auto& given = draft.sides;
  for (std::size_t i = 0; i < given.size() && draft.to_corners; ++i) {
    const double before = tangent_length(given[(i + given.size() - 1) % given.size()]);
    const double after = tangent_length(given[i]), straight = given[i].length - before - after;
    if (straight < -kTouching) {
      throw InputError(
          fmt::format("{}:{}", file, draft.line_of_side[i]),
          fmt::format("the arcs at its ends take {} mm of an edge of {} mm; make the radii smaller",
                      trimmed(before + after, 4), trimmed(given[i].length, 4)));
    }
    list.sides[i].length = std::max(0.0, straight);
  }
  const double first = tangent_length(given.back());
  list.start = list.start + Vec2{base::cos(list.orientation), base::sin(list.orientation)} * first;
  return list;
}

void check_angles(const SideList& list, const std::string& file, Diagnostics& diagnostics) {
  const double excess = angle_excess(list);
  const auto text = [&](double factor) { return trimmed(Radians::of(factor).degrees(), 4); };
  const double closed = (static_cast<double>(list.sides.size()) - 2) * kPi;
  const std::string sums = fmt::format("the interior angles add up to {} degrees, those of {} edges to {}",
                                       text(closed + excess), list.sides.size(), text(closed));
  if (std::abs(excess) > kAngleExcess) {
    throw InputError(file, sums + "; give the angle inside the material at the end of each edge");
  }
  if (std::abs(excess) > 1e-9) diagnostics.warn(file, sums + "; the last angle follows from the others");
}

/// The closed loop; its closing error is noted, or repaired up to `most` mm, or refused.
Loop closed_loop(const SideList& list, double most, const std::string& file, Diagnostics& diagnostics) {
  const Path trace = traced(list);
  if (trace.size() < 2) throw InputError(file, "the edges have no length; check their unit");
  const Vec2 missed = closing_error(trace);
  const std::string text = fmt::format("closing error {} mm (dx {}, dy {})", trimmed(norm(missed), 6),
                                       trimmed(missed.x, 6), trimmed(missed.y, 6));
  if (!(norm(missed) <= most + kTouching)) {
    throw InputError(
        file,
        text + fmt::format("; up to {} mm is shared out; correct the lengths and angles, or set closing",
                           trimmed(most, 6)));
  }
  if (norm(missed) > 1e-6) {
    diagnostics.repair(file, text + ", shared out along the outline");
  } else {
    diagnostics.note(file, text);
  }
  return closed_by_compass_rule(trace);
}

Regions regions_of(Loop loop, const std::string& file, const ReadOptions& options, Diagnostics& diagnostics) {
  RepairOptions repairs;
  repairs.tol = options.tol;
  repairs.where = file;
  repairs.open_curves = options.open_curves.value_or(OpenCurves::kRefuse);
  repairs.find_arcs = options.find_arcs.value_or(false);
  RawCurve curve;
  curve.edges = std::move(loop);
  curve.closed = true;
  curve.source = "outline";
  return repair({std::move(curve)}, repairs, diagnostics);
}

double depth_of(const Draft& draft, double unit, const std::string& file, const ReadOptions& options,
                Diagnostics& diagnostics) {
  if (options.depth) return checked_depth(*options.depth, "depth");
  if (draft.depth) return checked_depth(unit * *draft.depth, file);
  if (!options.depth_if_missing)
    throw InputError(file, "no depth given; add a line 'depth 2' or give --depth");
  diagnostics.warn(file, "no depth given: " + trimmed(*options.depth_if_missing, 4) + " mm assumed");
  return checked_depth(*options.depth_if_missing, "depth");
}

}  // namespace

Part read_edges(std::string_view text, const std::string& file_name, const ReadOptions& options) {
  Draft draft = Reader(file_name).read(text);
  const double unit = require_unit(options.unit ? *options.unit : draft.unit.value_or("mm"), "unit");
  scale(draft, unit, file_name);
  Part part;
  part.source_file = file_name;
  part.name = draft.name.value_or(std::filesystem::path(file_name).stem().string());
  const SideList list = side_list_of(draft, file_name);
  check_angles(list, file_name, part.diagnostics);
  const double most = draft.closing ? unit * *draft.closing : kClosing;
  Loop loop = closed_loop(list, most, file_name, part.diagnostics);
  Feature feature;
  feature.name = part.name.empty() ? "pocket" : part.name;
  feature.source = "outline";
  feature.top_z = options.top ? *options.top : unit * draft.top.value_or(0);
  if (!(std::abs(feature.top_z) <= kLargestCoordinate)) throw InputError(file_name, "'top' is out of range");
  feature.floor_z = feature.top_z - depth_of(draft, unit, file_name, options, part.diagnostics);
  feature.target = regions_of(std::move(loop), file_name, options, part.diagnostics);
  feature.allowed = feature.target;
  add_features(part, {std::move(feature)});
  return part;
}

}  // namespace clearcut::read
