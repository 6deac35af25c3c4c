#!/usr/bin/env python3
"""A report of how large folders, files and argument lists are. Nobody fails by it: a large number is a place to look.

    scripts/sizes.py [ROOT]
"""
import collections
import pathlib
import re
import sys

FOLDERS = ("src", "include", "apps", "studies")
SUFFIXES = {".h", ".cpp", ".js", ".mjs", ".css"}
SHORT_FILE = 40
LONG_FILE = 450
MANY_ARGUMENTS = 6
LISTED = 15


def sources(root):
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in SUFFIXES and path.is_file() and not path.stem.endswith("_test"):
                yield path


def argument_lists(text):
    """Names and numbers of arguments of functions that are defined or declared, as far as a regular expression finds them."""
    for match in re.finditer(r"^[\w:<>,&*\s\[\]]*?\b(\w+)\(([^(){};]*)\)\s*(?:const\s*)?[{;]", text, re.MULTILINE):
        name, arguments = match.groups()
        depth, count = 0, 1 if arguments.strip() else 0
        for character in arguments:
            depth += character == "<"
            depth -= character == ">"
            count += character == "," and depth == 0
        if count >= MANY_ARGUMENTS and re.search(r"\w\s*[&*]?\s+[&*]?\w", arguments):
            yield name, count


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent)
    lines, modules, lists = {}, collections.defaultdict(set), []
    for path in sources(root):
        text = path.read_text(encoding="utf-8")
        name = path.relative_to(root)
        lines[name] = text.count("\n")
        modules[name.parent].add(path.stem)
        if path.suffix == ".h":
            lists += [(count, f"{name}: {function}") for function, count in argument_lists(text)]
    short = sum(count < SHORT_FILE for count in lines.values())
    print(f"{sum(lines.values())} lines in {len(lines)} files of {len(modules)} folders")
    print(f"{100 * short / len(lines):.0f} % of the files have fewer than {SHORT_FILE} lines")
    small = sorted(str(folder) for folder, names in modules.items() if len(names) <= 2)
    print(f"{len(small)} folders hold one or two modules: {' '.join(small)}")
    print(f"\nfiles over {LONG_FILE} lines")
    for name, count in sorted(lines.items(), key=lambda item: -item[1]):
        if count > LONG_FILE:
            print(f"{count:6} {name}")
    print("\nlargest folders, in modules")
    for folder, names in sorted(modules.items(), key=lambda item: -len(item[1]))[:LISTED]:
        print(f"{len(names):6} {folder}")
    print(f"\ndeclarations of {MANY_ARGUMENTS} arguments and more")
    for count, where in sorted(lists, reverse=True):
        print(f"{count:6} {where}")


if __name__ == "__main__":
    main()
