// Includes what emitted solvers and the programs around them include.
#pragma once

#include <array>
#include <assur/support/all_constraints.hpp>
#include <assur/support/derivative_digits.hpp>
#include <assur/support/discriminant.hpp>
#include <assur/support/flat_branch.hpp>
#include <assur/support/nearest.hpp>
#include <assur/support/redundant.hpp>
#include <assur/support/scale.hpp>
#include <assur/support/scene_track.hpp>
#include <assur/support/solved_by_lu.hpp>
#include <cstdio>
#include <cstring>
#include <limits>
