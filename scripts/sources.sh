#!/usr/bin/env bash
# sources.sh FOLDER PACKAGE...: sources of libraries that the builds for the web and for Windows compile themselves, as Debian has
# them (`apt-get source`, which checks their signatures). Does nothing where they lie there already. The system's own list of
# sources stays as it is.
set -euo pipefail
folder=$1
shift
packages=("$@")
mkdir -p "$folder"
cd "$folder"
present() { for one in "${packages[@]}"; do compgen -G "$one-[0-9]*/" > /dev/null || return 1; done; }
present && exit 0

# The same places as the packages, for sources.
cat /etc/apt/sources.list.d/*.sources 2> /dev/null | sed 's/^Types:.*/Types: deb-src/' > list.sources || true
sed -n 's/^deb /deb-src /p' /etc/apt/sources.list > list.list 2> /dev/null || true
list=list.sources
grep -q '^Types' list.sources || list=list.list
mkdir -p lists/partial
apt=(apt-get -qq -o "Dir::Etc::sourcelist=$PWD/$list" -o Dir::Etc::sourceparts=/dev/null -o "Dir::State::lists=$PWD/lists"
     -o APT::Sandbox::User=root)
"${apt[@]}" update
"${apt[@]}" source "${packages[@]}"
rm -f ./*.orig.tar.* ./*.debian.tar.* ./*.dsc
rm -rf lists list.sources list.list
present || { echo "sources.sh: apt-get source did not bring ${packages[*]}" >&2; exit 1; }
