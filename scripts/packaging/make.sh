#!/usr/bin/env bash
# Builds the Debian packages, the tarball, their bill of materials and checksums: make.sh [BUILD_FOLDER]; results in BUILD_FOLDER/out
# (default build/packages). The same sources and Debian packages give the same bytes, in any folder.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/packages}
# Every file is as old as the last change; a tree without git takes the time of its change log.
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2> /dev/null || stat -c %Y CHANGELOG.md)}
export SOURCE_DATE_EPOCH LC_ALL=C TZ=UTC
# ccache's base directory makes paths relative to the build's folder, and what is compiled then names its sources otherwise.
export CCACHE_BASEDIR=
umask 022
log() { "$@" > "$build.log" 2>&1 || { cat "$build.log" >&2; exit 1; }; rm -f "$build.log"; }

mkdir -p "$(dirname "$build")"
log cmake --preset packages -B "$build"
cmake --build "$build"
rm -rf "$build/out"
mkdir "$build/out"
log cmake -E chdir "$build" cpack -G DEB -B out
rm -rf "$build/out/_CPack_Packages" "$build"/out/*.sha256
cp "$build/sbom/clearcut.spdx.json" "$build/out/"
scripts/packaging/tarball.sh "$build" "$build/out"
(cd "$build/out" && sha256sum -- *.deb *.tar.xz *.json > SHA256SUMS)
cat "$build/out/SHA256SUMS"
