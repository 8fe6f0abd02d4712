// Campaigns: tables of results for a large number of parameter values, computed in parts.
#pragma once

#include <assur/mechanism/campaign_columns.hpp>
#include <assur/mechanism/force_columns.hpp>
#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/point_values.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace assur::mechanism {

/// Items numbered from 0, each with rows that depend only on its number.
struct Campaign {
  /// Appends the rows of an item to a vector, one row after another. NaN stands for a number that
  /// does not exist. The first number of a row is the item's number.
  using Worker = std::function<void(std::uint64_t, std::vector<double>&)>;

  std::vector<Column> columns;
  std::uint64_t items;
  std::function<Worker()> worker;  ///< returns a worker with its own memory, for one thread
};

/// The items from `first` up to but not including `last`.
struct ItemRange {
  std::uint64_t first, last;
};
/// Part `number` (from 1) of `parts` parts, which together contain each item exactly once.
[[nodiscard]] ItemRange part_of(std::uint64_t items, std::uint64_t number, std::uint64_t parts);

/// The rows of consecutive items.
struct RowBlock {
  ItemRange items;
  std::vector<double> rows;
  std::string text;  ///< the result of `encode` for the rows
};

/// Computes items on some threads and passes their rows to `use`, block by block in the order of
/// the items, on the thread of the caller. `encode`, if given, converts rows to text on the
/// computing threads. An exception of a worker, `encode` or `use` ends the run and is thrown here.
void run_campaign(const Campaign& campaign, ItemRange items, int threads,
                  const std::function<std::string(const std::vector<double>&)>& encode,
                  const std::function<void(const RowBlock&)>& use);

/// A parameter that deviates, and its largest deviation; for a covariance law, its standard
/// deviation.
struct Deviation {
  ParameterIndex parameter;
  double half_width;
};

/// The distribution of the parameters' deviations in a sample.
struct DeviationLaw {
  enum class Kind : unsigned char {
    uniform,     ///< within the half-widths t of their tolerances, each independently
    normal,      ///< with the standard deviations t/3, each independently
    covariance,  ///< normal, with the request's covariance
    given        ///< explicit deviations
  };

  Kind kind = Kind::uniform;
  std::vector<ParameterIndex> parameters;  ///< of given deviations
  std::vector<double> given;               ///< of these parameters, sample by sample
};

/// An output at the nominal values, and its deviations as predicted by the derivatives there.
/// Parameters have the covariance of their law: uniform ones the variances t^2/3.
struct NominalPoint {
  std::string name;
  Eigen::Vector2d position;
  /// Absent if the derivatives are unknown there.
  std::optional<Eigen::Vector2d> worst_case, rss;
  /// Absent in that case, too, and if there are too many parameters for second derivatives.
  std::optional<PointSpread> spread;
};

/// A number of the requested forces at the nominal values, with the deviations that the derivatives
/// there predict; NaN where one is unknown.
struct NominalForce {
  ForceColumn column;
  double number, worst_case, rss;
};

/// Outputs, and forces if they are requested, under random deviations, by default within the
/// tolerances. Sample k takes its deviations from a generator that is a function of the seed, k and
/// the parameter's place. Each parameter is the value of its formula for the deviating other
/// parameters, plus a deviation of its own. The sample takes the configuration nearest to the
/// nominal one, by the angles of the links that no driver places.
class Sampling {
 public:
  /// `branch`: the number of the nominal configuration, from 1 as `Plan::solve` counts; for zero,
  /// the one nearest to the request's reference, or without a reference the first. Throws
  /// MechanismError if nothing deviates, if there is no output, or if there is no such
  /// configuration.
  Sampling(const Mechanism& mechanism, const Request& request, std::size_t branch,
           std::uint64_t seed, std::uint64_t count, DeviationLaw law = {});

  /// The columns `sample`, `outcome`, the coordinates of the outputs, `P.x`, and the numbers of the
  /// requested forces, `A.effort`.
  [[nodiscard]] Campaign campaign() const;
  [[nodiscard]] const std::vector<NominalPoint>& nominal() const { return nominal_; }
  /// In the order of the campaign's columns.
  [[nodiscard]] const std::vector<NominalForce>& nominal_forces() const { return forces_; }
  [[nodiscard]] const std::vector<Deviation>& deviations() const { return deviations_; }
  /// The values of the deviating parameters in a sample, in the order of `deviations()`.
  [[nodiscard]] std::vector<double> parameters_of(std::uint64_t sample) const;
  /// The solver's reason why a sample has no configuration.
  [[nodiscard]] std::string reason_of(std::uint64_t sample) const;

 private:
  class Worker;

  std::vector<Deviation> deviations_;
  [[nodiscard]] double deviation(std::uint64_t sample, std::size_t place) const;

  DeviationLaw law_;
  /// For a covariance law: factors that combine independent normal numbers to deviations.
  Eigen::MatrixXd factors_;
  /// The deviating parameters, and those that depend on them, with the half-width zero. Each stands
  /// after the parameters that its formula reads.
  std::vector<Deviation> changing_;
  std::vector<NominalPoint> nominal_;
  std::vector<NominalForce> forces_;
  /// For positions, and for forces if they are requested, with the nominal configuration as
  /// reference.
  std::optional<Plan> plan_;
  std::uint64_t seed_, count_;
};

/// Equally spaced values of one parameter, both ends included.
struct GridAxis {
  ParameterIndex parameter;
  double from, to;
  std::uint64_t count;
};

/// The largest number of cells of a grid.
inline constexpr std::uint64_t most_cells = 100'000'000;

/// All configurations over a grid of parameters, whose values replace their formulas. The last axis
/// varies fastest. A row for each configuration, with columns `cell`, the parameters,
/// `configurations` and `families` (their numbers in the cell), `configuration` (its number, or
/// zero in the one row of a cell without any), `outcome`, and the coordinates of the outputs.
/// Throws MechanismError for a grid of too many cells, for a parameter on two axes, and for a
/// mechanism or request that `Plan` refuses.
[[nodiscard]] Campaign grid_campaign(const Mechanism& mechanism, const Request& request,
                                     const std::vector<GridAxis>& axes);

/// The value at a place of an axis.
[[nodiscard]] double value_at(const GridAxis& axis, std::uint64_t place);

}  // namespace assur::mechanism
