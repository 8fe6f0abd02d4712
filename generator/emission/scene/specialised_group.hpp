// The view of a group's model with the numbers of one mechanism.
#pragma once

#include <Eigen/Core>
#include <assur/loops/elimination.hpp>
#include <assur/loops/start.hpp>
#include <assur/normal_form.hpp>
#include <optional>
#include <string>
#include <vector>

#include "emission/cpp/page.hpp"
#include "program/expression_graph.hpp"
#include "structure/kind.hpp"

namespace assur::generator::emission::scene {

/// The parts of a link's frame that a solver needs.
enum class FrameNeed : unsigned char {
  nothing,
  direction,  ///< only to distinguish configurations
  everything
};

/// The numbers of a group. Lengths and the gradients of lengths are in `unit`, a power of two.
struct SpecialisedNumbers {
  const structure::Model* model;
  double unit;
  double size;  ///< the longest of the group's own lengths, without the arms of links that hold it
  int order;    ///< highest order of the wanted time derivatives: 0, 1 or 2
  /// For each dimension of the model, whether drivers move it: then it is an input, after the
  /// model's own, and is not among the dimensions below.
  std::vector<bool> dimension_moves;
  /// A dimension that variable parameters change has no number: it is an input after all others.
  std::vector<std::optional<DimensionValue<double>>> dimensions;
  Eigen::MatrixXd dimension_gradient;  ///< one column per parameter whose sensitivity is wanted
  /// The inputs that are constant numbers: those held by the ground.
  std::vector<std::optional<DimensionValue<double>>> inputs;
  Eigen::MatrixXd input_gradient;  ///< of these inputs; zero for the others
  std::vector<bool> input_moves;   ///< for each input, whether it moves with time
  std::vector<FrameNeed> frames;   ///< of the links, in the group's order
  bool holds_groups;               ///< whether its links hold other groups
  bool forces;                     ///< whether the forces in its joints are wanted
  /// For a group of more than four links: the eliminations that yield all of its complex
  /// configurations, their number, and the angle along which each displacement runs.
  std::vector<loops::Elimination> eliminations;
  std::vector<loops::Start> starts;  ///< if there are no eliminations
  std::size_t complex_configurations;
  std::vector<int> slide_angles;
};

/// The view of templates/specialised_group.hpp.mustache.
struct SpecialisedGroup {
  cpp::View view;
  std::size_t max_configurations;
  /// The numbers of a point on a branch: inputs, unknowns, J^-1 and the sign of det J.
  std::size_t branch_numbers;
  int first_key;            ///< of the keys that order a group's configurations, the first that may
                            ///< differ
  bool shares_reciprocals;  ///< whether forces use reciprocals found with the rates
};

/// The group's links with frames, in the order of the solver: those needed in full come first.
[[nodiscard]] std::vector<std::size_t> framed_links(const std::vector<FrameNeed>& frames);

/// The functions of a rigid model that the runtime needs and the scene wants, with the dimensions
/// and the held inputs as numbers.
[[nodiscard]] SpecialisedGroup specialised_group(const SpecialisedNumbers& numbers,
                                                 const std::string& struct_name,
                                                 const std::string& title);

}  // namespace assur::generator::emission::scene
