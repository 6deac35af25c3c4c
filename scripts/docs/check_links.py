"""Every link of a folder of HTML pages leads somewhere within it: check_links.py FOLDER. Links to the web are only counted."""
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    def __init__(self, file):
        super().__init__()
        self.links, self.places, self.loads = [], set(), []
        self.feed(file.read_text(errors="replace"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("id", "name") and value:
                self.places.add(value)
            elif name in ("href", "src", "data") and value:
                self.links.append(value)
                if tag in ("script", "img", "link") and dict(attributes).get("rel") not in ("canonical", "prev", "next"):
                    self.loads.append(value)


def main(folder):
    root = Path(folder).resolve()
    pages = {file.resolve(): Page(file) for file in root.rglob("*.html")}
    wrong, links, web = [], 0, 0
    for file, page in pages.items():
        for link in page.links:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc or link.startswith("//"):
                web += parts.scheme in ("http", "https", "") and link in page.loads
                continue
            links += 1
            target = (file.parent / unquote(parts.path)).resolve() if parts.path else file
            if not target.exists() or target.is_dir():
                wrong.append(f"{file.relative_to(root)}: {link} leads nowhere")
            # Doxygen names sections in its lists of contents that it then leaves out.
            elif parts.fragment and target in pages and "cpp" not in file.relative_to(root).parts and unquote(parts.fragment) not in pages[target].places:
                wrong.append(f"{file.relative_to(root)}: {link} leads to no place of its page")
    print("\n".join(sorted(set(wrong))[:50]) + ("\n" if wrong else "") + f"{len(pages)} pages, {links} links, {len(wrong)} wrong, {web} loaded from the web")
    sys.exit(1 if wrong or web or not pages else 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
