#include "terminal/man_page.h"

#include <clearcut/version.h>

#include "terminal/option_table.h"

namespace clearcut::cli {
namespace {

/// Text for roff: a backslash or a leading dot would be a command, and a plain hyphen would be printed as a dash.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
  }
  return out.starts_with(".") || out.starts_with("'") ? "\\&" + out : out;
}

std::string man_entry(const OptionText& option) {
  std::string text = ".TP\n.B " + roff(synopsis(option)) + "\n" + roff(option.help) + "\n";
  if (option.values.empty()) return text;
  text += "Values:";
  for (const auto& value : option.values)
    text += (&value == &option.values.front() ? " " : ", ") + roff(value);
  return text + ".\n";
}

std::string command_section(const CommandText& command) {
  std::string text = ".SH CLEARCUT " + roff(command.name) + "\n" + roff(command.help) + ".\n";
  for (const OptionText& option : command.options) {
    if (option.positional) text += man_entry(option);
  }
  for (const auto& group : command.groups) {
    text += ".SS " + roff(group) + "\n";
    for (const OptionText& option : command.options) {
      if (!option.positional && option.group == group) text += man_entry(option);
    }
  }
  return text;
}

const char* const kEnd = R"(.SH EXIT STATUS
.TP
.B 0
Done; the verdict is CLEAN.
.TP
.B 1
Done; the verdict is FAULTY, or CONDITIONAL with a condition that nobody has accepted.
.TP
.B 2
The input or the arguments cannot be used; one line says why, nothing is written.
.TP
.B 3
An internal fault.
.TP
.B 130
Stopped by Ctrl\-C; nothing is left behind.
.SH ENVIRONMENT
.TP
.B NO_COLOR
When set, the verdict is not coloured. It is coloured on terminals alone.
.TP
.B COLUMNS
Width of tables and help where the output is no terminal; 80 when unset.
)";

}  // namespace

std::string man_page(const CLI::App& app) {
  const auto commands = commands_of(app);
  std::string text =
      ".TH CLEARCUT 1 \"\" \"clearcut " + std::string(kVersion) + "\" \"User Commands\"\n.ad l\n.nh\n";
  text += ".SH NAME\nclearcut \\- plan 2.5\\-D pocket\\-milling toolpaths and prove them\n";
  text += ".SH SYNOPSIS\n.B clearcut\n.I COMMAND\n[\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n";
  text += roff(app.get_description()) + "\n.SH COMMANDS\n";
  for (const CommandText& command : commands)
    text += ".TP\n.B " + roff(command.name) + "\n" + roff(command.help) + ".\n";
  for (const CommandText& command : commands) text += command_section(command);
  return text + kEnd;
}

}  // namespace clearcut::cli
