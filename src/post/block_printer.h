// Lines of a word-address program.
#pragma once

#include <string>
#include <string_view>
#include <utility>

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
  bool in_block() const { return !block_.empty(); }
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

}  // namespace clearcut::post
