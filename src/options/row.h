// An option of a plan: all its properties, in one row.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "options/plan_options.h"
#include "options/value.h"

namespace clearcut::inline options {

/// All values that the rows can set.
struct Asked {
  PlanOptions plan;
  InputOptions input;
};

/// Heading in the help under which an option is listed.
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
  kCopies,
  kController,
  kSearch,
  kPublishedSolver
};
const char* name_of(Group group);

/// Whom an option is for.
enum class Level : unsigned char {
  kFirst,    ///< needed for a first program: shown by `plan --help`
  kRest,     ///< `plan --help all`
  kResearch  ///< the same, at its end
};

/// The table of a job file with the option's key.
enum class JobTable : unsigned char { kNone, kPart, kTools, kPlan, kMachine, kOutput };
/// "part", "tools", "plan", "machine", "output"; "" for none.
const char* name_of(JobTable table);

/// Kinds of input files of a part. Bits of a set.
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

/// Checks of programs that take an option. Bits of a set.
enum Checks : unsigned {
  kNoCheck = 0,         ///< none: the option serves planning
  kCheckOfProgram = 1,  ///< of a program without its part
  kCheckOfPart = 2,     ///< of a program against its part
  kCheckOfTexts = 4,    ///< either, by the function of texts, which reads no file
  kAllChecks = 7
};

/// Kinds of work on a feature. Bits of a set.
enum Works : unsigned {
  kHoleMaking = 1,      ///< along the tool's axis: drills, taps, reamers and the like
  kBoring = 2,          ///< a round hole milled along a helix
  kClearing = 4,        ///< areas, layer by layer: pockets, slots, steps, faces
  kProfiling = 8,       ///< beside an outline
  kFollowing = 16,      ///< along a line: engraving
  kCarving = 32,        ///< by a cone as deep as the outline is wide
  kChamfering = 64,     ///< the edge of a wall
  kUndercutting = 128,  ///< T-slots
  kMilling = 254,
  kAllWorks = 255
};

struct Situation;

/// Cases in which an option has an effect. In all other cases the option is refused.
struct Effect {
  unsigned inputs = kAllInputs;
  unsigned works = kAllWorks;
  /// Why the option has no effect in this plan, in words: "no pass begins with a lead, see --lead"; "" if it has an
  /// effect. Null: it always has one.
  std::string (*idle_because)(const Situation&) = nullptr;
};

/// Place of the value of a row in the options.
struct Field {
  bool is_of_plan = true;  ///< in Asked::plan; false: in Asked::input
  void (*set)(Asked&, const Value&, const std::vector<std::string>& names) = nullptr;
  std::optional<Value> (*get)(const Asked&, const std::vector<std::string>& names) = nullptr;
  /// Puts the value back that the options have before anything is stated.
  void (*clear)(Asked&) = nullptr;
};

struct Row {
  std::string name = {};  ///< name typed after "--"
  Group group = Group::kInput;
  unsigned checks = kNoCheck;  ///< Checks
  Level level = Level::kRest;
  ValueKind kind = ValueKind::kFlag;
  std::string sentence = {};  ///< effect of the option, as text of the help
  std::string fallback = {};  ///< default with its reason; "" for none
  Field field = {};
  Range range = between(-kLongestLength, kLongestLength);
  std::string unit = {};  ///< unit of numbers: "degrees", "s", "rpm"
  /// For kChoice: all valid names; for other kinds: examples for completion.
  std::vector<std::string> names = {};
  std::string type = {};  ///< placeholder of the value in the help: "FILE", "X,Y"; "" for the kind's own
  JobTable table = JobTable::kNone;
  std::string key = {};          ///< key in the job table; "": the name with underscores
  std::string example = {};      ///< example value for a sample job; "": the kind's example
  bool key_is_opposite = false;  ///< "no-arcs" is arcs = false
  /// Names for which a job may write false and true; empty for none.
  std::vector<std::string> flag_names = {};
  bool (*is_known)(const std::string&) = nullptr;  ///< for texts: whether a text is valid; null: any text is
  std::string known = {};              ///< list of valid texts for the message about an invalid one
  bool is_of_operations = false;       ///< also permitted in an [[operation]] of a job
  std::optional<double> neutral = {};  ///< the number that requests no effect
  Effect effect = {};

  std::string job_key() const;
  /// Unit of its numbers: "mm", "mm/min", "degrees"; "" for none.
  std::string counted_in() const;
  /// The sentence of help: effect, unit and its default.
  std::string described() const;
  /// A valid value of the row, as text.
  std::string shown_example() const;
};

/// Every option of `plan`, in the order of its help.
const std::vector<Row>& rows();
/// Null if there is none of this name.
const Row* row_named(const std::string& name);

/// The value of a text. Throws InputError at `place`, naming the valid texts.
Value value_of_text(const Row& row, const std::string& text, const std::string& place);
/// The same for several texts, for rows with several values.
Value value_of_texts(const Row& row, const std::vector<std::string>& texts, const std::string& place);
/// Throws InputError at `place` if a value is out of the row's range or none of its names.
void check_value(const Row& row, const Value& value, const std::string& place);
/// Checks every value in `asked`; places in messages are `prefix` plus the option's name.
void check_values(const Asked& asked, const std::string& prefix);

}  // namespace clearcut::inline options
