#include "read/dxf/dxf_document.h"

#include <charconv>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/text.h"
#include "read/common/text.h"

namespace clearcut::read {
namespace {

/// Takes groups off the text one by one.
class Groups {
 public:
  Groups(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  /// False at the end of the text.
  bool next(DxfGroup& group) {
    std::string_view code = line();
    while (code.empty() && !text_.empty()) code = line();
    if (code.empty()) return false;
    const auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), group.code);
    if (error != std::errc{} || end != code.data() + code.size()) {
      fail("a DXF group code was expected; this is not a DXF file, or it is damaged here");
    }
    if (text_.empty()) fail("the file ends in the middle of a group; copy it again");
    const bool is_text = group.code == 1 || group.code == 3;
    group.value = line(is_text ? "\r" : kBlanks);
    group.line = line_;
    return true;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(file_ + ":" + std::to_string(line_), what);
  }

  static constexpr std::string_view kBlanks = " \t\r\n\v\f";

  std::string_view line(std::string_view blanks = kBlanks) {
    const std::size_t end = text_.find(line_end_);
    const std::string_view whole = text_.substr(0, end);
    text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
    ++line_;
    return stripped(whole, blanks);
  }

  std::string_view text_;
  const char line_end_ = line_end_of(text_);
  const std::string& file_;
  int line_ = 0;
};

/// Sorts entities into their sections.
class Builder {
 public:
  explicit Builder(DxfDocument& document) : document_(document) {}

  void take(const DxfGroup& group) {
    if (group.code == 999) return;  // comment
    if (group.code == 0) {
      finish();
      current_ = {group.value, group.line, {}};
      if (current_.type == "SECTION") section_ = {};
    } else if (current_.type == "SECTION" && section_.empty() && group.code == 2) {
      section_ = group.value;
    } else if (section_ != "HEADER") {
      current_.groups.push_back(group);
    } else if (group.code == 9) {
      variable_ = &document_.header[group.value];
    } else if (variable_) {
      variable_->groups.push_back(group);
    }
  }

  /// Stores the finished entity.
  void finish() {
    if (current_.type == "SECTION") {
      seen_entities_ = seen_entities_ || section_ == "ENTITIES";
    } else if (current_.type == "ENDSEC") {
      section_ = {};
      variable_ = nullptr;
    } else if (section_ == "TABLES" && current_.type == "LAYER") {
      document_.layers[capitals(current_.text(2))] = std::move(current_);
    } else if (section_ == "TABLES" && current_.type == "STYLE") {
      document_.styles[capitals(current_.text(2))] = std::move(current_);
    } else if (section_ == "BLOCKS") {
      finish_in_block();
    } else if (section_ == "OBJECTS") {
      finish_object();
    } else if (section_ == "ENTITIES") {
      document_.entities.push_back(std::move(current_));
    }
    current_ = {};
  }

  /// Marks the owners of active filters, through dictionaries up to the INSERT.
  void find_clipped() {
    constexpr int kDeepestOwner = 8;
    for (std::string_view handle : filters_) {
      for (int k = 0; k < kDeepestOwner && !handle.empty(); ++k) {
        document_.clipped.insert(handle);
        const auto owner = owners_.find(handle);
        handle = owner == owners_.end() ? std::string_view{} : owner->second;
      }
    }
  }

  bool seen_entities() const { return seen_entities_; }

 private:
  void finish_object() {
    const bool filters = current_.type == "SPATIAL_FILTER";
    if (!filters && current_.type != "DICTIONARY") return;
    const std::string_view handle = current_.text(5);
    if (filters && document_.integer(current_, 71, 1) != 0) filters_.push_back(handle);
    bool listed = false;  // in a list of others between braces
    for (const DxfGroup& group : current_.groups) {
      if (group.code == 102) listed = group.value.starts_with('{');
      if (group.code == 330 && !listed) owners_.try_emplace(handle, group.value);
    }
  }

  void finish_in_block() {
    if (current_.type == "BLOCK") {
      block_ = &document_.blocks[capitals(current_.text(2))];
      block_->base = {document_.number(current_, 10, 0), document_.number(current_, 20, 0)};
      constexpr int kExternal = 4 | 8;  // a reference, an overlay
      block_->external = (document_.integer(current_, 70, 0) & kExternal) != 0;
      block_->path = stripped(current_.text(1));
    } else if (current_.type == "ENDBLK") {
      block_ = nullptr;
    } else if (block_) {
      block_->entities.push_back(std::move(current_));
    }
  }

  DxfDocument& document_;
  DxfEntity current_;
  std::string_view section_;
  DxfEntity* variable_ = nullptr;
  DxfBlock* block_ = nullptr;
  std::vector<std::string_view> filters_;  ///< handles of filters that clip blocks
  /// Owners of filters and dictionaries, by their handles.
  std::map<std::string_view, std::string_view> owners_;
  bool seen_entities_ = false;
};

}  // namespace

const DxfGroup* DxfEntity::find(int code) const {
  for (const DxfGroup& group : groups) {
    if (group.code == code) return &group;
  }
  return nullptr;
}

std::string_view DxfEntity::text(int code, std::string_view otherwise) const {
  const DxfGroup* group = find(code);
  return group ? group->value : otherwise;
}

double DxfDocument::number(const DxfGroup& group) const {
  std::string_view text = group.value;
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    fail(group.line, "'" + printable(group.value) + "' is not a number; correct the file");
  }
  return value;
}

double DxfDocument::number(const DxfEntity& entity, int code, double otherwise) const {
  const DxfGroup* group = entity.find(code);
  return group ? number(*group) : otherwise;
}

double DxfDocument::required(const DxfEntity& entity, int code) const {
  const DxfGroup* group = entity.find(code);
  if (!group) {
    fail(entity.line,
         printable(entity.type) + " lacks its group " + std::to_string(code) + "; the file is damaged here");
  }
  return number(*group);
}

Vec2 DxfDocument::point(const DxfEntity& entity, int x_code) const {
  return {required(entity, x_code), required(entity, x_code + 10)};
}

int DxfDocument::integer(const DxfEntity& entity, int code, int otherwise) const {
  const double value = number(entity, code, otherwise);
  return std::abs(value) < 1e9 ? static_cast<int>(value) : otherwise;
}

void DxfDocument::fail(int line, const std::string& what) const {
  throw InputError(file + ":" + std::to_string(line), what);
}

DxfDocument parse_dxf(std::string_view text, const std::string& file_name) {
  if (text.substr(0, 18) == "AutoCAD Binary DXF") {
    throw InputError(file_name, "this is a binary DXF; save the drawing as ASCII DXF");
  }
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
  DxfDocument document;
  document.file = file_name;
  Groups groups(text, file_name);
  Builder builder(document);
  DxfGroup group;
  while (groups.next(group)) {
    builder.take(group);
    if (group.code == 0 && group.value == "EOF") break;
  }
  builder.finish();
  builder.find_clipped();
  if (!builder.seen_entities()) {
    throw InputError(file_name, "no ENTITIES section; this is not a DXF drawing, or it is cut short");
  }
  return document;
}

double mm_of_insunits(int code) {
  constexpr double kInch = 25.4, kMetre = 1000, kSurveyFoot = 1200.0 / 3937 * kMetre;
  constexpr std::pair<int, double> kUnits[] = {{1, kInch},
                                               {2, 12 * kInch},
                                               {3, 63360 * kInch},
                                               {4, 1},
                                               {5, 10},
                                               {6, kMetre},
                                               {7, 1000 * kMetre},
                                               {8, kInch / 1e6},
                                               {9, kInch / 1000},
                                               {10, 36 * kInch},
                                               {13, 0.001},
                                               {14, 100},
                                               {15, 10 * kMetre},
                                               {16, 100 * kMetre},
                                               {21, kSurveyFoot},
                                               {22, kSurveyFoot / 12},
                                               {23, 3 * kSurveyFoot},
                                               {24, 5280 * kSurveyFoot}};
  for (const auto& [unit, mm] : kUnits) {
    if (unit == code) return mm;
  }
  return 0;
}

}  // namespace clearcut::read
