#include "groups/elimination.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace assur::mechanism::groups {

namespace {

/// The coefficients of one equation: for each product of reciprocal directions the powers of x.
using Row = std::map<AngleSet, std::map<int, Complex>>;

[[nodiscard]] AngleSet bit(Eigen::Index angle) { return AngleSet(1) << angle; }
[[nodiscard]] bool holds(AngleSet set, Eigen::Index angle) { return (set & bit(angle)) != 0; }

/// The equations of a group in which one angle is the ground and one is hidden.
class HiddenAngle {
 public:
  HiddenAngle(const LoopEquations& equations, int ground, int hidden)
      : equations_(equations), loops_(equations.loop_count()), ground_(ground), hidden_(hidden) {
    for (std::size_t slide = 0; slide < equations.slide_angles.size(); ++slide) {
      hidden_slides_ += equations.slide_angles[slide] == hidden ? 1 : 0;
    }
  }

  /// The equation of a set of angles, up to a constant factor; empty where all is eliminated
  /// without an equation being left.
  [[nodiscard]] Row row_of(AngleSet set) const {
    Row row;
    for (const auto& [power, cofactors] : cofactors_of(set)) {
      add(set, power, cofactors, row);
    }
    return row;
  }

 private:
  using Cofactors = std::map<int, Eigen::VectorXcd>;  ///< by powers of x

  [[nodiscard]] bool is_other(Eigen::Index angle) const {
    return angle != ground_ && angle != hidden_;
  }

  /// The columns that are eliminated for a set, where x has a value.
  [[nodiscard]] Eigen::MatrixXcd eliminated(AngleSet set, Complex x) const {
    Eigen::MatrixXcd result = Eigen::MatrixXcd::Zero(2 * loops_, 2 * loops_ - 1);
    Eigen::Index column = 0;
    for (Eigen::Index angle = 0; angle < equations_.of_angles.cols(); ++angle) {
      if (!is_other(angle)) {
        continue;
      }
      if (holds(set, angle)) {
        result.col(column).tail(loops_) = equations_.of_angles.col(angle).conjugate();
      } else {
        result.col(column).head(loops_) = equations_.of_angles.col(angle);
      }
      ++column;
    }
    for (Eigen::Index slide = 0; slide < equations_.slide_count(); ++slide) {
      const Complex along =
          equations_.slide_angles[static_cast<std::size_t>(slide)] == hidden_ ? x : Complex(1);
      result.col(column).head(loops_) = along * equations_.of_slides.col(slide);
      result.col(column).tail(loops_) = equations_.of_slides.col(slide).conjugate() / along;
      ++column;
    }
    return result;
  }

  /// The cofactors of a further column, as a polynomial in x and 1/x. Where x is not among what is
  /// eliminated, any multiple of them serves.
  [[nodiscard]] Cofactors cofactors_of(AngleSet set) const {
    if (hidden_slides_ == 0) {
      const Eigen::ColPivHouseholderQR<Eigen::MatrixXcd> factors(eliminated(set, 1));
      if (factors.rank() < 2 * loops_ - 1) {
        return {};
      }
      const Eigen::MatrixXcd q = factors.householderQ();
      return {{0, q.col(2 * loops_ - 1).conjugate()}};
    }
    // Each displacement along the hidden angle brings a factor x or 1/x: the polynomial follows
    // from its values at roots of one.
    const int samples = 2 * hidden_slides_ + 1;
    std::vector<Eigen::VectorXcd> values;
    for (int sample = 0; sample < samples; ++sample) {
      Eigen::MatrixXcd bordered(2 * loops_, 2 * loops_);
      bordered.leftCols(2 * loops_ - 1) = eliminated(set, root_of_one(sample, samples));
      for (Eigen::Index row = 0; row < 2 * loops_; ++row) {
        bordered(row, 2 * loops_ - 1) = std::polar(1.0, static_cast<double>(row * row + 1));
      }
      const Eigen::FullPivLU<Eigen::MatrixXcd> factors(bordered);
      if (!factors.isInvertible()) {
        return {};
      }
      values.emplace_back(factors.determinant() *
                          factors.inverse().row(2 * loops_ - 1).transpose());
    }
    Cofactors result;
    for (int power = -hidden_slides_; power <= hidden_slides_; ++power) {
      Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(2 * loops_);
      for (int sample = 0; sample < samples; ++sample) {
        sum += std::conj(root_of_one(sample * power, samples)) *
               values[static_cast<std::size_t>(sample)];
      }
      result[power] = sum / samples;
    }
    return result;
  }

  [[nodiscard]] static Complex root_of_one(int power, int order) {
    return std::polar(1.0, 2 * std::numbers::pi * power / order);
  }

  void add(AngleSet set, int power, const Eigen::VectorXcd& cofactors, Row& row) const {
    const auto of_loops = cofactors.head(loops_).transpose();
    const auto of_conjugates = cofactors.tail(loops_).transpose();
    for (Eigen::Index angle = 0; angle < equations_.of_angles.cols(); ++angle) {
      const Eigen::VectorXcd column = equations_.of_angles.col(angle);
      if (is_other(angle)) {
        row[set ^ bit(angle)][power] += holds(set, angle)
                                            ? Complex(of_loops * column)
                                            : Complex(of_conjugates * column.conjugate());
      } else {
        const int shift = angle == hidden_ ? 1 : 0;
        row[set][power + shift] += Complex(of_loops * column);
        row[set][power - shift] += Complex(of_conjugates * column.conjugate());
      }
    }
  }

  const LoopEquations& equations_;
  Eigen::Index loops_;
  Eigen::Index ground_, hidden_;
  int hidden_slides_ = 0;
};

/// The largest coefficient of a row.
double largest(const Row& row) {
  double result = 0;
  for (const auto& [product, powers] : row) {
    for (const auto& [power, value] : powers) {
      result = std::max(result, std::abs(value));
    }
  }
  return result;
}

/// In general position a coefficient of a row that is smaller than this part of the largest one is
/// zero by structure, but for rounding.
constexpr double structural_zero = 1e-9;

/// Eigenvalues that differ by less than the root of a rounding may be one.
const double one_x = std::sqrt(epsilon);
constexpr int places_of_kernel = 8;

/// The elimination with a ground and a hidden angle; without rows where it is of no use.
Elimination elimination_with(const LoopEquations& general, int ground, int hidden) {
  Elimination result{ground, hidden, {}, {}, {}, 0};
  const HiddenAngle equations(general, ground, hidden);
  AngleSet others = 0;
  for (int angle = 0; angle <= general.angle_count(); ++angle) {
    others |= angle == ground || angle == hidden ? 0 : bit(angle);
  }
  std::vector<AngleSet> products;
  for (AngleSet set = others;; set = (set - 1) & others) {
    const Row row = equations.row_of(set);
    const double size = largest(row);
    int lowest = 0;
    int highest = 0;
    bool is_first = true;
    for (const auto& [product, powers] : row) {
      bool is_used = false;
      for (const auto& [power, value] : powers) {
        if (std::abs(value) > structural_zero * size) {
          lowest = is_first ? power : std::min(lowest, power);
          highest = is_first ? power : std::max(highest, power);
          is_first = false;
          is_used = true;
        }
      }
      if (is_used) {
        products.push_back(product);
      }
    }
    if (!is_first) {
      result.sets.push_back(set);
      result.lowest_powers.push_back(lowest);
      result.degree = std::max(result.degree, highest - lowest);
    }
    if (set == 0) {
      break;
    }
  }
  std::ranges::sort(products);
  products.erase(std::ranges::unique(products).begin(), products.end());
  result.products = products;
  return result;
}

/// The polynomial matrix of an elimination, by the powers of x.
std::vector<Eigen::MatrixXcd> matrices_of(const LoopEquations& equations,
                                          const Elimination& elimination) {
  const HiddenAngle hidden(equations, elimination.ground, elimination.hidden);
  const auto rows = static_cast<Eigen::Index>(elimination.sets.size());
  const auto columns = static_cast<Eigen::Index>(elimination.products.size());
  std::vector<Eigen::MatrixXcd> result(static_cast<std::size_t>(elimination.degree) + 1,
                                       Eigen::MatrixXcd::Zero(rows, columns));
  for (Eigen::Index index = 0; index < rows; ++index) {
    const auto place = static_cast<std::size_t>(index);
    const Row row = hidden.row_of(elimination.sets[place]);
    const double size = largest(row);
    for (const auto& [product, powers] : row) {
      const auto column = std::ranges::lower_bound(elimination.products, product);
      for (const auto& [power, value] : powers) {
        const int of = power - elimination.lowest_powers[place];
        if (column != elimination.products.end() && *column == product && of >= 0 &&
            of <= elimination.degree) {
          result[static_cast<std::size_t>(of)](index, column - elimination.products.begin()) =
              value / size;
        }
      }
    }
  }
  return result;
}

double binomial(int n, int k) {
  double result = 1;
  for (int factor = 1; factor <= k; ++factor) {
    result = result * (n - k + factor) / factor;
  }
  return result;
}

/// The eigenvalues x of a polynomial matrix, each with its kernel. About a point sigma that is no
/// eigenvalue, w = 1 / (x - sigma) is an eigenvalue of the companion matrix: those at infinity and
/// those of a singular leading coefficient become w = 0.
struct Eigenpairs {
  std::vector<Complex> x;
  std::vector<Eigen::VectorXcd> kernels;
};

Eigenpairs eigenpairs_of(const std::vector<Eigen::MatrixXcd>& matrices) {
  const Complex sigma(0.37, 1.21);  // any point off the unit circle, on which real angles lie
  const auto degree = static_cast<int>(matrices.size()) - 1;
  const Eigen::Index size = matrices.front().rows();
  std::vector<Eigen::MatrixXcd> about;  // the Taylor coefficients at sigma
  for (int order = 0; order <= degree; ++order) {
    Eigen::MatrixXcd sum = Eigen::MatrixXcd::Zero(size, size);
    for (int power = order; power <= degree; ++power) {
      sum += binomial(power, order) * std::pow(sigma, power - order) *
             matrices[static_cast<std::size_t>(power)];
    }
    about.push_back(sum);
  }
  const Eigen::PartialPivLU<Eigen::MatrixXcd> factors(about.front());
  Eigen::MatrixXcd companion = Eigen::MatrixXcd::Zero(size * degree, size * degree);
  for (int order = 1; order <= degree; ++order) {
    companion.block(0, size * (order - 1), size, size) =
        -factors.solve(about[static_cast<std::size_t>(order)]);
  }
  companion.bottomLeftCorner(size * (degree - 1), size * (degree - 1)).setIdentity();
  Eigenpairs result;
  if (!companion.allFinite()) {
    return result;
  }
  const Eigen::ComplexEigenSolver<Eigen::MatrixXcd> solved(companion);
  if (solved.info() != Eigen::Success) {
    return result;
  }
  for (Eigen::Index index = 0; index < companion.rows(); ++index) {
    const Complex w = solved.eigenvalues()(index);
    if (w != Complex(0)) {
      result.x.push_back(sigma + 1.0 / w);
      result.kernels.emplace_back(solved.eigenvectors().col(index).head(size));
    }
  }
  return result;
}

/// The configuration with these angles; the displacements close the loops as well as they can.
ComplexConfiguration with_displacements(const LoopEquations& equations, Eigen::VectorXcd theta) {
  ComplexConfiguration result{std::move(theta), Eigen::VectorXcd::Zero(equations.slide_count())};
  if (equations.slide_count() > 0) {
    const Eigen::VectorXcd open = closures_at(equations, result);
    const Eigen::MatrixXcd slides =
        jacobian_at(equations, result).rightCols(equations.slide_count());
    result.s = slides.colPivHouseholderQr().solve(-open);
  }
  return result;
}

/// The configuration that an eigenvalue and its kernel tell: t_c is the ratio of two products.
ComplexConfiguration told_configuration(const LoopEquations& equations,
                                        const Elimination& elimination, Complex x,
                                        const Eigen::VectorXcd& kernel) {
  Eigen::VectorXcd theta = Eigen::VectorXcd::Ones(equations.of_angles.cols());
  theta(elimination.hidden) = x;
  const std::vector<AngleSet>& products = elimination.products;
  for (Eigen::Index angle = 0; angle < theta.size(); ++angle) {
    if (angle == elimination.ground || angle == elimination.hidden) {
      continue;
    }
    double best = 0;
    for (std::size_t without = 0; without < products.size(); ++without) {
      const auto with = std::ranges::lower_bound(products, products[without] | bit(angle));
      if (holds(products[without], angle) || with == products.end() ||
          *with != (products[without] | bit(angle))) {
        continue;
      }
      const Complex below = kernel(static_cast<Eigen::Index>(without));
      const Complex above = kernel(with - products.begin());
      if (const double weight = std::abs(below) * std::abs(above); weight > best) {
        best = weight;
        theta(angle) = below / above;
      }
    }
  }
  return with_displacements(equations, theta / Complex(theta(0)));
}

}  // namespace

std::vector<Elimination> eliminations_of(const LoopEquations& general) {
  if (general.angle_count() == 0) {
    return {{0, Elimination::none, {}, {}, {}, 0}};
  }
  std::vector<Elimination> result;
  for (int ground = 0; ground <= general.angle_count(); ++ground) {
    for (int hidden = 0; hidden <= general.angle_count(); ++hidden) {
      const bool runs = std::ranges::all_of(
          general.slide_angles, [&](int angle) { return angle == ground || angle == hidden; });
      if (hidden == ground || !runs) {
        continue;
      }
      Elimination elimination = elimination_with(general, ground, hidden);
      if (!elimination.sets.empty() && elimination.sets.size() == elimination.products.size() &&
          elimination.degree > 0) {
        result.push_back(std::move(elimination));
      }
    }
  }
  std::ranges::stable_sort(result, {}, [](const Elimination& one) {
    return one.sets.size() * static_cast<std::size_t>(one.degree);
  });
  return result;
}

std::vector<ComplexConfiguration> candidates(const LoopEquations& equations,
                                             const Elimination& elimination) {
  if (elimination.hidden == Elimination::none) {
    return {with_displacements(equations, Eigen::VectorXcd::Ones(1))};
  }
  std::vector<ComplexConfiguration> result;
  const Eigenpairs pairs = eigenpairs_of(matrices_of(equations, elimination));
  const auto add = [&](Complex x, const Eigen::VectorXcd& kernel) {
    ComplexConfiguration told = told_configuration(equations, elimination, x, kernel);
    if (told.theta.allFinite() && told.s.allFinite()) {
      result.push_back(std::move(told));
    }
  };
  for (std::size_t index = 0; index < pairs.x.size(); ++index) {
    add(pairs.x[index], pairs.kernels[index]);
    // Two configurations with one x have a kernel of two dimensions, which does not tell them
    // apart: Newton's method begins in several places of it.
    for (std::size_t other = index + 1; other < pairs.x.size(); ++other) {
      if (std::abs(pairs.x[other] - pairs.x[index]) < one_x * std::abs(pairs.x[index])) {
        for (int place = 0; place < places_of_kernel; ++place) {
          add(pairs.x[index], pairs.kernels[index] +
                                  std::polar(1.0, 2 * std::numbers::pi * place / places_of_kernel) *
                                      pairs.kernels[other]);
        }
      }
    }
  }
  return result;
}

}  // namespace assur::mechanism::groups
