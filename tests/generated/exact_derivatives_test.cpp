// Law: over rational numbers every generated derivative equals the exact Taylor coefficient of the
// generated residual and link poses.
#include "runtime/exact.hpp"
#include "runtime/model_types.hpp"
#include "runtime/taylor.hpp"

namespace assur::test::exact_derivatives_test {
namespace {

constexpr int samples = 20;

template <typename Model>
class ExactDerivatives : public testing::Test {
 protected:
  using Moving = Taylor<Rational>;
  using Dimensions = typename Model::template Dimensions<Rational>;
  using Inputs = typename Model::template Inputs<Rational>;
  using Configuration = typename Model::template Configuration<Rational>;
  using UnknownVector = Vector<Rational, Model::unknown_count>;
  using DimensionVector = Vector<Rational, Model::dimension_count>;
  using InputVector = Vector<Rational, Model::input_count>;
  using ResidualVector = Vector<Moving, Model::equation_count>;

  explicit ExactDerivatives() : random_(20260U + static_cast<unsigned>(Model::number)) {}

  void draw() {
    d_ = random_.template variables<Dimensions>();
    u_ = random_.template variables<Inputs>();
    q_ = random_.template variables<Configuration>();
  }

  /// How all variables move; at rest where not set.
  struct AllRates {
    Rates<UnknownVector> q;
    Rates<DimensionVector> d;
    Rates<InputVector> u;
  };

  /// Residual and poses while the variables move.
  void move(const AllRates& rates) {
    const auto d = all_moving<typename Model::template Dimensions<Moving>>(d_, rates.d);
    const auto u = all_moving<typename Model::template Inputs<Moving>>(u_, rates.u);
    const auto q = all_moving<typename Model::template Configuration<Moving>>(q_, rates.q);
    Model::residual(d, u, q, residual_);
    Model::link_poses(d, u, q, poses_);
  }

  /// d theta/dt from the rates of (cos, sin).
  static Rational turning(const Direction<Moving>& direction) {
    return direction.cos.c0 * direction.sin.c1 - direction.sin.c0 * direction.cos.c1;
  }
  /// d2 theta/dt2 from the second rates: cos sin'' - sin cos''.
  static Rational second_turning(const Direction<Moving>& direction) {
    return Rational(2) *
           (direction.cos.c0 * direction.sin.c2 - direction.sin.c0 * direction.cos.c2);
  }

  /// Checks one column of a residual Jacobian and of a pose Jacobian.
  template <typename ResidualJacobian, typename PoseJacobian>
  void check_column(const ResidualJacobian& f, const PoseJacobian& p, int column,
                    const char* name) {
    for (int row = 0; row < Model::equation_count; ++row) {
      EXPECT_EQ(f(row, column), residual_(row).c1) << name << ", equation " << row;
    }
    for (int link = 0; link < Model::link_count; ++link) {
      const auto& pose = poses_[static_cast<std::size_t>(link)];
      EXPECT_EQ(p(3 * link, column), pose.x.c1) << name << ", x of link " << link;
      EXPECT_EQ(p(3 * link + 1, column), pose.y.c1) << name << ", y of link " << link;
      EXPECT_EQ(p(3 * link + 2, column), turning(pose.direction)) << name << ", link " << link;
    }
  }

  RandomInputs random_;
  Dimensions d_;
  Inputs u_;
  Configuration q_;
  ResidualVector residual_;
  Poses<Moving, Model::link_count> poses_;
};

TYPED_TEST_SUITE(ExactDerivatives, AllModels, ModelNames);

TYPED_TEST(ExactDerivatives, JacobiansAreTheFirstCoefficients) {
  using Model = TypeParam;
  for (int sample = 0; sample < samples; ++sample) {
    this->draw();
    Matrix<Rational, Model::equation_count, Model::unknown_count> f_q;
    Matrix<Rational, Model::equation_count, Model::dimension_count> f_d;
    Matrix<Rational, Model::equation_count, Model::input_count> f_u;
    Model::jacobian(this->d_, this->u_, this->q_, f_q);
    Model::dimension_jacobian(this->d_, this->u_, this->q_, f_d);
    Model::input_jacobian(this->d_, this->u_, this->q_, f_u);
    Matrix<Rational, 3 * Model::link_count, Model::unknown_count> p_q;
    Matrix<Rational, 3 * Model::link_count, Model::dimension_count> p_d;
    Matrix<Rational, 3 * Model::link_count, Model::input_count> p_u;
    Model::pose_jacobians(this->d_, this->u_, this->q_, p_q, p_d, p_u);
    for (int column = 0; column < Model::unknown_count; ++column) {
      typename TestFixture::AllRates along;
      along.q.first(column) = 1;
      this->move(along);
      this->check_column(f_q, p_q, column, Model::unknowns[static_cast<std::size_t>(column)].name);
    }
    for (int column = 0; column < Model::dimension_count; ++column) {
      typename TestFixture::AllRates along;
      along.d.first(column) = 1;
      this->move(along);
      this->check_column(f_d, p_d, column,
                         Model::dimensions[static_cast<std::size_t>(column)].name);
    }
    for (int column = 0; column < Model::input_count; ++column) {
      typename TestFixture::AllRates along;
      along.u.first(column) = 1;
      this->move(along);
      this->check_column(f_u, p_u, column, Model::inputs[static_cast<std::size_t>(column)].name);
    }
  }
}

TYPED_TEST(ExactDerivatives, RatesAreTheTimeDerivatives) {
  using Model = TypeParam;
  using Unknowns = Vector<Rational, Model::unknown_count>;
  using InputRates = Vector<Rational, Model::input_count>;
  for (int sample = 0; sample < samples; ++sample) {
    this->draw();
    typename TestFixture::AllRates rates;
    for (Unknowns* drawn : {&rates.q.first, &rates.q.second, &rates.q.third}) {
      *drawn = this->random_.template vector<Unknowns>();
    }
    for (InputRates* drawn : {&rates.u.first, &rates.u.second, &rates.u.third}) {
      *drawn = this->random_.template vector<InputRates>();
    }
    const auto& [q1, q2, q3] = rates.q;
    const auto& [u1, u2, u3] = rates.u;
    this->move(rates);

    Matrix<Rational, Model::equation_count, Model::unknown_count> jacobian;
    Vector<Rational, Model::equation_count> velocity_rhs;
    Vector<Rational, Model::equation_count> acceleration_rhs;
    Vector<Rational, Model::equation_count> jerk_rhs;
    Model::jacobian(this->d_, this->u_, this->q_, jacobian);
    Model::velocity_rhs(this->d_, this->u_, this->q_, u1, velocity_rhs);
    Model::acceleration_rhs(this->d_, this->u_, this->q_, q1, u1, u2, acceleration_rhs);
    Model::jerk_rhs(this->d_, this->u_, this->q_, q1, q2, u1, u2, u3, jerk_rhs);
    for (int row = 0; row < Model::equation_count; ++row) {
      Rational first = -velocity_rhs(row);
      Rational second = -acceleration_rhs(row);
      Rational third = -jerk_rhs(row);
      for (int column = 0; column < Model::unknown_count; ++column) {
        first = first + jacobian(row, column) * q1(column);
        second = second + jacobian(row, column) * q2(column);
        third = third + jacobian(row, column) * q3(column);
      }
      EXPECT_EQ(first, this->residual_(row).c1) << "velocity, equation " << row;
      EXPECT_EQ(second, Rational(2) * this->residual_(row).c2) << "acceleration, equation " << row;
      EXPECT_EQ(third, Rational(6) * this->residual_(row).c3) << "jerk, equation " << row;
    }

    Matrix<Rational, Model::link_count, 3> v;
    Matrix<Rational, Model::link_count, 3> a;
    Model::link_velocities(this->d_, this->u_, this->q_, q1, u1, v);
    Model::link_accelerations(this->d_, this->u_, this->q_, q1, q2, u1, u2, a);
    for (int link = 0; link < Model::link_count; ++link) {
      const auto& pose = this->poses_[static_cast<std::size_t>(link)];
      EXPECT_EQ(v(link, 0), pose.x.c1);
      EXPECT_EQ(v(link, 1), pose.y.c1);
      EXPECT_EQ(v(link, 2), this->turning(pose.direction));
      EXPECT_EQ(a(link, 0), Rational(2) * pose.x.c2);
      EXPECT_EQ(a(link, 1), Rational(2) * pose.y.c2);
      EXPECT_EQ(a(link, 2), this->second_turning(pose.direction));
    }
  }
}

TYPED_TEST(ExactDerivatives, CurvaturesAreTheSecondCoefficientsAlongALine) {
  using Model = TypeParam;
  for (int sample = 0; sample < samples; ++sample) {
    this->draw();
    typename TestFixture::AllRates line;
    line.q.first = this->random_.template vector<Vector<Rational, Model::unknown_count>>();
    line.d.first = this->random_.template vector<Vector<Rational, Model::dimension_count>>();
    line.u.first = this->random_.template vector<Vector<Rational, Model::input_count>>();
    this->move(line);

    Vector<Rational, Model::equation_count> rhs;
    Matrix<Rational, Model::link_count, 3> p;
    Model::curvature_rhs(this->d_, this->u_, this->q_, line.q.first, line.d.first, line.u.first,
                         rhs);
    Model::pose_curvatures(this->d_, this->u_, this->q_, line.q.first, line.d.first, line.u.first,
                           p);
    for (int row = 0; row < Model::equation_count; ++row) {
      EXPECT_EQ(rhs(row), Rational(-2) * this->residual_(row).c2) << "equation " << row;
    }
    for (int link = 0; link < Model::link_count; ++link) {
      const auto& pose = this->poses_[static_cast<std::size_t>(link)];
      EXPECT_EQ(p(link, 0), Rational(2) * pose.x.c2) << "x of link " << link;
      EXPECT_EQ(p(link, 1), Rational(2) * pose.y.c2) << "y of link " << link;
      EXPECT_EQ(p(link, 2), this->second_turning(pose.direction)) << "angle of link " << link;
    }
  }
}

}  // namespace
}  // namespace assur::test::exact_derivatives_test
