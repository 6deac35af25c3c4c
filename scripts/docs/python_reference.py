"""The reference of the Python module, from its stubs and its texts: python_reference.py > python-reference.md; clearcut is imported."""
import ast
import inspect
import textwrap
from pathlib import Path

import clearcut

PACKAGE = Path(clearcut.__file__).parent


def signatures():
    """What the stubs and sources say of a name or Class.name, as text."""
    found = {}
    for file in ("_core.pyi", "_outlines.py", "_notebook.py", "__init__.py"):
        for node in ast.parse((PACKAGE / file).read_text()).body:
            _collect(node, "", found)
    return found


def _collect(node, scope, found):
    if isinstance(node, ast.ClassDef):
        found[node.name] = [f"class {node.name}"]
        for inner in node.body:
            _collect(inner, f"{node.name}.", found)
    elif isinstance(node, ast.FunctionDef):
        result = f" -> {ast.unparse(node.returns)}" if node.returns else ""
        is_property = any(isinstance(one, ast.Name) and one.id == "property" for one in node.decorator_list)
        text = f"{node.name}: {result[4:]}" if is_property else f"{node.name}({ast.unparse(node.args)}){result}"
        found.setdefault(scope + node.name, []).append(text)
    elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
        found.setdefault(scope + node.target.id, []).append(f"{node.target.id}: {ast.unparse(node.annotation)}")


def text_of(value):
    """The texts are written for help(): their columns are kept."""
    text = inspect.getdoc(value) or ""
    # pybind11 begins with the signature; the stubs have a better one.
    lines = text.splitlines()
    if lines and ("->" in lines[0] or lines[0].startswith("Overloaded")) and "(" in lines[0]:
        text = "\n".join(lines[1:]).strip()
    return f"```text\n{text}\n```\n" if "\n" in text or "  " in text else f"{text}\n" if text else ""


def entry(name, value, known, level):
    lines = "\n".join(known.get(name, [name.split(".")[-1]]))
    return f"{'#' * level} {name}\n\n```python\n{lines}\n```\n\n{text_of(value)}\n"


def members(owner, known):
    """As a table: most are a line each."""
    rows = []
    for name, value in vars(owner).items():
        if name.startswith("_"):
            continue
        says = "<br>".join(known.get(f"{owner.__name__}.{name}", known.get(f"_Judged.{name}", [name])))
        text = " ".join(text_of(value).replace("```text", "").replace("```", "").split())
        rows.append(f"| `{says.replace('|', chr(92) + '|').replace('<br>', '`<br>`')}` | {text.replace('|', chr(92) + '|')} |")
    return "| | |\n|---|---|\n" + "\n".join(rows) + "\n\n" if rows else ""


def main():
    known = signatures()
    print(f"# Python reference\n\n```text\n{textwrap.dedent(clearcut.__doc__).strip()}\n```\n")
    named = [(name, getattr(clearcut, name)) for name in clearcut.__all__ if name != "__version__"]
    print("## Functions\n")
    for name, value in named:
        if not inspect.isclass(value):
            print(entry(name, value, known, 3))
    print("## Classes\n")
    for name, value in named:
        if inspect.isclass(value):
            print(entry(name, value, known, 3) + members(value, known))


if __name__ == "__main__":
    main()
