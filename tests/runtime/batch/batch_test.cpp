// Law: a batch of groups has the answers of single calls.
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

/// How groups are drawn. Odd ones are in general position, but in various units, at various places,
/// and some have a number that is not finite.
enum class Kind { general, lattice, odd };
constexpr std::array<const char*, 3> kind_names = {" general", " lattice", " odd"};

/// The distance by which the coordinates of an odd group are moved, in parts of its lengths.
double moved_by(std::size_t group) {
  constexpr std::array<double, 8> moved = {0, 1e2, 1e4, 0, 1e8, 0, 1e12, 0};
  return moved[group % moved.size()];
}

/// The unit of an odd group.
double unit_of(std::size_t group) {
  constexpr std::array<double, 7> units = {1, 0x1p-30, 0x1p60, 0x1p-300, 0x1p400, 0x1p-900, 1};
  return units[group % units.size()];
}

template <typename Dimensions, typename Inputs>
void make_odd(std::size_t group, Dimensions& d, Inputs& u) {
  const double unit = unit_of(group);
  const auto change = [unit](double moved) {
    return [=](auto& member, std::size_t) {
      if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
        member = (member + moved) * unit;
      }
    };
  };
  for_each_member(d, change(0));
  for_each_member(u, change(moved_by(group)));
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (group % 11 == 10) {
    auto& first = std::get<0>(u.members());
    if constexpr (std::is_same_v<std::decay_t<decltype(first)>, double>) {
      first = group % 2 == 0 ? none : std::numeric_limits<double>::infinity();
    } else {
      first.sin = none;
    }
  }
  for_each_member(d, [group](auto& member, std::size_t index) {
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
      member = group % 13 == 12 && index == 0 ? 0 : member;
    }
  });
}

/// Groups, and room for their answers, with values between the columns that no answer may change.
template <typename Model>
class Columned {
  using Dimensions = typename Model::template Dimensions<double>;
  using Inputs = typename Model::template Inputs<double>;
  using Configuration = typename Model::template Configuration<double>;
  static constexpr double untouched = 12345.5;
  static constexpr auto capacity = static_cast<std::size_t>(Model::max_configurations);

 public:
  Columned(std::size_t count, Kind kind)
      : count_(count),
        stride_(count + 3),
        dimensions_(Columns<Dimensions>::count * stride_),
        inputs_(Columns<Inputs>::count * stride_),
        status_(stride_, AssemblyStatus::unresolved),
        counts_(stride_, -1),
        mobility_(stride_, -1),
        regularity_(capacity * stride_, Status::no_convergence),
        configurations_(capacity * Columns<Configuration>::count * stride_, untouched) {
    DrawnGroups<double> draws(seed + static_cast<unsigned>(Model::number), kind == Kind::lattice);
    for (std::size_t group = 0; group < count; ++group) {
      auto d = draws.template variables<Dimensions>();
      auto u = draws.template variables<Inputs>();
      if (kind == Kind::odd) {
        make_odd(group, d, u);
      }
      put_group({dimensions_.data(), stride_}, group, d);
      put_group({inputs_.data(), stride_}, group, u);
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

/// The largest difference of two configurations, of lengths relative to themselves or to a unit.
template <typename Configuration>
double distance(const Configuration& one, const Configuration& other, double unit) {
  double farthest = 0;
  for_each_pair(one, other, [&](const auto& found, const auto& truth) {
    if constexpr (std::is_same_v<std::decay_t<decltype(truth)>, double>) {
      farthest = largest(farthest, std::abs(found - truth) / std::max(unit, std::abs(truth)));
    } else {
      farthest = largest(farthest, std::abs(found.cos - truth.cos));
      farthest = largest(farthest, std::abs(found.sin - truth.sin));
    }
  });
  return farthest;
}

struct Seen {
  std::size_t groups = 0, configurations = 0, alone = 0, wrong = 0;
  double apart = 0;  ///< in eps/firmness
};

/// Compares every answer with that of the group by itself.
template <typename Model, std::size_t Lanes>
void compare(std::size_t count, Kind kind, Seen& seen) {
  Columned<Model> groups(count, kind);
  seen.alone += groups.template solve<Lanes>();
  groups.expect_nothing_beyond();
  const BatchAssemblies<Model> found = groups.result();
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
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
        // Distant points are known to the rounding of their coordinates.
        const double reach = kind == Kind::odd ? 1 + moved_by(group) : 1;
        const double unit = kind == Kind::odd ? unit_of(group) : 1;
        const double apart = distance(group_of(found.configuration(index), group), q, unit);
        seen.apart = largest(seen.apart, apart * firmness / reach / epsilon);
      }
    }
  }
}

/// The largest share of groups in general position that may be solved by themselves: batches are
/// quick if packs settle most groups. Where the error of a formula has a wide bound for all groups
/// of a model, more discriminants are within that bound.
template <typename Model>
double most_alone() {
  if constexpr (requires { Model::discriminant_error; }) {
    return Model::discriminant_error > 1e-6 ? 0.25 : 0.02;
  }
  return 0.02;
}

template <typename Model, std::size_t Lanes>
void compare_all(Kind kind) {
  Seen seen;
  for (const std::size_t count : {0U, 1U, 3U, 4U, 5U, 17U}) {
    compare<Model, Lanes>(count, kind, seen);
  }
  const std::size_t in_small_batches = seen.alone;
  const std::size_t many = is_whole_campaign() ? 20000 : kind == Kind::general ? 1000 : 100;
  compare<Model, Lanes>(many, kind, seen);
  std::cout << model_name<Model>() << kind_names[static_cast<std::size_t>(kind)] << ", " << Lanes
            << " lanes: groups " << seen.groups << ", alone " << seen.alone << ", configurations "
            << seen.configurations << ", apart " << seen.apart << " eps/firmness\n";
  EXPECT_EQ(seen.wrong, 0U);
  EXPECT_LT(seen.apart, 16);
  if (kind == Kind::general) {
    EXPECT_LE(static_cast<double>(seen.alone - in_small_batches),
              most_alone<Model>() * static_cast<double>(many));
  }
}

template <typename Model>
class Batches : public testing::Test {};
using Models = testing::Types<dyad::Model01, dyad::Model02, dyad::Model03, dyad::Model04,
                              dyad::Model05, triad::Model01, tetrad::Model01, tetrad::Model02,
                              tetrad::Model04, tetrad::Model05, tetrad::Model11, tetrad::Model15>;
TYPED_TEST_SUITE(Batches, Models, ModelNames);

TYPED_TEST(Batches, AnswerInGeneralPositionAsGroupsByThemselves) {
  compare_all<TypeParam, 4>(Kind::general);
  compare_all<TypeParam, numeric::native_lanes>(Kind::general);
}

TYPED_TEST(Batches, AnswerOnALatticeAsGroupsByThemselves) {
  compare_all<TypeParam, 4>(Kind::lattice);
}

TYPED_TEST(Batches, AnswerInAnyUnitAndPlaceAsGroupsByThemselves) {
  compare_all<TypeParam, 4>(Kind::odd);
}

}  // namespace
}  // namespace assur::test::batch_test
