#!/usr/bin/env bash
# Installs the Debian packages of packages.txt that are missing; does nothing where all are present.
set -euo pipefail
list=$(dirname "$0")/packages.txt
missing() { dpkg-query -W -f='${Status}' "$1" 2>/dev/null | grep -q 'install ok installed' || echo "$1"; }
required=() optional=()
while read -r name; do
  case $name in ''|'#'*) ;; optional:*) optional+=($(missing "${name#optional:}")) ;; *) required+=($(missing "$name")) ;; esac
done < "$list"
[ $((${#required[@]} + ${#optional[@]})) -eq 0 ] && exit 0
as_root=; [ "$(id -u)" -eq 0 ] || as_root=sudo
export DEBIAN_FRONTEND=noninteractive
$as_root apt-get update -qq
[ ${#required[@]} -eq 0 ] || $as_root apt-get install -y -qq --no-install-recommends "${required[@]}"
[ ${#optional[@]} -eq 0 ] || $as_root apt-get install -y -qq --no-install-recommends "${optional[@]}" ||
  echo "not installed (optional): ${optional[*]}" >&2
