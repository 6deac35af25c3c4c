#!/usr/bin/env bash
# Formats every C++ and JavaScript file that git tracks; with --check only says which differ, and fails if any does.
set -euo pipefail
cd "$(dirname "$0")/.."
mode=(-i); [ "${1:-}" = --check ] && mode=(--dry-run --Werror)
git ls-files '*.cpp' '*.h' '*.js' '*.mjs' | xargs -r clang-format "${mode[@]}"
