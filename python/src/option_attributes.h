// How one option becomes an attribute of PlanOptions.
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "bindings.h"

namespace clearcut::python {

/// A number, or text with a unit as on the command line.
inline double quantity_of(const py::handle& value, const std::string& name,
                          std::optional<double> (*convert)(std::string_view), const char* expected) {
  if (!py::isinstance<py::str>(value)) return value.cast<double>();
  const auto text = value.cast<std::string>();
  const auto number = convert(text);
  if (!number) throw InputError("--" + name, "'" + text + "' is not " + expected);
  return *number;
}

inline double length_of(const py::handle& value, const std::string& name) {
  return quantity_of(value, name, length_in_mm, "a length; write 6, 6mm or 0.25in");
}

inline MmPerMin feed_of(const py::handle& value, const std::string& name) {
  return MmPerMin::of(
      quantity_of(value, name, feed_in_mm_per_min, "a feed; write 800, 800mm/min or 40in/min"));
}

inline std::string option_name(std::string keyword) {
  for (char& c : keyword) {
    if (c == '_') c = '-';
  }
  return keyword;
}

using OptionsClass = py::class_<AskedOptions>;

/// A value that may be absent, with how it is read and shown. `at` gives its place in the options.
template <class At, class From, class To>
void add_optional(OptionsClass& options, const char* name, const char* text, At at, From from, To to) {
  options.def_property(
      name,
      [at, to](AskedOptions& given) -> py::object {
        const auto& value = at(given);
        return value ? py::cast(to(*value)) : py::none();
      },
      [at, from, name](AskedOptions& given, const py::object& value) {
        if (value.is_none())
          at(given).reset();
        else
          at(given) = from(value, option_name(name));
      },
      text);
}

template <class At>
void add_length(OptionsClass& options, const char* name, const char* text, At at) {
  add_optional(options, name, text, at, length_of, [](double mm) { return mm; });
}

template <class At>
void add_feed(OptionsClass& options, const char* name, const char* text, At at) {
  add_optional(options, name, text, at, feed_of, [](MmPerMin feed) { return feed.mm_per_min(); });
}

template <class At>
void add_angle(OptionsClass& options, const char* name, const char* text, At at) {
  add_optional(
      options, name, text, at,
      [](const py::handle& degrees, const std::string&) {
        return Radians::of_degrees(degrees.cast<double>());
      },
      [](Radians angle) { return angle.degrees(); });
}

/// Numbers and words that are taken as they are.
template <class Value, class At>
void add_plain(OptionsClass& options, const char* name, const char* text, At at) {
  add_optional(
      options, name, text, at,
      [](const py::handle& value, const std::string&) { return value.cast<Value>(); },
      [](const Value& value) { return value; });
}

/// One of a few names.
template <class At, class Named, class NameOf>
void add_named(OptionsClass& options, const char* name, const char* text, At at, Named named,
               NameOf name_of_value) {
  add_optional(
      options, name, text, at,
      [named](const py::handle& value, const std::string& option) {
        return named(value.cast<std::string>(), "--" + option);
      },
      name_of_value);
}

/// A plain value somewhere in the options.
template <class At>
void add_value(OptionsClass& options, const char* name, const char* text, At at) {
  using Value = std::remove_cvref_t<decltype(at(std::declval<AskedOptions&>()))>;
  options.def_property(
      name, [at](AskedOptions& given) { return at(given); },
      [at](AskedOptions& given, const Value& value) { at(given) = value; }, text);
}

void add_post_options(OptionsClass& options);
void add_published_options(OptionsClass& options);

}  // namespace clearcut::python
