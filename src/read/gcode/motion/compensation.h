// Cutter radius compensation: where a control runs the centre of the tool while a program states the contour (G41,
// G42, RL, RR), and what the tables of the control hold of tools' radii, as far as it was said.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/move.h"

namespace clearcut::read::gcode {

struct CompensationValues {
  std::map<int, double> radii;        ///< mm, by the number of the tool
  std::optional<double> only_radius;  ///< mm, of the one tool there is, whatever number it is called by
  std::optional<double> wear;         ///< mm; programs follow the tool's centre, and every D word holds this
  bool is_stated = false;             ///< somebody said which of the two it is
};

/// Where the tool's centre runs, seen along the contour.
enum class CompensationSide : signed char { kRight = -1, kLeft = 1 };

/// Where the first move ends.
enum class EntryRule : unsigned char {
  kAcrossEntry,  ///< beside its own end, a radius across its own direction (LinuxCNC, Fanuc's type B at inside corners)
  kAcrossNext  ///< beside its own end, a radius across the beginning of the next move (Fanuc's type A, Siemens, Heidenhain)
};

/// How two moves are joined round an outside corner.
enum class OutsideCorner : unsigned char {
  kArc,   ///< by an arc about the corner
  kLines  ///< by lines: up to where both meet, and where the corner is sharper than 90 degrees across
};

/// What controls do otherwise than each other.
struct CompensationRules {
  EntryRule entry = EntryRule::kAcrossNext;
  OutsideCorner outside = OutsideCorner::kArc;
  /// radians; moves that turn by less are taken as tangent: none is trimmed, nothing is inserted.
  double tangent = 1e-4;
  bool begins_in_plan = false;  ///< the first move after the word has to move X or Y by more than the radius
  /// radians; so much more than was programmed an arc may sweep before it counts as running round the other way: a
  /// thousandth of a turn.
  double more_sweep = 0.00628;
  bool looks_at_all = true;  ///< a move that would run backwards stops the control wherever it is
  bool exit_takes_height =
      false;  ///< the first move after the end goes to the programmed place, also where it says Z alone
  int most_still =
      1;  ///< moves without X and Y that the control looks beyond, of which an inside corner may have no more
  std::string_view outside_needs =
      {};  ///< condition where an outside corner is joined; empty: every such control does so
};

/// A move of the tool's centre and the number of the programmed move that it comes from, counted from 0.
struct OffsetMove {
  Move move;
  std::size_t from = 0;
};

/// Takes programmed moves one by one and gives those of the tool's centre. Looks one move in plan ahead: each waits until the corner
/// behind it is known. Follows the geometry that LinuxCNC's interpreter documents.
class Compensation {
 public:
  /// `radius`: mm, > 0. `place`: where the centre is. `file_name` is for messages.
  Compensation(const CompensationRules& rules, CompensationSide side, double radius, Vec2 place,
               std::string file_name);

  /// `said`: a line or an arc of less than a full turn. Throws InputError where the control would stop.
  std::vector<OffsetMove> add(const Move& said);
  /// Moves that wait, ended a radius across the last one.
  std::vector<OffsetMove> end();
  /// No move in plan was added.
  bool begins() const { return !began_; }
  /// Of the centre, after end().
  Vec2 place() const { return place_; }
  /// Lines of an outside corner that was joined; 0: none.
  int outside_corner_line() const { return outside_line_; }

 private:
  /// A move held back until the next move in plan states the corner between them, or a move of Z within that corner.
  struct Waiting {
    OffsetMove offset;
    Vec2 direction;    ///< of lines, as programmed
    double sweep = 0;  ///< radians, of arcs, as programmed
    Vec2 begins;       ///< from where its way is looked at
  };

  void stand(const Move& said);
  void begin(const Move& said);
  void go_on(const Move& said);
  void join_inside(const Move& said);
  void join_outside(const Move& said, double outside);
  void join_by_arc(const Move& said, Vec2 next_begins);
  void join_by_lines(const Move& said, Vec2 next_begins, double outside);
  void put_in_line(const Move& said, Vec2 to);
  void wait_for(const Move& said);

  void settle(Vec2 end, bool looks);
  void give(const OffsetMove& offset);
  void give_arc(const OffsetMove& offset);
  void check(const Waiting& waiting, Vec2 end) const;

  bool is_inside(const Edge& arc) const;
  double radius_beside(const Edge& arc) const;
  Vec2 beside(Vec2 place, Vec2 direction) const;
  Vec2 meeting(const Move& said) const;
  Vec2 line_meets_arc(Vec2 on_line, Vec2 along, const Edge& arc, bool later, int line) const;
  Vec2 arc_meets_arc(const Edge& before, const Edge& after, int line) const;
  double height() const;
  [[noreturn]] void refuse(int line, const std::string& what) const;

  CompensationRules rules_;
  CompensationSide side_;
  double radius_;
  Vec2 place_;  ///< where the moves given so far end
  std::string file_name_;
  std::vector<Waiting> waiting_;
  std::vector<OffsetMove> given_;
  Edge before_;   ///< the last programmed move in plan
  Vec2 heading_;  ///< its direction at its end
  double z_ = 0;
  bool began_ = false, entry_open_ = false;
  std::size_t count_ = 0;
  int outside_line_ = 0;
};

}  // namespace clearcut::read::gcode
