#!/usr/bin/env bash
# Turns campaigns of several sizes into a table of their times: by threads, by shards, by the groups
# in a chain, by the size of the sample. Each time is the least of three runs.
# usage: measure.sh ASSUR SCENE [SAMPLES] > campaigns.tsv
set -eu
assur=$1 scene=$2 samples=${3:-100000}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The least of three runs of a command, in seconds: of the wall clock, and of the processors.
least() {
  for run in 1 2 3; do
    rm -f "$work"/*.csv
    TIMEFORMAT='%R %U %S'
    { time "$@" > /dev/null; } 2>&1
  done | awk '{cpu = $2 + $3} NR == 1 || $1 < wall {wall = $1} NR == 1 || cpu < least {least = cpu}
              END {print wall, least}'
}

sample() { # SCENE COUNT ARGUMENT...
  "$assur" sample "$1" --seed 1 --count "$2" --quiet --output "$work/a.csv" "${@:3}"
}

in_shards() { # SHARDS
  for ((shard = 1; shard <= $1; ++shard)); do
    "$assur" sample "$scene" --seed 1 --count "$samples" --quiet --threads 1 \
      --shard "$shard/$1" --output "$work/$shard.csv"
  done
  "$assur" merge "$work"/*.csv --output "$work/merged.csv"
}

chain() { # GROUPS: parallelograms side by side, each a dyad on the rocker of the one before
  awk -v groups="$1" 'BEGIN {
    printf "{\"parameters\": {\"a\": {\"value\": 1, \"tolerance\": 1e-4}, "
    printf "\"c\": {\"value\": 3, \"tolerance\": 1e-4}}, \"links\": {\"ground\": {"
    for (k = 0; k <= groups; ++k) printf "%s\"D%d\": [%d, 0]", k ? ", " : "", k, 3 * k
    printf "}"
    for (k = 0; k <= groups; ++k) printf ", \"r%d\": {\"D\": [0, 0], \"C\": [\"a\", 0]}", k
    for (k = 1; k <= groups; ++k) printf ", \"c%d\": {\"B\": [0, 0], \"C\": [\"c\", 0]}", k
    printf "}, \"joints\": {"
    for (k = 0; k <= groups; ++k)
      printf "\"D%d\": {\"type\": \"revolute\", \"between\": [\"ground.D%d\", \"r%d.D\"]}, ", k, k, k
    for (k = 1; k <= groups; ++k) {
      printf "\"B%d\": {\"type\": \"revolute\", \"between\": [\"r%d.C\", \"c%d.B\"]}, ", k, k - 1, k
      printf "\"C%d\": {\"type\": \"revolute\", \"between\": [\"c%d.C\", \"r%d.C\"]}%s",
        k, k, k, k < groups ? ", " : ""
    }
    printf "}, \"drivers\": {\"D0\": {\"position\": \"60*deg\"}}, "
    printf "\"outputs\": {\"C\": \"r%d.C\"}}\n", groups
  }' > "$work/chain.json"
}

echo "# what size wall_seconds cpu_seconds samples"
for threads in $(seq 1 "$(nproc)"); do
  echo "threads $threads $(least sample "$scene" "$samples" --threads "$threads") $samples"
done
for shards in 1 2 4 8 16 32 64; do
  echo "shards $shards $(least in_shards "$shards") $samples"
done
for groups in 1 2 4 8 16 32 64; do
  chain "$groups"
  count=$((samples / 2 / groups))
  echo "groups $groups $(least sample "$work/chain.json" "$count" --threads 1) $count"
done
for count in 1 10 100 1000 10000 100000; do
  echo "samples $count $(least sample "$scene" "$count" --threads 1) $count"
done
