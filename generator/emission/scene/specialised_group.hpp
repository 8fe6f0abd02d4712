// Turns a model and the numbers of one mechanism's group into the view of a specialised model.
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

/// What a solver needs of a link's frame.
enum class FrameNeed : unsigned char {
  nothing,
  direction,  ///< only to tell configurations apart
  everything
};

/// The numbers of a group. Lengths and the gradients of lengths are in `unit`, a power of two.
struct SpecialisedNumbers {
  const structure::Model* model;
  double unit;
  double size;  ///< the longest of the group's own lengths, without the arms of links that hold it
  int order;    ///< of the time derivatives that are wanted: 0, 1 or 2
  /// For each dimension of the model, whether drivers move it: then it is an input, after the
  /// model's own, and is not among the dimensions below.
  std::vector<bool> dimension_moves;
  /// A dimension that variable parameters change has no number: it is an input after all others.
  std::vector<std::optional<DimensionValue<double>>> dimensions;
  Eigen::MatrixXd dimension_gradient;  ///< one column per parameter whose sensitivity is wanted
  /// The inputs that are numbers: the ground holds them, and nothing changes them.
  std::vector<std::optional<DimensionValue<double>>> inputs;
  Eigen::MatrixXd input_gradient;  ///< of these inputs; zero for the others
  std::vector<bool> input_moves;   ///< for each input, whether it moves with time
  std::vector<FrameNeed> frames;   ///< of the links, in the group's order
  bool holds_groups;               ///< whether other groups are held by its links
  bool forces;                     ///< whether the forces in its joints are wanted
  /// Of a group of more than four links: the ways to all of its complex configurations, their
  /// number, and the angle along which each displacement runs.
  std::vector<loops::Elimination> eliminations;
  std::vector<loops::Start> starts;  ///< where there are none
  std::size_t complex_configurations;
  std::vector<int> slide_angles;
};

/// The view that templates/specialised_group.hpp.mustache shows.
struct SpecialisedGroup {
  cpp::View view;
  std::size_t max_configurations;
  /// The numbers of a place on a branch: inputs, unknowns, J^-1 and the sign of det J.
  std::size_t branch_numbers;
  int first_key;            ///< of the keys that order a group's configurations, the first that may
                            ///< differ
  bool shares_reciprocals;  ///< whether forces take reciprocals that are found with the rates
};

/// The group's links with frames, in the order of the solver: those of which everything is needed
/// come first.
[[nodiscard]] std::vector<std::size_t> framed_links(const std::vector<FrameNeed>& frames);

/// The functions of a rigid model that the runtime needs and the scene wants, with the dimensions
/// and the held inputs as numbers.
[[nodiscard]] SpecialisedGroup specialised_group(const SpecialisedNumbers& numbers,
                                                 const std::string& struct_name,
                                                 const std::string& title);

}  // namespace assur::generator::emission::scene
