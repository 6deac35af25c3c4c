#!/usr/bin/env bash
# same_bytes.sh COMMAND BUILT [COUNT]: whether the WebAssembly build in BUILT writes the command's programs, byte for byte, for the examples
# and COUNT random parts (200 where none is named).
set -euo pipefail
cd "$(dirname "$0")/../.."
exec node tests/web/same_bytes.mjs "$1" "$2" examples "${3:-200}"
