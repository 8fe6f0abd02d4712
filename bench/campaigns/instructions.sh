#!/usr/bin/env bash
# Turns campaigns of 5,000 and 10,000 samples into the instructions of one sample, step by step, as
# callgrind counts them: the table of docs/reports/campaigns.md.
# usage: instructions.sh BUILD_DIRECTORY SCENE
set -eu
build=$1 scene=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

counted() { # COMMAND...
  valgrind --tool=callgrind --callgrind-out-file=/dev/null "$@" 2>&1 >/dev/null |
    awk '/Collected/ {print $NF}'
}
per_sample() { # COMMAND... with COUNT in place of the number of samples
  rm -f "$work"/*
  local less more
  less=$(counted "${@//COUNT/5000}")
  rm -f "$work"/*
  more=$(counted "${@//COUNT/10000}")
  echo $(((more - less) / 5000))
}
command() { # EXTENSION
  per_sample "$build/assur" sample "$scene" --seed 1 --count COUNT --quiet --threads 1 \
    --output "$work/samples.$1"
}

for step in loop rows statistics; do
  echo "$step $(per_sample "$build/bench/campaign_steps" "$step" "$scene" COUNT)"
done
for extension in h5 csv; do
  echo "assur sample, .$extension $(command "$extension")"
done
