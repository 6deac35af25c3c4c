// Expressions in brackets, parameters and functions, as controls with macros compute them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace clearcut::read::gcode {

/// A number, or nothing: Fanuc's vacant variables count as 0 in sums and make a word of a block disappear.
struct MacroValue {
  double number = 0;
  bool is_vacant = false;
};

/// Whose rules of expressions hold: order of operators, rounding, equality.
enum class MacroStyle : unsigned char { kLinuxCnc, kFanuc };

/// Where expressions find parameters. Each throws InputError where the control has no such parameter or nothing states its value.
class MacroVariables {
 public:
  MacroVariables() = default;
  MacroVariables(const MacroVariables&) = delete;
  MacroVariables& operator=(const MacroVariables&) = delete;
  virtual ~MacroVariables() = default;

  virtual MacroValue numbered(int number) = 0;
  virtual double named(const std::string& name) = 0;
  virtual bool exists(const std::string& name) const = 0;
  /// What ATAN gives for two sides whose angle, from -180 to 180 degrees, is below 0.
  virtual double angle_below_zero(double degrees) { return degrees; }
};

/// Reads values from a line without blanks and in upper case; `at` moves behind what was read. Throws InputError(place, ...) for what
/// the control would not take. Nesting is bounded.
class Expression {
 public:
  /// Keeps references to all but the style.
  Expression(std::string_view line, std::size_t& at, MacroStyle style, MacroVariables& variables,
             const std::string& place)
      : line_(line), at_(at), style_(style), variables_(variables), place_(place) {}

  /// A number, a parameter, a bracket or a function.
  MacroValue value();
  /// Values and operators up to what is none: a sum without brackets around it.
  MacroValue sum() { return terms(1); }
  /// The number behind a '#' that was read, for parameters that have one.
  int parameter_number();
  /// The name in '<' and '>' that comes next.
  std::string name();

  bool at_end() const { return at_ >= line_.size(); }
  char next() const { return at_end() ? '\0' : line_[at_]; }
  bool skip(std::string_view text);

 private:
  struct Operator {
    int kind = 0;
    int strength = 0;
  };

  MacroValue bracket();
  MacroValue terms(int weakest);
  MacroValue parameter();
  MacroValue function();
  MacroValue existence();
  double plain_number();
  double arc_tangent();
  double angle_of_sides(double opposite, double adjacent);
  Operator peek(std::size_t& length) const;
  MacroValue computed(int kind, MacroValue left, MacroValue right) const;
  double applied(int function, double argument) const;
  double checked(double number) const;
  [[noreturn]] void refuse(const std::string& what) const;

  std::string_view line_;
  std::size_t& at_;
  MacroStyle style_;
  MacroVariables& variables_;
  const std::string& place_;
  int depth_ = 0;
};

/// Rounded half away from zero; throws InputError(place, ...) where the number is no whole one, within a ten thousandth.
int whole_number(double number, const std::string& what, const std::string& place);

}  // namespace clearcut::read::gcode
