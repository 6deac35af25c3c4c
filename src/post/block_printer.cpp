#include "post/block_printer.h"

#include <algorithm>
#include <string>

#include "post/words/comment.h"

namespace clearcut::post {
namespace {

constexpr int kNumberStep = 10;
constexpr int kGreatestNumber = 99990;  // controls read five digits; then they begin again
constexpr std::size_t kLongestNumber = std::string_view("N99990 ").size();

}  // namespace

void BlockPrinter::word(std::string_view text) {
  if (!block_.empty()) block_ += ' ';
  block_ += text;
}

void BlockPrinter::word(char letter, long long ticks, const PrintGrid& grid) {
  if (!block_.empty()) block_ += ' ';
  block_ += letter;
  append_number(block_, ticks, grid.decimals(), dialect_.always_point);
}

std::size_t BlockPrinter::packed_size() const {
  return block_.size() - static_cast<std::size_t>(std::count(block_.begin(), block_.end(), ' '));
}

void BlockPrinter::end_block() {
  const std::size_t number = numbered_ || due_number_ > 0 ? kLongestNumber : 0;
  if (block_.size() + number > dialect_.line_length) std::erase(block_, ' ');
  line(block_);
  block_.clear();
}

void BlockPrinter::line(std::string_view text) {
  // Comments, the tape's ends and the program's number have their own lines.
  const bool is_block =
      !text.empty() && std::string_view("(;%O").find(text.front()) == std::string_view::npos;
  if (numbered_ && is_block) out_ += 'N' + std::to_string(next_number()) + ' ';
  if (!numbered_ && is_block && due_number_ > 0) out_ += 'N' + std::to_string(due_number_) + ' ';
  if (is_block) due_number_ = 0;
  out_ += text;
  out_ += '\n';
}

int BlockPrinter::next_number() {
  number_ = number_ == kGreatestNumber ? kNumberStep : number_ + kNumberStep;
  return number_;
}

void BlockPrinter::title(const std::string& number, std::string_view name) {
  const std::string both = number + " (" + plain_comment(name) + ")";
  if (!number.empty() && !name.empty() && both.size() <= dialect_.line_length) return line(both);
  if (!number.empty()) line(number);
  if (!name.empty()) comment(name);
}

void BlockPrinter::comment(std::string_view text) {
  for (const std::string& piece : comment_pieces(text, dialect_.line_length - 2))
    line(dialect_.comments == CommentForm::kParentheses ? "(" + piece + ")" : "; " + piece);
}

}  // namespace clearcut::post
