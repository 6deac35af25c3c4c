#include "model/section_names.h"

#include <cctype>

namespace clearcut::inline model {

namespace {

/// Letters and digits: the characters of a name that survive in a comment of any control.
std::string key_of(const std::string& name) {
  std::string key;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 128 && std::isalnum(byte)) key += static_cast<char>(std::toupper(byte));
  }
  return key;
}

const char* words_for(const Part& part, const Workingstep& step) {
  const Operation& operation = step.operation;
  if (is_carved(feature_of(part, step), tool_of(part, step))) return "carve";
  if (operation.rest) return "rest";
  switch (operation.kind) {
    case OperationKind::kFinishing:
      return "finish";
    case OperationKind::kBottomFinishing:
      return "finish floor";
    case OperationKind::kSideFinishing:
      return "finish walls";
    case OperationKind::kDrilling:
      return "drill";
    case OperationKind::kReaming:
      return "ream";
    case OperationKind::kRoughing:
    case OperationKind::kOther:
      break;
  }
  return "rough";
}

}  // namespace

SectionNames::SectionNames(const Part& part) {
  std::vector<int> steps_on(part.features.size(), 0);
  for (const Workingstep& step : part.workplan) ++steps_on[static_cast<std::size_t>(step.feature)];
  for (const Workingstep& step : part.workplan) {
    const std::string& feature = feature_of(part, step).name;
    const bool alone = steps_on[static_cast<std::size_t>(step.feature)] == 1;
    const std::string wanted = alone ? feature : feature + " " + words_for(part, step);
    const int index = static_cast<int>(names_.size());
    std::string name = wanted;
    for (int i = 2; !by_key_.emplace(key_of(name), index).second; ++i)
      name = wanted + " " + std::to_string(i);
    names_.push_back(std::move(name));
  }
  for (std::size_t i = 0; i < part.workplan.size(); ++i) {
    by_key_.emplace(key_of(part.workplan[i].name), static_cast<int>(i));
    by_key_.emplace(key_of(feature_of(part, part.workplan[i]).name), static_cast<int>(i));
  }
}

int SectionNames::workingstep_of(const Section& section) const {
  const std::string key = key_of(section.label);
  const auto found = key.empty() ? by_key_.end() : by_key_.find(key);
  if (found != by_key_.end()) return found->second;
  return section.workingstep < static_cast<int>(names_.size()) ? section.workingstep : -1;
}

void SectionNames::settle(Toolpath& toolpath) const {
  for (Section& section : toolpath.sections) section.workingstep = workingstep_of(section);
}

}  // namespace clearcut::inline model
