// Groups at known distances from a singular configuration.
#pragma once

#include <Eigen/LU>
#include <assur/kinematics.hpp>
#include <cmath>
#include <tuple>
#include <type_traits>

#include "least_change.hpp"
#include "runtime/exact.hpp"

namespace assur::test {

template <typename Model>
class NearSingularGroups {
  using Long = long double;

 public:
  explicit NearSingularGroups(unsigned seed) : random_(seed) {}

  template <typename Scalar>
  struct Group {
    typename Model::template Dimensions<Scalar> d;
    typename Model::template Inputs<Scalar> u;
    typename Model::template Configuration<Scalar> q;
  };

  /// A random group whose angles among the dimensions are shrunk, which makes slides parallel.
  Group<double> drawn(double shrink) {
    Group<double> group;
    group.d = random_.template variables<typename Model::template Dimensions<double>>();
    group.u = random_.template variables<typename Model::template Inputs<double>>();
    group.q = random_.template variables<typename Model::template Configuration<double>>();
    const auto turn_back = [shrink](auto& member) {
      if constexpr (std::is_same_v<std::decay_t<decltype(member)>, Direction<double>>) {
        member = direction_of(shrink * angle_of(member));
      }
    };
    std::apply([&](auto&... member) { (turn_back(member), ...); }, group.d.members());
    return group;
  }

  template <typename To, typename From>
  static To in_scalar(const From& from) {
    using Scalar =
        std::conditional_t<std::is_same_v<To, typename Model::template Configuration<double>>,
                           double, Long>;
    return converted<To>(from, [](const auto& source) {
      if constexpr (requires { source.cos; }) {
        return Direction<Scalar>{static_cast<Scalar>(source.cos), static_cast<Scalar>(source.sin)};
      } else {
        return static_cast<Scalar>(source);
      }
    });
  }

  /// The first group with its unknowns moved towards the second's and its inputs changed to close.
  Group<double> between(const Group<double>& from, const Group<double>& to, double part) {
    Group<double> group = from;
    Vector<double, Model::unknown_count> way;
    int index = 0;
    for_each_pair(from.q, to.q, [&](const auto& start, const auto& end) {
      if constexpr (requires { start.cos; }) {
        way(index++) = part * angle_of(turned(end, reversed(start)));
      } else {
        way(index++) = part * (end - start);
      }
    });
    advance(group.q, way);
    Vector<double, Model::equation_count> f;
    Matrix<double, Model::equation_count, Model::input_count> f_u;
    Model::residual(group.d, group.u, group.q, f);
    Model::input_jacobian(group.d, group.u, group.q, f_u);
    for (int input = 0; input < Model::input_count; ++input) {
      if (Model::inputs[static_cast<std::size_t>(input)].is_angle) {
        f_u.col(input).setZero();
      }
    }
    advance(group.u, Vector<double, Model::input_count>(least_change(f_u, -f)));
    return group;
  }

  /// The fraction of that path at which the determinant vanishes; almost 1 if its sign does not
  /// change.
  double singular_between(const Group<double>& from, const Group<double>& to) {
    const auto orientation = [&](double part) {
      const Group<double> group = between(from, to, part);
      Matrix<double, Model::equation_count, Model::unknown_count> jacobian;
      Model::jacobian(group.d, group.u, group.q, jacobian);
      return std::signbit(Eigen::MatrixXd(jacobian).partialPivLu().determinant());
    };
    double low = 0;
    double high = 1;
    const bool before = orientation(low);
    for (int step = 0; step < 60; ++step) {
      const double centre = (low + high) / 2;
      (orientation(centre) == before ? low : high) = centre;
    }
    return low;
  }

 private:
  RandomInputs random_;
};

}  // namespace assur::test
