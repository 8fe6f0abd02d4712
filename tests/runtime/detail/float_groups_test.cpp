// Law: what float says of a group is what double says of the same numbers, or that it cannot tell.
#include <assur/assembly.hpp>
#include <assur/kinematics.hpp>
#include <cmath>
#include <iostream>
#include <limits>
#include <type_traits>

#include "largest.hpp"
#include "runtime/compiled_models.hpp"
#include "runtime/drawn_groups.hpp"
#include "runtime/model_types.hpp"
#include "whole_campaign.hpp"

namespace assur::test::float_groups_test {
namespace {

constexpr unsigned seed = 1702;
/// `ctest -L long` draws the whole.
const int samples = is_whole_campaign() ? 10000 : 100;

/// What was seen of one model.
struct Seen {
  int groups = 0, configurations = 0, regular = 0;
  int unresolved = 0, undecided = 0, miscounted = 0;
  double pose = 0;        ///< largest error of a configuration, in eps/firmness
  double derivative = 0;  ///< largest error of derivatives where they are regular
  double constant = 0;    ///< and of all, in eps/margin
};

template <typename Model>
double distance(const typename Model::template Configuration<float>& q,
                const typename Model::template Configuration<double>& truth) {
  double farthest = 0;
  for_each_pair(q, truth, [&](const auto& one, const auto& other) {
    if constexpr (detail::is_direction<std::decay_t<decltype(one)>>) {
      farthest = std::max({farthest, std::abs(static_cast<double>(one.cos) - other.cos),
                           std::abs(static_cast<double>(one.sin) - other.sin)});
    } else {
      farthest = largest(
          farthest, std::abs(static_cast<double>(one) - other) / std::max(1.0, std::abs(other)));
    }
  });
  return farthest;
}

/// The largest difference of derivatives over the largest of them, among unknowns of one unit.
/// Where all of these vanish there is nothing to compare with but the others.
template <typename Model>
double difference(const Sensitivities<Model, float>& found,
                  const Sensitivities<Model, double>& truth) {
  double worst = 0;
  const auto compare = [&worst](const auto& rows, const auto& true_rows) {
    const double least = true_rows.size() > 0 ? 1e-3 * true_rows.cwiseAbs().maxCoeff() : 0;
    for (const bool angles : {false, true}) {
      double off = 0;
      double size = least;
      for (Eigen::Index row = 0; row < rows.rows(); ++row) {
        if (Model::unknowns[static_cast<std::size_t>(row)].is_angle == angles) {
          for (Eigen::Index column = 0; column < rows.cols(); ++column) {
            const double exact = true_rows(row, column);
            off = largest(off, std::abs(static_cast<double>(rows(row, column)) - exact));
            size = std::max(size, std::abs(exact));
          }
        }
      }
      worst = size > 0 ? largest(worst, off / size) : worst;
    }
  };
  compare(found.to_dimensions, truth.to_dimensions);
  compare(found.to_inputs, truth.to_inputs);
  return worst;
}

template <typename Model>
class Comparison {
  template <typename Scalar>
  using Dimensions = typename Model::template Dimensions<Scalar>;
  template <typename Scalar>
  using Inputs = typename Model::template Inputs<Scalar>;
  template <typename Scalar>
  using Configuration = typename Model::template Configuration<Scalar>;
  static constexpr double epsilon = std::numeric_limits<float>::epsilon();

 public:
  void look_at(const Dimensions<float>& d, const Inputs<float>& u) {
    ++seen_.groups;
    const auto found = assemblies<Model, float, Unresolved::refuse>(d, u);
    if (found.status == AssemblyStatus::unresolved) {
      ++seen_.unresolved;
      return;
    }
    const auto exact_d = detail::widened<Dimensions<double>>(d);
    const auto exact_u = detail::widened<Inputs<double>>(u);
    const auto truth = compiled::assemblies<Model>(exact_d, exact_u);
    if (found.status != truth.status || found.count != truth.count || truth.mobility > 0) {
      ++seen_.miscounted;
      return;
    }
    std::array<bool, Assemblies<Model>::capacity> taken{};
    for (std::size_t index = 0; index < static_cast<std::size_t>(found.count); ++index) {
      const auto& q = found.configurations[index];
      std::size_t nearest = taken.size();
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t other = 0; other < static_cast<std::size_t>(truth.count); ++other) {
        const double away = distance<Model>(q, truth.configurations[other]);
        if (!taken[other] && away < least) {
          least = away;
          nearest = other;
        }
      }
      if (nearest == taken.size()) {
        ++seen_.miscounted;
        return;
      }
      taken[nearest] = true;
      compare(d, u, q, exact_d, exact_u, truth.configurations[nearest], least,
              found.regularity[index] == Status::ok);
    }
  }

  [[nodiscard]] const Seen& seen() const { return seen_; }

 private:
  void compare(const Dimensions<float>& d, const Inputs<float>& u, const Configuration<float>& q,
               const Dimensions<double>& exact_d, const Inputs<double>& exact_u,
               const Configuration<double>& exact_q, double away, bool is_regular) {
    ++seen_.configurations;
    Sensitivities<Model, float> sensitive;
    Sensitivities<Model, double> truth;
    const auto standing = regularity<Model, float>(d, u, q);
    seen_.pose = largest(seen_.pose, away * static_cast<double>(standing.firmness) / epsilon);
    Model::sensitivities(d, u, q, sensitive.to_dimensions, sensitive.to_inputs);
    if (!is_solvable(sensitivities<Model, double>(exact_d, exact_u, exact_q, truth))) {
      return;
    }
    const double error = difference(sensitive, truth);
    seen_.constant =
        largest(seen_.constant, error * static_cast<double>(standing.margin) / epsilon);
    if (is_regular) {
      ++seen_.regular;
      seen_.derivative = largest(seen_.derivative, error);
    }
  }

  Seen seen_;
};

template <typename Model>
class FloatGroups : public testing::Test {};
TYPED_TEST_SUITE(FloatGroups, AllModels, ModelNames);

template <typename Model>
void compare_with_double(bool on_lattice) {
  if constexpr (Model::rigid) {
    DrawnGroups<float> draws(seed + static_cast<unsigned>(Model::number), on_lattice);
    Comparison<Model> comparison;
    for (int sample = 0; sample < samples; ++sample) {
      const auto d = draws.template variables<typename Model::template Dimensions<float>>();
      const auto u = draws.template variables<typename Model::template Inputs<float>>();
      comparison.look_at(d, u);
    }
    const Seen& seen = comparison.seen();
    std::cout << model_name<Model>() << (on_lattice ? " lattice" : " general") << ": groups "
              << seen.groups << ", unresolved " << seen.unresolved << ", configurations "
              << seen.configurations << ", regular " << seen.regular << ", poses " << seen.pose
              << " eps/firmness, derivatives " << seen.derivative << ", " << seen.constant
              << " eps/margin\n";
    EXPECT_EQ(seen.miscounted, 0);
    EXPECT_LT(seen.derivative, 5e-4);
    EXPECT_LT(seen.pose, 16);
  }
}

TYPED_TEST(FloatGroups, SayWhatDoubleSaysInGeneralPosition) {
  compare_with_double<TypeParam>(false);
}

TYPED_TEST(FloatGroups, SayWhatDoubleSaysOnALattice) { compare_with_double<TypeParam>(true); }

}  // namespace
}  // namespace assur::test::float_groups_test
