#!/usr/bin/env bash
# test.sh COMMAND ZIP: unpacks Clearcut for Windows in a folder of its own and tries it under Wine: the same bytes as COMMAND for every
# example, and the server's page. Skipped where Wine is absent.
set -euo pipefail
cd "$(dirname "$0")/../.."
command=$(realpath "$1") zip=$(realpath "$2") place=build/windows/try
command -v wine > /dev/null || { echo "skipped: Clearcut for Windows is tried under Wine (Debian packages wine, wine64)"; exit 0; }
command -v node > /dev/null || { echo "skipped: the trial under Wine needs Node (Debian package nodejs)"; exit 0; }
rm -rf "$place"
mkdir -p "$place"
place=$(realpath "$place")
# A space and letters beyond ASCII in the path, as in many users' folders.
unzip -q "$zip" -d "$place/Fräs teile"
export WINEPREFIX=$place/prefix WINEDEBUG=-all WINEDLLOVERRIDES='winemenubuilder.exe,mscoree,mshtml=d' LC_ALL=C.UTF-8
timeout 300 wine wineboot -i > "$place/wineboot.log" 2>&1 || { cat "$place/wineboot.log" >&2; exit 1; }
# One Windows for all runs, which would start anew for each. What it starts itself holds no stream of a run.
wineserver -w
wineserver -p
trap 'wineserver -k || true' EXIT
timeout 300 wine cmd /c exit > "$place/wineboot.log" 2>&1 < /dev/null
timeout 3000 node scripts/windows/try.mjs "$command" "$place/Fräs teile/$(basename "$zip" .zip)" examples "$place/work"
