// Law: a batch of groups gets the answers that each of them gets by itself.
#include <assur/batch.hpp>
#include <assur/dyad/models.hpp>
#include <assur/kinematics.hpp>
#include <assur/tetrad/model_01.hpp>
#include <assur/tetrad/model_02.hpp>
#include <assur/tetrad/model_04.hpp>
#include <assur/tetrad/model_05.hpp>
#include <assur/tetrad/model_11.hpp>
#include <assur/tetrad/model_15.hpp>
#include <assur/triad/model_01.hpp>
#include <iostream>
#include <limits>
#include <vector>

#include "largest.hpp"
#include "runtime/compiled_models.hpp"
#include "runtime/drawn_groups.hpp"
#include "runtime/model_types.hpp"
#include "whole_campaign.hpp"

namespace assur::test::batch_test {
namespace {

constexpr unsigned seed = 9041;

/// Groups, and room for their answers. What no answer may overwrite stands around each column.
template <typename Model>
class Columned {
  using Dimensions = typename Model::template Dimensions<double>;
  using Inputs = typename Model::template Inputs<double>;
  using Configuration = typename Model::template Configuration<double>;
  static constexpr double untouched = 12345.5;
  static constexpr auto capacity = static_cast<std::size_t>(Model::max_configurations);

 public:
  Columned(std::size_t count, bool on_lattice)
      : count_(count),
        stride_(count + 3),
        dimensions_(Columns<Dimensions>::count * stride_),
        inputs_(Columns<Inputs>::count * stride_),
        status_(stride_, AssemblyStatus::unresolved),
        counts_(stride_, -1),
        mobility_(stride_, -1),
        regularity_(capacity * stride_, Status::no_convergence),
        configurations_(capacity * Columns<Configuration>::count * stride_, untouched) {
    DrawnGroups<double> draws(seed + static_cast<unsigned>(Model::number), on_lattice);
    for (std::size_t group = 0; group < count; ++group) {
      put_group({dimensions_.data(), stride_}, group, draws.template variables<Dimensions>());
      put_group({inputs_.data(), stride_}, group, draws.template variables<Inputs>());
    }
  }

  template <std::size_t Lanes>
  std::size_t solve() {
    return assemblies<Model, Lanes>(count_, {dimensions_.data(), stride_},
                                    {inputs_.data(), stride_}, result());
  }
  [[nodiscard]] BatchAssemblies<Model> result() {
    return {status_.data(),     counts_.data(),         mobility_.data(),
            regularity_.data(), configurations_.data(), stride_};
  }
  [[nodiscard]] Dimensions dimensions(std::size_t group) const {
    return group_of(Columns<const Dimensions>{dimensions_.data(), stride_}, group);
  }
  [[nodiscard]] Inputs inputs(std::size_t group) const {
    return group_of(Columns<const Inputs>{inputs_.data(), stride_}, group);
  }

  void expect_nothing_beyond() const {
    for (std::size_t place = count_; place < stride_; ++place) {
      EXPECT_EQ(status_[place], AssemblyStatus::unresolved);
      EXPECT_EQ(counts_[place], -1);
      EXPECT_EQ(mobility_[place], -1);
    }
    for (std::size_t row = 0; row < configurations_.size() / stride_; ++row) {
      for (std::size_t place = count_; place < stride_; ++place) {
        EXPECT_EQ(configurations_[row * stride_ + place], untouched);
      }
    }
  }

 private:
  std::size_t count_, stride_;
  std::vector<double> dimensions_, inputs_;
  std::vector<AssemblyStatus> status_;
  std::vector<int> counts_, mobility_;
  std::vector<Status> regularity_;
  std::vector<double> configurations_;
};

/// The largest difference of two configurations, lengths in parts of themselves if beyond one.
template <typename Configuration>
double distance(const Configuration& one, const Configuration& other) {
  std::array<double, Columns<Configuration>::count> found{};
  std::array<double, Columns<Configuration>::count> truth{};
  put_group(Columns<Configuration>{found.data(), 1}, 0, one);
  put_group(Columns<Configuration>{truth.data(), 1}, 0, other);
  double farthest = 0;
  for (std::size_t place = 0; place < found.size(); ++place) {
    farthest = largest(
        farthest, std::abs(found[place] - truth[place]) / std::max(1.0, std::abs(truth[place])));
  }
  return farthest;
}

struct Seen {
  std::size_t groups = 0, configurations = 0, alone = 0, wrong = 0;
  double apart = 0;  ///< in eps/firmness
};

/// Compares every answer with that of the group by itself.
template <typename Model, std::size_t Lanes>
void compare(std::size_t count, bool on_lattice, Seen& seen) {
  Columned<Model> groups(count, on_lattice);
  seen.alone += groups.template solve<Lanes>();
  groups.expect_nothing_beyond();
  const BatchAssemblies<Model> found = groups.result();
  for (std::size_t group = 0; group < count; ++group) {
    ++seen.groups;
    const auto d = groups.dimensions(group);
    const auto u = groups.inputs(group);
    const Assemblies<Model> truth = compiled::assemblies<Model>(d, u);
    if (found.status[group] != truth.status || found.count[group] != truth.count ||
        found.mobility[group] != truth.mobility) {
      ++seen.wrong;
      continue;
    }
    for (int index = 0; index < truth.count; ++index) {
      ++seen.configurations;
      const auto place = static_cast<std::size_t>(index);
      const auto& q = truth.configurations[place];
      if (found.regularity[place * found.stride + group] != truth.regularity[place]) {
        ++seen.wrong;
      } else if (truth.regularity[place] == Status::ok) {
        const double firmness = regularity<Model, double>(d, u, q).firmness;
        seen.apart = largest(seen.apart, distance(group_of(found.configuration(index), group), q) *
                                             firmness / std::numeric_limits<double>::epsilon());
      }
    }
  }
}

template <typename Model, std::size_t Lanes>
void compare_all(bool on_lattice) {
  Seen seen;
  for (const std::size_t count : {0, 1, 3, 4, 5, 17}) {
    compare<Model, Lanes>(count, on_lattice, seen);
  }
  compare<Model, Lanes>(is_whole_campaign() ? 20000 : on_lattice ? 100 : 1000, on_lattice, seen);
  std::cout << model_name<Model>() << (on_lattice ? " lattice" : " general") << ", " << Lanes
            << " lanes: groups " << seen.groups << ", alone " << seen.alone << ", configurations "
            << seen.configurations << ", apart " << seen.apart << " eps/firmness\n";
  EXPECT_EQ(seen.wrong, 0U);
  EXPECT_LT(seen.apart, 16);
}

template <typename Model>
class Batches : public testing::Test {};
using Models = testing::Types<dyad::Model01, dyad::Model02, dyad::Model03, dyad::Model04,
                              dyad::Model05, triad::Model01, tetrad::Model01, tetrad::Model02,
                              tetrad::Model04, tetrad::Model05, tetrad::Model11, tetrad::Model15>;
TYPED_TEST_SUITE(Batches, Models, ModelNames);

TYPED_TEST(Batches, AnswerInGeneralPositionAsGroupsByThemselves) {
  compare_all<TypeParam, 4>(false);
  compare_all<TypeParam, 2>(false);
}

TYPED_TEST(Batches, AnswerOnALatticeAsGroupsByThemselves) { compare_all<TypeParam, 4>(true); }

}  // namespace
}  // namespace assur::test::batch_test
