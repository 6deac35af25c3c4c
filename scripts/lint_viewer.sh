#!/usr/bin/env bash
# lint_viewer.sh: checks the scripts of the report (src/report/viewer), of the server's page (apps/serve/page) with both of its ways to the
# pipeline, of the page's workers (apps/web/page), and the modules that test them: ESLint, types (TypeScript's checker reads the JSDoc
# comments; nothing is translated), style sheets, and unit tests under Node. npm installs the tools into build/lint-viewer as the lock file
# says. Fails on any finding.
set -euo pipefail
cd "$(dirname "$0")/.."
source=scripts/lint_viewer kit=build/lint-viewer
command -v npm > /dev/null || { echo "lint-viewer needs npm (Debian package npm)" >&2; exit 2; }
mkdir -p "$kit"
if ! cmp -s "$source/package-lock.json" "$kit/package-lock.json" || [ ! -e "$kit/node_modules/.package-lock.json" ]; then
  cp "$source/package.json" "$source/package-lock.json" "$kit/"
  (cd "$kit" && npm ci --no-audit --no-fund --loglevel=error)
fi

# The same folders as here beside the tools, so that the modules find their packages, and with what the web build writes.
rm -rf "$kit/tree"
mkdir "$kit/tree"
cp -r --parents src/report/viewer apps/serve/page apps/web scripts/viewer_browser scripts/windows "$source" tests/web tests/page "$kit/tree/"
cd "$kit/tree"
sed "s/@version@/1/; s/@files@/'.\/'/" apps/web/page/offline.js.in > apps/web/page/offline.js
mkdir web
cp apps/serve/page/* web/
mv apps/web/page/local.js web/server.js  # the page without a server: the same scripts, another way to the pipeline

lint() { node "$source/lint.mjs" "$@"; }
lint src/report/viewer report
lint apps/serve/page page
lint web page
lint apps/web/page worker
for folder in scripts/viewer_browser scripts/windows "$source" tests/web tests/page apps/web; do lint "$folder" modules; done
mv web/server.js apps/web/page/local.js

# Neither the type that fits everything nor a comment that silences the checker.
if grep -rnE '@ts-(ignore|nocheck|expect-error)|(: |<|\| |=> |, |\{)(any|\*)([][;,)>}]| \|)' --include='*.js' --include='*.mjs' --include='*.d.ts' .; then
  echo "types: nothing is to be left unchecked" >&2
  exit 1
fi
for project in "$source"/types.*.json; do
  [ "$project" = "$source/types.base.json" ] || ../node_modules/.bin/tsc -p "$project"
done
echo "types: no findings"
cd ../../..
node --test --test-reporter=spec tests/page/
