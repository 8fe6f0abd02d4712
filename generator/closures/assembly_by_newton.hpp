// Solves equations to many digits by Newton's method from many starts.
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <vector>

namespace assur::generator::closures {

/// The number of decimal digits of solutions.
inline constexpr int solution_digits = 100;

/// Solves equations, which are quotients of polynomials, for some of their symbols.
class AssemblyByNewton {
 public:
  struct Variable {
    GiNaC::symbol symbol;
    bool is_root = false;       ///< not negative
    bool is_direction = false;  ///< a cosine or sine
  };

  /// There must be at least as many variables as equations.
  AssemblyByNewton(const std::vector<GiNaC::ex>& equations, std::vector<Variable> variables);

  /// The distinct solutions found for values of all other symbols, from random starts with a fixed
  /// seed: values of the variables. Solutions at which the equations are nearly dependent are left
  /// out, so that the digits of the others are certain.
  [[nodiscard]] std::vector<GiNaC::exmap> solutions(const GiNaC::exmap& given, unsigned seed) const;
  /// The largest number in the equations, or 1: the assumed size of lengths.
  [[nodiscard]] const GiNaC::numeric& size() const { return size_; }

 private:
  /// One operation of the equations and their derivatives.
  struct Step {
    enum class Kind : unsigned char { number, symbol, sum, product, power } kind;
    std::size_t place = 0;                ///< the index of a number or of a symbol
    int exponent = 0;                     ///< of a power
    std::vector<std::size_t> operands{};  ///< earlier steps
  };
  template <typename Number>
  struct Values;

  [[nodiscard]] std::size_t step_of(const GiNaC::ex& expression);
  [[nodiscard]] std::size_t added(const GiNaC::ex& expression, Step step);
  /// Newton's step, and whether the equations are independent enough.
  template <typename Number>
  [[nodiscard]] bool correction(Values<Number>& values, std::vector<Number>& step) const;
  /// Whether Newton's method converges from these values, to about the precision of double.
  [[nodiscard]] bool converges(Values<double>& values) const;
  /// Refines the variables' values to all digits. Returns whether it succeeds.
  [[nodiscard]] bool polish(Values<GiNaC::numeric>& values) const;

  std::vector<Variable> variables_;
  GiNaC::numeric size_ = 1;
  std::size_t equation_count_;
  std::vector<GiNaC::numeric> numbers_;
  std::vector<GiNaC::ex> symbols_;  ///< the variables first
  std::vector<Step> steps_;
  std::map<GiNaC::ex, std::size_t, GiNaC::ex_is_less> known_;
  std::vector<std::size_t> equations_;  ///< as steps
  std::vector<std::size_t> slopes_;     ///< derivatives as steps, equation by equation
};

}  // namespace assur::generator::closures
