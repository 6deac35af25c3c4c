// Expressions and variables of Siemens' own language: R parameters, variables of DEF, operators, functions.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "read/gcode/sinumerik/words.h"

namespace clearcut::read::gcode {

enum class SinumerikType : unsigned char { kReal, kInt, kBool, kText };

/// A number or a text.
struct SinumerikResult {
  double number = 0;
  std::string text;
  bool is_text = false;
};

/// A variable of DEF; several values are an array.
struct SinumerikVariable {
  SinumerikType type = SinumerikType::kReal;
  std::vector<SinumerikResult> values;
};

/// Parameters and variables that a line can read and set.
struct SinumerikMemory {
  std::map<int, double> r;  ///< R parameters that the program has set
  std::vector<std::map<std::string, SinumerikVariable>> variables{
      1};  ///< of the program, and of each subprogram that runs

  SinumerikVariable* named(const std::string& name);
};

/// Reads expressions from a line in capitals; `at` moves behind what was read. Nesting is bounded.
///
/// Comparisons bind weaker than AND, OR and XOR on this control: where both stand in one expression without parentheses it is refused.
class SinumerikFormula {
 public:
  /// Keeps references to all.
  SinumerikFormula(std::string_view line, std::size_t& at, SinumerikMemory& memory, const RefuseBlock& refuse)
      : line_(line), at_(at), memory_(memory), refuse_(refuse) {}

  SinumerikResult value();
  double number();
  /// What is set by "R1=", "R[2]=" or "NAME=", "NAME[1]=" comes next and is set. False where nothing of the kind stands there; `at` stays then.
  bool assignment();

 private:
  struct Operator {
    int kind = 0;
    int strength = 0;
    std::size_t length = 0;
  };

  char peek(std::size_t ahead = 0) const { return at_ + ahead < line_.size() ? line_[at_ + ahead] : '\0'; }
  void skip_blanks();
  bool take(char c);
  void expect(char c, const char* what);
  std::string name();
  Operator next_operator() const;
  SinumerikResult terms(int weakest, bool& compares, bool& joins);
  SinumerikResult operand();
  SinumerikResult literal();
  SinumerikResult named(const std::string& name);
  SinumerikResult function(const std::string& name);
  double computed(int kind, double a, double b) const;
  double checked(double value) const;
  int whole(double value, const char* what) const;
  int r_number(const std::string& name);
  std::size_t index_in(const SinumerikVariable& variable, const std::string& name);

  std::string_view line_;
  std::size_t& at_;
  SinumerikMemory& memory_;
  const RefuseBlock& refuse_;
  int depth_ = 0;
};

/// A value as the type holds it: whole numbers are rounded, truth is 0 or 1.
SinumerikResult as_type(SinumerikType type, SinumerikResult value, const RefuseBlock& refuse);

/// The shortest decimals that read back equal, without an exponent.
std::string sinumerik_number(double value);

}  // namespace clearcut::read::gcode
