"""Docstrings from the comments of the library's headers.

    docstrings.py ROOT OUTPUT

Reads include/clearcut/*.h below ROOT and every header of ours that these include, and writes OUTPUT, a C++ header with the
function doc("plan_part"), doc("PlanOptions::stepdown"): the text of the comment. A name without a comment does not compile.
"""
import re
import sys
from pathlib import Path

SCOPE = re.compile(r"^(?:struct|class|enum class)\s+(\w+)")
FUNCTION = re.compile(r"(\w+)\s*\([^;]*$|(\w+)\s*\(")
MEMBER = re.compile(r"(\w+)(?:\{[^}]*\})?(?:\s*=\s*[^;]+)?\s*[;,]?$")


def headers(root):
    """The public headers, then what they include, each once."""
    waiting = sorted((root / "include" / "clearcut").glob("*.h"))
    waiting += sorted((root / "studies" / "include" / "clearcut").glob("*.h"))
    done = []
    while waiting:
        header = waiting.pop(0)
        if header in done or not header.exists():
            continue
        done.append(header)
        for name in re.findall(r'#include "([^"]+)"', header.read_text()):
            for folder in ("include", "src", "."):
                waiting.append(root / folder / name)
    return done


def declared(line, scope):
    """What a line of code declares, as Scope::name; None where that is nothing."""
    code = line.split("//")[0].strip()
    opened = SCOPE.match(code)
    if opened:
        return opened.group(1)
    before = code.split("(")[0]
    if "(" in code and "=" not in before and "{" not in before:
        name = re.search(r"(\w+)\s*$", before)
    else:
        name = MEMBER.search(code)
    if not name:
        return None
    return f"{scope}::{name.group(1)}" if scope else name.group(1)


def comments(text):
    """(name, comment) of every declaration that has one."""
    scope, above, trailing = "", [], None
    for line in text.splitlines():
        stripped = line.strip()
        if stripped.startswith("///<") and trailing:
            yield trailing, stripped[4:].strip()
        elif stripped.startswith("///"):
            above.append(stripped[3:].removeprefix(" "))
        else:
            name = declared(line, scope) if stripped and not stripped.startswith("//") else None
            if name and above:
                yield name, "\n".join(above)
            if name and "///<" in line:
                yield name, line.split("///<")[1].strip()
            trailing = name
            above = []
            if SCOPE.match(line):
                scope = "" if ";" in line and "{" not in line else SCOPE.match(line).group(1)
            elif line.startswith("}"):
                scope = ""


def collected(root):
    found = {}
    for header in headers(root):
        own = {}
        for name, text in comments(header.read_text()):
            own[name] = own[name] + " " + text if name in own and "\n" not in text else text
        for name, text in own.items():
            found.setdefault(name, text)
    return found


def main(root, output):
    rows = "".join(f'    {{"{name}", R"doc({text})doc"}},\n' for name, text in sorted(collected(Path(root)).items()))
    Path(output).write_text(
        "// Written by docstrings.py: the comments of the library's headers.\n#pragma once\n\n#include <string_view>\n\n"
        "namespace clearcut::python {\n\nstruct Doc {\n  std::string_view name;\n  const char* text;\n};\n\n"
        f"inline constexpr Doc kDocs[] = {{\n{rows}}};\n\n"
        "/// The comment of a declaration. Names that have none do not compile.\n"
        "consteval const char* doc(std::string_view name) {\n  for (const Doc& one : kDocs)\n"
        '    if (one.name == name) return one.text;\n  throw "there is no comment of that name";\n}\n\n'
        "}  // namespace clearcut::python\n"
    )


if __name__ == "__main__":
    main(*sys.argv[1:])
