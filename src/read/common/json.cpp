#include <cctype>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "read/common/data_value.h"

namespace clearcut::read {
namespace {

constexpr int kDeepestValue = 64;

/// Position of the parser in the text. The parser reads one character ahead after a number, so the line is that of
/// the last character other than white space.
struct Position {
  int line = 1;
  int pending = 0;  ///< line ends passed since
  void pass(char c) {
    if (c == '\n') {
      ++pending;
    } else if (c != ' ' && c != '\t' && c != '\r') {
      line += pending;
      pending = 0;
    }
  }
};

/// Input iterator that updates `position` with every character read.
class Reader {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  Reader(const char* at, Position* position) : at_(at), position_(position) {}
  reference operator*() const { return *at_; }
  Reader& operator++() {
    position_->pass(*at_);
    ++at_;
    return *this;
  }
  Reader operator++(int) {
    Reader before = *this;
    ++*this;
    return before;
  }
  bool operator==(const Reader& other) const { return at_ == other.at_; }

 private:
  const char* at_;
  Position* position_;
};

/// Builds DataValues from the parser's events.
class Builder {
 public:
  using number_integer_t = nlohmann::json::number_integer_t;
  using number_unsigned_t = nlohmann::json::number_unsigned_t;
  using number_float_t = nlohmann::json::number_float_t;
  using string_t = nlohmann::json::string_t;
  using binary_t = nlohmann::json::binary_t;

  Builder(const std::string& file_name, const Position& position) : file_(file_name), position_(position) {}

  bool null() { return put({}); }
  bool boolean(bool value) {
    DataValue made;
    made.kind = DataValue::Kind::kBoolean;
    made.boolean = value;
    return put(std::move(made));
  }
  bool number_integer(number_integer_t value) { return put_number(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) { return put_number(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t&) { return put_number(value); }
  bool string(string_t& value) {
    DataValue made;
    made.kind = DataValue::Kind::kString;
    made.text = value;
    return put(std::move(made));
  }
  bool binary(binary_t&) { return false; }
  bool start_object(std::size_t) { return open(DataValue::Kind::kObject); }
  bool start_array(std::size_t) { return open(DataValue::Kind::kArray); }
  bool key(string_t& name) {
    keys_.back() = name;
    return true;
  }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception& error) {
    fail(reason_of(error.what()));
  }

  DataValue take() { return std::move(root_); }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(file_ + ":" + std::to_string(position_.line), what);
  }
  /// The part of the library's message about the text, in printable characters.
  static std::string reason_of(const std::string& message) {
    const auto colon = message.find(": ");
    std::string reason = colon == std::string::npos ? message : message.substr(colon + 2);
    if (reason.size() > 160) reason = reason.substr(0, 160) + "...";
    for (char& c : reason) {
      if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
    }
    return "not JSON (" + reason + "); mend the text there";
  }
  bool put_number(double value) {
    DataValue made;
    made.kind = DataValue::Kind::kNumber;
    made.number = value;
    return put(std::move(made));
  }
  bool put(DataValue value) {
    value.line = position_.line;
    return attach(std::move(value));
  }
  bool attach(DataValue value) {
    if (open_.empty()) {
      root_ = std::move(value);
    } else if (open_.back().is_object()) {
      open_.back().members.push_back({keys_.back(), std::move(value)});
    } else {
      open_.back().items.push_back(std::move(value));
    }
    return true;
  }
  bool open(DataValue::Kind kind) {
    if (open_.size() >= kDeepestValue) fail("nested deeper than 64 levels; this is not an outline");
    DataValue made;
    made.kind = kind;
    made.line = position_.line;
    open_.push_back(std::move(made));
    keys_.emplace_back();
    return true;
  }
  bool close() {
    DataValue done = std::move(open_.back());
    open_.pop_back();
    keys_.pop_back();
    return attach(std::move(done));
  }

  const std::string& file_;
  const Position& position_;
  DataValue root_;
  std::vector<DataValue> open_;
  std::vector<std::string> keys_;
};

}  // namespace

DataValue parse_json(std::string_view text, const std::string& file_name) {
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
  Position position;
  Builder builder(file_name, position);
  nlohmann::json::sax_parse(Reader(text.data(), &position), Reader(text.data() + text.size(), &position),
                            &builder);
  return builder.take();
}

}  // namespace clearcut::read
