// Law: where a configuration is called ok, six digits of its derivatives hold; where all are ok,
// none is missing, near singular configurations and far from the origin, too; judged by long double
// and Sturm's theorem.
#include <assur/assemblies.hpp>
#include <assur/kinematics.hpp>
#include <assur/support/scale.hpp>
#include <cmath>
#include <iostream>

#include "largest.hpp"
#include "runtime/compiled_models.hpp"
#include "runtime/model_types.hpp"
#include "runtime/near_singular_groups.hpp"
#include "whole_campaign.hpp"

namespace assur::test::verdicts_test {
namespace {

using Long = long double;

constexpr unsigned seed = 8129;
/// `ctest -L long` draws all samples.
const int samples = is_whole_campaign() ? 15 : 6;

template <typename Model>
class Verdicts : public testing::Test {
 protected:
  using Groups = NearSingularGroups<Model>;
  using Group = typename Groups::template Group<double>;

  /// Calls `use` with groups at known distances from a singular configuration.
  template <typename Use>
  void for_each_group(const Use& use) {
    for (int sample = 0; sample < samples; ++sample) {
      const auto from = groups_.drawn(1);
      const auto to = groups_.drawn(1);
      const double singular = groups_.singular_between(from, to);
      for (const double distance : {1e-1, 1e-2, 3e-3, 1e-3, 5e-4, 3e-4, 1e-4, 1e-5, 1e-7}) {
        use(groups_.between(from, to, singular + distance));
      }
    }
  }

  Groups groups_{seed + static_cast<unsigned>(Model::number)};
};

TYPED_TEST_SUITE(Verdicts, AllModels, ModelNames);

/// The inputs with all external joints moved by the same vector.
template <typename Scalar, typename Inputs>
Inputs shifted(Inputs u, double by) {
  bool is_x = true;
  for_each_member(u, [&](auto& member, std::size_t) {
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>, Scalar>) {
      member += is_x ? by : -3 * by / 4;
      is_x = !is_x;
    }
  });
  return u;
}

/// The largest difference of derivatives over the largest of them, among unknowns of one unit, of a
/// group that was shifted by `far`; 1 where there are no derivatives. Closures depend only on
/// differences of places, so that the truth is computed at the origin: long double shifts the
/// places back exactly.
template <typename Model>
double error_of(const typename Model::template Dimensions<double>& d,
                const typename Model::template Inputs<double>& u,
                const typename Model::template Configuration<double>& q, double far) {
  using Groups = NearSingularGroups<Model>;
  const auto long_d = Groups::template in_scalar<typename Model::template Dimensions<Long>>(d);
  const auto long_u =
      shifted<Long>(Groups::template in_scalar<typename Model::template Inputs<Long>>(u), -far);
  auto long_q = Groups::template in_scalar<typename Model::template Configuration<Long>>(q);
  Sensitivities<Model, Long> truth;
  if (!is_solvable(refine<Model, Long>(long_d, long_u, long_q)) ||
      !is_solvable(sensitivities<Model, Long>(long_d, long_u, long_q, truth))) {
    return 1;
  }
  Sensitivities<Model, double> found;
  Model::sensitivities(d, u, q, found.to_dimensions, found.to_inputs);
  Long worst = 0;
  const auto compare = [&](const auto& rows, const auto& true_rows) {
    for (const bool angles : {false, true}) {
      Long difference = 0;
      Long size = 0;
      for (Eigen::Index row = 0; row < rows.rows(); ++row) {
        if (Model::unknowns[static_cast<std::size_t>(row)].is_angle == angles) {
          for (Eigen::Index column = 0; column < rows.cols(); ++column) {
            difference =
                largest(difference, std::abs(Long{rows(row, column)} - true_rows(row, column)));
            size = std::max(size, std::abs(true_rows(row, column)));
          }
        }
      }
      worst = size > 0 ? largest(worst, difference / size) : worst;
    }
  };
  compare(found.to_dimensions, truth.to_dimensions);
  compare(found.to_inputs, truth.to_inputs);
  return static_cast<double>(worst);
}

TYPED_TEST(Verdicts, HoldFarFromTheOrigin) {
  using Model = TypeParam;
  if constexpr (Model::rigid) {
    for (const double far : {0.0, 0x1p12, 0x1p20, 0x1p24, 0x1p28}) {
      int listed = 0;
      int regular = 0;
      int wrong = 0;
      int miscounted = 0;
      double worst = 0;
      this->for_each_group([&](const auto& group) {
        const auto u = shifted<double>(group.u, far);
        const Assemblies<Model> found = compiled::assemblies<Model>(group.d, u);
        bool certain = found.status == AssemblyStatus::ok;
        for (int index = 0; index < found.count; ++index) {
          const auto slot = static_cast<std::size_t>(index);
          ++listed;
          certain = certain && found.regularity[slot] == Status::ok;
          if (found.regularity[slot] == Status::ok) {
            const double error = error_of<Model>(group.d, u, found.configurations[slot], far);
            ++regular;
            wrong += error > 5e-7 ? 1 : 0;
            worst = largest(worst, error);
          }
        }
        // An empty list may have lost two configurations that rounding cannot tell apart.
        if (certain && found.count > 0 &&
            found.count != compiled::exact_assembly_count<Model>(group.d, u)) {
          ++miscounted;
        }
      });
      std::cout << model_name<Model>() << ", seed " << seed << ", " << far
                << " from the origin: " << listed << " configurations, " << regular
                << " ok, of them wrong " << wrong << ", at most " << worst
                << "; lists that are wrong and all ok " << miscounted << '\n';
      EXPECT_EQ(wrong, 0);
      EXPECT_EQ(miscounted, 0);
      // Farther away a rounding of the places may be more than six digits allow.
      EXPECT_TRUE(regular > 0 || far > 0x1p20);
    }
  }
}

/// If nothing bounds how far a group is displaced, or if it may be turned by a thousandth, no
/// configuration is ok; those that may meet are listed once.
TYPED_TEST(Verdicts, AreNotOkWithoutABound) {
  using Model = TypeParam;
  if constexpr (Model::rigid) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    int listed = 0;
    this->for_each_group([&](const auto& group) {
      const Assemblies<Model> known = compiled::assemblies<Model>(group.d, group.u);
      if (known.count == 0) {
        return;
      }
      for (const support::Displacement& displaced :
           std::vector<support::Displacement>{{infinite, 0, 0},
                                              {0, infinite, 0},

                                              {none, 0, 0},
                                              {0, none, 0},

                                              {none, 1, 0},
                                              {1, none, 0},
                                              {none, none, none},
                                              {infinite, infinite, infinite},
                                              {0, 1e-3, 0}}) {
        SCOPED_TRACE(testing::Message()
                     << displaced.moved << " " << displaced.turned << " " << displaced.reach);
        const Assemblies<Model> found = compiled::assemblies<Model>(group.d, group.u, displaced);
        ASSERT_EQ(found.status, AssemblyStatus::ok);
        ASSERT_GT(found.count, 0);
        ASSERT_LE(found.count, known.count);
        for (int index = 0; index < found.count; ++index) {
          ++listed;
          ASSERT_EQ(found.regularity[static_cast<std::size_t>(index)], Status::near_singular);
        }
      }
    });
    EXPECT_GT(listed, 0);
  }
}

/// A power of two as a unit changes no digit, so that it must change no verdict.
TYPED_TEST(Verdicts, DoNotDependOnTheUnit) {
  using Model = TypeParam;
  if constexpr (Model::rigid) {
    int compared = 0;
    this->for_each_group([&](const auto& group) {
      const Assemblies<Model> here = compiled::assemblies<Model>(group.d, group.u);
      for (const int power : {-480, -300, -100, -40, 40, 100, 300, 480}) {
        const double unit = std::ldexp(1.0, power);
        const auto d = support::scaled_to<std::decay_t<decltype(group.d)>>(group.d, unit);
        const auto u = support::scaled_to<std::decay_t<decltype(group.u)>>(group.u, unit);
        const Assemblies<Model> there = compiled::assemblies<Model>(d, u);
        SCOPED_TRACE(power);
        ++compared;
        ASSERT_EQ(here.status, there.status);
        ASSERT_EQ(here.count, there.count);
        for (int index = 0; index < here.count; ++index) {
          const auto slot = static_cast<std::size_t>(index);
          ASSERT_EQ(here.regularity[slot], there.regularity[slot]);
        }
      }
    });
    std::cout << model_name<Model>() << ", seed " << seed << ": " << compared << " groups\n";
  }
}

}  // namespace
}  // namespace assur::test::verdicts_test
