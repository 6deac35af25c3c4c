#include "order/tsplib.h"

#include <charconv>
#include <vector>

#include "base/error.h"
#include "base/text.h"

namespace clearcut::order {

namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

/// Lines of a text with their numbers, and words of a line.
class Lines {
 public:
  Lines(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

  /// Next non-blank line, trimmed; false at the end.
  bool next(std::string_view& line) {
    while (!rest_.empty()) {
      const auto end = rest_.find(line_end_);
      line = stripped(rest_.substr(0, end));
      rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
      ++number_;
      if (!line.empty()) return true;
    }
    return false;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(name_ + ":" + std::to_string(number_), what);
  }

 private:
  std::string_view rest_;
  char line_end_ = line_end_of(rest_);
  std::string name_;
  int number_ = 0;
};

std::string_view take_word(std::string_view& line) {
  line = stripped(line);
  std::size_t end = 0;
  while (end < line.size() && !is_blank(line[end])) ++end;
  const std::string_view word = line.substr(0, end);
  line.remove_prefix(end);
  return word;
}

template <class Number>
Number take_number(std::string_view& line, const Lines& lines, const char* what) {
  std::string_view word = take_word(line);
  if (word.size() > 1 && word.front() == '+') word.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) {
    lines.fail(std::string("'") + std::string(word) + "' is not " + what + "; correct it");
  }
  return value;
}

struct Keyword {
  std::string_view key;
  std::string_view value;
};

Keyword split_keyword(std::string_view line) {
  const auto colon = line.find(':');
  if (colon == std::string_view::npos) return {line, {}};
  return {stripped(line.substr(0, colon)), stripped(line.substr(colon + 1))};
}

void expect_value(const Keyword& keyword, std::string_view wanted, const Lines& lines) {
  std::string_view value = keyword.value;
  if (take_word(value) != wanted) {
    lines.fail(std::string(keyword.key) + " is " + std::string(keyword.value) + "; only " +
               std::string(wanted) + " is read");
  }
}

void read_nodes(Lines& lines, int dimension, Problem& problem) {
  std::vector<bool> seen(static_cast<std::size_t>(dimension), false);
  problem.points.resize(static_cast<std::size_t>(dimension));
  std::string_view line;
  for (int i = 0; i < dimension; ++i) {
    if (!lines.next(line) || line == "EOF") {
      lines.fail("the file ends after " + std::to_string(i) + " of " + std::to_string(dimension) +
                 " points; correct DIMENSION or add the points");
    }
    const int id = take_number<int>(line, lines, "a node number");
    if (id < 1 || id > dimension) {
      lines.fail("node " + std::to_string(id) + " is outside 1.." + std::to_string(dimension) +
                 "; correct it");
    }
    if (seen[static_cast<std::size_t>(id - 1)])
      lines.fail("node " + std::to_string(id) + " comes twice; remove one");
    seen[static_cast<std::size_t>(id - 1)] = true;
    const double x = take_number<double>(line, lines, "a coordinate");
    const double y = take_number<double>(line, lines, "a coordinate");
    problem.points[static_cast<std::size_t>(id - 1)] = {x, y};
  }
}

}  // namespace

Problem read_tsplib(std::string_view text, const std::string& name) {
  Lines lines(text, name);
  Problem problem;
  problem.name = name;
  problem.metric = Metric::kRoundedEuc2d;
  int dimension = 0;
  bool has_nodes = false;
  std::string_view line;
  while (lines.next(line) && line != "EOF") {
    Keyword keyword = split_keyword(line);
    if (keyword.key == "NAME") {
      problem.name = std::string(keyword.value);
    } else if (keyword.key == "TYPE") {
      expect_value(keyword, "TSP", lines);
    } else if (keyword.key == "EDGE_WEIGHT_TYPE") {
      expect_value(keyword, "EUC_2D", lines);
    } else if (keyword.key == "DIMENSION") {
      dimension = take_number<int>(keyword.value, lines, "a number of points");
      // A node takes six characters at least: a larger number is a mistake, found before memory is allocated.
      if (dimension < 1 || static_cast<std::size_t>(dimension) > text.size()) {
        lines.fail("DIMENSION does not fit the file; correct it");
      }
    } else if (keyword.key == "NODE_COORD_SECTION") {
      if (dimension == 0) lines.fail("DIMENSION must come before NODE_COORD_SECTION; add it");
      if (has_nodes) lines.fail("a second NODE_COORD_SECTION; remove one");
      read_nodes(lines, dimension, problem);
      has_nodes = true;
    } else if (keyword.value.empty() && keyword.key != "COMMENT" && keyword.key != "DISPLAY_DATA_TYPE") {
      lines.fail("'" + std::string(line.substr(0, 40)) +
                 "' is no TSPLIB keyword with a value; remove the line");
    }
  }
  if (!has_nodes) lines.fail("no NODE_COORD_SECTION; only instances given by coordinates are read");
  check(problem);
  return problem;
}

Tour read_tsplib_tour(std::string_view text, const std::string& name, int size) {
  Lines lines(text, name);
  std::string_view line;
  bool in_section = false;
  while (!in_section && lines.next(line)) in_section = split_keyword(line).key == "TOUR_SECTION";
  if (!in_section) lines.fail("no TOUR_SECTION; give a file of TYPE : TOUR");
  Tour tour;
  std::vector<bool> seen(static_cast<std::size_t>(size), false);
  while (lines.next(line) && line != "EOF") {
    while (!stripped(line).empty()) {
      const int id = take_number<int>(line, lines, "a node number");
      if (id == -1) break;
      if (id < 1 || id > size)
        lines.fail("node " + std::to_string(id) + " is outside 1.." + std::to_string(size));
      if (seen[static_cast<std::size_t>(id - 1)]) lines.fail("node " + std::to_string(id) + " comes twice");
      seen[static_cast<std::size_t>(id - 1)] = true;
      tour.push_back(id - 1);
    }
    if (stripped(line).empty() && static_cast<int>(tour.size()) == size) break;
  }
  if (static_cast<int>(tour.size()) != size) {
    lines.fail("the tour has " + std::to_string(tour.size()) + " of " + std::to_string(size) +
               " nodes; add the rest");
  }
  return tour;
}

std::string write_tsplib_tour(const Tour& tour, const std::string& name) {
  std::string text =
      "NAME : " + name + "\nTYPE : TOUR\nDIMENSION : " + std::to_string(tour.size()) + "\nTOUR_SECTION\n";
  for (const int v : tour) text += std::to_string(v + 1) + "\n";
  return text + "-1\nEOF\n";
}

}  // namespace clearcut::order
