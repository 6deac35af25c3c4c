#include "read/stepnc/executables.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "base/error.h"
#include "model/results/findings.h"
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

namespace {

constexpr int kDeepestPlan = 64;                // nesting of workplans
constexpr std::size_t kMostElements = 100'000;  // workplan elements after expansion

/// What becomes of an executable that is no workingstep.
enum class Handling {
  kPlan,      ///< its elements one after the other
  kAnyOrder,  ///< the same; the free order is reported
  kFirst,     ///< the first of its elements
  kBranch,    ///< one of two, by a condition
  kLoop,      ///< again and again while a condition holds
  kHalt,      ///< M0
  kOptional,  ///< M1
  kMessage,   ///< a text for the operator
  kOfItself,  ///< done anyway; the reason says by what
  kNotFollowed
};

struct ExecutableRow {
  std::string_view keyword;
  Handling handling;
  const char* reason = "";  ///< why nothing has to be done, or what is not done
};
constexpr ExecutableRow kExecutables[] = {
    {"WORKPLAN", Handling::kPlan},
    {"NON_SEQUENTIAL", Handling::kAnyOrder, "elements in any order are cut in the order written"},
    {"PARALLEL", Handling::kAnyOrder,
     "one spindle cuts branches in parallel one after the other, as written"},
    {"SELECTIVE", Handling::kFirst},
    {"IF_STATEMENT", Handling::kBranch},
    {"WHILE_STATEMENT", Handling::kLoop},
    {"PROGRAM_STOP", Handling::kHalt},
    {"OPTIONAL_STOP", Handling::kOptional},
    {"DISPLAY_MESSAGE", Handling::kMessage},
    {"LOAD_TOOL", Handling::kOfItself, "tools are changed where the next step needs another"},
    {"UNLOAD_TOOL", Handling::kOfItself, "tools are changed where the next step needs another"},
    {"ASSIGNMENT", Handling::kNotFollowed, "values are not computed while the program runs"},
    {"RAPID_MOVEMENT", Handling::kNotFollowed, "the tool goes from step to step over all that stands"},
    {"RETURN_HOME", Handling::kNotFollowed, "the tool goes home at tool changes and at the end alone"},
    {"EXCHANGE_PALLET", Handling::kNotFollowed, "do it by hand: the program goes on without a halt"},
    {"INDEX_PALLET", Handling::kNotFollowed, "do it by hand: the program goes on without a halt"},
    {"INDEX_TABLE", Handling::kNotFollowed, "do it by hand: the program goes on without a halt"},
    {"SET_MARK", Handling::kNotFollowed, "there is one channel alone"},
    {"WAIT_FOR_MARK", Handling::kNotFollowed, "there is one channel alone"},
};

const ExecutableRow* row_of(const Node& node) {
  for (const ExecutableRow& row : kExecutables)
    if (node.is(row.keyword)) return &row;
  return nullptr;
}

/// Of an operand: a number, or an NC_CONSTANT(name, value), or an NC_VARIABLE(name, initial value) in a file that assigns nothing.
std::optional<double> constant_of(const Node& comparison, std::size_t argument) {
  const P21Kind kind = comparison.peek(argument).kind;
  if (kind == P21Kind::kInteger || kind == P21Kind::kReal) return comparison.number(argument);
  const auto operand = comparison.sound_ref(argument);
  if (!operand) return std::nullopt;
  const bool assigned = !nodes_called(operand->file(), "ASSIGNMENT").empty();
  if (!operand->is("NC_CONSTANT") && (assigned || !operand->is("NC_VARIABLE"))) return std::nullopt;
  const P21Kind value = operand->peek(1).kind;
  if (value != P21Kind::kInteger && value != P21Kind::kReal) return std::nullopt;
  return operand->number(1);
}

/// A condition that does not depend on what happens at the machine; nothing for all others.
std::optional<bool> known_condition(const Node& statement) {
  if (const auto flag = statement.flag(1)) return flag;
  const auto condition = statement.sound_ref(1);
  if (!condition) return std::nullopt;
  const auto a = constant_of(*condition, 0), b = constant_of(*condition, 1);
  if (!a || !b) return std::nullopt;
  if (condition->is("COMPARISON_EQUAL")) return *a == *b;
  if (condition->is("COMPARISON_NOT_EQUAL")) return *a != *b;
  if (condition->is("COMPARISON_GREATER")) return *a > *b;
  if (condition->is("COMPARISON_GREATER_EQUAL")) return *a >= *b;
  if (condition->is("COMPARISON_LESS")) return *a < *b;
  if (condition->is("COMPARISON_LESS_EQUAL")) return *a <= *b;
  return std::nullopt;
}

std::string own_name(const Node& step) {
  return step.text(0).empty() ? "workingstep #" + std::to_string(step.id()) : step.text(0);
}

class Collector {
 public:
  explicit Collector(Context& context) : context_(context) {}

  void collect(const Node& element, std::optional<Node> setup, int depth) {
    count(element, depth);
    if (element.is("MACHINING_WORKINGSTEP")) return add_step(element, setup);
    const ExecutableRow* row = row_of(element);
    if (row == nullptr) return leave_out_unknown(element, depth);
    switch (row->handling) {
      case Handling::kPlan:
        order_.workplans.push_back(element);
        if (const auto own = element.sound_ref(3)) setup = own;
        return collect_all(element, setup, depth);
      case Handling::kAnyOrder:
        context_.note(row->reason, element);
        return collect_all(element, setup, depth);
      case Handling::kFirst:
        return collect_first(element, setup, depth);
      case Handling::kBranch:
        return collect_branch(element, setup, depth);
      case Handling::kLoop:
        return collect_loop(element, depth);
      case Handling::kHalt:
        return add_stop(element, StopKind::kHalt, 0);
      case Handling::kOptional:
        return add_stop(element, StopKind::kOptional, 0);
      case Handling::kMessage:
        return add_stop(element, StopKind::kMessage, 1);
      case Handling::kOfItself:
        context_.said(element);
        return context_.note(row->reason, element);
      case Handling::kNotFollowed:
        return not_followed(element, row->reason);
    }
  }

  WorkOrder finished() {
    if (!stops_.empty())
      context_.diagnostics.note(
          context_.file.name,
          "stops and messages after the last workingstep are not in the program, which ends there");
    return std::move(order_);
  }

 private:
  void count(const Node& element, int depth) {
    if (depth > kDeepestPlan)
      element.fail("workplans are nested more than 64 deep (or in a circle); flatten them");
    if (++elements_ > kMostElements) element.fail("more than 100000 workplan elements; split the program");
  }

  void collect_all(const Node& element, const std::optional<Node>& setup, int depth) {
    for (const Node& inner : element.refs(1)) collect(inner, setup, depth + 1);
  }

  void add_step(const Node& step, const std::optional<Node>& setup) {
    order_.steps.push_back({step, std::move(stops_), setup});
    stops_.clear();
  }

  void add_stop(const Node& element, StopKind kind, std::size_t text) {
    std::string said = element.text(text);
    if (kind == StopKind::kMessage && said.empty()) said = element.text(0);
    stops_.push_back({kind, said});
  }

  /// The control may choose; so may whoever plans.
  void collect_first(const Node& element, const std::optional<Node>& setup, int depth) {
    const std::vector<Node> choices = element.refs(1);
    if (choices.empty()) return;
    std::string others;
    for (std::size_t i = 1; i < choices.size(); ++i)
      others += (i == 1 ? "" : ", ") + names_in(choices[i], depth + 1);
    if (choices.size() > 1)
      context_.warn("one of its elements is to be carried out; the first is, and not: " + others, element);
    for (std::size_t i = 1; i < choices.size(); ++i) context_.said(choices[i]);
    collect(choices[0], setup, depth + 1);
  }

  void collect_branch(const Node& element, const std::optional<Node>& setup, int depth) {
    const auto condition = known_condition(element);
    for (const bool way : {true, false}) {
      const auto branch = element.ref(way ? 2 : 3);
      if (!branch) continue;
      if (condition == way) {
        collect(*branch, setup, depth + 1);
      } else if (condition) {
        context_.said(*branch);
        context_.note("its condition is known; not carried out: " + names_in(*branch, depth + 1), element);
      } else {
        leave_out(element, *branch, "its condition is known at the machine alone", depth);
      }
    }
    context_.said(element);
  }

  void collect_loop(const Node& element, int depth) {
    const auto condition = known_condition(element);
    const auto body = element.ref(2);
    context_.said(element);
    if (!body) return;
    if (condition == false)
      return context_.note("its condition is false; not carried out: " + names_in(*body, depth + 1), element);
    leave_out(element, *body, "how often it is repeated is known at the machine alone", depth);
  }

  void leave_out(const Node& element, const Node& inner, const std::string& why, int depth) {
    context_.said(inner);
    say_not_machined(context_.diagnostics, context_.file.place(element.line()), names_in(inner, depth + 1),
                     element.label() + " '" + element.text(0) + "': " + why +
                         "; write the workingsteps into the workplan");
  }

  void leave_out_unknown(const Node& element, int depth) {
    context_.said(element);
    if (element.keyword().find("WORKINGSTEP") != std::string::npos)
      return say_not_machined(context_.diagnostics, context_.file.place(element.line()), own_name(element),
                              element.label() + " is no machining workingstep; leave it to its machine");
    (void)depth;
    not_followed(element, "executables of this kind are not carried out");
  }

  void not_followed(const Node& element, const std::string& why) {
    context_.said(element);
    context_.diagnostics.doubt(context_.file.place(element.line()), kNotFollowed,
                               element.label() + " '" + element.text(0) + "' is not followed: " + why);
  }

  /// The names of the workingsteps in an element, "POCKET1, POCKET2".
  std::string names_in(const Node& element, int depth) {
    count(element, depth);
    if (element.keyword().find("WORKINGSTEP") != std::string::npos) return own_name(element);
    const bool is_list = element.is_any("WORKPLAN", "NON_SEQUENTIAL", "PARALLEL", "SELECTIVE");
    std::string names;
    std::vector<Node> inner;
    if (is_list) inner = element.refs(1);
    for (const std::size_t branch : {2U, 3U}) {
      if (!element.is_any("IF_STATEMENT", "WHILE_STATEMENT")) break;
      if (const auto one = element.sound_ref(branch)) inner.push_back(*one);
    }
    for (const Node& one : inner) names += (names.empty() ? "" : ", ") + names_in(one, depth + 1);
    return names.empty() ? element.label() : names;
  }

  Context& context_;
  WorkOrder order_;
  std::vector<ProgramStop> stops_;  // since the last step
  std::size_t elements_ = 0;
};

}  // namespace

WorkOrder work_order(const Node& workplan, Context& context) {
  Collector collector(context);
  collector.collect(workplan, std::nullopt, 0);
  return collector.finished();
}

}  // namespace clearcut::read::stepnc
