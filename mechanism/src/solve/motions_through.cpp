#include "motions_through.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <assur/local/singular_point.hpp>
#include <assur/support/redundant.hpp>
#include <cmath>
#include <limits>
#include <set>

#include "group_by_group.hpp"
#include "quadratic_equations.hpp"

namespace assur::mechanism::solve {

namespace {

using Parts = MovingConstraints::Parts;

/// Rates are accurate to two digits where their relative error by rounding is at most this.
constexpr double two_digits_lost = 1e-3;
/// A singular value below this may vanish at a place nearby.
constexpr double nearly_lost = 1e-4;

/// The constraints at t = 0, as a local::System without a way: all of z is q.
class ConstraintsInPlace {
 public:
  using Scalar = double;
  using Point = Eigen::VectorXd;
  using Step = Eigen::VectorXd;
  static constexpr int rows = Eigen::Dynamic;
  static constexpr int unknowns = Eigen::Dynamic;

  explicit ConstraintsInPlace(const MovingConstraints& F) : F_(F) {}

  [[nodiscard]] int row_count() const { return static_cast<int>(F_.rows()); }
  [[nodiscard]] int unknown_count() const { return static_cast<int>(F_.unknowns()) - 1; }
  [[nodiscard]] Eigen::VectorXd misses(const Point& q) const {
    return F_.coefficient(0, F_.at_rest(q));
  }
  [[nodiscard]] Eigen::MatrixXd jacobian(const Point& q) const { return F_.jacobian(q); }
  [[nodiscard]] Eigen::MatrixXd bends(const Point& q, const Step& v) const {
    return F_.bends(q, v);
  }
  void move(const Step& step, Point& q) const { q += step; }

 private:
  const MovingConstraints& F_;
};

/// Transforms columns to a basis of the same span in which each belongs to a block: it is zero in
/// every earlier block, and has unit length there. `block_of` gives the block of each row. Returns
/// the block of each column.
template <typename Blocks>
std::vector<std::size_t> bring_to_echelon_form(const std::vector<std::size_t>& block_of,
                                               const Blocks& blocks, Eigen::MatrixXd& columns) {
  /// A column of unit length whose part in a block is shorter than this is zero there.
  constexpr double vanishing = 1e-6;
  std::vector<std::size_t> of_columns;
  Eigen::Index done = 0;
  for (const std::size_t block : blocks) {
    std::vector<Eigen::Index> rows;
    for (std::size_t row = 0; row < block_of.size(); ++row) {
      if (block_of[row] == block) {
        rows.push_back(static_cast<Eigen::Index>(row));
      }
    }
    const Eigen::Index left = columns.cols() - done;
    if (left == 0) {
      break;
    }
    const Eigen::MatrixXd part = columns(rows, Eigen::seqN(done, left));
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(part, Eigen::ComputeFullV);
    const auto rank =
        std::ranges::count_if(svd.singularValues(), [](double value) { return value > vanishing; });
    const Eigen::MatrixXd turned = columns.rightCols(left) * svd.matrixV();
    columns.rightCols(left) = turned;
    columns(rows, Eigen::seqN(done + rank, left - rank)).setZero();
    for (Eigen::Index column = 0; column < rank; ++column) {
      columns.col(done + column) /= svd.singularValues()(column);
    }
    of_columns.insert(of_columns.end(), static_cast<std::size_t>(rank), block);
    done += rank;
  }
  return of_columns;
}

class MotionSearch {
 public:
  explicit MotionSearch(const MovingConstraints& F)
      : F_(F), place_(F.at_rest(Eigen::VectorXd::Zero(F.unknowns()))), W_(F.rows(), 0) {}

  [[nodiscard]] bool is_known() const {
    return F_.coefficient(1, place_).allFinite() && F_.coefficient(2, place_).allFinite();
  }

  std::vector<Motion> run() {
    if (F_.rows() < F_.unknowns()) {
      return {};
    }
    if (F_.rows() > F_.unknowns() || !begin_group_by_group()) {
      settle();
      if (!begin()) {
        return {};  // a fold, or redundant constraints that contradict one another
      }
    }
    if (N_.cols() == 0) {
      add_only_motion();
    } else if (noise_ < 1) {
      add_motions_of_cone();
    }
    return std::move(found_);
  }

 private:
  /// The equations of one group, and the number of unknowns that they determine.
  struct Level {
    std::vector<Eigen::Index> equations;
    Eigen::Index unknowns = 0;
  };

  /// Quadratic equations W' f(N x) = 0 in levels; each level has its own unknowns and those of the
  /// levels before.
  struct Cone {
    Eigen::MatrixXd N, W;
    double noise;       ///< of the coefficients
    double most_error;  ///< accepted relative error of a root
    std::vector<Level> levels = {};
    QuadraticEquations equations = {};
  };

  /// A root of the first levels of a cone.
  struct Root {
    Eigen::VectorXd x;
    Eigen::VectorXd error;
    bool is_simple = true;  ///< in all levels
  };

  /// Finds the place, the kernels, and the rounding of the coefficients that follow.
  void settle() {
    const auto lost = [this](double least) {
      return std::ranges::count_if(svd_.singularValues(),
                                   [least](double value) { return value <= least; });
    };
    decompose();
    const double rounding = F_.rounding();
    Eigen::Index corank = lost(nearly_lost);
    bool is_exact = false;
    if (corank > 0) {
      const ConstraintsInPlace system(F_);
      const auto singular = local::singular_point(system, Eigen::VectorXd(place_.col(0)),
                                                  static_cast<int>(corank) - 1);
      // The exact place is this configuration if all constraints also hold halfway between the two.
      is_exact = singular.is_found && singular.opening <= rounding &&
                 system.misses(singular.at / 2).norm() <= some * rounding;
      if (is_exact) {
        place_.col(0) = singular.at;
        decompose();
      }
    }
    corank = is_exact ? corank : lost(hidden());
    choose_rank(F_.unknowns() - corank);
    noise_ = some * std::max(some * rounding / (firmness_ * firmness_), is_exact ? 0 : hidden());
  }
  void choose_rank(Eigen::Index rank) {
    rank_ = rank;
    N_ = svd_.matrixV().rightCols(F_.unknowns() - rank);
    W_ = svd_.matrixU().rightCols(F_.rows() - rank);
    firmness_ = rank > 0 ? svd_.singularValues()(rank - 1) / svd_.singularValues()(0) : 1;
  }
  /// Finds the first rates if each group is firm; returns false otherwise.
  [[nodiscard]] bool begin_group_by_group() {
    if (!group_by_group_.factorise(F_.blocks(), F_.jacobian(place_.col(0)), nearly_lost)) {
      return false;
    }
    firmness_ = group_by_group_.firmness();
    start_ = place_;
    start_.col(1) = group_by_group_.solve(F_.coefficient(1, place_));
    return true;
  }
  /// Finds the shortest first rates; returns false if there are none.
  [[nodiscard]] bool begin() {
    const Eigen::VectorXd f = F_.coefficient(1, place_);
    start_ = place_;
    start_.col(1) = shortest(f);
    return take_distance((W_.transpose() * f).norm());
  }
  /// A place that is accurate to r / s gives a singular value s up to r / s.
  [[nodiscard]] double hidden() const { return std::sqrt(8 * F_.rounding()); }
  /// Takes W' f_1 as the distance in t to its zero, by which all further coefficients change.
  /// Returns false where that place is too far away.
  [[nodiscard]] bool take_distance(double distance) {
    noise_ = std::max(noise_, some * distance);
    return distance <= some * hidden();
  }
  void decompose() {
    svd_.compute(F_.jacobian(place_.col(0)), Eigen::ComputeFullU | Eigen::ComputeFullV);
  }

  /// The shortest q with J q = -f.
  [[nodiscard]] Eigen::VectorXd shortest(const Eigen::VectorXd& f) const {
    return -svd_.matrixV().leftCols(rank_) * (svd_.matrixU().leftCols(rank_).transpose() * f)
                                                 .cwiseQuotient(svd_.singularValues().head(rank_));
  }

  void add_only_motion() {
    const double error = F_.rounding() / (firmness_ * firmness_);
    if (!(error < two_digits_lost)) {
      return;
    }
    const Eigen::VectorXd f = F_.coefficient(2, start_);
    const bool is_known_twice = error / firmness_ < two_digits_lost;
    if (is_known_twice && (W_.transpose() * f).norm() > agreement * f.norm()) {
      return;  // redundant constraints cease to hold
    }
    add(start_, rank_ > 0 ? shortest(f) : group_by_group_.solve(f), is_known_twice);
  }

  /// Brings N and W to echelon form and pairs the unknowns of each group with its equations.
  /// Returns false where some unknowns have none.
  [[nodiscard]] bool find_levels(Cone& cone) const {
    const std::set<std::size_t> blocks(F_.blocks().of_rows.begin(), F_.blocks().of_rows.end());
    std::set<std::size_t> all(F_.blocks().of_unknowns.begin(), F_.blocks().of_unknowns.end());
    all.insert(blocks.begin(), blocks.end());
    const std::vector<std::size_t> of_unknowns =
        bring_to_echelon_form(F_.blocks().of_unknowns, all, cone.N);
    const std::set<std::size_t, std::greater<>> from_last(blocks.begin(), blocks.end());
    const std::vector<std::size_t> of_equations =
        bring_to_echelon_form(F_.blocks().of_rows, from_last, cone.W);
    Level level;
    for (const std::size_t block : all) {
      level.unknowns += std::ranges::count(of_unknowns, block);
      for (std::size_t equation = 0; equation < of_equations.size(); ++equation) {
        if (of_equations[equation] == block) {
          level.equations.push_back(static_cast<Eigen::Index>(equation));
        }
      }
      if (std::ssize(level.equations) >= level.unknowns && !level.equations.empty()) {
        cone.levels.push_back(level);
        level = {};
      }
    }
    return level.unknowns == 0 && std::ssize(of_unknowns) == cone.N.cols();
  }

  /// The roots of a cone whose equations are W' `function`(N x); nothing where one of them is less
  /// accurate than `most_error`.
  template <typename Function>
  [[nodiscard]] std::optional<std::vector<Root>> roots_of(Cone& cone,
                                                          const Function& function) const {
    if (!find_levels(cone)) {
      return std::nullopt;
    }
    cone.equations = interpolated(cone.N.cols(), [&](const Eigen::VectorXd& x) {
      return Eigen::VectorXd(cone.W.transpose() * function(cone.N * x));
    });
    std::vector<Root> roots;
    const bool is_known = cone.equations.constant.allFinite() && descend(cone, 0, {}, roots);
    return is_known ? std::optional(std::move(roots)) : std::nullopt;
  }

  /// The coefficients of a function that consists of quadratic polynomials.
  template <typename Function>
  [[nodiscard]] static QuadraticEquations interpolated(Eigen::Index unknowns,
                                                       const Function& function) {
    const auto unit = [unknowns](Eigen::Index place) {
      return Eigen::VectorXd(Eigen::VectorXd::Unit(unknowns, place));
    };
    QuadraticEquations result;
    result.constant = function(Eigen::VectorXd::Zero(unknowns));
    const Eigen::Index count = result.constant.size();
    result.linear.resize(count, unknowns);
    result.square.assign(static_cast<std::size_t>(count),
                         Eigen::MatrixXd::Zero(unknowns, unknowns));
    const auto set = [&](Eigen::Index one, Eigen::Index other, const Eigen::VectorXd& values) {
      for (Eigen::Index row = 0; row < count; ++row) {
        Eigen::MatrixXd& square = result.square[static_cast<std::size_t>(row)];
        square(one, other) = square(other, one) = values(row);
      }
    };
    std::vector<Eigen::VectorXd> at;
    for (Eigen::Index one = 0; one < unknowns; ++one) {
      at.push_back(function(unit(one)));
      const Eigen::VectorXd behind = function(-unit(one));
      result.linear.col(one) = (at.back() - behind) / 2;
      set(one, one, (at.back() + behind) / 2 - result.constant);
    }
    for (Eigen::Index one = 0; one < unknowns; ++one) {
      for (Eigen::Index other = 0; other < one; ++other) {
        set(one, other,
            (function(unit(one) + unit(other)) - at[static_cast<std::size_t>(one)] -
             at[static_cast<std::size_t>(other)] + result.constant) /
                2);
      }
    }
    return result;
  }

  /// Solves the levels of a cone from `depth` on, where `before` holds the unknowns of the earlier
  /// ones. Returns false where some roots are less accurate than `most_error`.
  [[nodiscard]] static bool descend(const Cone& cone, std::size_t depth, const Root& before,
                                    std::vector<Root>& roots) {
    if (depth == cone.levels.size()) {
      roots.push_back(before);
      return true;
    }
    const Level& level = cone.levels[depth];
    const QuadraticEquations here = cone.equations.of(level.equations, before.x, level.unknowns);
    if (level.unknowns == 0) {
      return here.constant.norm() > agreement * std::max(1.0, before.x.squaredNorm()) ||
             descend(cone, depth + 1, before, roots);
    }
    const auto own = common_roots(here, cone.noise);
    return own && std::ranges::all_of(*own, [&](const Eigen::VectorXd& root) {
             const Root longer = lengthened(cone, before, level, here, root);
             const double size = cone.N.middleCols(before.x.size(), root.size()).norm();
             const double error = longer.error.tail(root.size()).maxCoeff() * size;
             return error < cone.most_error * std::max(1.0, root.norm() * size) &&
                    descend(cone, depth + 1, longer, roots);
           });
  }

  /// A root of the earlier levels, extended by a root of one level's equations.
  [[nodiscard]] static Root lengthened(const Cone& cone, const Root& before, const Level& level,
                                       const QuadraticEquations& here,
                                       const Eigen::VectorXd& root) {
    const Eigen::Index known = before.x.size();
    const Eigen::Index count = known + root.size();
    Root result{Eigen::VectorXd(count), Eigen::VectorXd(count)};
    result.x << before.x, root;
    Eigen::VectorXd all = Eigen::VectorXd::Zero(cone.N.cols());
    all.head(count) = result.x;
    const Eigen::MatrixXd by_known =
        cone.equations.derivative(all)(level.equations, Eigen::seqN(0, known));
    const double reach = std::max(1.0, (cone.N * all).norm());
    const double open = cone.noise * reach * reach + (by_known.cwiseAbs() * before.error).norm();
    const Eigen::VectorXd slopes =
        Eigen::JacobiSVD<Eigen::MatrixXd>(here.derivative(root)).singularValues();
    const double slope = slopes(slopes.size() - 1);
    double bend = 0;
    for (const Eigen::MatrixXd& square : here.square) {
      bend = std::max(bend, square.cwiseAbs().maxCoeff());
    }
    // At a double root the slope is 2 sqrt(bend open) at most.
    const bool is_simple = slope > 2 * std::sqrt(bend * open);
    result.is_simple = before.is_simple && is_simple;
    const double error = is_simple ? open / slope : std::sqrt(open / bend);
    result.error << before.error, Eigen::VectorXd::Constant(root.size(), error);
    return result;
  }

  /// Adds the motions along the tangents at which W' f_2 vanishes.
  void add_motions_of_cone() {
    Cone cone{N_, W_, noise_, two_digits_lost};
    const auto tangents = roots_of(cone, [this](const Eigen::VectorXd& by) {
      Parts parts = start_;
      parts.col(1) += by;
      return F_.coefficient(2, parts);
    });
    if (tangents) {
      for (const Root& tangent : *tangents) {
        add_motions(cone, tangent);
      }
    }
  }

  /// Adds the motions with a tangent of the cone.
  void add_motions(const Cone& cone, const Root& tangent) {
    Parts parts = start_;
    parts.col(1) += cone.N * tangent.x;
    const Eigen::VectorXd second = shortest(F_.coefficient(2, parts));
    parts.col(2) = second;
    const Eigen::VectorXd f = F_.coefficient(3, parts);
    if (!f.allFinite()) {
      add(parts, second, false);
      return;
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd> M(cone.equations.derivative(tangent.x),
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Index unknowns = cone.N.cols();
    const double least = std::sqrt(cone.noise) * std::max(1.0, M.singularValues()(0));
    const auto is_firm = [least](double value) { return value > least; };
    const Eigen::Index rank =
        tangent.is_simple ? unknowns : std::ranges::count_if(M.singularValues(), is_firm);
    const Eigen::VectorXd open = cone.W.transpose() * f;
    const Eigen::VectorXd part =
        -M.matrixV().leftCols(rank) * (M.matrixU().leftCols(rank).transpose() * open)
                                          .cwiseQuotient(M.singularValues().head(rank));
    const Eigen::MatrixXd unreached = M.matrixU().rightCols(open.size() - rank);
    const bool goes_on = (unreached.transpose() * open).norm() <= agreement * (1 + f.norm());
    if (rank == unknowns) {
      if (goes_on) {
        add(parts, second + cone.N * part, true);
      }
      return;
    }
    if (!goes_on) {  // a cusp, where the second rates grow beyond all bounds
      add(parts, second, false);
      return;
    }
    // Where several tangents coincide, they are accurate to the square root of rounding only. This
    // bound is pessimistic for zero tangents, as those of links at rest.
    Cone next{cone.N * M.matrixV().rightCols(unknowns - rank), cone.W * unreached,
              std::max(std::sqrt(cone.noise), tangent.error.maxCoeff()),
              std::numeric_limits<double>::infinity()};
    const auto roots = roots_of(next, [&](const Eigen::VectorXd& by) {
      Parts moved = parts;
      moved.col(2) = second + cone.N * part + by;
      moved.col(3) = shortest(F_.coefficient(3, moved));
      return F_.coefficient(4, moved);
    });
    if (!roots) {
      add(parts, second, false);
      return;
    }
    for (const Root& root : *roots) {
      add(parts, second + cone.N * part + next.N * root.x, true);
    }
  }

  void add(Parts parts, const Eigen::VectorXd& second, bool is_known_twice) {
    parts.col(2) = second;
    for (const Eigen::Index order : {1, 2}) {
      const double rounding = F_.rounding() * std::max(1.0, parts.col(order).norm());
      parts.col(order) = (parts.col(order).array().abs() > rounding).select(parts.col(order), 0);
    }
    found_.push_back({std::move(parts), is_known_twice});
  }

  /// The factor by which several sums and products enlarge a rounding error.
  static constexpr double some = 16;
  /// The accepted contradiction between redundant constraints.
  static constexpr double agreement = support::agreement_of_second_rates<double>;

  const MovingConstraints& F_;
  GroupByGroup group_by_group_;
  Parts place_;  ///< at which J is singular
  Parts start_;  ///< with the shortest first rates
  Eigen::BDCSVD<Eigen::MatrixXd> svd_;
  Eigen::Index rank_ = 0;
  Eigen::MatrixXd N_, W_;
  double firmness_ = 1;  ///< the ratio of the least nonzero singular value or pivot to the largest
  double noise_ = 0;
  std::vector<Motion> found_;
};

}  // namespace

std::optional<std::vector<Motion>> motions_through(const MovingConstraints& F) {
  MotionSearch search(F);
  return search.is_known() ? std::optional(search.run()) : std::nullopt;
}

}  // namespace assur::mechanism::solve
