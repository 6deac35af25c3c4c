// Diagnostics of readers and planners: problems noticed without giving up. The library collects them and never prints
// them.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace clearcut::inline base {

enum class Severity {
  kNote,     ///< a documented default or reading was chosen
  kRepair,   ///< the input was mended within the stated tolerance
  kWarning,  ///< the user should look
  kSkipped   ///< a requested feature will not be machined
};

struct Diagnostic {
  Severity severity = Severity::kNote;
  std::string where;  ///< "file:line", "#216 POCKET1", "outline 2 at (10.5, 3)", ...
  std::string what;   ///< one sentence: the problem, its sizes, and how it was handled
  /// Name by which somebody accepts this warning; the verdict stays conditional until then (docs/conditions.md); ""
  /// for warnings without such a name.
  std::string condition = {};
};

/// An ordered list of diagnostics; a value.
class Diagnostics {
 public:
  void note(std::string where, std::string what) { add(Severity::kNote, std::move(where), std::move(what)); }
  void repair(std::string where, std::string what) {
    add(Severity::kRepair, std::move(where), std::move(what));
  }
  void warn(std::string where, std::string what) {
    add(Severity::kWarning, std::move(where), std::move(what));
  }
  void skip(std::string where, std::string what) {
    add(Severity::kSkipped, std::move(where), std::move(what));
  }
  /// A warning that makes the verdict conditional: the cut shape may differ from the drawing, unless `condition` is
  /// accepted.
  void doubt(std::string where, std::string condition, std::string what) {
    items_.push_back({Severity::kWarning, std::move(where), std::move(what), std::move(condition)});
  }
  void append(const Diagnostics& other) {
    items_.insert(items_.end(), other.items_.begin(), other.items_.end());
  }
  const std::vector<Diagnostic>& items() const { return items_; }

 private:
  void add(Severity severity, std::string where, std::string what) {
    items_.push_back({severity, std::move(where), std::move(what), {}});
  }
  std::vector<Diagnostic> items_;
};

}  // namespace clearcut::inline base
