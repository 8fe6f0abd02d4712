#!/usr/bin/env bash
# Law: the WebAssembly module in pages is, byte for byte, the one compiled from the sources.
# page_module_test.sh BUILD KEPT
set -euo pipefail
build=$1
kept=$2
made=$build/mechanism/src/page
if ! cmp --silent "$made/made_with.txt" "$kept/made_with.txt"; then
  echo "the module was made with other versions, which write other bytes:"
  diff "$kept/made_with.txt" "$made/made_with.txt" || true
  exit 77
fi
cmake --build "$build" --target page_module_alone
base64 --decode "$kept/mechanism.wasm.lzma.base64" | xz --format=lzma --decompress --stdout |
  cmp - "$made/mechanism.wasm" ||
  { echo "cmake --build $build --target page_module makes it anew"; exit 1; }
