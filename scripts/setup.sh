#!/usr/bin/env bash
# setup.sh [GROUP...]: installs the Debian packages of these groups of packages.txt (none named: of all but those marked "alone")
# that are missing; does nothing where all are present.
set -euo pipefail
list=$(dirname "$0")/packages.txt
for group in "$@"; do
  grep -qxF -e "[$group]" -e "[$group] alone" "$list" || { echo "setup.sh: packages.txt has no group $group" >&2; exit 2; }
done

declare -A present
while read -r name status; do
  [ "$status" != installed ] || present[$name]=1
done < <(dpkg-query -W -f='${Package} ${db:Status-Status}\n')

required=() optional=() wanted=
while read -r line; do
  case $line in
    ''|'#'*) ;;
    '['*)
      wanted= group=${line%%]*}
      if [ $# -gt 0 ]; then [[ " $* " != *" ${group:1} "* ]] || wanted=yes; else [[ $line == *' alone' ]] || wanted=yes; fi ;;
    optional:*) [ -z "$wanted" ] || [ -n "${present[${line#optional:}]:-}" ] || optional+=("${line#optional:}") ;;
    *) [ -z "$wanted" ] || [ -n "${present[$line]:-}" ] || required+=("$line") ;;
  esac
done < "$list"
[ $((${#required[@]} + ${#optional[@]})) -eq 0 ] && exit 0

as_root=; [ "$(id -u)" -eq 0 ] || as_root=sudo
export DEBIAN_FRONTEND=noninteractive
$as_root apt-get update -qq
[ ${#required[@]} -eq 0 ] || $as_root apt-get install -y -qq --no-install-recommends "${required[@]}"
[ ${#optional[@]} -eq 0 ] || $as_root apt-get install -y -qq --no-install-recommends "${optional[@]}" ||
  echo "not installed (optional): ${optional[*]}" >&2
