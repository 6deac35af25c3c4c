#include "post/block_printer.h"

#include "post/comment.h"

namespace clearcut::post {

void BlockPrinter::word(std::string_view text) {
  if (!block_.empty()) block_ += ' ';
  block_ += text;
}

void BlockPrinter::word(char letter, long long ticks, const PrintGrid& grid) {
  if (!block_.empty()) block_ += ' ';
  block_ += letter;
  append_number(block_, ticks, grid.decimals(), dialect_.always_point);
}

void BlockPrinter::end_block() {
  if (block_.size() > dialect_.line_length) std::erase(block_, ' ');
  line(block_);
  block_.clear();
}

void BlockPrinter::line(std::string_view text) {
  out_ += text;
  out_ += '\n';
}

void BlockPrinter::comment(std::string_view text) {
  const std::string plain = plain_comment(text);
  const std::size_t room = dialect_.line_length - 2;
  std::size_t begin = 0;
  do {
    const std::string piece = plain.substr(begin, room);
    line(dialect_.comments == CommentForm::kParentheses ? "(" + piece + ")" : "; " + piece);
    begin += room;
  } while (begin < plain.size());
}

}  // namespace clearcut::post
