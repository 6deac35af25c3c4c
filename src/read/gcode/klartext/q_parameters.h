// Q parameters of Klartext: FN functions, and values in the words of blocks.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace clearcut::read::gcode {

/// What an FN block asks for besides a value.
struct FnBlock {
  std::optional<std::string> jump;  ///< label to go on at
};

class QParameters {
 public:
  /// Executes FN 0 to FN 7 and FN 9 to FN 12. Throws InputError(place, ...) for other functions, for parameters that nothing has set, and for FN 14,
  /// at which the control stops.
  FnBlock execute(const std::vector<std::string>& words, const std::string& place);
  /// Executes "Q1 = +5" and "Q1 = +Q2"; false where the block sets a cycle's parameter, Q200 and on, or none.
  bool assign(const std::vector<std::string>& words, const std::string& place);
  /// Puts numbers in the place of Q parameters, "X+Q1" and "FQ2"; of "Q200=+Q5" behind the equals sign.
  void put_values(std::vector<std::string>& words, const std::string& place) const;

 private:
  double value_of(int parameter, const std::string& place) const;
  double operand(const std::string& text, std::size_t& at, const std::string& place) const;
  double computed(int function, const std::string& text, std::size_t& at, const std::string& place) const;

  std::map<int, double> values_;
};

}  // namespace clearcut::read::gcode
