// Law: a batch of configurations has the derivatives and statuses of single calls.
#include <assur/batch_kinematics.hpp>
#include <assur/dyad/models.hpp>
#include <assur/tetrad/model_01.hpp>
#include <assur/tetrad/model_05.hpp>
#include <assur/tetrad/model_15.hpp>
#include <assur/triad/model_01.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "largest.hpp"
#include "runtime/drawn_groups.hpp"
#include "runtime/model_types.hpp"

namespace assur::test::batch_kinematics_test {
namespace {

constexpr unsigned seed = 4417;

/// Configurations with the rates of their inputs, and room for what follows from them.
template <typename Model>
struct Given {
  using Dimensions = typename Model::template Dimensions<double>;
  using Inputs = typename Model::template Inputs<double>;
  using Configuration = typename Model::template Configuration<double>;
  static constexpr auto unknowns = static_cast<std::size_t>(Model::unknown_count);
  static constexpr auto all_inputs = static_cast<std::size_t>(Model::input_count);
  static constexpr auto all_dimensions = static_cast<std::size_t>(Model::dimension_count);

  std::size_t count, stride;
  std::vector<double> dimensions, inputs, configurations, first_rates, second_rates;
  std::vector<Status> status;
  std::vector<double> to_dimensions, to_inputs, velocity, acceleration;

  /// If `with_gaps`, one configuration in ten has a number that is not finite.
  Given(std::size_t number, bool on_lattice, bool with_gaps)
      : count(number),
        stride(number + 3),
        dimensions(Columns<Dimensions>::count * stride),
        inputs(Columns<Inputs>::count * stride),
        configurations(Columns<Configuration>::count * stride),
        first_rates(all_inputs * stride),
        second_rates(all_inputs * stride),
        status(stride, Status::no_convergence),
        to_dimensions(unknowns * all_dimensions * stride),
        to_inputs(unknowns * all_inputs * stride),
        velocity(unknowns * stride),
        acceleration(unknowns * stride) {
    DrawnGroups<double> draws(seed, on_lattice);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> rate(-2, 2);
    for (std::size_t index = 0; index < count; ++index) {
      put_group({dimensions.data(), stride}, index, draws.template variables<Dimensions>());
      put_group({inputs.data(), stride}, index, draws.template variables<Inputs>());
      put_group({configurations.data(), stride}, index, draws.template variables<Configuration>());
      for (std::size_t input = 0; input < all_inputs; ++input) {
        first_rates[input * stride + index] = rate(random);
        second_rates[input * stride + index] = rate(random);
      }
    }
    if (with_gaps) {
      const std::vector<std::vector<double>*> lists = {&dimensions, &inputs, &configurations,
                                                       &first_rates, &second_rates};
      for (std::size_t index = 0; index < count; index += 10) {
        std::vector<double>& list = *lists[index / 10 % lists.size()];
        const std::size_t row = index / 50 % (list.size() / stride);
        list[row * stride + index] = index % 20 == 0 ? std::numeric_limits<double>::quiet_NaN()
                                                     : std::numeric_limits<double>::infinity();
      }
    }
  }

  [[nodiscard]] BatchConfigurations<Model> batch() const {
    return {{dimensions.data(), stride}, {inputs.data(), stride}, {configurations.data(), stride}};
  }
  [[nodiscard]] BatchSensitivities sensitivities() {
    return {status.data(), to_dimensions.data(), to_inputs.data(), stride};
  }
  [[nodiscard]] Vector<double, Model::input_count> rates(const std::vector<double>& from,
                                                         std::size_t index) const {
    Vector<double, Model::input_count> result;
    for (std::size_t input = 0; input < all_inputs; ++input) {
      result(static_cast<Eigen::Index>(input)) = from[input * stride + index];
    }
    return result;
  }
};

/// The largest difference of a matrix and the column of one configuration, over the largest entry.
template <typename Found>
double difference(const Found& truth, const std::vector<double>& found, std::size_t stride,
                  std::size_t index) {
  double off = 0;
  double size = std::numeric_limits<double>::min();
  for (Eigen::Index place = 0; place < truth.size(); ++place) {
    const double exact = truth.data()[place];
    size = std::max(size, std::abs(exact));
    off = largest(off, std::abs(exact - found[static_cast<std::size_t>(place) * stride + index]));
  }
  return off / size;
}

template <typename Model, std::size_t Lanes>
void compare(std::size_t count, bool on_lattice, bool with_gaps) {
  Given<Model> given(count, on_lattice, with_gaps);
  const double epsilon = std::numeric_limits<double>::epsilon();
  for (const bool moves : {false, true}) {
    if (moves) {
      sensitivities_and_motion<Model, Lanes>(
          count, given.batch(), {given.first_rates.data(), given.second_rates.data(), given.stride},
          given.sensitivities(), {given.velocity.data(), given.acceleration.data(), given.stride});
    } else {
      sensitivities<Model, Lanes>(count, given.batch(), given.sensitivities());
    }
    for (std::size_t index = 0; index < count; ++index) {
      SCOPED_TRACE(index);
      const auto d = group_of(given.batch().dimensions, index);
      const auto u = group_of(given.batch().inputs, index);
      const auto q = group_of(given.batch().configurations, index);
      Sensitivities<Model, double> sensitive;
      Motion<Model, double> moving;
      const Status status = moves ? sensitivities_and_motion<Model, double>(
                                        d, u, q, given.rates(given.first_rates, index),
                                        given.rates(given.second_rates, index), sensitive, moving)
                                  : sensitivities<Model, double>(d, u, q, sensitive);
      ASSERT_EQ(given.status[index], status);
      if (!is_solvable(status)) {
        continue;
      }
      const double margin = regularity<Model, double>(d, u, q).margin;
      const double bound = derivative_error_constant * epsilon / margin;
      ASSERT_LE(difference(sensitive.to_dimensions, given.to_dimensions, given.stride, index),
                bound);
      ASSERT_LE(difference(sensitive.to_inputs, given.to_inputs, given.stride, index), bound);
      if (moves) {
        // Rates may cancel; accelerations divide by the margin once more.
        ASSERT_LE(difference(moving.velocity, given.velocity, given.stride, index), bound / margin);
        ASSERT_LE(difference(moving.acceleration, given.acceleration, given.stride, index),
                  bound / margin);
      }
    }
    for (std::size_t index = count; index < given.stride; ++index) {
      EXPECT_EQ(given.status[index], Status::no_convergence);
      EXPECT_EQ(given.to_inputs[index], 0);
    }
  }
}

/// Motion without sensitivities, which models compute by another function.
template <typename Model, std::size_t Lanes>
void compare_motion(std::size_t count, bool on_lattice, bool with_gaps) {
  Given<Model> given(count, on_lattice, with_gaps);
  motion<Model, Lanes>(
      count, given.batch(), {given.first_rates.data(), given.second_rates.data(), given.stride},
      given.status.data(), {given.velocity.data(), given.acceleration.data(), given.stride});
  for (std::size_t index = 0; index < count; ++index) {
    SCOPED_TRACE(index);
    const auto d = group_of(given.batch().dimensions, index);
    const auto u = group_of(given.batch().inputs, index);
    const auto q = group_of(given.batch().configurations, index);
    Motion<Model, double> moving;
    const Status status = motion<Model, double>(d, u, q, given.rates(given.first_rates, index),
                                                given.rates(given.second_rates, index), moving);
    ASSERT_EQ(given.status[index], status);
    if (!is_solvable(status)) {
      continue;
    }
    const double margin = regularity<Model, double>(d, u, q).margin;
    const double bound =
        derivative_error_constant * std::numeric_limits<double>::epsilon() / (margin * margin);
    ASSERT_LE(difference(moving.velocity, given.velocity, given.stride, index), bound);
    ASSERT_LE(difference(moving.acceleration, given.acceleration, given.stride, index), bound);
  }
  for (std::size_t index = count; index < given.stride; ++index) {
    EXPECT_EQ(given.status[index], Status::no_convergence);
    EXPECT_EQ(given.velocity[index], 0);
  }
}

template <typename Model>
class BatchKinematics : public testing::Test {};
using Models = testing::Types<dyad::Model01, dyad::Model02, dyad::Model05, triad::Model01,
                              tetrad::Model01, tetrad::Model05, tetrad::Model15>;
TYPED_TEST_SUITE(BatchKinematics, Models, ModelNames);

TYPED_TEST(BatchKinematics, AnswerAsConfigurationsByThemselves) {
  for (const std::size_t count : {0U, 1U, 3U, 4U, 5U, 1000U}) {
    compare<TypeParam, 4>(count, false, false);
  }
  compare<TypeParam, 2>(101, false, false);
}

TYPED_TEST(BatchKinematics, MoveAsConfigurationsByThemselves) {
  for (const std::size_t count : {0U, 1U, 4U, 5U, 500U}) {
    compare_motion<TypeParam, 4>(count, false, false);
  }
  compare_motion<TypeParam, 4>(200, true, false);
  compare_motion<TypeParam, 4>(501, false, true);
}

TYPED_TEST(BatchKinematics, TellSingularAndUnfitOnesFromOthers) {
  compare<TypeParam, 4>(200, true, false);
  compare<TypeParam, 4>(501, false, true);
}

}  // namespace
}  // namespace assur::test::batch_kinematics_test
