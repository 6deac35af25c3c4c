#!/usr/bin/env bash
# serve_browser_test.sh COMMAND: drives the page of `clearcut serve` in Chromium: plan, cancel, download, check, elements, tours; screenshots go to
# build/viewer-browser/pictures. playwright-core and axe-core come from npm as the lock file says.
set -euo pipefail
cd "$(dirname "$0")/.."
clearcut=$(realpath "$1") source=scripts/viewer_browser kit=build/viewer-browser browser=${CHROMIUM:-/usr/bin/chromium}
[ -x "$browser" ] || { echo "skipped: test-browser needs chromium (Debian package chromium)"; exit 0; }
command -v npm > /dev/null || { echo "skipped: test-browser needs npm (Debian package npm)"; exit 0; }
[ -x "$(dirname "$clearcut")/clearcut-serve" ] || { echo "skipped: this build has no server (libcpp-httplib-dev)"; exit 0; }
mkdir -p "$kit/pictures"
if ! cmp -s "$source/package-lock.json" "$kit/package-lock.json" || [ ! -e "$kit/node_modules/.package-lock.json" ]; then
  cp "$source/package.json" "$source/package-lock.json" "$kit/"
  (cd "$kit" && npm ci --no-audit --no-fund --loglevel=error)
fi
cp "$source"/*.mjs "$kit/"
cat > "$kit/square.json" <<'PART'
{"name": "square", "units": "mm", "outer": [[0, 0, 0], [50, 0, 0], [50, 50, 0], [0, 50, 0]], "islands": [], "top": 0, "depth": 2}
PART
cat > "$kit/twice.toml" <<'JOB'
[part]
file = "square.json"

[stock]
x = [-5, 55]
y = [-5, 55]
z = [-20, 0]

[[tool]]
number = 1
kind = "endmill"
diameter = 6

[[setup]]
up = "+Z"
origin = "corner"

[[setup]]
up = "-Z"
origin = "corner"
JOB
cat > "$kit/large.json" <<'PART'
{"name": "large", "units": "mm", "outer": [[0, 0, 0.1], [400, 0, 0.2], [400, 300, 0.1], [0, 300, 0.3]],
 "islands": [[[200, 150, 1], [150, 150, 1]]], "top": 0, "depth": 5}
PART
rm -f "$kit/serve.txt"
"$clearcut" serve --port 0 > "$kit/serve.txt" &
server=$!
trap 'kill $server 2> /dev/null || true' EXIT
for _ in $(seq 600); do [ ! -s "$kit/serve.txt" ] || break; sleep 0.1; done
cp examples/plate.dxf examples/tools.toml examples/five_pockets.toml "$kit/"
timeout 900 node "$kit/serve_browser_test.mjs" "$kit" "$browser" "$(head -1 "$kit/serve.txt")" "$clearcut"
timeout 1800 node "$kit/examples_test.mjs" server "$kit" "$browser" "$clearcut" examples "$(head -1 "$kit/serve.txt")"
