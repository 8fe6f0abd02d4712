// Turns what was solved into configurations of links, slides and output points.
#pragma once

#include <assur/mechanism/frame.hpp>
#include <assur/mechanism/structure.hpp>
#include <assur/status.hpp>
#include <memory>
#include <string>
#include <vector>

namespace assur::mechanism {

struct PlanData;

enum class SolutionStatus : unsigned char {
  ok,
  no_assembly,  ///< the links cannot reach: there are no configurations
  degenerate    ///< a group moves freely or is inconsistent, as `reason` says
};

/// The displacement of a slide, from the first feature to the second, and how it moves.
struct SlideState {
  JointIndex joint;
  double displacement = 0;
  double velocity = 0;
  double acceleration = 0;
  Derivatives<1> follows;
};

/// One assembly configuration of the whole mechanism.
struct Configuration {
  Table<LinkIndex, Frame> links;  ///< of the mechanism's links, in the frame of the ground
  std::vector<SlideState> slides;
  Table<OutputIndex, Point> outputs;
  Status regularity = Status::ok;  ///< ok or near_singular
  double residual = 0;             ///< largest of the closures

  /// By name; throws MechanismError for a name that the mechanism does not have.
  [[nodiscard]] const Frame& link(const std::string& name) const;
  [[nodiscard]] const Point& output(const std::string& name) const;

  std::shared_ptr<const PlanData> plan;

 private:
  void expect_solved() const;
};

/// Every assembly configuration at one set of values.
struct Solution {
  SolutionStatus status = SolutionStatus::ok;
  int mobility = 0;    ///< of a degenerate group where it was found assembled
  std::string reason;  ///< why it is degenerate
  /// In an order that depends on the mechanism alone.
  std::vector<Configuration> configurations;
  int undecided = 0;  ///< places where no arithmetic here tells whether there are configurations
};

}  // namespace assur::mechanism
