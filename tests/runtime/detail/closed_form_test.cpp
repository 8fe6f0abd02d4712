// Laws of the closed form of models with at most two configurations, compared with double-double:
// no discriminant is wrong by more than its bound, no group is nearer to a singularity than its
// bound says, configurations are ordered by the first key in which they can differ, and those that
// the formula gives close the loops.
#include <assur/detail/assembly_order.hpp>
#include <assur/detail/closed_form.hpp>
#include <assur/detail/completion.hpp>
#include <assur/detail/pivots.hpp>
#include <assur/numeric/double_double.hpp>
#include <cmath>
#include <iostream>

#include "largest.hpp"
#include "runtime/exact.hpp"
#include "runtime/model_types.hpp"

namespace assur::test::closed_form_test {
namespace {

using numeric::DoubleDouble;
using numeric::Pair;

constexpr unsigned seed = 57722;

template <typename Model>
struct Group {
  typename Model::template Dimensions<double> d;
  typename Model::template Inputs<double> u;

  [[nodiscard]] double square() const {
    return square_of_lengths<double>(d) + square_of_lengths<double>(u);
  }
  [[nodiscard]] detail::FinalPolynomial<Model, double> polynomial() const {
    detail::FinalPolynomial<Model, double> T;
    Model::position_polynomial(d, u, T);
    return T;
  }
};

/// A length is an integer from -3 to 3, a direction a multiple of 90 degrees or of a Pythagorean
/// triangle.
struct Lattice {
  RandomInputs random;

  void fill(double& length) { length = random.integer(-3, 3); }
  void fill(Direction<double>& direction) {
    constexpr std::array<Direction<double>, 4> corners = {
        {{1, 0}, {0.6, 0.8}, {5.0 / 13, 12.0 / 13}, {0.28, 0.96}}};
    direction = corners[static_cast<std::size_t>(random.integer(0, 3))];
    for (int turns = random.integer(0, 3); turns > 0; --turns) {
      direction = {-direction.sin, direction.cos};
    }
  }
};

template <typename Model, typename Filler>
Group<Model> filled_by(Filler& filler) {
  Group<Model> group;
  const auto fill = [&filler](auto& member, std::size_t) { filler.fill(member); };
  for_each_member(group.d, fill);
  for_each_member(group.u, fill);
  return group;
}

/// Moves a group that can be assembled towards one that cannot, until its discriminant is `part` of
/// the least that certifies a regular group. False if that does not happen on the path.
template <typename Model>
bool bring_near_end(Group<Model>& group, const Group<Model>& other, double part) {
  using Form = detail::ClosedForm<Model, double>;
  const auto over = [&](const Group<Model>& at) {
    return detail::discriminants_of(at.polynomial()).discriminant * Form::firmness / part -
           Form::discriminant.power(at.square());
  };
  const auto between = [&](double way) {
    Group<Model> result = group;
    for_each_pair(result.u, other.u, [way](auto& target, const auto& source) {
      if constexpr (std::is_same_v<std::decay_t<decltype(target)>, double>) {
        target += way * (source - target);
      }
    });
    return result;
  };
  double low = 0;
  double high = 1;
  if (!(over(between(low)) > 0 && over(between(high)) < 0)) {
    return false;
  }
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (low + high) / 2;
    (over(between(middle)) > 0 ? low : high) = middle;
  }
  group = between(low);
  return true;
}

/// The variables in double-double, moved at random within the rounding that inputs may have.
template <typename To, typename From>
To moved(const From& from, double length, RandomInputs& random) {
  const double most = numeric::Magnitude::given_rounding();
  const auto by = [&random, most](double size) {
    return DoubleDouble(size) * DoubleDouble(random.between(-most, most));
  };
  To result;
  for_each_pair(result, from, [&](auto& target, const auto& source) {
    if constexpr (std::is_same_v<std::decay_t<decltype(source)>, double>) {
      target = DoubleDouble(source) + by(length);
    } else {
      target = {DoubleDouble(source.cos) + by(1), DoubleDouble(source.sin) + by(1)};
    }
  });
  return result;
}

/// The least margin among the configurations of a group whose first unknown is an angle, computed
/// without the search's own functions but the formula.
template <typename Model>
double least_margin(const Group<Model>& group) {
  using Scalar = DoubleDouble;
  const auto d = support::scaled_to<typename Model::template Dimensions<Scalar>>(group.d, 1.0);
  const auto u = support::scaled_to<typename Model::template Inputs<Scalar>>(group.u, 1.0);
  TrigonometricPolynomial<Scalar, 1> T;
  Model::position_polynomial(d, u, T);
  const auto found = detail::discriminants_of(T);
  const Scalar root = sqrt(found.discriminant);
  double least = 1;
  for (const Scalar& reach : {root, -root}) {
    typename Model::template Configuration<Scalar> q;
    detail::first_of<Model>(q) = {
        (-(T.cosine[0] * T.cosine[1]) - reach * T.sine[1]) / found.leading,
        (reach * T.cosine[1] - T.cosine[0] * T.sine[1]) / found.leading};
    Model::complete(d, u, q);
    const auto regularity =
        detail::regularity_of(detail::firmness_of(detail::pivots_at<Model, Scalar>(d, u, q)),
                              detail::derivative_rounding<Scalar>());
    least = std::min(least, static_cast<double>(regularity.margin));
  }
  return least;
}

struct Largest {
  double error = 0;  ///< of the discriminant, relative to its bound
  double lost = 0;   ///< loss of a group, relative to what a regular one may lose
  double key = 0;    ///< difference of keys that are passed over
  double alike = 0;  ///< what may pass for equal, relative to the difference that counts
  double miss = 0;   ///< of the closures, in roundings of the longest length
  int regular = 0;   ///< number of regular groups
};

/// Examines the configurations that a group's discriminant certifies, as the search does.
template <typename Model>
void examine_roots(const Group<Model>& group, Largest& largest_of) {
  const auto d = support::scaled_to<typename Model::template Dimensions<Pair>>(group.d, 1.0);
  const auto u = support::scaled_to<typename Model::template Inputs<Pair>>(group.u, 1.0);
  const double longest = std::sqrt(group.square());
  const auto T = group.polynomial();
  typename Model::template Configuration<Pair> q;
  detail::first_of<Model>(q) = detail::roots_of(T, detail::discriminants_of(T));
  const Pair off = detail::complete_root<Model, Pair>(d, u, q);
  detail::for_each_key<Model, Pair>(d, u, q, [&](const Pair& key, int place, bool is_length) {
    const double difference = std::abs(key[0] - key[1]);
    if (place < Model::first_key) {
      largest_of.key = largest(largest_of.key, difference);
    } else if (place == Model::first_key) {
      const Pair alone = detail::key_at<Model, Model::first_key, Pair>(d, u, q);
      EXPECT_TRUE(alone[0] == key[0] && alone[1] == key[1]);
      const double rounding = 1e-6 * ((is_length ? longest : 1) + std::abs(key[0]));
      largest_of.alike = largest(largest_of.alike, rounding / difference);
    }
  });
  using Scalar = DoubleDouble;
  for (std::size_t index = 0; index < 2; ++index) {
    if (detail::completes_angles<Model> && !(off[index] <= detail::settled_direction<double>)) {
      continue;
    }
    const auto one = detail::lane_of<typename Model::template Configuration<double>>(q, index);
    Vector<Scalar, Model::equation_count> f;
    Model::residual(support::scaled_to<typename Model::template Dimensions<Scalar>>(group.d, 1.0),
                    support::scaled_to<typename Model::template Inputs<Scalar>>(group.u, 1.0),
                    support::scaled_to<typename Model::template Configuration<Scalar>>(one, 1.0),
                    f);
    for (const Scalar& closure : f) {
      largest_of.miss =
          largest(largest_of.miss, std::abs(static_cast<double>(closure)) /
                                       (longest * std::numeric_limits<double>::epsilon()));
    }
  }
}

template <typename Model>
void examine(const Group<Model>& group, RandomInputs& random, Largest& largest_of) {
  using Certified = detail::Discriminants<DoubleDouble>;
  using Form = detail::ClosedForm<Model, double>;
  const double square = group.square();
  if (!(square > 0)) {
    return;
  }
  const auto T = group.polynomial();
  const auto found = detail::discriminants_of(T);
  detail::FinalPolynomial<Model, DoubleDouble> exact_T;
  Model::position_polynomial(
      moved<typename Model::template Dimensions<DoubleDouble>>(group.d, std::sqrt(square), random),
      moved<typename Model::template Inputs<DoubleDouble>>(group.u, std::sqrt(square), random),
      exact_T);
  const Certified exact = detail::discriminants_of(exact_T);
  const auto part = [square](double value, const DoubleDouble& truth,
                             const detail::Certainty<double>& certainty) {
    return std::abs(static_cast<double>(DoubleDouble(value) - truth)) * certainty.firmness /
           certainty.power(square);
  };
  largest_of.error =
      largest(largest_of.error, part(found.discriminant, exact.discriminant, Form::discriminant));
  if constexpr (!detail::is_angle<Model>(Model::first_unknown) && Model::polynomial_degree == 2) {
    constexpr auto leading = detail::certainty<double>(Model::leading_error, Model::leading_degree);
    largest_of.error = largest(largest_of.error, part(found.leading, exact.leading, leading));
  }
  if constexpr (Form::vouches) {
    if (found.discriminant * Form::firmness > Form::discriminant.power(square)) {
      ++largest_of.regular;
      largest_of.lost = largest(largest_of.lost, detail::derivative_rounding<double>() /
                                                     (support::six_digits * least_margin(group)));
      examine_roots(group, largest_of);
    }
  }
}

template <typename Model>
struct HasClosed : std::bool_constant<detail::has_closed_form<Model>> {};
template <typename Model>
using HasClosedForm = std::conjunction<IsRigid<Model>, HasClosed<Model>>;

template <typename Model>
class ClosedForm : public testing::Test {};
TYPED_TEST_SUITE(ClosedForm, ModelsWhere<HasClosedForm>, ModelNames);

TYPED_TEST(ClosedForm, HoldsOfAllGroups) {
  using Model = TypeParam;
  constexpr int groups = 4000;
  RandomInputs random(seed + static_cast<unsigned>(Model::number));
  Lattice lattice{random};
  Largest largest_of;
  int near_end = 0;
  for (int index = 0; index < groups; ++index) {
    const auto group = filled_by<Model>(random);
    examine(group, random, largest_of);
    examine(filled_by<Model>(lattice), random, largest_of);
    if (detail::ClosedForm<Model, double>::vouches) {
      Group<Model> there = group;
      if (bring_near_end(there, filled_by<Model>(random), 1 + 1e-6)) {
        ++near_end;
        examine(there, random, largest_of);
      }
    }
  }
  std::cout << model_name<Model>() << ", seed " << seed << ": of the bound " << largest_of.error
            << ", of what a regular group may lose " << largest_of.lost << " in "
            << largest_of.regular << " groups, " << near_end << " of them near their end, keys "
            << largest_of.key << ", first keys alike " << largest_of.alike
            << ", closures missed by roundings " << largest_of.miss << '\n';
  EXPECT_LT(largest_of.error, 1);
  EXPECT_LT(largest_of.lost, 1);
  EXPECT_LT(largest_of.key, 1e-6);
  EXPECT_LT(largest_of.alike, 1);
  EXPECT_LT(largest_of.miss, 8);
  EXPECT_EQ(near_end > 200, (detail::ClosedForm<Model, double>::vouches));
}

TEST(ClosedFormReport, VouchesForTheDyads) {
  // In every textbook the determinants are multiples of the root of the discriminant.
  EXPECT_TRUE((detail::ClosedForm<dyad::Model01, double>::vouches));
  EXPECT_TRUE((detail::ClosedForm<dyad::Model02, double>::vouches));
  EXPECT_TRUE((detail::ClosedForm<dyad::Model03, double>::vouches));
  EXPECT_EQ(dyad::Model01::first_key, 1);
  EXPECT_EQ(dyad::Model02::first_key, 0);
  EXPECT_EQ(dyad::Model03::first_key, 2);
}

}  // namespace
}  // namespace assur::test::closed_form_test
