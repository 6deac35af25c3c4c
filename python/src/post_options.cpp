// How the program is written, as keywords.
#include "option_attributes.h"

namespace clearcut::python {
namespace {

WorkOffset work_offset_of(const std::string& word) {
  if (const auto offset = work_offset_named(word)) return *offset;
  throw InputError("--work-offset",
                   "'" + word + "' is unknown; use one of " + std::string(kKnownWorkOffsets));
}

EndPosition end_position_of(const std::string& word) {
  if (const auto end = end_position_named(word)) return *end;
  throw InputError("--end-position", "'" + word + "' is unknown; use home, none, or X,Y in mm");
}

}  // namespace

void add_post_options(OptionsClass& options) {
  add_value(
      options, "post", doc("PostOptions::dialect"), [](auto& o) -> auto& { return o.post.dialect; });
  add_value(
      options, "inch", "Write the program in inches.", [](auto& o) -> auto& { return o.post.inch; });
  add_value(
      options, "program_name", doc("PostOptions::program_name"),
      [](auto& o) -> auto& { return o.post.program_name; });
  add_plain<int>(
      options, "decimals", doc("PostOptions::decimals"), [](auto& o) -> auto& { return o.post.decimals; });
  add_value(
      options, "arcs", doc("PostOptions::arcs"), [](auto& o) -> auto& { return o.post.arcs; });
  add_value(
      options, "tool_change", doc("PostOptions::tool_changer"),
      [](auto& o) -> auto& { return o.post.tool_changer; });
  add_value(
      options, "length_offset", doc("PostOptions::length_offset"),
      [](auto& o) -> auto& { return o.post.length_offset; });
  add_value(
      options, "exact_stop", doc("PostOptions::exact_stop"),
      [](auto& o) -> auto& { return o.post.exact_stop; });
  add_optional(
      options, "spindle_wait", doc("PostOptions::spindle_wait"),
      [](auto& o) -> auto& { return o.post.spindle_wait; },
      [](const py::handle& s, const std::string&) { return Seconds::of(s.cast<double>()); },
      [](Seconds time) { return time.seconds(); });
  add_plain<int>(
      options, "program_number", doc("PostOptions::program_number"),
      [](auto& o) -> auto& { return o.post.program_number; });
  options.def_property(
      "work_offset", [](const AskedOptions& o) { return words_of(o.post.work_offset); },
      [](AskedOptions& o, const std::string& word) { o.post.work_offset = work_offset_of(word); },
      doc("PostOptions::work_offset"));
  options.def_property(
      "end_position",
      [](const AskedOptions& o) {
        return o.post.end == EndPosition{} ? std::nullopt : std::optional(name_of(o.post.end));
      },
      [](AskedOptions& o, const std::optional<std::string>& word) {
        o.post.end = word ? end_position_of(*word) : EndPosition{};
      },
      "Where the machine goes at the end: \"home\", \"X,Y\" in mm at the safe height, or \"none\"; None: as "
      "the "
      "controller is used.");
  add_value(
      options, "block_numbers", doc("PostOptions::block_numbers"),
      [](auto& o) -> auto& { return o.post.block_numbers; });
  add_value(
      options, "optional_stop", doc("PostOptions::optional_stop"),
      [](auto& o) -> auto& { return o.post.optional_stop; });
}

}  // namespace clearcut::python
