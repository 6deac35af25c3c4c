#!/usr/bin/env bash
# Builds the documentation as pages that open from disk: make.sh BUILD_FOLDER (with the command and the Python module); the site is
# build/docs/site/index.html. Every link is checked; nothing is loaded from the web.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=$1 out=build/docs
mkdir -p "$out"
python=/usr/bin/python3
version=$(sed -n 's/^project(clearcut VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
$python scripts/docs/pages.py . "$out"
$python scripts/docs/commands.py "$build/apps/cli/clearcut" > "$out/pages/commands.md"
PYTHONPATH=$build/python PYTHONDONTWRITEBYTECODE=1 $python scripts/docs/python_reference.py > "$out/pages/python-reference.md"

# Doxygen reads the headers as users get them.
rm -rf "$out/prefix"
cmake --install "$build" --prefix "$out/prefix" --component development > /dev/null
(cat scripts/docs/Doxyfile; printf 'INPUT = %s\nOUTPUT_DIRECTORY = %s\nSTRIP_FROM_PATH = %s\nPROJECT_NUMBER = %s\n' \
  "$out/prefix/include" "$out/pages" "$out/prefix/include" "$version") | doxygen - > "$out/doxygen.log" 2>&1 || { tail "$out/doxygen.log" >&2; exit 1; }
printf '# C++ reference\n\n[Headers, classes and functions](cpp/index.html), as installed below `include/clearcut`. The promise is what the\npublic headers bring into the namespace `clearcut`: [the library](library.md).\n' > "$out/pages/cpp-reference.md"

mkdocs build --quiet --strict --clean --config-file "$out/mkdocs.yml"
rm "$out/site/404.html"  # for servers alone
$python scripts/docs/search_index.py "$out/site" > "$out/site/search-index.js"
$python scripts/docs/check_links.py "$out/site"
echo "$out/site/index.html"
