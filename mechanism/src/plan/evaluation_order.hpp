// Turns a mechanism's formulas into the order in which they are evaluated, and each parameter into
// what depends on it.
#pragma once

#include <assur/mechanism/request.hpp>
#include <assur/mechanism/structure.hpp>
#include <cstddef>
#include <vector>

namespace assur::mechanism {

struct PlanData;

/// What must be evaluated again when some parameters change, each list in the order of evaluation.
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

/// The order of evaluation. Formulas hold indices, so that nothing is looked up by name any more.
struct EvaluationOrder {
  std::vector<ParameterIndex> parameters;  ///< each behind those in its formula
  std::vector<NumberIndex> numbers;        ///< all others that solving reads, except laws
  std::vector<DriverIndex> drivers;        ///< each behind those that its law reads
  Table<DriverIndex, bool> reads_links;    ///< whether a law reads where links are
  Table<ParameterIndex, bool> moves;       ///< whether a parameter has rates in time
  std::vector<FeatureIndex> features;      ///< of joints and outputs
  std::vector<ParameterIndex> columns;  ///< parameters with respect to which derivatives are taken
  Table<ParameterIndex, std::ptrdiff_t> column_of;  ///< of each parameter; -1 where it has none
  bool second_order = false;
};

/// What depends on some parameters. It is found when it is first asked for, because in a long chain
/// of parameters the lists of all parameters together would grow as the square of the chain.
[[nodiscard]] Dependents dependents_of(const std::vector<ParameterIndex>& changed,
                                       const PlanData& plan);

/// The groups with links that a driver, or a group before them, moves against one another.
[[nodiscard]] std::vector<GroupIndex> groups_carried_by(DriverIndex driver, const PlanData& plan);
[[nodiscard]] std::vector<GroupIndex> groups_carried_by(GroupIndex group, const PlanData& plan);

/// Throws MechanismError where a parameter depends on itself or has no value.
/// `more`: features that are evaluated beside those of joints and outputs.
[[nodiscard]] EvaluationOrder evaluation_order(const Mechanism& mechanism, const Request& request,
                                               const std::vector<FeatureIndex>& more = {});

}  // namespace assur::mechanism::plan
