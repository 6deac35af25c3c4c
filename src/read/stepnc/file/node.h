// Entities with their arguments, as the STEP-NC mapping sees them: lenient about what careless writers leave
// out or write in another type, exact about where something is wrong.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostics.h"
#include "base/tolerances.h"
#include "base/units.h"
#include "read/part21/part21.h"

namespace clearcut::read::stepnc {

/// One entity. Argument numbers count from 0; arguments beyond the end of the list are unset. A handle: the
/// P21File must outlive it. What is read of it counts as used (P21File::uses), what is only asked for with unset() does not.
class Node {
 public:
  Node(const P21File& file, const P21Entity& entity);

  std::uint64_t id() const { return entity_->id; }
  int line() const { return entity_->line; }
  const std::string& keyword() const { return keyword_; }  ///< upper case; "A+B" for complex instances
  bool is(std::string_view keyword) const { return keyword_ == keyword; }
  template <typename... Names>
  bool is_any(const Names&... names) const {
    return (is(names) || ...);
  }
  /// "#216 CLOSED_POCKET".
  std::string label() const { return "#" + std::to_string(id()) + " " + keyword_; }
  /// Throws InputError("file:line", "#216 CLOSED_POCKET: ...").
  [[noreturn]] void fail(const std::string& what_and_what_to_do) const;

  bool unset(std::size_t i) const;
  /// Counts as used although its value is not read: what is written there is what is done anyway.
  void use(std::size_t i) const;
  bool is_used(std::size_t i) const;
  std::size_t arguments() const;  ///< number of them
  /// The value as Part 21 writes it, with what it refers to in the place of references down to a few levels; without blanks.
  std::string shown(std::size_t i) const;
  /// Integers, reals, typed numbers, and references to measures that hold one. Fails for anything else that
  /// is set.
  std::optional<double> number(std::size_t i) const;
  double needed_number(std::size_t i, std::string_view what) const;
  /// number() that must be a length within 1 km, in mm whatever the file's unit. Of a toleranced length the middle of its field.
  std::optional<double> length(std::size_t i) const;
  double needed_length(std::size_t i, std::string_view what) const;
  std::optional<Node> ref(std::size_t i) const;
  /// ref() for what can be done without: nothing where the reference is broken.
  std::optional<Node> sound_ref(std::size_t i) const;
  Node needed_ref(std::size_t i, std::string_view what) const;
  /// References in a list; unset gives none, a single reference gives one.
  std::vector<Node> refs(std::size_t i) const;
  std::vector<double> numbers(std::size_t i) const;
  std::vector<double> lengths(std::size_t i) const;  ///< numbers() in mm
  /// Strings decoded and trimmed; "" when unset.
  std::string text(std::size_t i) const;
  std::string enumeration(std::size_t i) const;  ///< upper case, "" when unset
  std::optional<bool> flag(std::size_t i) const;
  /// Raw values of list argument i.
  std::vector<P21Value> list(std::size_t i) const;
  const P21File& file() const { return *file_; }
  P21Value peek(std::size_t i) const;  ///< the value, without using it

 private:
  P21Value value(std::size_t i) const;
  double in_mm(const P21Value& value, double number) const;
  Node resolve(const P21Value& reference) const;
  std::optional<double> number_of(const P21Value& value) const;

  const P21File* file_;
  const P21Entity* entity_;
  const P21Record* record_;
  std::string keyword_;
};

/// All entities of one kind, in file order.
std::vector<Node> nodes_called(const P21File& file, std::string_view keyword);

/// Of conditions: what the file asks for and nobody does.
inline constexpr const char* kNotFollowed = "not-followed";

/// Radians. The largest angle that is still a full turn: 6.2832 and 6.28319 are 2 pi with few digits.
inline constexpr double kRoundedTurn = 2 * kPi + 5e-5;

/// What every part of the mapping needs: tolerances, where to report, and the units that the file leaves
/// open.
class Context {
 public:
  /// `in_degrees`: the file says that its angles are.
  Context(const P21File& file, const Tolerances& tol, bool in_degrees = false);

  const P21File& file;
  Tolerances tol;
  Diagnostics diagnostics;
  bool degrees = false;                    ///< angles are in degrees (some angle is above 2 pi), else radians
  std::optional<std::uint64_t> workpiece;  ///< the one that is machined
  std::set<std::uint64_t> operations;      ///< those that a workingstep of the workplan carries out
  bool spindle_rpm = false;  ///< spindle speeds are in rpm (some are 1000 per second or more), else 1/s
  /// Feeds, speeds, angles and shares are in the standard's units for certain: the file is of Clearcut's own writer.
  bool standard_units = false;

  /// File's angle to radians.
  double angle(double value) const;
  /// `otherwise`: radians where the file states none.
  double angle(const std::optional<double>& value, double otherwise) const {
    return value ? angle(*value) : otherwise;
  }
  /// The same for an angle that must be below 90 degrees: larger values are degrees in any file.
  double draft_angle(double value) const;
  /// Notes that hold for many entities are given once, with the entities' labels; see flush().
  void note(const std::string& what, const Node& node) { gather(Severity::kNote, what, node); }
  void warn(const std::string& what, const Node& node) { gather(Severity::kWarning, what, node); }
  /// The workpiece and the list of operations of a feature count as used where they say what the workplan says.
  void use_head(const Node& feature) const;
  /// What the entity refers to has been spoken of as a whole: the ledger of what is not used passes over it.
  void said(const Node& node) { said_.insert(node.id()); }
  bool is_said(std::uint64_t id) const { return said_.count(id) > 0; }
  /// Moves the gathered notes to diagnostics, in the order of their first mention.
  void flush();
  /// Counts work; throws InputError when references that share one another would expand without bound.
  void spend(std::size_t amount, const Node& node);

 private:
  void gather(Severity severity, const std::string& what, const Node& node);
  struct Group {
    Severity severity;
    std::string what;
    std::vector<std::string> labels;
  };
  std::vector<Group> groups_;
  std::set<std::uint64_t> said_;
  std::size_t spent_ = 0;
};

}  // namespace clearcut::read::stepnc
