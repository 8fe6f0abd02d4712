#!/bin/sh
# Turns scenes into a table of what their emitted solvers cost, one row per scene: lines of the
# header, bytes of the object that calls `solve`, seconds and megabytes of its compilation.
#
#   solver_sizes.sh GENERATOR PROJECT [SCENES]
#
# GENERATOR is the command assur of the project whose runtime is in PROJECT: of this one, or of an
# older one to compare with. SCENES is a directory of scenes, by default examples/ of this project,
# and CXX the compiler, by default g++.
set -eu
generator=$1
project=$2
scenes=${3:-$(dirname "$0")/../../../examples}
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

echo '| scene | lines | bytes of object | seconds | MB |'
echo '|---|---|---|---|---|'
for scene in "$scenes"/*.json; do
  name=$(basename "$scene" .json)
  "$generator" emit --scene "$scene" --output "$work" 2> /dev/null > /dev/null
  header=$work/assur/scenes/$name.hpp
  # The solver is the last struct that begins a line; its groups stand before it.
  solver=$(sed -n 's/^struct \([A-Za-z0-9_]*\) {$/\1/p' "$header" | tail -n 1)
  cat > "$work/calls.cpp" << CALLS
#include <array>
#include <assur/scenes/$name.hpp>
using Solver = assur::scenes::$solver;
int count(const Solver::Drivers<double>& drivers,
    std::array<Solver::State<double>, Solver::max_configurations>& states) {
  return Solver::solve(drivers, states).count;
}
CALLS
  env time -f '%U %M' -o "$work/cost" "${CXX:-g++}" -std=c++17 -O2 -c "$work/calls.cpp" \
    -o "$work/calls.o" -I"$work" -I"$project/runtime/include" $(pkg-config --cflags eigen3)
  read -r seconds kilobytes < "$work/cost"
  echo "| $name | $(wc -l < "$header") | $(wc -c < "$work/calls.o") | $seconds |" \
    "$((kilobytes / 1000)) |"
done
