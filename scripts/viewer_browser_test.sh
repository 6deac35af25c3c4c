#!/usr/bin/env bash
# viewer_browser_test.sh COMMAND: opens the fishhead's report in Chromium, plays, steps, clicks, and takes screenshots into
# build/viewer-browser/pictures. playwright-core and axe-core come from npm as the lock file says.
set -euo pipefail
cd "$(dirname "$0")/.."
clearcut=$1 source=scripts/viewer_browser kit=build/viewer-browser browser=${CHROMIUM:-/usr/bin/chromium}
[ -x "$browser" ] || { echo "skipped: test-browser needs chromium (Debian package chromium)"; exit 0; }
command -v npm > /dev/null || { echo "skipped: test-browser needs npm (Debian package npm)"; exit 0; }
mkdir -p "$kit/pictures"
if ! cmp -s "$source/package-lock.json" "$kit/package-lock.json" || [ ! -e "$kit/node_modules/.package-lock.json" ]; then
  cp "$source/package.json" "$source/package-lock.json" "$kit/"
  (cd "$kit" && npm ci --no-audit --no-fund --loglevel=error)
fi
cp "$source"/*.mjs "$kit/"
"$clearcut" plan examples/fishhead.p21 -o "$kit/fishhead.ngc" --stepdown 2 --report "$kit/fishhead.html" --quiet
cat > "$kit/square.json" <<'PART'
{"name": "square", "units": "mm", "outer": [[0, 0, 0], [50, 0, 0], [50, 50, 0], [0, 50, 0]], "islands": [], "top": 0, "depth": 2}
PART
"$clearcut" plan "$kit/square.json" --tool endmill:6 --accept out-of-reach -o "$kit/square.ngc" --report "$kit/square.html" --quiet
"$clearcut" plan examples/bracket.json --tool endmill:10 --tool endmill:3 --rest -o "$kit/rest.ngc" --report "$kit/rest.html" --quiet
printf '%s\n' G21 G90 G17 G54 'T1 M6' 'S5000 M3' 'G0 X50 Y100' 'G0 Z5' 'G1 Z-2 F100' 'G1 X350 F900' 'G1 Y106.1' 'G1 X50' 'G0 Z5' M5 M2 > "$kit/rib.ngc"
"$clearcut" verify "$kit/rib.ngc" --stock 400,300,5 --tool endmill:6 --dialect linuxcnc --report "$kit/rib.html" > /dev/null || [ $? -eq 1 ]
{
  printf '%s\n' 'G21 G90 G17 G54' 'T1 M6' 'S5000 M3' 'G0 Z5'
  for ((i = 0; i < 260; ++i)); do printf 'G0 X%d Y%d\nG0 Z-1\nG1 X%d F600\nG0 Z5\n' $((2 + 2 * (i % 20))) $((2 + 3 * (i / 20))) $((3 + 2 * (i % 20))); done
  echo M30
} > "$kit/faulty.ngc"
"$clearcut" verify "$kit/faulty.ngc" --part "$kit/square.json" --tool endmill:6 --dialect linuxcnc --report "$kit/faulty.html" > /dev/null || [ $? -eq 1 ]
timeout 900 node "$kit/viewer_browser_test.mjs" "$kit" "$browser"
timeout 1800 node "$kit/examples_test.mjs" report "$kit" "$browser" "$clearcut" examples
