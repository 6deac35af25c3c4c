#include "read/part21/part21.h"

#include <algorithm>
#include <numeric>

#include "base/error.h"
#include "read/part21/lexer.h"

namespace clearcut::read {

namespace {

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return result;
}

/// Reads tokens into the tables of a P21File. Open lists are kept on a separate stack, so that depth costs memory and
/// not the machine's stack.
class Parser {
 public:
  Parser(std::string_view text, P21File& file) : lexer_(text, file.name), file_(file) { lexer_.next(); }

  void parse() {
    expect_keyword("ISO-10303-21", "a Part 21 file begins with ISO-10303-21;");
    expect(P21Token::kSemicolon, "';' after ISO-10303-21");
    parse_header();
    bool data = false;
    while (!at_keyword("END-ISO-10303-21")) {
      if (lexer_.token == P21Token::kEnd)
        lexer_.fail("the file ends without END-ISO-10303-21; it was cut short, get the whole file");
      data = at_keyword("DATA") || data;
      parse_section();
    }
    if (!data) lexer_.fail("no DATA section; there is nothing to make");
  }

 private:
  bool at_keyword(std::string_view keyword) const {
    return lexer_.token == P21Token::kKeyword && upper(lexer_.text) == keyword;
  }
  void expect(P21Token token, const std::string& what) {
    if (lexer_.token != token) lexer_.fail("expected " + what + ", found " + lexer_.shown());
    lexer_.next();
  }
  void expect_keyword(std::string_view keyword, const std::string& what) {
    if (!at_keyword(keyword)) lexer_.fail(what + " but here is " + lexer_.shown());
    lexer_.next();
  }
  void end_section() {
    expect_keyword("ENDSEC", "a section ends with ENDSEC;");
    expect(P21Token::kSemicolon, "';' after ENDSEC");
  }

  void parse_header() {
    expect_keyword("HEADER", "the HEADER section comes first,");
    expect(P21Token::kSemicolon, "';' after HEADER");
    while (lexer_.token == P21Token::kKeyword && !at_keyword("ENDSEC")) {
      file_.header.push_back(parse_record());
      expect(P21Token::kSemicolon, "';' after a header entity");
    }
    end_section();
  }

  void parse_section() {
    const bool data = at_keyword("DATA");
    if (lexer_.token != P21Token::kKeyword)
      lexer_.fail("expected a section such as DATA, found " + lexer_.shown());
    lexer_.next();
    if (!data) return pass_over_section();
    if (lexer_.token == P21Token::kOpen) parse_record_arguments({});
    expect(P21Token::kSemicolon, "';' after DATA");
    while (lexer_.token == P21Token::kReference) parse_entity();
    end_section();
  }

  /// ANCHOR, REFERENCE, SIGNATURE: nothing in them is needed.
  void pass_over_section() {
    while (!at_keyword("ENDSEC")) {
      if (lexer_.token == P21Token::kEnd) lexer_.fail("the file ends inside a section; get the whole file");
      lexer_.next();
    }
    end_section();
  }

  void parse_entity() {
    P21Entity entity{lexer_.id, lexer_.line, 0, 0};
    lexer_.next();
    expect(P21Token::kEquals, "'=' after #" + std::to_string(entity.id));
    entity.first_record = static_cast<std::uint32_t>(file_.records.size());
    if (lexer_.token == P21Token::kOpen) {
      lexer_.next();
      while (lexer_.token == P21Token::kKeyword) file_.records.push_back(parse_record());
      expect(P21Token::kClose, "')' after the parts of complex instance #" + std::to_string(entity.id));
    } else {
      file_.records.push_back(parse_record());
    }
    entity.records = static_cast<std::uint32_t>(file_.records.size()) - entity.first_record;
    if (entity.records == 0) lexer_.fail("complex instance #" + std::to_string(entity.id) + " is empty");
    expect(P21Token::kSemicolon, "';' after entity #" + std::to_string(entity.id));
    file_.entities.push_back(entity);
  }

  P21Record parse_record() {
    if (lexer_.token != P21Token::kKeyword) lexer_.fail("expected an entity's name, found " + lexer_.shown());
    const std::string_view keyword = lexer_.text;
    lexer_.next();
    if (lexer_.token != P21Token::kOpen)
      lexer_.fail("expected '(' after " + std::string(keyword.substr(0, 60)) + ", found " + lexer_.shown());
    return parse_record_arguments(keyword);
  }

  /// From '(' to its ')': without recursion, the open lists are in open_ and their values so far in pending_.
  P21Record parse_record_arguments(std::string_view keyword) {
    open_list(P21Kind::kList, keyword);
    bool value_expected = false;  // a value must follow a comma
    while (true) {
      if (lexer_.token == P21Token::kClose && !value_expected) {
        const P21Value list = close_list();
        if (open_.empty()) return {keyword, list.first, list.count};
        pending_.push_back(list);
      } else if (begins_list()) {
        value_expected = false;
        continue;
      } else {
        pending_.push_back(simple_value());
        lexer_.next();
      }
      value_expected = lexer_.token == P21Token::kComma;
      if (value_expected)
        lexer_.next();
      else if (lexer_.token != P21Token::kClose)
        lexer_.fail("expected ',' or ')', found " + lexer_.shown());
    }
  }

  bool begins_list() {
    if (lexer_.token == P21Token::kOpen) {
      open_list(P21Kind::kList, {});
      return true;
    }
    if (lexer_.token != P21Token::kKeyword) return false;
    const std::string_view keyword = lexer_.text;
    lexer_.next();
    if (lexer_.token != P21Token::kOpen)
      lexer_.fail("expected '(' after " + std::string(keyword.substr(0, 60)));
    open_list(P21Kind::kTyped, keyword);
    return true;
  }

  void open_list(P21Kind kind, std::string_view keyword) {
    open_.push_back({kind, keyword, pending_.size()});
    lexer_.next();
  }

  P21Value close_list() {
    const Open open = open_.back();
    open_.pop_back();
    P21Value list;
    list.kind = open.kind;
    list.text = open.keyword;
    list.first = static_cast<std::uint32_t>(file_.values.size());
    list.count = static_cast<std::uint32_t>(pending_.size() - open.first);
    file_.values.insert(file_.values.end(), pending_.begin() + static_cast<std::ptrdiff_t>(open.first),
                        pending_.end());
    pending_.resize(open.first);
    lexer_.next();
    return list;
  }

  P21Value simple_value() const {
    P21Value value;
    value.text = lexer_.text;
    value.number = lexer_.number;
    value.id = lexer_.id;
    switch (lexer_.token) {
      case P21Token::kReference:
        value.kind = P21Kind::kReference;
        break;
      case P21Token::kInteger:
        value.kind = P21Kind::kInteger;
        break;
      case P21Token::kReal:
        value.kind = P21Kind::kReal;
        break;
      case P21Token::kString:
        value.kind = P21Kind::kString;
        break;
      case P21Token::kEnum:
        value.kind = P21Kind::kEnum;
        break;
      case P21Token::kBinary:
        value.kind = P21Kind::kBinary;
        break;
      case P21Token::kUnset:
        value.kind = P21Kind::kUnset;
        break;
      case P21Token::kDerived:
        value.kind = P21Kind::kDerived;
        break;
      default:
        lexer_.fail("expected a value, found " + lexer_.shown());
    }
    return value;
  }

  struct Open {
    P21Kind kind;
    std::string_view keyword;
    std::size_t first;
  };
  P21Lexer lexer_;
  P21File& file_;
  std::vector<Open> open_;
  std::vector<P21Value> pending_;
};

void read_schemas(P21File& file) {
  for (const P21Record& record : file.header) {
    if (upper(record.keyword) != "FILE_SCHEMA" || record.count == 0) continue;
    const P21Value list = file.arguments(record)[0];
    if (list.kind != P21Kind::kList) continue;
    for (const P21Value& schema : file.children(list))
      if (schema.kind == P21Kind::kString) file.schemas.push_back(upper(p21_decoded(schema.text)));
  }
}

void read_originating_system(P21File& file) {
  constexpr std::size_t kPlace = 5;
  for (const P21Record& record : file.header) {
    if (upper(record.keyword) != "FILE_NAME" || record.count <= kPlace) continue;
    const P21Value system = file.arguments(record)[kPlace];
    if (system.kind == P21Kind::kString) file.originating_system = p21_decoded(system.text);
  }
}

}  // namespace

const P21Entity* P21File::find(std::uint64_t id) const {
  const auto at =
      std::lower_bound(by_id_.begin(), by_id_.end(), id,
                       [&](std::uint32_t i, std::uint64_t wanted) { return entities[i].id < wanted; });
  return at != by_id_.end() && entities[*at].id == id ? &entities[*at] : nullptr;
}

void P21File::index_ids() {
  by_id_.resize(entities.size());
  std::iota(by_id_.begin(), by_id_.end(), 0U);
  const auto before = [&](std::uint32_t a, std::uint32_t b) { return entities[a].id < entities[b].id; };
  if (!std::is_sorted(by_id_.begin(), by_id_.end(), before))
    std::stable_sort(by_id_.begin(), by_id_.end(), before);
  for (std::size_t i = 1; i < by_id_.size(); ++i) {
    const P21Entity& first = entities[by_id_[i - 1]];
    const P21Entity& second = entities[by_id_[i]];
    if (first.id == second.id)
      throw InputError(place(second.line), "#" + std::to_string(second.id) + " was already defined on line " +
                                               std::to_string(first.line) +
                                               "; give each entity its own number");
  }
}

P21File parse_part21(std::string_view text, const std::string& file_name) {
  constexpr std::size_t kLargest = std::size_t{1} << 31;  // indices are 32 bits
  if (text.size() > kLargest) throw InputError(file_name, "larger than 2 GB; split the job");
  P21File file;
  file.name = file_name;
  file.text_.assign(text.begin(), text.end());
  Parser({file.text_.data(), file.text_.size()}, file).parse();
  file.index_ids();
  file.uses_ = std::make_unique<UseLedger>(file.values.size());
  read_schemas(file);
  read_originating_system(file);
  return file;
}

}  // namespace clearcut::read
