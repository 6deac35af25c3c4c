#!/usr/bin/env bash
# demo.sh COMMAND FOLDER: plans and certifies the fishhead part and says where everything is.
set -euo pipefail
clearcut=$1 out=$2
mkdir -p "$out"
status=0
"$clearcut" plan examples/fishhead.p21 -o "$out/fishhead.ngc" --stepdown 2 --certificate "$out/fishhead.json" \
  --svg "$out/fishhead.svg" --report "$out/fishhead.html" || status=$?
[ $status -le 1 ] || exit $status
rsvg-convert -w 1800 "$out/fishhead.svg" -o "$out/fishhead.png"
echo
echo "program      $out/fishhead.ngc"
echo "certificate  $out/fishhead.json"
echo "picture      $out/fishhead.png ($out/fishhead.svg)"
echo "report       $out/fishhead.html"
[ ! -x "$(dirname "$clearcut")/clearcut-serve" ] || echo "page         $clearcut serve, then http://127.0.0.1:8080/ in a browser"
exit $status
