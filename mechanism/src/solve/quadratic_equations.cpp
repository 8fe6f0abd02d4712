#include "quadratic_equations.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace assur::mechanism::solve {

namespace {

/// The largest relative residual of a root in equations that did not determine it.
constexpr double agreement = 1e-6;

/// As many combinations of the equations as there are unknowns. The factors are unrelated to the
/// equations, so that further common roots arise by chance only.
QuadraticEquations combined(const QuadraticEquations& from, const std::vector<Eigen::Index>& rows) {
  const Eigen::Index unknowns = from.unknowns();
  const auto count = static_cast<Eigen::Index>(rows.size());
  QuadraticEquations result{
      {}, Eigen::MatrixXd::Zero(unknowns, unknowns), Eigen::VectorXd::Zero(unknowns)};
  for (Eigen::Index index = 0; index < unknowns; ++index) {
    Eigen::MatrixXd square = Eigen::MatrixXd::Zero(unknowns, unknowns);
    for (Eigen::Index place = 0; place < count; ++place) {
      const Eigen::Index row = rows[static_cast<std::size_t>(place)];
      const double weight = count == unknowns
                                ? (place == index ? 1.0 : 0.0)
                                : std::cos(static_cast<double>(1 + place + count * index));
      square += weight * from.square[static_cast<std::size_t>(row)];
      result.linear.row(index) += weight * from.linear.row(row);
      result.constant(index) += weight * from.constant(row);
    }
    result.square.push_back(square);
  }
  return result;
}

/// The roots of a x^2 + b x + c.
std::vector<double> roots_of(double a, double b, double c, double noise) {
  const double size = std::max({std::abs(a), std::abs(b), std::abs(c)});
  if (std::abs(a) <= noise * size) {
    return std::abs(b) > noise * size ? std::vector{0.0 - c / b} : std::vector<double>{};
  }
  const double discriminant = b * b - 4 * a * c;
  if (std::abs(discriminant) <= noise * (2 * std::abs(b) + 4 * (std::abs(a) + std::abs(c)))) {
    return {0.0 - b / (2 * a)};
  }
  if (discriminant < 0) {
    return {};
  }
  // The first root adds magnitudes and so loses no digits; the other follows from the product of
  // both.
  const double far = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  return {far / a, c / far};
}

/// A polynomial of degree four at most, by rising powers.
using Quartic = std::array<double, 5>;

std::vector<std::complex<double>> roots_of(const Quartic& polynomial) {
  constexpr double vanishing = 1e-12;
  double size = 0;
  for (const double coefficient : polynomial) {
    size = std::max(size, std::abs(coefficient));
  }
  Eigen::Index degree = 4;
  while (degree > 0 && std::abs(polynomial[static_cast<std::size_t>(degree)]) <= vanishing * size) {
    --degree;
  }
  if (degree == 0) {
    return {};
  }
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(degree, degree);
  for (Eigen::Index row = 0; row < degree; ++row) {
    companion(row, degree - 1) =
        -polynomial[static_cast<std::size_t>(row)] / polynomial[static_cast<std::size_t>(degree)];
    if (row > 0) {
      companion(row, row - 1) = 1;
    }
  }
  const Eigen::VectorXcd values = companion.eigenvalues();
  return {values.begin(), values.end()};
}

/// The two equations as polynomials in the second unknown, whose coefficients are polynomials in
/// the first: a y^2 + (b0 + b1 x) y + c0 + c1 x + c2 x^2.
struct InSecond {
  double a, b0, b1, c0, c1, c2;

  [[nodiscard]] double b(double x) const { return b0 + b1 * x; }
  [[nodiscard]] double c(double x) const { return c0 + x * (c1 + x * c2); }
};

/// The real roots of two equations in two unknowns, from their resultant
/// (a1 c2 - a2 c1)^2 - (a1 b2 - a2 b1)(b1 c2 - b2 c1), a polynomial in the first unknown.
std::vector<Eigen::VectorXd> roots_of_two(const QuadraticEquations& equations) {
  // The unknowns are rotated by an angle unrelated to the equations, so that two roots share the
  // first unknown by chance only.
  const double cosine = std::cos(0.6);
  const double sine = std::sin(0.6);
  Eigen::Matrix2d turn;
  turn << cosine, -sine, sine, cosine;
  std::array<InSecond, 2> of{};
  for (std::size_t row = 0; row < 2; ++row) {
    const Eigen::Matrix2d square = turn.transpose() * equations.square[row] * turn;
    const Eigen::RowVector2d linear = equations.linear.row(static_cast<Eigen::Index>(row)) * turn;
    of[row] = {square(1, 1),     linear(1),
               2 * square(0, 1), equations.constant(static_cast<Eigen::Index>(row)),
               linear(0),        square(0, 0)};
  }
  const auto& [one, two] = of;
  const std::array<double, 3> ac{one.a * two.c0 - two.a * one.c0, one.a * two.c1 - two.a * one.c1,
                                 one.a * two.c2 - two.a * one.c2};
  const std::array<double, 2> ab{one.a * two.b0 - two.a * one.b0, one.a * two.b1 - two.a * one.b1};
  const std::array<double, 4> bc{
      one.b0 * two.c0 - two.b0 * one.c0,
      one.b0 * two.c1 + one.b1 * two.c0 - two.b0 * one.c1 - two.b1 * one.c0,
      one.b0 * two.c2 + one.b1 * two.c1 - two.b0 * one.c2 - two.b1 * one.c1,
      one.b1 * two.c2 - two.b1 * one.c2};
  Quartic resultant{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      resultant[i + j] += ac[i] * ac[j];
    }
  }
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      resultant[i + j] -= ab[i] * bc[j];
    }
  }
  std::vector<std::complex<double>> first = roots_of(resultant);
  // A double root appears as two whose difference is the square root of a rounding error; their
  // mean is as accurate as a simple root.
  constexpr double apart = 1e-4;
  std::vector<Eigen::VectorXd> result;
  for (std::size_t index = 0; index < first.size(); ++index) {
    std::complex<double> sum = 0;
    int count = 0;
    bool is_new = true;
    for (std::size_t other = 0; other < first.size(); ++other) {
      if (std::abs(first[other] - first[index]) <= apart * (1 + std::abs(first[index]))) {
        is_new = is_new && other >= index;
        sum += first[other];
        ++count;
      }
    }
    const std::complex<double> mean = sum / static_cast<double>(count);
    if (!is_new || std::abs(mean.imag()) > agreement * (1 + std::abs(mean))) {
      continue;
    }
    const double x = mean.real();
    const double y = -(one.a * two.c(x) - two.a * one.c(x)) / (one.a * two.b(x) - two.a * one.b(x));
    result.emplace_back(turn * Eigen::Vector2d(x, y));
  }
  return result;
}

/// Corrects a simple root by Newton steps.
void polish(const QuadraticEquations& equations, Eigen::VectorXd& root) {
  constexpr int steps = 3;
  constexpr double least_firmness = 1e-4;
  for (int time = 0; time < steps; ++time) {
    const Eigen::FullPivLU<Eigen::MatrixXd> factors(equations.derivative(root));
    if (factors.rcond() < least_firmness) {
      return;
    }
    root -= factors.solve(equations.at(root));
  }
}

}  // namespace

Eigen::VectorXd QuadraticEquations::at(const Eigen::VectorXd& x) const {
  Eigen::VectorXd result = constant + linear * x;
  for (Eigen::Index row = 0; row < count(); ++row) {
    result(row) += x.dot(square[static_cast<std::size_t>(row)] * x);
  }
  return result;
}

Eigen::MatrixXd QuadraticEquations::derivative(const Eigen::VectorXd& x) const {
  Eigen::MatrixXd result = linear;
  for (Eigen::Index row = 0; row < count(); ++row) {
    result.row(row) += 2 * (square[static_cast<std::size_t>(row)] * x).transpose();
  }
  return result;
}

QuadraticEquations QuadraticEquations::of(const std::vector<Eigen::Index>& equations,
                                          const Eigen::VectorXd& known,
                                          Eigen::Index unknowns) const {
  const Eigen::Index first = known.size();
  const auto rows = static_cast<Eigen::Index>(equations.size());
  QuadraticEquations result{{}, Eigen::MatrixXd(rows, unknowns), Eigen::VectorXd(rows)};
  for (Eigen::Index row = 0; row < rows; ++row) {
    const Eigen::Index from = equations[static_cast<std::size_t>(row)];
    const Eigen::MatrixXd& whole = square[static_cast<std::size_t>(from)];
    result.square.emplace_back(whole.block(first, first, unknowns, unknowns));
    result.linear.row(row) = linear.row(from).segment(first, unknowns) +
                             2 * (whole.block(first, 0, unknowns, first) * known).transpose();
    result.constant(row) = constant(from) + linear.row(from).head(first).dot(known) +
                           known.dot(whole.topLeftCorner(first, first) * known);
  }
  return result;
}

std::optional<std::vector<Eigen::VectorXd>> common_roots(const QuadraticEquations& equations,
                                                         double noise) {
  const Eigen::Index unknowns = equations.unknowns();
  Eigen::VectorXd sizes(equations.count());
  std::vector<Eigen::Index> telling;
  for (Eigen::Index row = 0; row < equations.count(); ++row) {
    sizes(row) = std::max({equations.square[static_cast<std::size_t>(row)].cwiseAbs().maxCoeff(),
                           equations.linear.row(row).cwiseAbs().maxCoeff(),
                           std::abs(equations.constant(row))});
    if (sizes(row) > noise) {
      telling.push_back(row);
    }
  }
  if (std::ssize(telling) < unknowns || unknowns > 2) {
    return std::nullopt;
  }
  const QuadraticEquations used = combined(equations, telling);
  std::vector<Eigen::VectorXd> found;
  if (unknowns == 1) {
    for (const double root :
         roots_of(used.square.front()(0, 0), used.linear(0, 0), used.constant(0), noise)) {
      found.emplace_back(Eigen::VectorXd::Constant(1, root));
    }
  } else if (used.linear.cwiseAbs().maxCoeff() <= noise &&
             used.constant.cwiseAbs().maxCoeff() <= noise) {
    found.emplace_back(Eigen::VectorXd::Zero(unknowns));  // a root of fourth order
  } else {
    found = roots_of_two(used);
    std::ranges::for_each(found, [&](Eigen::VectorXd& root) { polish(used, root); });
  }
  std::erase_if(found, [&](const Eigen::VectorXd& root) {
    const Eigen::VectorXd left = equations.at(root);
    const double reach = std::max(1.0, root.squaredNorm());
    return !std::ranges::all_of(telling, [&](Eigen::Index row) {
      return std::abs(left(row)) <= agreement * sizes(row) * reach;
    });
  });
  return found;
}

}  // namespace assur::mechanism::solve
