#!/usr/bin/env bash
# Formats every C++ file that git tracks; with --check only says which differ, and fails if any does.
set -euo pipefail
cd "$(dirname "$0")/.."
mode=(-i); [ "${1:-}" = --check ] && mode=(--dry-run --Werror)
git ls-files '*.cpp' '*.h' | xargs -r clang-format "${mode[@]}"
