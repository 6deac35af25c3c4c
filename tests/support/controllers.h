// What the tests expect of each controller, one row each, from its manual and not from the code that writes and reads its programs.
// docs/adding-a-controller.md tells what a new row needs.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace clearcut::test_support {

struct Controller {
  std::string_view name;
  std::size_t line_length = 80;                     ///< of the longest line that it takes
  bool junction_deviation = false;                  ///< its planner slows down at corners by it
  bool always_point = false;                        ///< a coordinate without a point is in increments
  std::vector<std::string_view> never = {};         ///< what no block of its programs contains
  std::string_view mist_condition = {};             ///< empty: every such control has mist
  std::vector<std::string_view> work_offsets = {};  ///< of all_work_offsets(), without G54
  std::string_view work_offsets_said = {};          ///< behind "has no ...: ", for the others
  std::string_view home = {};                       ///< blocks of the end position "home"; empty: it has none
  std::string_view home_condition = {};             ///< empty: home is a place of the machine
  /// Open conditions of a program of ours with several tools, beside those of the part.
  std::vector<std::string> of_tools = {};
  std::string_view pecks = {};  ///< word of its pecking cycle; empty: its holes are moves
};

/// In the order of kControllers; a test holds both equal.
std::span<const Controller> controllers();
/// Of this name, which there has to be.
const Controller& controller_named(std::string_view name);
/// One or two of each kind that some control has, in words of programs.
std::span<const std::string_view> all_work_offsets();

}  // namespace clearcut::test_support
