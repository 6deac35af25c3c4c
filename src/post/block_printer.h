// Lines of a word-address program.
#pragma once

#include <string>
#include <string_view>

#include "post/iso_dialect.h"
#include "post/print_grid.h"

namespace clearcut::post {

class BlockPrinter {
 public:
  explicit BlockPrinter(const IsoDialect& dialect) : dialect_(dialect) {}

  /// Adds a word to the block begun.
  void word(std::string_view text);
  void word(char letter, long long ticks, const PrintGrid& grid);
  bool in_block() const { return !block_.empty(); }
  /// Ends the block, without its spaces if the line would be too long for the control.
  void end_block();
  /// A whole line as it is.
  void line(std::string_view text);
  /// One comment, on as many lines as its length needs.
  void comment(std::string_view text);

  std::string take() { return std::move(out_); }

 private:
  const IsoDialect& dialect_;
  std::string out_;
  std::string block_;
};

}  // namespace clearcut::post
