// The text of a DXF file as sections, blocks and entities of (code, value) groups.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/vec2.h"

namespace clearcut::read {

struct DxfGroup {
  int code = 0;
  int line = 0;            ///< line of the value
  std::string_view value;  ///< without surrounding blanks, except for text (codes 1 and 3)
};

/// One entity (or vertex, or table row): everything up to the next group 0.
struct DxfEntity {
  std::string_view type;
  int line = 0;
  std::vector<DxfGroup> groups;

  const DxfGroup* find(int code) const;
  std::string_view text(int code, std::string_view otherwise = {}) const;
};

struct DxfBlock {
  Vec2 base;
  std::vector<DxfEntity> entities;
  bool external = false;  ///< represents a drawing in a separate file
  std::string_view path;  ///< path of that file, as written
};

/// Views into the text, which must outlive it.
struct DxfDocument {
  std::string file;
  std::map<std::string_view, DxfEntity> header;  ///< "$INSUNITS" -> its groups
  std::map<std::string, DxfEntity> layers;       ///< layers by name in capitals
  std::map<std::string, DxfEntity> styles;       ///< text styles by name in capitals
  std::map<std::string, DxfBlock> blocks;        ///< blocks by name in capitals
  std::vector<DxfEntity> entities;
  /// Handles, including those of INSERTs shown only within a boundary (XCLIP).
  std::set<std::string_view> clipped;

  /// Throws  InputError "file:line: ..." unless the group's value is a finite number.
  double number(const DxfGroup& group) const;
  double number(const DxfEntity& entity, int code, double otherwise) const;
  /// Throws  also when the group is missing.
  double required(const DxfEntity& entity, int code) const;
  int integer(const DxfEntity& entity, int code, int otherwise) const;
  /// The point in the groups `x_code` and `x_code` + 10. Throws  as required() does.
  Vec2 point(const DxfEntity& entity, int x_code) const;
  [[noreturn]] void fail(int line, const std::string& what) const;
};

/// Throws  InputError for binary DXF, for other text, and for a file ending in the middle of a group or without
///         ENTITIES. Cost O(length).
DxfDocument parse_dxf(std::string_view text, const std::string& file_name);

/// mm per unit for a value of $INSUNITS, 0 if unspecified.
double mm_of_insunits(int code);

}  // namespace clearcut::read
