#!/usr/bin/env bash
# A tarball that runs where it is unpacked: tarball.sh BUILD_FOLDER OUT. It brings every shared library but those of glibc, which
# programs look for beside themselves; SOURCE_DATE_EPOCH is the time of its files.
set -euo pipefail
build=$1 out=$(realpath "$2")
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$build/CMakeCache.txt")
name=clearcut-$version-linux-$(uname -m)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
root=$scratch/$name
cmake --install "$build" --prefix "$root" --strip > /dev/null
# MPI is the machine's own, never a copy of another.
rm -rf "$root/lib/clearcut"
# One folder of papers for all.
papers=$root/share/doc/clearcut
find "$root/share/doc" -mindepth 1 -maxdepth 1 ! -name clearcut -exec rm -r {} +
cp README.md LICENSE "$papers/"

bundled=$root/lib/bundled
mkdir -p "$bundled"
programs=$(find "$root" -type f \( -path '*/bin/*' -o -name '*.so' -o -name '*.so.*' \))
for library in $(for program in $programs; do ldd "$program"; done | awk '$2 == "=>" && $3 ~ /^\// {print $3}' | sort -u); do
  case $(basename "$library") in
    libc.so.* | libm.so.* | libdl.so.* | libpthread.so.* | librt.so.* | ld-linux*) continue ;;
  esac
  cp -L "$library" "$bundled/"
  # dpkg knows files of merged directories by either of their names.
  real=$(realpath "$library")
  owner=$(dpkg -S "$library" "$real" "${real#/usr}" 2> /dev/null | head -n 1 | cut -d: -f1 || true)
  cp "/usr/share/doc/$owner/copyright" "$papers/licenses/$owner"
done
# DT_RPATH, unlike RUNPATH, serves the libraries' own libraries too.
for program in $programs; do
  patchelf --force-rpath --set-rpath "\$ORIGIN/$(realpath --relative-to="$(dirname "$program")" "$bundled")" "$program"
done
tar -C "$scratch" --sort=name --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner --mode=go=rX,u+rw -cJf "$out/$name.tar.xz" "$name"
