"""Lays out the pages of the site: pages.py SOURCE OUT. OUT/pages gets docs/*.md and what they link to, OUT/mkdocs.yml the navigation.

Links that lead out of docs/ lead to copies: Markdown as pages, anything else as a listing. Sections and order are those of docs/README.md.
"""
import re
import shutil
import sys
from pathlib import Path

CODE = re.compile(r"```.*?```|`[^`\n]*`", re.DOTALL)
LINK = re.compile(r"\]\(([^)#\s]+)(#[^)\s]*)?\)")
RENAMED = {"README.md": "index.md", "docs/README.md": "contents.md"}
LANGUAGES = {".py": "python", ".cpp": "cpp", ".h": "cpp", ".toml": "toml", ".json": "json", ".sh": "sh", ".sbatch": "sh"}


SEARCH = """# Search

<input id="search-words" type="search" placeholder="words, all of them" autofocus style="width: 100%; padding: .5rem; border: 1px solid">
<ol id="search-found"></ol>
<script src="search-index.js"></script>
<script src="search.js"></script>

The C++ reference has [a search of its own](cpp/index.html).
"""


def place(path):
    """Where a file of the tree lies on the site."""
    if path in RENAMED:
        return RENAMED[path]
    if path.startswith("docs/"):
        return path.removeprefix("docs/")
    return f"source/{path}" if path.endswith(".md") else f"source/{path}.md"


def relative(target, page):
    return "../" * page.count("/") + target


def with_lists_apart(text):
    """Python-Markdown wants an empty line before a list, and four spaces where a list is nested."""
    lines, fenced = [], False
    for line in text.splitlines():
        fenced ^= line.startswith("```")
        item = re.match(r"( *)([-*]|\d+\.) ", line)
        if item and not fenced and lines and lines[-1].strip() and not re.match(r" *([-*]|\d+\.) |  ", lines[-1]):
            lines.append("")
        lines.append(line)
    return "\n".join(lines) + "\n"


class Site:
    def __init__(self, source, out):
        self.source, self.pages = Path(source), Path(out) / "pages"
        self.waiting, self.done = [], set()

    def add(self, path):
        if path not in self.done:
            self.done.add(path)
            self.waiting.append(path)

    def link(self, path, match):
        target, anchor = match[1], match[2] or ""
        if ":" in target:
            return match[0]
        file = (self.source / path).parent.joinpath(target).resolve().relative_to(self.source.resolve()).as_posix()
        if (self.source / file).is_dir():
            return f"]({target})"
        self.add(file)
        return f"]({relative(place(file), place(path))}{anchor})"

    def page(self, path):
        """Rewrites the links outside code."""
        text, parts, at = (self.source / path).read_text(), [], 0
        for code in CODE.finditer(text):
            # A picture's or link's text may hold code: it is part of the link.
            parts += [text[at : code.start()], code[0]]
            at = code.end()
        parts.append(text[at:])
        kept = parts[1::2]
        text = "\0".join(parts[0::2])
        text = LINK.sub(lambda match: self.link(path, match), text)
        pieces = text.split("\0")
        return with_lists_apart("".join(piece + code for piece, code in zip(pieces, [*kept, ""])))

    def write(self):
        while self.waiting:
            path = self.waiting.pop()
            to = self.pages / place(path)
            to.parent.mkdir(parents=True, exist_ok=True)
            if path.endswith(".md"):
                to.write_text(self.page(path))
            elif path.startswith("docs/"):
                shutil.copy(self.source / path, to)
            else:
                language = LANGUAGES.get(Path(path).suffix, "text")
                to.write_text(f"# {path}\n\n```{language}\n{(self.source / path).read_text()}\n```\n")


def navigation(source):
    """Sections and pages of docs/README.md."""
    lines, sections = (Path(source) / "docs/README.md").read_text().splitlines(), []
    for line in lines:
        heading = re.match(r"\| \*\*(.+?)\*\*", line)
        row = re.match(r"\| \[(.+?)\]\((.+?\.md)\)", line)
        if heading:
            sections.append((heading[1], []))
        elif row:
            sections[-1][1].append((row[1], row[2]))
    text = "nav:\n  - Clearcut: index.md\n  - search: search.md\n"
    for name, pages in sections:
        text += f"  - {name}:\n" + "".join(f"      - {title}: {file}\n" for title, file in pages)
    return text + "  - Reference:\n      - commands: commands.md\n      - Python: python-reference.md\n      - C++: cpp-reference.md\n      - all pages: contents.md\n"


def main(source, out):
    site = Site(source, out)
    shutil.rmtree(site.pages, ignore_errors=True)
    site.add("README.md")
    for file in sorted((Path(source) / "docs").iterdir()):
        if file.suffix == ".md":
            site.add(f"docs/{file.name}")
    site.write()
    (site.pages / "pictures" / "favicon.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 8 8"><path d="M1 1h6v6H1z" fill="#546e7a"/></svg>\n')
    (site.pages / "search.md").write_text(SEARCH)
    shutil.copy(Path(source) / "scripts/docs/search.js", site.pages / "search.js")
    (site.pages / "search-index.js").write_text("window.SEARCH_INDEX = [];\n")
    (Path(out) / "mkdocs.yml").write_text((Path(source) / "scripts/docs/mkdocs.yml").read_text() + navigation(source))


if __name__ == "__main__":
    main(*sys.argv[1:])
