// Order in which a mechanism's formulas are evaluated, and the dependents of each parameter.
#pragma once

#include <assur/mechanism/request.hpp>
#include <assur/mechanism/structure.hpp>
#include <cstddef>
#include <vector>

namespace assur::mechanism {

struct PlanData;

/// The parts to evaluate again when some parameters change, each list in the order of evaluation.
struct Dependents {
  std::vector<ParameterIndex> parameters;  ///< these, and others through their formulas
  std::vector<NumberIndex>
      numbers;  ///< other than the values of parameters and the laws of drivers
  std::vector<DriverIndex> drivers;
  std::vector<FeatureIndex> features;
  std::vector<GroupIndex> groups;
  bool spread = false;  ///< whether a tolerance or the covariance is among them
};

}  // namespace assur::mechanism

namespace assur::mechanism::plan {

/// The order of evaluation, by indices without any look-up of names.
struct EvaluationOrder {
  std::vector<ParameterIndex> parameters;  ///< each after those in its formula
  std::vector<NumberIndex> numbers;        ///< all others needed for solving, except laws
  std::vector<DriverIndex> drivers;        ///< each after those that its law reads
  Table<DriverIndex, bool> reads_links;    ///< whether a law reads links' poses
  Table<ParameterIndex, bool> moves;       ///< whether a parameter has rates in time
  std::vector<FeatureIndex> features;      ///< of joints and outputs
  std::vector<ParameterIndex> columns;  ///< parameters with respect to which derivatives are taken
  Table<ParameterIndex, std::ptrdiff_t> column_of;  ///< of each parameter; -1 without a column
  bool second_order = false;
};

/// The dependents of some parameters, found on request, because in a long chain of parameters the
/// lists of all parameters together would grow as the square of the chain.
[[nodiscard]] Dependents dependents_of(const std::vector<ParameterIndex>& changed,
                                       const PlanData& plan);

/// The groups with links that a driver, or an earlier group, moves relative to one another.
[[nodiscard]] std::vector<GroupIndex> groups_carried_by(DriverIndex driver, const PlanData& plan);
[[nodiscard]] std::vector<GroupIndex> groups_carried_by(GroupIndex group, const PlanData& plan);

/// Throws MechanismError if a parameter depends on itself or has no value.
/// `more`: features to evaluate beside those of joints and outputs.
[[nodiscard]] EvaluationOrder evaluation_order(const Mechanism& mechanism, const Request& request,
                                               const std::vector<FeatureIndex>& more = {});

}  // namespace assur::mechanism::plan
