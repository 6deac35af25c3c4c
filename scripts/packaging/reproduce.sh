#!/usr/bin/env bash
# Builds all packages again from a copy of the tree in another folder, without a compiler cache, and compares: reproduce.sh FIRST_PACKAGES
set -euo pipefail
first=$(realpath "$1")
cd "$(dirname "$0")/../.."
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}
export SOURCE_DATE_EPOCH CCACHE_DISABLE=1
mkdir "$scratch/another folder"
git ls-files -z | tar --null -T - -c | tar -x -C "$scratch/another folder"
"$scratch/another folder/scripts/packaging/make.sh" > "$scratch/log" || { tail -n 40 "$scratch/log" >&2; exit 1; }
(cd "$scratch/another folder/build/packages/out" && sha256sum --check --quiet "$first/SHA256SUMS")
echo "the same bytes: $(wc -l < "$first/SHA256SUMS") files"
