// The whole interface of the runtime for users of generated models, in one include.
//
//   Assemblies    assemblies(d, u)                    every configuration of a group
//   assemblies(count, d, u, result)                   the same of many groups, several at once
//   Status        refine(d, u, q)                     one configuration, from a guess
//   Regularity    regularity(d, u, q)                 how far it is from singular
//   Status        sensitivities, motion, jerk, ...    derivatives of first to third order
//   SecondOrder   SecondOrder(d, u, q)                second derivatives, on demand
//   BranchPoint   branch_point(d, inputs, q)          the start of a branch
//   Track         track(d, path, from, to, start)     continuation along a branch
//   Singularity   singularity_along(d, u, q, ...)     a fold or a crossing
//   Status        special_points, ...                 the published method, instead of the Jacobian
//   Status        normal_form, fill_dimensions        from a drawing's features to dimensions
//
// Each answer is a status or holds one. The models themselves are in assur/<group>/model_<n>.hpp.
#pragma once

#include <assur/assemblies.hpp>
#include <assur/assembly.hpp>
#include <assur/batch.hpp>
#include <assur/batch_kinematics.hpp>
#include <assur/branch_point.hpp>
#include <assur/directions.hpp>
#include <assur/kinematics.hpp>
#include <assur/model.hpp>
#include <assur/model_tables.hpp>
#include <assur/normal_form.hpp>
#include <assur/second_order.hpp>
#include <assur/singularity.hpp>
#include <assur/special_points.hpp>
#include <assur/status.hpp>
#include <assur/tracking.hpp>
#include <assur/variables.hpp>
#include <assur/version.hpp>
