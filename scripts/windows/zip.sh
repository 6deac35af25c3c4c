#!/usr/bin/env bash
# zip.sh BUILD_FOLDER: Clearcut for Windows as BUILD_FOLDER/clearcut-VERSION-windows-x86_64.zip: programs that need nothing but Windows,
# examples, and the notices of what is compiled in. The same sources give the same bytes: every file is as old as the last change.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=$1
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$build/CMakeCache.txt")
name=clearcut-$version-windows-x86_64
root=$build/zip/$name sources=build/windows-sources
rm -rf "$build/zip" "$build/$name.zip"
mkdir -p "$root/examples" "$root/licenses"

for program in clearcut clearcut-serve clearcut-studies clearcut-check; do
  cp "$build/apps/cli/$program.exe" "$root/"
  # Libraries that come with Windows: anything else would be missing where the programs run.
  foreign=$(x86_64-w64-mingw32-objdump -p "$root/$program.exe" | sed -n 's/^.*DLL Name: //p' | grep -vixE '(kernel32|msvcrt|advapi32|user32|bcrypt|ws2_32)\.dll' || true)
  [ -z "$foreign" ] || { echo "zip.sh: $program.exe needs $foreign" >&2; exit 1; }
done
cp LICENSE scripts/windows/README.txt "$root/"
find examples -maxdepth 1 -type f -exec cp {} "$root/examples/" \;
for package in libboost1.74-dev libcli11-dev nlohmann-json3-dev libtomlplusplus-dev mingw-w64-common gcc-mingw-w64-base; do
  cp "/usr/share/doc/$package/copyright" "$root/licenses/$package" 2> /dev/null || { echo "zip.sh: no notice of $package" >&2; exit 1; }
done
for source in libpolyclipping pugixml fmtlib cpp-httplib musl onetbb; do cp "$sources/$source"-[0-9]*/debian/copyright "$root/licenses/$source"; done

time=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2> /dev/null || stat -c %Y CHANGELOG.md)}
find "$build/zip" -exec touch -d "@$time" {} +
(cd "$build/zip" && find "$name" -type f | LC_ALL=C sort | TZ=UTC zip -q -X -9 "../$name.zip" -@)
echo "$build/$name.zip: $(stat -c %s "$build/$name.zip") bytes"
