#!/usr/bin/env bash
# pictures.sh COMMAND: renews the README's pictures in docs/pictures: the fishhead's pictures by the command and rsvg-convert (Debian package librsvg2-bin),
# the page of its plan as `make test-browser` has just taken it.
set -euo pipefail
cd "$(dirname "$0")/../.."
taken=build/viewer-browser/pictures/1366-light.png out=docs/pictures scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
[ -e "$taken" ] || { echo "pictures.sh: $taken is missing; run make test-browser" >&2; exit 2; }
"$1" plan examples/fishhead.p21 --stepdown 2 -o "$scratch/fishhead.ngc" --svg "$scratch/fishhead.svg" --animation "$out/fishhead-milling.svg" --quiet
rsvg-convert -w 1100 "$scratch/fishhead.svg" -o "$out/fishhead.png"
cp "$taken" "$out/report-page.png"
