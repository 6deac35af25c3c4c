// Work offset of a control for the zero of a program.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace clearcut::inline model {

struct WorkOffset {
  int code = 540;  ///< G word in tenths
  int number = 0;  ///< P word, from 1; 0: the word has none
  friend bool operator==(const WorkOffset&, const WorkOffset&) = default;
};

/// Codes of Sinumerik's settable offsets beyond G54 to G57: G505 to G599.
inline constexpr int kFirstSettable = 5050, kLastSettable = 5990;

/// Words in a program: "G55", "G59.1", "G54.1 P12".
std::string words_of(const WorkOffset& offset);
/// Name of the condition that this offset is at the work's zero: "g55", "g59.1", "g54.1-p12".
std::string condition_of(const WorkOffset& offset);

/// G54 to G59.3, G505 to G599, G54.1 P, G59 P and G154 P, in any case, with or without blanks; nothing for other
/// texts.
std::optional<WorkOffset> work_offset_named(std::string_view text);
/// For messages: the words of all known offsets.
inline constexpr std::string_view kKnownWorkOffsets =
    "G54 to G59, G59.1 to G59.3, G54.1 P1 to P300, G154 P1 to P99, G59 P7 to P254, G505 to G599";

}  // namespace clearcut::inline model
