#include "read/board/gerber_commands.h"

#include "base/error.h"

namespace clearcut::read {
namespace {

class Splitter {
 public:
  explicit Splitter(const std::string& file) : file_(file) {}

  void add(char c) {
    if (c == '\n') ++line_;
    if (c == '%' && !is_comment()) {
      in_extended_ ? end_extended() : begin_extended();
    } else if (c == '*') {
      end_block();
    } else if (static_cast<unsigned char>(c) >= ' ') {
      if (block_.empty()) block_line_ = line_;
      block_ += c;
    }
  }

  std::vector<GerberCommand> take() {
    if (in_extended_) fail();
    if (block_.find_first_not_of(' ') != std::string::npos) end_block();
    return std::move(commands_);
  }

 private:
  bool is_comment() const { return block_.starts_with("G04"); }

  [[noreturn]] void fail() const {
    throw InputError(file_ + ":" + std::to_string(begin_line_),
                     "a command that begins with % has no end; the file is damaged, export it again");
  }

  void begin_extended() {
    end_block();
    in_extended_ = true;
    begin_line_ = line_;
    begin_ = commands_.size();
  }

  void end_extended() {
    end_block();
    in_extended_ = false;
    if (begin_ == commands_.size() || !commands_[begin_].text.starts_with("AM")) return;
    for (std::size_t i = begin_ + 1; i < commands_.size(); ++i)
      commands_[begin_].blocks.push_back(std::move(commands_[i].text));
    commands_.resize(begin_ + 1);
  }

  void end_block() {
    if (block_.find_first_not_of(' ') != std::string::npos)
      commands_.push_back({std::move(block_), {}, in_extended_, block_line_});
    block_.clear();
  }

  const std::string& file_;
  std::vector<GerberCommand> commands_;
  std::string block_;
  int line_ = 1, block_line_ = 1, begin_line_ = 1;
  std::size_t begin_ = 0;  ///< the first command of the extended ones
  bool in_extended_ = false;
};

}  // namespace

std::vector<GerberCommand> gerber_commands(std::string_view text, const std::string& file) {
  Splitter splitter(file);
  for (const char c : text) splitter.add(c);
  return splitter.take();
}

}  // namespace clearcut::read
