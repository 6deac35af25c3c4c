#!/usr/bin/env bash
# browser_test.sh SITE [COMMAND]: drives the page of `make web` in Chromium: plan, cancel, check, elements, tours, download, reload without a network; screenshots
# go to build/viewer-browser/pictures. playwright-core and axe-core come from npm as the lock file says.
set -euo pipefail
cd "$(dirname "$0")/../.."
site=$(realpath "$1") source=scripts/viewer_browser kit=build/viewer-browser browser=${CHROMIUM:-/usr/bin/chromium}
[ -x "$browser" ] || { echo "skipped: the page's test needs chromium (Debian package chromium)"; exit 0; }
command -v npm > /dev/null || { echo "skipped: the page's test needs npm (Debian package npm)"; exit 0; }
mkdir -p "$kit/pictures"
if ! cmp -s "$source/package-lock.json" "$kit/package-lock.json" || [ ! -e "$kit/node_modules/.package-lock.json" ]; then
  cp "$source/package.json" "$source/package-lock.json" "$kit/"
  (cd "$kit" && npm ci --no-audit --no-fund --loglevel=error)
fi
cp "$source"/*.mjs "$kit/"
timeout 900 node "$kit/web_browser_test.mjs" "$kit" "$browser" "$site" examples ${2:+"$(realpath "$2")"}
[ $# -lt 2 ] || timeout 1800 node "$kit/examples_test.mjs" web "$kit" "$browser" "$2" examples "$site"
