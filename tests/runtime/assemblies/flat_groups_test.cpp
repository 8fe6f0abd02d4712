// Law: groups that close with all links on one line, and groups near these, lose no configuration
// and invent none; an answer is left open only where the final polynomial is below its error.
#include <gtest/gtest.h>

#include <assur/assemblies.hpp>
#include <assur/numeric/double_double.hpp>
#include <assur/support/position_polynomial.hpp>
#include <assur/support/scale.hpp>
#include <assur/tetrad/model_01.hpp>
#include <assur/tetrad/model_02.hpp>
#include <assur/tetrad/model_03.hpp>
#include <iostream>
#include <vector>

#include "runtime/cluster_value.hpp"
#include "runtime/compiled_models.hpp"
#include "runtime/exact_assembly.hpp"
#include "whole_campaign.hpp"

namespace assur::test::flat_groups_test {
namespace {

constexpr unsigned seed = 30103;

/// |T| at undecided roots in units of its error, as `assemblies` meets them in double-double.
template <typename Model>
double undecided_value(const typename Model::template Dimensions<double>& d,
                       const typename Model::template Inputs<double>& u) {
  using numeric::DoubleDouble;
  const double scale = support::unit_scale<Model>(d, u);
  const auto polynomial = support::position_polynomial<Model, DoubleDouble>(
      support::scaled_to<typename Model::template Dimensions<double>>(d, scale),
      support::scaled_to<typename Model::template Inputs<double>>(u, scale));
  return largest_cluster_value<DoubleDouble, Model::polynomial_degree>(
      polynomial.value, DoubleDouble(polynomial.error));
}

struct Tally {
  int groups = 0;
  int counted = 0;
  int roots = 0;
  int degenerate = 0;
  int open = 0;
  double largest_open = 0;
};

/// Counts the real roots exactly if `by_sturm`.
template <typename Model>
void judge(const typename Model::template Dimensions<double>& d,
           const typename Model::template Inputs<double>& u, bool by_sturm, Tally& tally) {
  const Assemblies<Model> found = compiled::assemblies<Model>(d, u);
  ++tally.groups;
  if (found.status == AssemblyStatus::degenerate) {
    ++tally.degenerate;
    return;
  }
  if (!by_sturm) {
    return;
  }
  const int expected = compiled::exact_assembly_count<Model>(d, u);
  ++tally.counted;
  tally.roots += expected;
  if (found.count == expected) {
    return;
  }
  const double value = undecided_value<Model>(d, u);
  EXPECT_GE(value, 0) << found.count << " configurations of " << expected << ", none undecided";
  ++tally.open;
  tally.largest_open = std::max(tally.largest_open, value);
}

void report(const char* family, const Tally& tally) {
  std::cout << family << ", seed " << seed << ": " << tally.groups << " groups, of these "
            << tally.counted << " with " << tally.roots << " real roots counted exactly, "
            << tally.degenerate << " degenerate; " << tally.open
            << " left open, the polynomial there at most " << tally.largest_open
            << " of its error\n";
  EXPECT_GT(tally.roots, 0);
  EXPECT_LT(tally.degenerate, tally.groups / 100);
  EXPECT_LT(tally.largest_open, 10);
}

/// Collinear ternaries, integer lengths and angles of 0 or pi, closed by lengths.
template <typename Model>
bool draw_flat(RandomInputs& random, Assembly<Model, Rational>& at) {
  const auto lay_down = [&](auto& member, const char* name) {
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>, Rational>) {
      member = name[0] == 'y' ? 0 : random.integer(-16, 16);
    } else {
      member = {Rational(random.integer(0, 1) == 0 ? 1 : -1), Rational(0)};
    }
  };
  const auto lay_all = [&](auto members, const auto& list) {
    std::size_t place = 0;
    std::apply([&](auto&... member) { (lay_down(member, list[place++].name), ...); }, members);
  };
  lay_all(at.d.members(), Model::dimensions);
  lay_all(at.u.members(), Model::inputs);
  lay_all(at.q.members(), Model::unknowns);
  return close_loops(at);
}

/// Whether no length of a link vanishes and no two agree: otherwise configurations may share their
/// first angle, and Sturm's theorem counts them once.
template <typename Model>
bool is_generic(const Assembly<Model, Rational>& at) {
  std::vector<Rational> lengths;
  std::size_t place = 0;
  const auto collect = [&](const auto& member) {
    const char first = Model::dimensions[place++].name[0];
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>, Rational>) {
      if (first != 'y' && first != 'h') {
        lengths.push_back(member);
      }
    }
  };
  std::apply([&](const auto&... member) { (collect(member), ...); }, at.d.members());
  for (std::size_t one = 0; one < lengths.size(); ++one) {
    if (lengths[one].is_zero() || std::count(lengths.begin(), lengths.end(), lengths[one]) > 1) {
      return false;
    }
  }
  return true;
}

template <typename Model>
class FlatGroups : public testing::Test {};
using Models = testing::Types<tetrad::Model01, tetrad::Model02, tetrad::Model03>;
TYPED_TEST_SUITE(FlatGroups, Models);

TYPED_TEST(FlatGroups, LoseNoneAndInventNone) {
  using Model = TypeParam;
  RandomInputs random(seed + static_cast<unsigned>(Model::number));
  Tally tally;
  constexpr int steps = 400;
  // The long campaign solves every step of all groups; the default solves an eighth of the groups,
  // and in each an eighth of the steps and the step that is counted.
  const int groups = is_whole_campaign() ? 2000 : 250;
  const int stride = is_whole_campaign() ? 1 : 8;
  for (int group = 0; group < groups; ++group) {
    Assembly<Model, Rational> flat;
    if (!draw_flat(random, flat) || !is_generic(flat)) {
      continue;
    }
    const auto at = rounded<double>(flat);
    using Step = Vector<double, Model::input_count>;
    const Step direction = random.vector<Step>();
    const int counted = 1 + group % steps;
    for (int step = 1; step <= steps; ++step) {
      if (step % stride != 0 && step != counted) {
        continue;
      }
      auto u = at.u;
      advance(u, Step(direction * (0.5 * step / steps)));
      judge<Model>(at.d, u, step == counted, tally);
    }
  }
  report(("model " + std::to_string(Model::number)).c_str(), tally);
}

/// B moves on a circle about the origin past a flat configuration; E stays in place.
TEST(FlatGroup, AnEndLedOnACircle) {
  using Model = tetrad::Model01;
  const Model::Dimensions<double> d = {6, -4, 0, 10, 16, 0, 3, 13};
  Tally tally;
  constexpr int steps = 400;
  for (int step = 0; step < steps; ++step) {
    const double p = -0.0588 + 0.0004 * step / steps;
    judge<Model>(d, {-2 * std::cos(p), -2 * std::sin(p), -9, 0}, true, tally);
    const double around = 2 * 3.14159265358979323846 * (step + 0.5) / steps;
    judge<Model>(d, {-2 * std::cos(around), -2 * std::sin(around), -9, 0}, true, tally);
  }
  report("an end led on a circle", tally);
  EXPECT_EQ(tally.open, 0);
}

}  // namespace
}  // namespace assur::test::flat_groups_test
