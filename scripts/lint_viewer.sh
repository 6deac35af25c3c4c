#!/usr/bin/env bash
# lint_viewer.sh: ESLint over the scripts and styles of the report (src/report/viewer) and of the server's page
# (apps/serve/page) with both of its ways to the pipeline (apps/web/page), installed by npm into build/lint-viewer as the lock file says. Fails on any finding.
set -euo pipefail
cd "$(dirname "$0")/.."
source=src/report/viewer kit=build/lint-viewer
command -v npm > /dev/null || { echo "lint-viewer needs npm (Debian package npm)" >&2; exit 2; }
mkdir -p "$kit"
if ! cmp -s "$source/package-lock.json" "$kit/package-lock.json" || [ ! -e "$kit/node_modules/.package-lock.json" ]; then
  cp "$source/package.json" "$source/package-lock.json" "$kit/"
  (cd "$kit" && npm ci --no-audit --no-fund --loglevel=error)
fi
cp "$source/lint.mjs" "$kit/"
node "$kit/lint.mjs" "$source"
node "$kit/lint.mjs" apps/serve/page may-fetch
# The page without a server: the same scripts, another way to the pipeline.
rm -rf "$kit/web"
cp -r apps/serve/page "$kit/web"
cp apps/web/page/local.js "$kit/web/server.js"
node "$kit/lint.mjs" "$kit/web" may-fetch
