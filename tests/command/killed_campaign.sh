#!/usr/bin/env bash
# Workers of a campaign are killed at random moments and started again until every shard is there;
# merged, the shards are the bytes of a run that nobody disturbed.
# usage: killed_campaign.sh ASSUR SCENE COUNT SHARDS ENDING
set -u
assur=$1 scene=$2 count=$3 shards=$4 ending=$5
RANDOM=20261123
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
  echo "$1" >&2
  exit 1
}

campaign=(sample "$scene" --count "$count" --seed 11 --quiet)
"$assur" "${campaign[@]}" --output "$work/whole$ending" > "$work/whole.txt" || fail "no reference"

killed=0
rounds=0
while true; do
  missing=()
  for ((shard = 1; shard <= shards; ++shard)); do
    [ -e "$work/$shard$ending" ] || missing+=("$shard")
  done
  [ ${#missing[@]} -gt 0 ] || break
  ((++rounds <= 200)) || fail "after 200 rounds ${#missing[@]} shards are missing"
  if ((${#missing[@]} < shards)) && "$assur" merge "$work"/[0-9]*"$ending" \
      --output "$work/early$ending" > /dev/null 2> "$work/message"; then
    fail "merge took ${#missing[@]} missing shards for nothing"
  fi
  # A worker gets from 10 ms on, and more from round to round: the first are killed as they begin.
  workers=()
  for shard in "${missing[@]}"; do
    after=$(printf '0.%03d' $((10 + RANDOM % (20 + 10 * rounds > 900 ? 900 : 20 + 10 * rounds))))
    timeout --signal=KILL "$after" "$assur" "${campaign[@]}" --threads 1 \
      --shard "$shard/$shards" --output "$work/$shard$ending" > /dev/null 2>&1 &
    workers+=($!)
    if ((${#workers[@]} == 4)); then
      for worker in "${workers[@]}"; do wait "$worker" 2> /dev/null || ((++killed)); done
      workers=()
    fi
  done
  for worker in "${workers[@]}"; do wait "$worker" 2> /dev/null || ((++killed)); done
done

"$assur" merge "$work"/[0-9]*"$ending" --output "$work/merged$ending" > "$work/merged.txt" ||
  fail "the shards cannot be merged"
cmp "$work/whole$ending" "$work/merged$ending" || fail "the merged bytes differ"
cmp "$work/whole.txt" "$work/merged.txt" || fail "the summaries differ"
((killed > 0)) || fail "no worker was killed: give more samples"
echo "$killed workers were killed in $rounds rounds; the bytes are the same"
