"""The reference of the commands, from their own help: commands.py CLEARCUT > commands.md"""
import re
import subprocess
import sys


def help_of(*words):
    return subprocess.run([*words, "--help"], check=True, capture_output=True, text=True).stdout.strip()


def options(text):
    """Help as tables: option lines are indented, a long name stands alone above its text."""
    page, open_table = [], False
    for line in text.splitlines():
        option = re.match(r"  (\S.*?)(?:  +(\S.*))?$", line) if line.startswith("  ") and not line.startswith("      ") else None
        more = re.match(r"\s{6,}(\S.*)$", line)
        if option:
            page += [] if open_table else ["", "| | |", "|---|---|"]
            open_table = True
            page.append([option[1], option[2] or ""])
        elif more and open_table:
            page[-1][1] = f"{page[-1][1]} {more[1]}".strip()
        else:
            open_table = False
            heading = re.match(r"([A-Z][\w ]*):$", line)
            page.append(f"\n**{heading[1]}**" if heading else f"\n`{line}`" if line.startswith("Usage:") else line)
    def cell(word):
        return word.replace("|", "\\|")
    return "\n".join(line if isinstance(line, str) else f"| `{cell(line[0])}` | {cell(line[1])} |" for line in page)


def main(command):
    text = help_of(command)
    print("# Commands\n\nWhat `clearcut COMMAND --help` says.\n")
    print(f"## clearcut\n\n{options(text)}\n")
    section = text.split("Subcommands:")[1] if "Subcommands:" in text else text
    for name in re.findall(r"^  ([a-z]+) ", section, re.MULTILINE):
        print(f"## {name}\n\n{options(help_of(command, name))}\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
