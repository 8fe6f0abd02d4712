// All complex configurations of a group: Dixon's determinant in the complex plane as an eigenvalue
// problem.
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <assur/loops/elimination.hpp>
#include <assur/loops/loop_equations.hpp>
#include <assur/loops/small_systems.hpp>
#include <cmath>
#include <type_traits>
#include <vector>

namespace assur::loops {

inline constexpr double full_turn = 6.283185307179586;  ///< radians

/// The equations of a group in which one angle is the ground and one is hidden.
template <typename Of>
class HiddenAngle {
  using Column = typename Of::ComplexClosures;
  using Square = typename Of::ComplexSquare;

 public:
  HiddenAngle(const LoopEquations<Of>& equations, int ground, int hidden)
      : equations_(equations), loops_(equations.loop_count()), ground_(ground), hidden_(hidden) {
    for (Eigen::Index slide = 0; slide < equations.slide_count(); ++slide) {
      hidden_slides_ += equations.slide_angles(slide) == hidden ? 1 : 0;
    }
  }

  /// Calls `visit(product, power, coefficient)` for the terms of a set's equation, which is
  /// determined up to a constant factor. There are none if elimination leaves no equation.
  template <typename Visit>
  void each_term(AngleSet set, const Visit& visit) const {
    if (hidden_slides_ == 0) {
      Column cofactors;
      if (cofactors_of(eliminated(set, 1), cofactors)) {
        add(set, 0, cofactors, visit);
      }
    } else if constexpr (Of::slides != 0) {
      each_term_along_hidden(set, visit);
    }
  }

 private:
  template <typename Visit>
  void each_term_along_hidden(AngleSet set, const Visit& visit) const {
    // Each displacement along the hidden angle contributes a factor x or 1/x: the polynomial is
    // interpolated from its values at roots of unity.
    const int samples = 2 * hidden_slides_ + 1;
    std::array<Column, 2 * most_slides + 1> values;
    for (int sample = 0; sample < samples; ++sample) {
      Square bordered(2 * loops_, 2 * loops_);
      bordered = eliminated(set, root_of_one(sample, samples));
      for (Eigen::Index row = 0; row < 2 * loops_; ++row) {
        bordered(row, 2 * loops_ - 1) = std::polar(1.0, static_cast<double>(row * row + 1));
      }
      const Eigen::FullPivLU<Square> factors(bordered);
      if (!factors.isInvertible()) {
        return;
      }
      values[static_cast<std::size_t>(sample)] =
          factors.determinant() * factors.inverse().row(2 * loops_ - 1).transpose();
    }
    for (int power = -hidden_slides_; power <= hidden_slides_; ++power) {
      Column sum = Column::Zero(2 * loops_);
      for (int sample = 0; sample < samples; ++sample) {
        sum += std::conj(root_of_one(sample * power, samples)) *
               values[static_cast<std::size_t>(sample)];
      }
      add(set, power, sum / samples, visit);
    }
  }

  static constexpr int most_slides = 16;

  [[nodiscard]] bool is_other(Eigen::Index angle) const {
    return angle != ground_ && angle != hidden_;
  }

  /// The columns eliminated for a set, at a value of x, and a last column of zeros.
  [[nodiscard]] Square eliminated(AngleSet set, Complex x) const {
    Square result = Square::Zero(2 * loops_, 2 * loops_);
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
      const Complex along = equations_.slide_angles(slide) == hidden_ ? x : Complex(1);
      result.col(column).head(loops_) = along * equations_.of_slides.col(slide);
      result.col(column).tail(loops_) = equations_.of_slides.col(slide).conjugate() / along;
      ++column;
    }
    return result;
  }

  /// A multiple of the cofactors of the last column of zeros, if x is not among the eliminated
  /// unknowns; false if the other columns are dependent.
  [[nodiscard]] bool cofactors_of(const Square& columns, Column& cofactors) const {
    const Eigen::Index size = columns.rows();
    ClosureSystem<Of, Complex> system(size - 1, size);
    system.put(0, columns.leftCols(size - 1).transpose());
    if (!(system.eliminate(size, size - 1) > epsilon * static_cast<double>(size))) {
      return false;
    }
    cofactors.setOnes(size);
    for (Eigen::Index column = 0; column < size; ++column) {
      if (system.row_of(column) < 0) {
        for (Eigen::Index other = 0; other < size; ++other) {
          const int row = system.row_of(other);
          cofactors(other) = row < 0 ? Complex(1) : -system.entry(row, column);
        }
      }
    }
    return true;
  }

  [[nodiscard]] static Complex root_of_one(int power, int order) {
    return std::polar(1.0, full_turn * power / order);
  }

  template <typename Visit>
  void add(AngleSet set, int power, const Column& cofactors, const Visit& visit) const {
    const auto of_loops = cofactors.head(loops_).transpose();
    const auto of_conjugates = cofactors.tail(loops_).transpose();
    for (Eigen::Index angle = 0; angle < equations_.of_angles.cols(); ++angle) {
      const auto column = equations_.of_angles.col(angle);
      if (is_other(angle)) {
        visit(set ^ bit(angle), power,
              holds(set, angle) ? Complex(of_loops * column)
                                : Complex(of_conjugates * column.conjugate()));
      } else {
        const int shift = angle == hidden_ ? 1 : 0;
        visit(set, power + shift, Complex(of_loops * column));
        visit(set, power - shift, Complex(of_conjugates * column.conjugate()));
      }
    }
  }

  const LoopEquations<Of>& equations_;
  Eigen::Index loops_;
  Eigen::Index ground_, hidden_;
  int hidden_slides_ = 0;
};

/// The polynomial matrix of an elimination about a point sigma: the Taylor coefficient of an order
/// is stored from column `order * size` on. Each row is divided by its largest term.
template <typename Of>
class PolynomialMatrix {
 public:
  using Pencil = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                               Of::eigenvalues, Of::eigenvalues>;
  /// An arbitrary point off the unit circle, on which real angles lie.
  [[nodiscard]] static Complex sigma() { return {0.37, 1.21}; }

  PolynomialMatrix(const LoopEquations<Of>& equations, const Elimination& elimination)
      : size_(elimination.size),
        degree_(elimination.degree),
        entries_(size_, size_ * (degree_ + 1)) {
    const HiddenAngle<Of> hidden(equations, elimination.ground, elimination.hidden);
    for (int row = 0; row < size_; ++row) {
      double largest = 0;
      hidden.each_term(elimination.sets[row],
                       [&](AngleSet product, int power, const Complex& coefficient) {
                         const int column = elimination.column_of(product);
                         const int of = power - elimination.lowest_powers[row];
                         if (column < size_ && of >= 0 && of <= degree_) {
                           largest = (std::max)(largest, std::abs(coefficient));
                           add(row, column, of, coefficient);
                         }
                       });
      for (int column = 0; largest > 0 && column < size_ * (degree_ + 1); ++column) {
        entries_.entry(row, column) /= largest;
      }
    }
  }

  /// Fills a zero matrix so that its eigenvalues are w = 1 / (x - sigma); false if the matrix at
  /// sigma has no inverse.
  [[nodiscard]] bool put_companion(Pencil& companion) {
    if (entries_.eliminate(size_, size_) == 0) {
      return false;
    }
    for (int row = 0; row < size_; ++row) {
      for (int column = 0; column < size_ * degree_; ++column) {
        companion(row, column) = -entries_.entry(entries_.row_of(row), size_ + column);
      }
    }
    companion.bottomLeftCorner(size_ * (degree_ - 1), size_ * (degree_ - 1)).setIdentity();
    return true;
  }

 private:
  /// Adds `coefficient` x^power: its Taylor coefficients are binomials times powers of sigma.
  void add(int row, int column, int power, Complex value) {
    double binomial = 1;
    for (int order = power; order >= 0; --order) {
      entries_.entry(row, size_ * order + column) += binomial * value;
      value *= sigma();
      binomial = binomial * order / (power - order + 1);
    }
  }

  int size_;
  int degree_;
  // size (degree + 1) is at most twice the number of eigenvalues.
  SmallSystem<Complex, Of::eigenvalues, 2 * Of::eigenvalues> entries_;
};

/// The configuration with these angles; the displacements are least-squares solutions of the loop
/// closures.
template <typename Of>
[[nodiscard]] ComplexConfiguration<Of> with_displacements(const LoopEquations<Of>& equations,
                                                          const typename Of::Directions& theta) {
  ComplexConfiguration<Of> result{theta, {}};
  result.s.setZero(equations.slide_count());
  if constexpr (Of::slides != 0) {
    if (equations.slide_count() > 0) {
      const typename Of::ComplexClosures open = closures_at(equations, result);
      const typename Of::ComplexSquare slides =
          jacobian_at(equations, result).rightCols(equations.slide_count());
      result.s = slides.colPivHouseholderQr().solve(-open);
    }
  }
  return result;
}

/// The configuration of an eigenvalue and its eigenvector: t_c is the ratio of two products.
template <typename Of, typename Kernel>
[[nodiscard]] ComplexConfiguration<Of> told_configuration(const LoopEquations<Of>& equations,
                                                          const Elimination& elimination,
                                                          const Complex& x, const Kernel& kernel) {
  typename Of::Directions theta;
  theta.setOnes(equations.of_angles.cols());
  theta(elimination.hidden) = x;
  for (Eigen::Index angle = 0; angle < theta.size(); ++angle) {
    if (angle == elimination.ground || angle == elimination.hidden) {
      continue;
    }
    double best = 0;
    for (int without = 0; without < elimination.size; ++without) {
      const AngleSet product = elimination.products[without];
      const int with =
          holds(product, angle) ? elimination.size : elimination.column_of(product | bit(angle));
      if (with == elimination.size) {
        continue;
      }
      const Complex below = kernel(without);
      const Complex above = kernel(with);
      if (const double weight = std::norm(below) * std::norm(above); weight > best) {
        best = weight;
        theta(angle) = below / above;
      }
    }
  }
  const Complex base = theta(0);
  return with_displacements<Of>(equations, theta / base);
}

/// Calls `visit(configuration)` for approximate complex configurations: all those of a group in
/// general position, and some spurious ones.
template <typename Of, typename Visit>
void each_candidate(const LoopEquations<Of>& equations, const Elimination& elimination,
                    const Visit& visit) {
  if (elimination.hidden == Elimination::none) {
    typename Of::Directions theta;
    theta.setOnes(equations.of_angles.cols());
    visit(with_displacements<Of>(equations, theta));
    return;
  }
  // About a point sigma that is no eigenvalue, w = 1 / (x - sigma) is an eigenvalue of the
  // companion matrix: those at infinity and those of a singular leading coefficient become w = 0.
  using Pencil = typename PolynomialMatrix<Of>::Pencil;
  const int size = elimination.size;
  Pencil companion = Pencil::Zero(elimination.eigenvalues(), elimination.eigenvalues());
  if (!PolynomialMatrix<Of>(equations, elimination).put_companion(companion) ||
      !companion.allFinite()) {
    return;
  }
  const Eigen::ComplexEigenSolver<Pencil> solved(companion);
  if (solved.info() != Eigen::Success) {
    return;
  }
  const auto& w = solved.eigenvalues();
  const auto kernel = [&](Eigen::Index index) {
    return solved.eigenvectors().col(index).head(size);
  };
  const auto x_of = [&](Eigen::Index index) {
    return PolynomialMatrix<Of>::sigma() + 1.0 / Complex(w(index));
  };
  const auto tell = [&](const Complex& x, const auto& of) {
    const ComplexConfiguration<Of> told = told_configuration<Of>(equations, elimination, x, of);
    if (told.theta.allFinite() && told.s.allFinite()) {
      visit(told);
    }
  };
  // Eigenvalues that differ by less than the square root of epsilon may coincide.
  const double one_x = std::sqrt(epsilon);
  for (Eigen::Index index = 0; index < w.size(); ++index) {
    if (w(index) == Complex(0)) {
      continue;
    }
    const Complex x = x_of(index);
    tell(x, kernel(index));
    // Two configurations with the same x share a null space of dimension two, in which they cannot
    // be distinguished: Newton's method starts from several points of it.
    for (Eigen::Index other = index + 1; other < w.size(); ++other) {
      if (w(other) != Complex(0) && std::abs(x_of(other) - x) < one_x * std::abs(x)) {
        constexpr int places = 8;
        for (int place = 0; place < places; ++place) {
          tell(x, kernel(index) + std::polar(1.0, full_turn * place / places) * kernel(other));
        }
      }
    }
  }
}

}  // namespace assur::loops
