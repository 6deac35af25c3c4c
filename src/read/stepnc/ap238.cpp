#include "read/stepnc/ap238.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/error.h"
#include "read/stepnc/file/node.h"

namespace clearcut::read::stepnc {
namespace {

constexpr std::size_t kMostLines = 100'000;
constexpr int kDeepestWorkplan = 64;

/// An executable and its place in its workplan.
struct Element {
  double position = 0;
  Node node;
};

/// "MACHINING_WORKINGSTEP" as "workingstep".
std::string kind_of_executable(const Node& node) {
  std::string kind = node.keyword();
  if (const std::size_t plus = kind.find('+'); plus != std::string::npos) kind.resize(plus);
  constexpr std::string_view kPrefix = "MACHINING_";
  if (kind.rfind(kPrefix, 0) == 0) kind.erase(0, kPrefix.size());
  for (char& c : kind) c = c == '_' ? ' ' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return kind;
}

std::string name_of_executable(const Node& node) {
  const P21Value name = node.peek(0);
  const std::string text = name.kind == P21Kind::kString ? node.text(0) : "";
  return kind_of_executable(node) + (text.empty() ? "" : " " + text) + " (#" + std::to_string(node.id()) +
         ")";
}

class Outline {
 public:
  explicit Outline(const P21File& file) : file_(file) {
    for (const Node& link : nodes_called(file, "MACHINING_PROCESS_SEQUENCE_RELATIONSHIP")) {
      const auto whole = link.sound_ref(2), element = link.sound_ref(3);
      if (!whole || !element) continue;
      const P21Value place = link.peek(4);
      const bool is_number = place.kind == P21Kind::kReal || place.kind == P21Kind::kInteger;
      elements_[whole->id()].push_back({is_number ? place.number : 0, *element});
      inner_.insert(element->id());
    }
    for (auto& [whole, elements] : elements_)
      std::stable_sort(elements.begin(), elements.end(),
                       [](const Element& a, const Element& b) { return a.position < b.position; });
  }

  std::vector<std::string> lines() {
    for (const Node& plan : nodes_called(file_, "MACHINING_WORKPLAN"))
      if (!inner_.contains(plan.id())) add(plan, "", 0);
    if (lines_.empty())
      for (const Node& step : nodes_called(file_, "MACHINING_WORKINGSTEP"))
        lines_.push_back(name_of_executable(step));
    return std::move(lines_);
  }

 private:
  void add(const Node& element, const std::string& before, int depth) {
    if (depth > kDeepestWorkplan || lines_.size() >= kMostLines) return;
    lines_.push_back(before + name_of_executable(element));
    const auto own = elements_.find(element.id());
    if (own == elements_.end()) return;
    const std::string inset(2 * static_cast<std::size_t>(depth + 1), ' ');
    int number = 0;
    for (const Element& inner : own->second)
      add(inner.node, inset + std::to_string(++number) + "  ", depth + 1);
  }

  const P21File& file_;
  std::map<std::uint64_t, std::vector<Element>> elements_;  // by workplan
  std::set<std::uint64_t> inner_;                           // what is an element of another
  std::vector<std::string> lines_;
};

}  // namespace

bool is_ap238(const P21File& file) {
  return std::any_of(file.schemas.begin(), file.schemas.end(), [](const std::string& schema) {
    return schema.find("INTEGRATED_CNC_SCHEMA") != std::string::npos;
  });
}

std::vector<std::string> ap238_lines(const P21File& file) {
  return Outline(file).lines();
}

std::vector<std::string> ap238_lines(std::string_view text, const std::string& file_name) {
  if (text.find("INTEGRATED_CNC_SCHEMA") == std::string_view::npos) return {};
  const P21File file = parse_part21(text, file_name);
  return is_ap238(file) ? ap238_lines(file) : std::vector<std::string>{};
}

}  // namespace clearcut::read::stepnc
