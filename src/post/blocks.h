// Lines of a word-address program, and holes as Sinumerik's cycles: CYCLE81 to CYCLE85 and CYCLE840, called at each
// place by MCALL.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "model/part.h"
#include "post/words/drill_cycle.h"
#include "post/words/iso_dialect.h"
#include "post/words/print_grid.h"

namespace clearcut::post {

class BlockPrinter {
 public:
  /// `numbered`: every block begins with an N word, in tens.
  explicit BlockPrinter(const IsoDialect& dialect, bool numbered = false)
      : dialect_(dialect), numbered_(numbered) {}

  /// Adds a word to the block begun.
  void word(std::string_view text);
  void word(char letter, long long ticks, const PrintGrid& grid);
  /// Characters of the block begun, without its blanks.
  std::size_t packed_size() const;
  /// Ends the block, without its spaces if the line would be too long for the control.
  void end_block();
  /// The next block begins with this N word, unless all have theirs.
  void number_next(int number) { due_number_ = number; }
  /// A whole line unchanged, after its number.
  void line(std::string_view text);
  /// The program's number, or "", and its name, or "": in one block if there is room, as controls list them together.
  void title(const std::string& number, std::string_view name);
  /// One comment, on as many lines as its length needs.
  void comment(std::string_view text);

  /// The lines so far; others follow from then on.
  std::string take() { return std::exchange(out_, {}); }

 private:
  int next_number();

  const IsoDialect& dialect_;
  bool numbered_;
  int number_ = 0;      ///< number of the previous block
  int due_number_ = 0;  ///< number of the next block; 0: none
  std::string out_;
  std::string block_;
};

/// Data of a call in addition to the hole itself.
struct CycleCall {
  const DrillBlock& hole;
  const Tool* tap = nullptr;  ///< null for other tools
  long long spindle_rpm = 0;
  bool clockwise = true;  ///< the spindle before and after the cycle
  double dwell_s = 0;     ///< at the bottom
};

/// Whether a cycle of the control does exactly what the moves of the hole do. In chip breaking the cycle rises at the
/// feed and not at the rapid, so those holes are written as moves; so are holes with a dwell after the pecks.
bool has_cycle(const DrillBlock& hole, double dwell_s);

/// "MCALL CYCLE81(10,2,0,-5)": the height before and after, the plane at which feeding begins, and the bottom, all
/// absolute. In inch programs the pitch of a tap is in inches, too.
std::string cycle_call(const CycleCall& call, const PrintGrid& grid, bool inch);

}  // namespace clearcut::post
