// Sources of the values of a plan.
#pragma once

#include <map>
#include <string>

#include "model/part.h"

namespace clearcut::inline model {

enum class Origin {
  kUser,         ///< an option of the command line or of the caller
  kJobFile,      ///< a key of a job file
  kPart,         ///< the part's own file
  kToolLibrary,  ///< a preset of a tool library
  kMachineFile,  ///< a key of a machine file
  kDefault,      ///< not stated by any source
  kDerived       ///< follows from other values
};
/// "user", "job file", "part", "tool library", "machine file", "default", "derived".
const char* name_of(Origin origin);

/// An origin with the place or the reason in words: "--feed", "job.toml:12", "fishhead.p21 #123", "30 % of the feed".
struct Source {
  Origin origin = Origin::kDefault;
  std::string text;
};

/// Sources of values by the names of their options: "feed", "allowance-floor".
class Sources {
 public:
  void set(const std::string& name, Source source) { all_[name] = std::move(source); }
  /// The value is no longer stated.
  void forget(const std::string& name) { all_.erase(name); }
  /// Null if no source is known.
  const Source* find(const std::string& name) const;
  /// Those of `other` go before these.
  void merge(const Sources& other);

 private:
  std::map<std::string, Source> all_;
};

/// The sources of the values of workingsteps, by step_key().
using StepSources = std::map<std::string, Sources>;

/// Key that distinguishes workingsteps: their place in the input and their names.
std::string step_key(const Workingstep& step);

}  // namespace clearcut::inline model
