"""The sections of the site's own pages for search.js: search_index.py SITE > search-index.js"""
import json
import sys
from html.parser import HTMLParser
from pathlib import Path


class Sections(HTMLParser):
    """Text of the article, parted at its headings."""

    def __init__(self, page):
        super().__init__()
        self.page, self.sections, self.depth, self.heading = page, [], 0, False

    def handle_starttag(self, tag, attributes):
        if tag == "article":
            self.depth += 1
        if self.depth and tag in ("h1", "h2", "h3"):
            self.sections.append([self.page, dict(attributes).get("id") or "", "", ""])
            self.heading = True

    def handle_endtag(self, tag):
        if tag == "article":
            self.depth -= 1
        if tag in ("h1", "h2", "h3"):
            self.heading = False

    def handle_data(self, data):
        if self.depth and self.sections:
            self.sections[-1][2 if self.heading else 3] += data


def main(site):
    rows = []
    for file in sorted(Path(site).rglob("*.html")):
        page = file.relative_to(site).as_posix()
        if page.startswith("cpp/") or page in ("search.html", "reproduced.html"):
            continue
        sections = Sections(page)
        sections.feed(file.read_text())
        rows += [[name, anchor, title.replace("¶", "").strip(), " ".join(text.split())] for name, anchor, title, text in sections.sections]
    print(f"window.SEARCH_INDEX = {json.dumps(rows, ensure_ascii=False)};")


if __name__ == "__main__":
    main(*sys.argv[1:])
