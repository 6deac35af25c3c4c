// Collects the machine's motion as a toolpath: joins moves, guesses their kind, cuts the program into
// sections, and keeps what the control held meanwhile.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "base/diagnostics.h"
#include "model/control.h"
#include "model/move.h"
#include "read/gcode/motion/arc.h"
#include "read/gcode/motion/compensation.h"
#include "read/gcode/motion/corner.h"

namespace clearcut::read::gcode {

/// Values of X, Y, Z; absent where not given. mm, in the frame of the work offset.
using Target = std::array<std::optional<double>, 3>;

/// What drives the tool; a change between two feed moves begins a new section.
struct Drive {
  int tool = 0;
  double spindle_rpm = 0;  ///< 0 while stopped
  bool clockwise = true;
  Coolant coolant = Coolant::kOff;
  friend bool operator==(const Drive&, const Drive&) = default;
};

struct BuilderSetup {
  std::string file_name;
  double home_z =
      0;  ///< mm, height of places above the work that the program does not state: the start, machine home
  double safe_z = 0;  ///< mm, nothing stands above it
};

/// Where the program starts is unknown: a coordinate is known once it has been given, and the first move
/// begins at its own coordinates. What that leaves open is a condition.
class ToolpathBuilder {
 public:
  ToolpathBuilder(BuilderSetup setup, Diagnostics& diagnostics, std::vector<Condition>& conditions);

  Drive drive;
  double speed = 0;  ///< S word, rpm, also while the spindle is off
  ToolLength length;
  PathControl path_control;

  /// The next move begins a new section, named for the table of figures alone.
  void begin_section(std::string label, int workingstep);
  /// A tool is put in, by the changer or during a pause.
  void change_tool(int number, bool by_hand, int line);
  void add_event(ControlEventKind kind, int line, double seconds = 0);
  /// At the bottom of a tapping cycle.
  void turn_tap_back(const TapCycle& tap, int line);
  /// The spindle turns (3, 4) or stops (5).
  void set_spindle(int m, int line);
  /// A word was met that turns spindles, whatever it does here.
  void say_spindle() { control_.spindle_said = true; }
  void say_speed() { control_.speed_said = true; }
  void say_units(bool inch, int line);
  /// The line of a subprogram from which the next moves come, with the calls that led to this line; "": none.
  void set_calls(const std::string& text);

  void rapid(const Target& target, int line);
  void feed(const Target& target, MmPerMin feed, int line);
  /// Along `path` (which starts at the known position) to height z_to.
  /// `apart`: mm between the radii at the ends of the whole arc.
  void arc(const Edge& path, double z_to, MmPerMin feed, int line, double apart = 0);
  /// The same along an arc as programs say it, in even pieces, from the known height to z_to.
  void arc(const ArcShape& shape, double z_to, MmPerMin feed, int line, double apart = 0);
  /// The moves that follow, up to the next round_corner(), lead to a corner that is rounded or chamfered: the last one waits for the move
  /// behind the corner.
  void expect_corner(int line);
  /// At the end of the last move. Throws InputError where that is none that waits.
  void round_corner(const Corner& corner);
  bool waits_at_corner() const { return corner_.has_value(); }
  /// Straight up to where the machine's own zero is taken to be.
  void lift_home(int line);
  bool at_home_height() const { return at_[2] && *at_[2] >= setup_.home_z; }
  /// X or Y are at a place of the machine now that is not known here; `name` is the condition for going on from there.
  void leave_plan(const std::string& name);

  /// From here on the places of moves are those of the contour, beside which the tool's centre runs. `radius`: mm, 0 where the centre
  /// runs on the contour itself.
  void begin_compensation(const CompensationRules& rules, CompensationSide side, double radius);
  /// The next move in plan leads from where the centre is to its own place.
  void end_compensation();
  bool compensates() const { return compensated_.has_value(); }
  bool compensates_as(CompensationSide side, double radius) const {
    return compensated_ && compensated_->side == side && compensated_->radius == radius;
  }
  /// The next move in plan is the first or the first behind the end of one with a radius above 0.
  bool compensation_begins() const;
  bool compensation_leaves() const { return beside_.has_value(); }
  const std::set<int>& compensated_tools() const { return compensated_tools_; }
  /// At the end of the text, in that line: no compensation is on, no corner waits for its second move.
  void require_nothing_open(int line) const;

  const Target& position() const { return at_; }
  /// What happened between moves so far.
  const std::vector<ControlEvent>& events() const { return control_.events; }
  double safe_z() const { return setup_.safe_z; }
  double home_z() const { return setup_.home_z; }
  /// Coordinate of `axis`, taken as 0 under a condition where the program has not said it.
  double known(std::size_t axis, int line);
  void place_at(std::size_t axis, double value) { at_[axis] = value; }

  Toolpath take() { return std::move(toolpath_); }
  ControlTable take_control() { return std::move(control_); }
  /// Adds `what` once, with the line where it was first seen.
  void note(int line, const std::string& what);
  void warn(int line, const std::string& what);
  /// Adds a condition once by its name, with the line where it was first met.
  void condition(const std::string& name, int line, const std::string& what);
  std::string place(int line) const { return setup_.file_name + ":" + std::to_string(line); }

 private:
  /// Vertical moves made before X and Y are known.
  struct Unplaced {
    double z_from = 0;
    double z_to = 0;
    int line = 0;
  };

  /// A control that compensates looks ahead: what comes with moves that wait waits with them.
  struct State {
    Drive drive;
    bool turns = false;
    double speed = 0;
    ToolLength length;
    PathControl path;
    int calls = -1;
  };
  struct SectionStart {
    std::string label;
    int workingstep = -1;
  };
  /// A move that leads to a corner, with what the control held for it.
  struct BeforeCorner {
    Move move;
    double apart = 0;
    State state;
  };
  using Deferred = std::variant<ControlEvent, SectionStart, State, double>;
  struct Compensated {
    CompensationRules rules;
    CompensationSide side = CompensationSide::kLeft;
    double radius = 0;
    std::optional<Compensation> moves;  ///< from the first move on
    /// For each programmed move what comes before it, its state and, for arcs, how far its radii are apart.
    std::vector<std::vector<Deferred>> before;
  };

  void straight(const Target& target, bool rapid, MmPerMin feed, int line);
  void take(const Move& move, double apart);
  void take_at_corner(const Move& move, double apart);
  void pass(Move move, double apart);
  std::optional<Move> pass_corner(Move move);
  void pass_as(const State& held, const Move& move, double apart);
  void require_no_corner(int line, const std::string& what) const;
  void leave_contour(Move& move);
  void defer(const Deferred& what);
  bool defers() const { return compensated_ && compensated_->moves; }
  void give(const std::vector<OffsetMove>& moves);
  void bring(const Deferred& what);
  State state() const { return {drive, drive_turns_, speed, length, path_control, calls_}; }
  void use(const State& state);
  void note_outside_corner();
  void check_return(const Target& target, bool rapid, int line);
  void check_start(const Target& target, int line);
  void place_first_rapids(Vec2 place);
  void append(const Move& move);
  void keep_control(int line);
  Section& section_for(const Move& move);
  void check_size(int line);

  BuilderSetup setup_;
  Diagnostics& diagnostics_;
  std::vector<Condition>& conditions_;
  std::set<std::string> said_;
  Toolpath toolpath_;
  ControlTable control_;
  Target at_;
  std::vector<Unplaced> unplaced_;
  bool expects_corner_ = false;
  std::optional<BeforeCorner> before_corner_;
  std::optional<Corner> corner_;  ///< at the end of that move
  std::optional<Compensated> compensated_;
  std::optional<Vec2> beside_;  ///< where the centre is behind the end of a compensation, until it leaves
  bool exit_takes_height_ = false;
  std::set<int> compensated_tools_;
  std::string away_;  ///< condition for going on from an unknown place of the machine
  double highest_;
  std::string label_;
  int workingstep_ = -1;
  bool new_section_ = true;
  bool section_cuts_ = false;
  bool drive_turns_ = false;
  long long moves_ = 0;
  int calls_ = -1;  ///< into ControlTable::call_texts
  std::map<std::string, int> calls_known_;
};

}  // namespace clearcut::read::gcode
