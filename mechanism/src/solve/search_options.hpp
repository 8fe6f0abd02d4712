// Options of a search for configurations, its targets, and its answer.
#pragma once

#include <Eigen/Core>
#include <assur/mechanism/error.hpp>
#include <assur/mechanism/solution.hpp>
#include <cstddef>
#include <limits>
#include <optional>
#include <variant>

namespace assur::mechanism::solve {

struct SearchOptions {
  /// Whether configurations beyond the limits of joints are omitted. A sweep keeps them, since
  /// branches go through them.
  bool within_limits = true;
  /// Whether a solution without configurations reports by how much the links fail to close, and
  /// which configuration comes nearest to the limits of joints. This takes longer than solving.
  bool measures_gap = false;
  /// Whether the motions through configurations at which several meet are found. A sweep needs them
  /// in its rows only.
  bool finds_motions = true;
};

struct SoughtAll {};
/// The configuration with a number, from 1, of a mechanism whose configurations are numbered group
/// by group; alone in the solution.
struct SoughtNumber {
  std::size_t number;
};
/// The configuration nearest to the request's reference, alone in the solution.
struct SoughtReference {};
/// The configuration nearest to a point, alone in the solution. The point holds the sought poses of
/// the links: (x / L, y / L, cos theta, sin theta) of every link that was described, with L =
/// `length`.
struct SoughtPoint {
  Eigen::VectorXd at;
  double length = 1;
  double farthest =
      std::numeric_limits<double>::infinity();  ///< more distant configurations do not count
};

using Sought = std::variant<SoughtAll, SoughtNumber, SoughtReference, const SoughtPoint*>;

struct Answer {
  std::size_t passed = 0;          ///< how many configurations were met
  std::optional<Nearest> nearest;  ///< if the nearest is sought, and there is one
  /// The refusal of a search within limits, if redundant constraints hold in none of the
  /// configurations. The solution has the same reason.
  std::optional<OverConstrained> refusal;
  /// Whether rounding may have hidden a configuration: the search rejected a place that groups
  /// hardly determine.
  bool is_unsure = false;
};

}  // namespace assur::mechanism::solve
