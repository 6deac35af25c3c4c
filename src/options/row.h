// An option of a plan: everything that is known of it, in one row.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "options/input_options.h"
#include "options/plan_options.h"
#include "options/value.h"

namespace clearcut::inline options {

/// Everything that the rows can set.
struct Asked {
  PlanOptions plan;
  InputOptions input;
};

/// Under which heading help lists an option.
enum class Group : unsigned char {
  kInput,
  kSolids,
  kDrawings,
  kTools,
  kMachine,
  kLimits,
  kStrategy,
  kEntry,
  kLeads,
  kFeeds,
  kStages,
  kController,
  kSearch,
  kPublishedSolver
};
const char* name_of(Group group);

/// Whom an option is for.
enum class Level : unsigned char {
  kFirst,    ///< of a first program: `plan --help` shows it
  kRest,     ///< `plan --help all`
  kResearch  ///< the same, at its end
};

/// The table of a job file that has the option's key.
enum class JobTable : unsigned char { kNone, kPart, kTools, kPlan, kMachine, kOutput };
/// "part", "tools", "plan", "machine", "output"; "" for none.
const char* name_of(JobTable table);

/// Kinds of files that a part is read from. Bits of a set.
enum InputKinds : unsigned {
  kStepNcInput = 1,
  kSolidInput = 2,
  kDxfInput = 4,
  kSvgInput = 8,
  kBoardInput = 16,  ///< Gerber and Excellon
  kOutlineInput = 32,
  kSegmentsInput = 64,
  kDrawingInputs = kDxfInput | kSvgInput | kBoardInput,
  kFlatInputs = kDrawingInputs | kOutlineInput | kSegmentsInput,
  kAllInputs = 127
};

struct Situation;

/// Where an option has an effect. Where it has none it is refused.
struct Effect {
  unsigned inputs = kAllInputs;
  /// Why the option has no effect in this plan, in words: "no pass begins with a lead, see --lead"; "" where it has one. Null: it
  /// always has.
  std::string (*idle_because)(const Situation&) = nullptr;
};

/// Where the value of a row is kept.
struct Field {
  void (*set)(Asked&, const Value&, const std::vector<std::string>& names) = nullptr;
  std::optional<Value> (*get)(const Asked&, const std::vector<std::string>& names) = nullptr;
};

struct Row {
  std::string name = {};  ///< as typed after "--"
  Group group = Group::kInput;
  Level level = Level::kRest;
  ValueKind kind = ValueKind::kFlag;
  std::string sentence = {};  ///< what it does, as help says it
  std::string fallback = {};  ///< what holds where nobody says, with the reason; "" for none
  Field field = {};
  Range range = between(-kLongestLength, kLongestLength);
  std::string unit = {};  ///< of numbers: "degrees", "s", "rpm"
  std::vector<std::string> names =
      {};                 ///< of kChoice: all there are; of other kinds: examples for completion
  std::string type = {};  ///< what help calls the value: "FILE", "X,Y"; "" for the kind's own
  JobTable table = JobTable::kNone;
  std::string key = {};          ///< in that table; "": the name with underscores
  std::string example = {};      ///< of a value, for a job that shows how; "": one that the kind gives
  bool key_is_opposite = false;  ///< "no-arcs" is arcs = false
  /// Names that a job may write as false and true; empty for none.
  std::vector<std::string> flag_names = {};
  bool (*is_known)(const std::string&) = nullptr;  ///< of texts: whether one means something; null: any does
  std::string known = {};                          ///< what to write instead of a text that means nothing
  bool is_of_operations = false;                   ///< an [[operation]] of a job may have it, too
  std::optional<double> neutral = {};              ///< the number by which nothing is asked
  Effect effect = {};

  std::string job_key() const;
  /// What its numbers are counted in: "mm", "mm/min", "degrees"; "" for none.
  std::string counted_in() const;
  /// The sentence of help: what it does, its unit and its default.
  std::string described() const;
  /// A value that the row takes, as text.
  std::string shown_example() const;
};

/// Every option of `plan`, in the order of its help.
const std::vector<Row>& rows();
/// Null where there is none of that name.
const Row* row_named(const std::string& name);

/// The value that a text stands for. Throws InputError at `place` with what is right.
Value value_of_text(const Row& row, const std::string& text, const std::string& place);
/// The same of several texts, for rows that take several.
Value value_of_texts(const Row& row, const std::vector<std::string>& texts, const std::string& place);
/// Throws InputError at `place` where a value is out of the row's range or none of its names.
void check_value(const Row& row, const Value& value, const std::string& place);
/// Checks every value that `asked` holds, at the places that `prefix` and the names of options give.
void check_values(const Asked& asked, const std::string& prefix);

}  // namespace clearcut::inline options
