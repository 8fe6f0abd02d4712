// Kernel functions of a degenerate model, by the closures that its slides leave.
#pragma once

#include <algorithm>
#include <assur/support/flat_variables.hpp>
#include <assur/support/scale.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <limits>

#include "models/model_kernel.hpp"
#include "models/tied_closures.hpp"

namespace assur::mechanism::models {

/// The functions of a degenerate model on flat variables. No such group has an isolated
/// configuration: it moves, or it cannot be assembled.
template <typename Model>
class DegenerateFunctions final : public ModelKernel {
  using Dimensions = typename Model::template Dimensions<double>;
  using Inputs = typename Model::template Inputs<double>;
  using Configuration = typename Model::template Configuration<double>;
  using Residual = Vector<double, Model::equation_count>;
  using Jacobian = Matrix<double, Model::equation_count, Model::unknown_count>;
  static_assert(Model::equation_count % 2 == 0 && Model::unknown_count <= most_rows);

 public:
  void assemble(const FlatVariables& flat_d, const FlatVariables& flat_u,
                const support::Displacement& displaced, GroupAssemblies& result) const override {
    const auto d = support::unflattened<Dimensions>(flat_d);
    const auto u = support::unflattened<Inputs>(flat_u);
    result.count = 0;
    result.mobility = 0;
    result.is_compatible = true;
    result.status = is_finite(d) && is_finite(u) ? AssemblyStatus::ok : AssemblyStatus::not_finite;
    if (result.status != AssemblyStatus::ok) {
      return;
    }
    const double misfit = misfit_of_angles(d, u);
    result.is_compatible = misfit < tolerance_of_angles(displaced);
    if (result.is_compatible) {
      result.mobility = verdict_on(tied_closures(d, u, displaced, misfit)).mobility;
      result.status = result.mobility > 0 ? AssemblyStatus::degenerate : AssemblyStatus::ok;
    }
  }

  /// Computes the gap of the closures or, if the angles are incompatible, the distance by which
  /// they move a point of the group.
  Status gap(const FlatVariables& flat_d, const FlatVariables& flat_u,
             double& result) const override {
    const auto d = support::unflattened<Dimensions>(flat_d);
    const auto u = support::unflattened<Inputs>(flat_u);
    if (!is_finite(d) || !is_finite(u)) {
      return Status::not_finite;
    }
    const double misfit = misfit_of_angles(d, u);
    const double miss = misfit < tolerance_of_angles({})
                            ? verdict_on(tied_closures(d, u, {}, misfit)).miss
                            : misfit;
    result = miss / support::unit_scale<Model>(d, u);
    return std::isfinite(result) ? Status::ok : Status::not_finite;
  }

 private:
  /// Directions result from the scene's expressions, with a few roundings each; those of links that
  /// are placed before may have lost more digits. Even the largest tolerance is smaller than any
  /// intended contradiction of a scene.
  [[nodiscard]] static double tolerance_of_angles(const support::Displacement& displaced) {
    constexpr double least = 1e-12;
    constexpr double most = 1e-9;
    return std::isfinite(displaced.turned) ? std::clamp(4 * displaced.turned, least, most) : least;
  }

  /// The chord length of the largest contradiction between angles that prismatic joints fix.
  [[nodiscard]] static double misfit_of_angles(const Dimensions& d, const Inputs& u) {
    double largest = 0;
    if constexpr (Model::compatibility_count > 0) {
      Matrix<double, Model::compatibility_count, 2> c;
      Model::compatibility(d, u, c);
      for (int sum = 0; sum < Model::compatibility_count; ++sum) {
        const double own = c(sum, 0) > 0 ? std::abs(c(sum, 1)) : 2.0;
        largest = std::max(largest, own);
      }
    }
    return largest;
  }

  [[nodiscard]] static TiedClosures tied_closures(const Dimensions& dimensions,
                                                  const Inputs& inputs,
                                                  const support::Displacement& given,
                                                  double misfit) {
    const support::Displacement displaced = given.bounded();
    const double scale = support::unit_scale<Model>(dimensions, inputs, displaced);
    const auto d = support::scaled_to<Dimensions>(dimensions, scale);
    const auto u = support::scaled_to<Inputs>(inputs, scale);
    TiedClosures result;
    result.turns = has_angle;
    fill_closures(d, u, result);
    result.farthest = longest_length(u);
    // Beyond this, rounding is disregarded in rigid groups, too.
    const double longest = std::max(1.0, displaced.reach * scale);
    result.displaced = support::counted_displacement(displaced.moved * scale, longest);
    result.turned = support::counted_displacement(displaced.turned, 1.0) + misfit;
    return result;
  }

  /// Sets the closures from their values at three directions, since they are linear in the
  /// direction and the displacements.
  static void fill_closures(const Dimensions& d, const Inputs& u, TiedClosures& result) {
    const bool turns_all = slides_turn(d, u);
    const auto at = [&](double cos, double sin) {
      const Residual f = closures(d, u, standing_at(cos, sin));
      return turns_all ? turned_back(f, {cos, sin}) : f;
    };
    const Residual front = at(1, 0);
    const Residual back = at(-1, 0);
    result.fixed = (front + back) / 2;
    result.turning.setZero(Model::equation_count, 2);
    if (has_angle) {
      result.turning.col(0) = (front - back) / 2;
      result.turning.col(1) = at(0, 1) - (front + back) / 2;
    }
    fill_slides(d, u, standing_at(1, 0), result.slides);
  }

  [[nodiscard]] static Residual closures(const Dimensions& d, const Inputs& u,
                                         const Configuration& q) {
    Residual f;
    Model::residual(d, u, q, f);
    return f;
  }

  /// Each loop's vector in the frame of a link in this direction.
  [[nodiscard]] static Residual turned_back(const Residual& f, const Direction<double>& link) {
    Residual result;
    for (int row = 0; row < Model::equation_count; row += 2) {
      result(row) = link.cos * f(row) + link.sin * f(row + 1);
      result(row + 1) = link.cos * f(row + 1) - link.sin * f(row);
    }
    return result;
  }

  /// Whether slides turn with the angle; then all do, since they fix each link's angle relative to
  /// it.
  [[nodiscard]] static bool slides_turn(const Dimensions& d, const Inputs& u) {
    SmallMatrix before;
    SmallMatrix after;
    fill_slides(d, u, standing_at(1, 0), before);
    fill_slides(d, u, standing_at(0, 1), after);
    return (before - after).cwiseAbs().maxCoeff() > 0.5;
  }

  static void fill_slides(const Dimensions& d, const Inputs& u, const Configuration& q,
                          SmallMatrix& slides) {
    Jacobian j;
    Model::jacobian(d, u, q, j);
    slides.resize(Model::equation_count, Model::unknown_count - (has_angle ? 1 : 0));
    Eigen::Index column = 0;
    for (int unknown = 0; unknown < Model::unknown_count; ++unknown) {
      if (!Model::unknowns[static_cast<std::size_t>(unknown)].is_angle) {
        slides.col(column++) = j.col(unknown);
      }
    }
  }

  /// The configuration with zero displacements and this direction of the angle.
  [[nodiscard]] static Configuration standing_at(double cos, double sin) {
    FlatVariables flat{};
    std::size_t place = 0;
    for (const ModelUnknown& unknown : Model::unknowns) {
      if (unknown.is_angle) {
        flat[place++] = cos;
        flat[place] = sin;
      }
      ++place;
    }
    return support::unflattened<Configuration>(flat);
  }

  static constexpr int angle_count = [] {
    int count = 0;
    for (const ModelUnknown& unknown : Model::unknowns) {
      count += unknown.is_angle ? 1 : 0;
    }
    return count;
  }();
  static_assert(angle_count <= 1, "slides fix the angles of all links but one");
  static constexpr bool has_angle = angle_count == 1;
};

}  // namespace assur::mechanism::models
