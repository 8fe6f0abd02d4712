// Includes every public header and every generated model, to be compiled as C++17 under the
// strictest warnings; headers_alone.cmake does the same with each header alone.
#include <array>
#include <assur/assur.hpp>
#include <assur/dyad/models.hpp>
#include <assur/numeric/bounded.hpp>
#include <assur/numeric/double_double.hpp>
#include <assur/numeric/entries.hpp>
#include <assur/numeric/order.hpp>
#include <assur/numeric/polynomial_bracket.hpp>
#include <assur/numeric/second_unknown.hpp>
#include <assur/numeric/trigonometric_charts.hpp>
#include <assur/numeric/trigonometric_roots.hpp>
#include <assur/support/configuration_order.hpp>
#include <assur/support/coordinate_motions.hpp>
#include <assur/support/displacement.hpp>
#include <assur/support/equations_of_motion.hpp>
#include <assur/support/equilibrium.hpp>
#include <assur/support/link_forces.hpp>
#include <assur/support/placed_group.hpp>
#include <assur/support/placed_link.hpp>
#include <assur/support/position_polynomial.hpp>
#include <assur/support/scale.hpp>
#include <assur/support/solved_by_lu.hpp>
#include <assur/tetrad/models.hpp>
#include <assur/triad/models.hpp>
#include <tuple>

static_assert(std::tuple_size_v<assur::dyad::Models> == 6);
static_assert(std::tuple_size_v<assur::triad::Models> == 20);
static_assert(std::tuple_size_v<assur::tetrad::Models> == 24);

namespace {

using Model = assur::tetrad::Model02;

/// One use of each function that a program calls, so that it is compiled here, for both scalars.
template <typename Scalar>
assur::Status use(const Model::Dimensions<Scalar>& d, const Model::Inputs<Scalar>& u) {
  const auto found = assur::assemblies<Model, Scalar>(d, u);
  Model::Configuration<Scalar> q = found.configurations[0];
  const assur::Vector<Scalar, Model::input_count> steady =
      assur::Vector<Scalar, Model::input_count>::Zero();
  const assur::Vector<Scalar, Model::dimension_count> held =
      assur::Vector<Scalar, Model::dimension_count>::Zero();
  const auto path = [&](Scalar) { return assur::InputMotion<Model, Scalar>{u, steady, steady}; };
  const auto start = assur::branch_point<Model, Scalar>(d, path(0), q);
  const auto way = assur::track<Model, Scalar>(d, path, 0, 1, start);
  assur::Sensitivities<Model, Scalar> sensitive;
  assur::Motion<Model, Scalar> moving;
  assur::Vector<Scalar, Model::unknown_count> third;
  assur::SecondDerivative<Model, Scalar> second;
  assur::FirstDerivative<Model, Scalar> first;
  const assur::SecondOrder<Model, Scalar> order(d, u, q);
  const std::array statuses = {
      way.status,
      assur::refine<Model, Scalar>(d, u, q),
      assur::regularity<Model, Scalar>(d, u, q).status,
      assur::sensitivities<Model, Scalar>(d, u, q, sensitive),
      assur::motion<Model, Scalar>(d, u, q, steady, steady, moving),
      assur::sensitivities_and_motion<Model, Scalar>(d, u, q, steady, steady, sensitive, moving),
      assur::jerk<Model, Scalar>(d, u, q, steady, steady, steady, moving, third),
      assur::singularity_along<Model, Scalar>(d, u, q, held, steady).status,
      assur::special_point_motion<Model, Scalar>(d, u, q, steady, steady, moving),
      order.first(held, steady, first),
      order.second(first, first, second)};
  assur::Status worst = assur::Status::ok;
  for (const assur::Status status : statuses) {
    worst = status == assur::Status::ok ? worst : status;
  }
  return worst;
}

[[maybe_unused]] const std::tuple uses(&use<double>, &use<float>);

}  // namespace
