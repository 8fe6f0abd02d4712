// Turns very many values of a mechanism's parameters into table rows, however split into parts.
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

/// Items that are numbered from 0, each with rows that depend only on its number.
struct Campaign {
  /// Appends the rows of an item to a vector, one row after another. NaN stands for a number that
  /// does not exist. The first number of a row is that of the item.
  using Worker = std::function<void(std::uint64_t, std::vector<double>&)>;

  std::vector<Column> columns;
  std::uint64_t items;
  std::function<Worker()> worker;  ///< makes a worker with memory of its own, for one thread
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
  std::string text;  ///< what `encode` made of the rows
};

/// Computes items on some threads and hands over their rows, block by block in the order of the
/// items, on the thread of the caller. `encode`, where it is given, turns rows into text beside the
/// computing. What a worker, `encode` or `use` throws ends the run and is thrown here.
void run_campaign(const Campaign& campaign, ItemRange items, int threads,
                  const std::function<std::string(const std::vector<double>&)>& encode,
                  const std::function<void(const RowBlock&)>& use);

/// A parameter that deviates, and its largest deviation. Where the law is a covariance, that is its
/// standard deviation.
struct Deviation {
  ParameterIndex parameter;
  double half_width;
};

/// How the parameters of a sample deviate.
struct DeviationLaw {
  enum class Kind : unsigned char {
    uniform,     ///< within the half-widths t of their tolerances, each independently
    normal,      ///< with the standard deviations t/3, each independently
    covariance,  ///< normal, with the request's covariance
    given        ///< by the deviations that are given
  };

  Kind kind = Kind::uniform;
  std::vector<ParameterIndex> parameters;  ///< of given deviations
  std::vector<double> given;               ///< of these parameters, for one sample after the other
};

/// An output at the nominal values, and its deviations as the derivatives there predict them.
/// Parameters have the covariance of their law: uniform ones the variances t^2/3.
struct NominalPoint {
  std::string name;
  Eigen::Vector2d position;
  /// Absent where the derivatives are not known there.
  std::optional<Eigen::Vector2d> worst_case, rss;
  /// Absent in that case, too, and where there are too many parameters for second derivatives.
  std::optional<PointSpread> spread;
};

/// A number of the wanted forces at the nominal values, with the deviations that derivatives there
/// predict; NaN where one is not known.
struct NominalForce {
  ForceColumn column;
  double number, worst_case, rss;
};

/// Outputs, and forces where they are wanted, under random deviations, by default within the
/// tolerances. Sample k takes its deviations from a generator that is a function of the seed, k and
/// the parameter's place. Each parameter is the value of its formula for the deviating other
/// parameters, plus a deviation of its own. The sample takes the configuration that is nearest to
/// the nominal one, by the angles of the links that no driver places.
class Sampling {
 public:
  /// `branch`: the number of the nominal configuration, from 1 as `Plan::solve` counts; zero for
  /// the one nearest to the request's reference, or without a reference the first. Throws
  /// MechanismError where nothing deviates, nothing is an output, or there is no such
  /// configuration.
  Sampling(const Mechanism& mechanism, const Request& request, std::size_t branch,
           std::uint64_t seed, std::uint64_t count, DeviationLaw law = {});

  /// The columns `sample`, `outcome`, the coordinates of the outputs, `P.x`, and the numbers of the
  /// wanted forces, `A.effort`.
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
  /// Of the deviations of a covariance: their factors of independent normal numbers.
  Eigen::MatrixXd factors_;
  /// The deviating parameters, and those that depend on them, with the half-width zero. Each stands
  /// after the parameters that its formula reads.
  std::vector<Deviation> changing_;
  std::vector<NominalPoint> nominal_;
  std::vector<NominalForce> forces_;
  /// Of positions, and of forces where they are wanted, with the nominal configuration as
  /// reference.
  std::optional<Plan> plan_;
  std::uint64_t seed_, count_;
};

/// Equally spaced values of one parameter, both ends among them.
struct GridAxis {
  ParameterIndex parameter;
  double from, to;
  std::uint64_t count;
};

/// The largest number of cells of a grid.
inline constexpr std::uint64_t most_cells = 100'000'000;

/// All configurations over a grid of parameters, whose values take the place of their formulas. The
/// last axis runs fastest. A row for each configuration, with columns `cell`, the parameters,
/// `configurations` and `families` (how many there are in the cell), `configuration` (its number,
/// or zero in the one row of a cell that has none), `outcome`, and the coordinates of the outputs.
/// Throws MechanismError for a grid of too many cells, for a parameter on two axes, and for what
/// `Plan` refuses.
[[nodiscard]] Campaign grid_campaign(const Mechanism& mechanism, const Request& request,
                                     const std::vector<GridAxis>& axes);

/// The value at a place of an axis.
[[nodiscard]] double value_at(const GridAxis& axis, std::uint64_t place);

}  // namespace assur::mechanism
