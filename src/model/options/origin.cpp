#include "model/options/origin.h"

namespace clearcut::inline model {

const char* name_of(Origin origin) {
  switch (origin) {
    case Origin::kUser:
      return "user";
    case Origin::kJobFile:
      return "job file";
    case Origin::kPart:
      return "part";
    case Origin::kToolLibrary:
      return "tool library";
    case Origin::kMachineFile:
      return "machine file";
    case Origin::kDefault:
      return "default";
    case Origin::kDerived:
      break;
  }
  return "derived";
}

std::string step_key(const Workingstep& step) {
  return step.source + "/" + step.name;
}

const Source* Sources::find(const std::string& name) const {
  const auto found = all_.find(name);
  return found == all_.end() ? nullptr : &found->second;
}

void Sources::merge(const Sources& other) {
  for (const auto& [name, source] : other.all_) all_[name] = source;
}

}  // namespace clearcut::inline model
