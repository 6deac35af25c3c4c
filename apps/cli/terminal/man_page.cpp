#include "terminal/man_page.h"

#include <clearcut/options.h>
#include <clearcut/version.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

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

namespace {

std::string value_text(const Row& row) {
  if (row.kind == ValueKind::kFlag) return "";
  if (row.kind == ValueKind::kChoice) return fmt::format("{}", fmt::join(row.names, ", "));
  if (!row.counted_in().empty()) return row.counted_in();
  if (row.kind == ValueKind::kPoint || row.kind == ValueKind::kPoints) return "X,Y";
  if (row.kind == ValueKind::kFile || row.kind == ValueKind::kFiles) return "file";
  return is_number(row.kind) || row.kind == ValueKind::kSeed ? "number" : "text";
}

std::string job_text_of(const Row& row) {
  if (row.table == JobTable::kNone) return "";
  const std::string key = fmt::format("`[{}] {}`", name_of(row.table), row.job_key());
  return row.key_is_opposite ? key + " (opposite)" : key;
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

}  // namespace

std::string options_page() {
  std::string text =
      "# All options of a plan\n\nMade by `clearcut generate table` from the table of options, "
      "[src/options/rows.cpp](../src/options/rows.cpp). Whatever is given and can have no effect on the part "
      "is "
      "refused, exit code 2, with what it serves.\n";
  const Group* group = nullptr;
  for (const Row& row : rows()) {
    if (!group || *group != row.group) {
      text += fmt::format(
          "\n## {}\n\n| option | value | what it does | default | in a job |\n|---|---|---|---|---|\n",
          name_of(row.group));
      group = &row.group;
    }
    text += fmt::format("| `--{}` | {} | {} | {} | {} |\n", row.name, value_text(row), escaped(row.sentence),
                        escaped(row.fallback), job_text_of(row));
  }
  text.pop_back();
  return text;
}

namespace {

std::string replaced(std::string text, char what, const std::string& with) {
  std::string out;
  for (const char c : text) out += c == what ? with : std::string(1, c);
  return out;
}

/// Within single quotes of a POSIX shell.
std::string quoted(const std::string& text) {
  return "'" + replaced(text, '\'', "'\\''") + "'";
}

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::vector<std::string> all_names(const CommandText& command) {
  std::vector<std::string> names;
  for (const OptionText& option : command.options) {
    if (!option.positional) names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

std::vector<std::string> names_of(const std::vector<CommandText>& commands) {
  std::vector<std::string> names;
  for (const CommandText& command : commands) names.push_back(command.name);
  return names;
}

// bash

std::string bash_values(const CommandText& command) {
  std::string text;
  for (const OptionText& option : command.options) {
    if (option.values.empty() && (option.file || option.value.empty())) continue;
    const std::string pattern = joined(option.names, "|");
    if (option.positional) continue;
    text += "    " + command.name + ":" + joined(option.names, ("|" + command.name + ":").c_str()) +
            ") COMPREPLY=($(compgen -W " + quoted(joined(option.values, " ")) + " -- \"$cur\")); return ;;\n";
  }
  return text;
}

/// Names permitted for the argument without an option.
std::vector<std::string> positional_values(const CommandText& command) {
  for (const OptionText& option : command.options) {
    if (option.positional) return option.values;
  }
  return {};
}

// zsh

/// Within the brackets and colons of _arguments.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string zsh_action(const OptionText& option) {
  if (!option.values.empty()) return ":" + option.value + ":(" + joined(option.values, " ") + ")";
  if (option.file || option.positional) return ":" + option.value + ":_files";
  return ":" + option.value + ": ";
}

std::string zsh_lines(const CommandText& command) {
  std::string text;
  for (const OptionText& option : command.options) {
    if (option.positional) {
      text += "        " + quoted(":" + zsh_action(option).substr(1)) + " \\\n";
      continue;
    }
    for (const auto& name : option.names) {
      const std::string action = option.value.empty() ? "" : zsh_action(option);
      text += "        " + quoted("*" + name + "[" + zsh_text(option.help) + "]" + action) + " \\\n";
    }
  }
  return text;
}

// fish

std::string fish_line(const std::string& command, const OptionText& option) {
  std::string text = "complete -c clearcut -n " + quoted("__fish_seen_subcommand_from " + command);
  if (option.positional)
    return option.values.empty() ? "" : text + " -f -a " + quoted(joined(option.values, " ")) + "\n";
  for (const auto& name : option.names)
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.values.empty()) {
    text += " -x -a " + quoted(joined(option.values, " "));
  } else if (!option.value.empty()) {
    text += option.file ? " -r" : " -x";
  }
  // fish ends a quoted string at a quote, too, and uses \' instead of '\''.
  std::string help = replaced(replaced(option.help, '\\', "\\\\"), '\'', "\\'");
  return text + " -d '" + help + "'\n";
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  const auto commands = commands_of(app);
  std::string text = "# bash completion for clearcut\n_clearcut() {\n";
  text +=
      "  local cur=\"${COMP_WORDS[COMP_CWORD]}\" prev=\"${COMP_WORDS[COMP_CWORD-1]}\" "
      "command=\"${COMP_WORDS[1]}\"\n";
  text += "  COMPREPLY=()\n  if [ \"$COMP_CWORD\" -eq 1 ]; then\n    COMPREPLY=($(compgen -W " +
          quoted(joined(names_of(commands), " ") + " --help --version") + " -- \"$cur\")); return\n  fi\n";
  text += "  case \"$command:$prev\" in\n";
  for (const CommandText& command : commands) text += bash_values(command);
  text += "  esac\n  case \"$cur\" in\n    -*) ;;\n    *)\n      case \"$command\" in\n";
  for (const CommandText& command : commands) {
    const auto values = positional_values(command);
    if (!values.empty())
      text += "        " + command.name + ") COMPREPLY=($(compgen -W " + quoted(joined(values, " ")) +
              " -- \"$cur\")); return ;;\n";
  }
  text +=
      "      esac\n      COMPREPLY=($(compgen -f -- \"$cur\")); return ;;\n  esac\n  case \"$command\" in\n";
  for (const CommandText& command : commands)
    text += "    " + command.name + ") COMPREPLY=($(compgen -W " + quoted(joined(all_names(command), " ")) +
            " -- \"$cur\")) ;;\n";
  return text + "  esac\n}\ncomplete -o filenames -F _clearcut clearcut\n";
}

std::string zsh_completion(const CLI::App& app) {
  const auto commands = commands_of(app);
  std::string text = "#compdef clearcut\n_clearcut() {\n  local -a commands\n  commands=(\n";
  for (const CommandText& command : commands)
    text += "    " + quoted(command.name + ":" + zsh_text(command.help)) + "\n";
  text += "  )\n  if (( CURRENT == 2 )); then\n    _describe command commands\n    return\n  fi\n";
  text +=
      "  local command=$words[2]\n  words=(\"${(@)words[2,-1]}\")\n  (( CURRENT-- ))\n  case $command in\n";
  for (const CommandText& command : commands) {
    std::string lines = zsh_lines(command);
    lines.erase(lines.size() - 3);  // the last continuation
    text += "    " + command.name + ")\n      _arguments \\\n" + lines + "\n      ;;\n";
  }
  return text + "  esac\n}\n_clearcut \"$@\"\n";
}

std::string fish_completion(const CLI::App& app) {
  const auto commands = commands_of(app);
  std::string text = "# fish completion for clearcut\n";
  for (const CommandText& command : commands)
    text += "complete -c clearcut -n __fish_use_subcommand -f -a " + command.name + " -d " +
            quoted(command.help) + "\n";
  for (const CommandText& command : commands) {
    for (const OptionText& option : command.options) text += fish_line(command.name, option);
  }
  return text;
}

}  // namespace clearcut::cli
