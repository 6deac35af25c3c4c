#!/bin/sh
# checker.sh SOURCE FOLDER: compiles the independent checker to WebAssembly, for a page or for Node:
#     node --no-experimental-fetch FOLDER/clearcut-check.js PROGRAM PART WITNESS
set -e
mkdir -p "$2"
em++ -std=c++20 -Oz -fwasm-exceptions -c -o "$2/clearcut-check.o" "$1"
em++ -O1 -fwasm-exceptions -sALLOW_MEMORY_GROWTH=1 -sFORCE_FILESYSTEM=1 -sNODERAWFS=${NODE_FILES:-1} -sMALLOC=emmalloc \
    -sEXIT_RUNTIME=1 "-sEXPORTED_RUNTIME_METHODS=['FS','callMain']" -o "$2/clearcut-check.js" "$2/clearcut-check.o"
wasm-opt -Oz --enable-exception-handling --enable-bulk-memory --enable-sign-ext --enable-mutable-globals --strip-debug --strip-producers -o "$2/clearcut-check.wasm" "$2/clearcut-check.wasm"
rm "$2/clearcut-check.o"
echo "$(wc -c < "$2/clearcut-check.wasm") bytes of WebAssembly, $(gzip -9 < "$2/clearcut-check.wasm" | wc -c) packed"
