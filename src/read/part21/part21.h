// The exchange structure of ISO 10303-21 ("Part 21", STEP files): text to a table of entity instances.
// Handles only the syntax, not the meaning of entities.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "read/common/use_ledger.h"

namespace clearcut::read {

enum class P21Kind : unsigned char {
  kUnset,    ///< $
  kDerived,  ///< *
  kInteger,
  kReal,
  kString,     ///< text is raw: see p21_decoded
  kEnum,       ///< text without its points: T, F, CLIMB
  kReference,  ///< #id
  kBinary,     ///< text is the hexadecimal digits
  kList,       ///< ( ... )
  kTyped       ///< KEYWORD( ... ): text is the keyword
};

/// One parameter. Lists and typed parameters hold the values [first, first + count) of P21File::values.
struct P21Value {
  P21Kind kind = P21Kind::kUnset;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  double number = 0;      ///< integers and reals
  std::uint64_t id = 0;   ///< references
  std::string_view text;  ///< strings, enumerations, binaries, keywords: into P21File::text
};

/// KEYWORD( parameters ).
struct P21Record {
  std::string_view keyword;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// #id = record, or #id = (record record ...) for a complex instance.
struct P21Entity {
  std::uint64_t id = 0;
  int line = 0;
  std::uint32_t first_record = 0;
  std::uint32_t records = 0;
};

/// A parsed file; a value, except that its text stays at a fixed address. Move-only.
class P21File {
 public:
  P21File() = default;
  P21File(P21File&&) = default;
  P21File& operator=(P21File&&) = default;

  std::string name;                  ///< for messages
  std::vector<std::string> schemas;  ///< FILE_SCHEMA, upper case
  std::string originating_system;    ///< FILE_NAME; empty where none is stated
  std::vector<P21Entity> entities;   ///< in file order
  std::vector<P21Record> records;
  std::vector<P21Value> values;
  std::vector<P21Record> header;
  double mm_per_length = 1;  ///< mm; set by readers that know the file's unit of length

  /// Null if the instance does not exist. O(log entities).
  const P21Entity* find(std::uint64_t id) const;
  std::span<const P21Value> children(const P21Value& list) const {
    return {values.data() + list.first, list.count};
  }
  std::span<const P21Value> arguments(const P21Record& r) const { return {values.data() + r.first, r.count}; }
  std::span<const P21Record> records_of(const P21Entity& e) const {
    return {records.data() + e.first_record, e.records};
  }
  /// Marks of values used by its readers, one for each of `values`.
  UseLedger& uses() const { return *uses_; }
  /// "file:line".
  std::string place(int line) const { return name + ":" + std::to_string(line); }

 private:
  friend P21File parse_part21(std::string_view text, const std::string& file_name);
  void index_ids();
  std::vector<std::uint32_t> by_id_;  ///< indices into entities, by id
  std::unique_ptr<UseLedger> uses_ = std::make_unique<UseLedger>();
  std::vector<char> text_;  ///< text referenced by every string_view above
};

/// Reads the whole exchange structure: comments anywhere, header, any number of DATA sections (with or
/// without parameters), ANCHOR, REFERENCE and SIGNATURE sections passed over, complex instances, any order of
/// ids.
///
/// Throws  InputError("file:line") for text of another syntax, a truncated file, an id used twice.
/// Cost    O(text) time and memory (ids out of order: O(entities log entities)); the nesting of lists may be
/// any
///         depth, nothing recurses.
P21File parse_part21(std::string_view text, const std::string& file_name);

/// A string parameter as UTF-8: '' and the escapes \\, \S\, \P.\, \X\, \X2\...\X0\, \X4\...\X0\ undone, line
/// ends dropped; bytes outside ASCII are taken as UTF-8 if valid, else as ISO 8859-1. Broken escapes stay as written.
std::string p21_decoded(std::string_view raw);

}  // namespace clearcut::read
