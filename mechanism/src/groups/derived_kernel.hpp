// Kernel of a model that is derived from the graph of its group.
#pragma once

#include <assur/mechanism/group_model.hpp>
#include <vector>

#include "groups/elimination.hpp"
#include "groups/loops.hpp"
#include "groups/starts.hpp"
#include "models/model_kernel.hpp"

namespace assur::mechanism::groups {

using ComplexConfiguration = loops::ComplexConfiguration<loops::AnySizes>;

/// The unknowns, inputs and dimensions of the largest group together.
inline constexpr int most_variables = 72;

/// The closures of a group of any size, by its loops, and their derivatives. The unknowns q are the
/// angles of the links in `Loops::free_turned` and then the displacements; the dimensions d are
/// those of `LinkForm`, link by link; the inputs u are the points, or lines, of the base at the
/// external joints.
class DerivedKernel final : public ModelKernel {
 public:
  /// `link_joints`: of each link, in the order in which the dimensions list them.
  DerivedKernel(Loops loops, std::vector<std::vector<int>> link_joints);

  /// The number of complex configurations in general position; zero if there is none, or if no
  /// method finds all.
  [[nodiscard]] int complex_count() const { return complex_count_; }
  [[nodiscard]] const Eliminations& eliminations() const { return eliminations_; }
  [[nodiscard]] const Starts& starts() const { return starts_; }
  [[nodiscard]] const Loops& loops() const { return loops_; }
  [[nodiscard]] const std::vector<bool>& dimension_is_angle() const { return dimension_is_angle_; }
  [[nodiscard]] const std::vector<bool>& input_is_angle() const { return input_is_angle_; }

  /// Encloses all configurations, and returns the ball of the one with these directions of the
  /// links.
  [[nodiscard]] GroupProof proof(const std::vector<JointFeatures<double>>& features,
                                 const std::vector<Direction<double>>& directions) const;

  void assemble(const models::FlatVariables& d, const models::FlatVariables& u,
                const support::Displacement& displaced,
                models::GroupAssemblies& found) const override;
  Status gap(const models::FlatVariables& d, const models::FlatVariables& u,
             double& result) const override;
  void stand(const models::FlatVariables& d, const models::FlatVariables& u,
             const models::FlatVariables& q, models::GroupPoses& poses) const override;
  void move(const models::FlatVariables& d, const models::FlatVariables& u,
            const models::FlatVariables& q, const models::MotionQuery& query,
            models::GroupMotion& motion) const override;
  void bend(const models::FlatVariables& d, const models::FlatVariables& u,
            const models::FlatVariables& q, const models::SmallVector& q_x,
            const models::SmallVector& d_x, const models::SmallVector& u_x,
            models::Curvature& along_x) const override;
  void expand(const models::FlatSeries& d, const models::FlatSeries& u, const models::FlatSeries& q,
              models::MovingGroup& moving) const override;

 private:
  /// Calls `search(ways)` with the eliminations, or with the starts if there are none.
  template <typename Search>
  auto by_every_way(const Search& search) const {
    return eliminations_.list().empty() ? search(starts_.list()) : search(eliminations_.list());
  }
  [[nodiscard]] bool slides(int joint) const;
  /// The joint at which the frame of a link with these joints has its origin (`LinkForm`).
  [[nodiscard]] int origin_of(const std::vector<int>& joints) const;
  template <typename Scalar>
  [[nodiscard]] std::vector<JointFeatures<Scalar>> features(const models::Flat<Scalar>& d,
                                                            const models::Flat<Scalar>& u) const;
  template <typename Scalar>
  [[nodiscard]] PlacedLinks<Scalar> placed(const models::Flat<Scalar>& d,
                                           const models::Flat<Scalar>& u,
                                           const models::Flat<Scalar>& q) const;
  [[nodiscard]] static models::FlatVariables flat(const ComplexConfiguration& at);
  /// The longest length of the group; the external joints' places count by their differences only.
  [[nodiscard]] double size_of(const models::FlatVariables& d,
                               const models::FlatVariables& u) const;
  /// How firmly the closures determine the unknowns, by the test of emitted solvers
  /// (support/loop_group.hpp).
  [[nodiscard]] Regularity<double> regularity(const Eigen::MatrixXd& j, double size,
                                              double unsure) const;
  /// The error bound of the loop Jacobian, as in `support::unsure_jacobian`.
  [[nodiscard]] double unsure_jacobian(const models::FlatVariables& d,
                                       const models::FlatVariables& u,
                                       const support::Displacement& displaced) const;

  Loops loops_;
  std::vector<std::vector<int>> link_joints_;
  std::vector<bool> unknown_is_angle_, dimension_is_angle_, input_is_angle_;
  Eliminations eliminations_;
  Starts starts_;  ///< if there is no elimination
  int complex_count_ = 0;
};

}  // namespace assur::mechanism::groups
