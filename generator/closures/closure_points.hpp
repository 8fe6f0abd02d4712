// Points of a closure system, rational if possible, assembled or not, and values there.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "closures/assembly_by_lengths.hpp"
#include "closures/assembly_by_newton.hpp"
#include "closures/closure_system.hpp"

namespace assur::generator::closures {

/// The number of computed points for one comparison: enough to reach all branches.
inline constexpr std::size_t computed_points = 40;
/// The name of such points in reports.
inline const std::string computed_sort = "points of " + std::to_string(solution_digits) + " digits";

/// The points of a system. They are drawn again when the system changes.
class ClosurePoints {
 public:
  /// A configuration: values of lengths, of cosines and sines, of rates and, once requested, of
  /// derivatives.
  struct Point {
    GiNaC::exmap values;
    GiNaC::matrix inverse_jacobian;  ///< empty unless the closures hold
    bool is_computed = false;        ///< decimals of many digits, not rationals
  };

  explicit ClosurePoints(ClosureSystem& system) : system_(system) {}

  [[nodiscard]] ClosureSystem& system() { return system_; }

  /// The points of comparisons, one after the other, drawn by fixed seeds; the closures hold there
  /// if `assembled`. Returns nullptr after the last. Where no rational points are assembled, as for
  /// fixed or equal lengths, the closures are solved for the unknowns, on all branches, to
  /// `solution_digits` digits; also where closures contain roots, since points with rational roots
  /// are special: their triangles have right angles or equal sides.
  [[nodiscard]] Point* point(std::size_t index, bool assembled);
  /// The point with these values of all symbols, except for some lengths, which are changed so that
  /// the closures hold; empty if they cannot hold.
  [[nodiscard]] std::optional<Point> assembled_from(const GiNaC::exmap& values);
  /// The symbols of an angle's cosine and sine in a point's values.
  [[nodiscard]] equations::Vector2 direction(const GiNaC::symbol& angle);

  /// An expression with roots that are not in the closures and whose signs matter.
  struct Rooted {
    CircleAlgebra algebra;  ///< of the closures, and then of the expression
    GiNaC::ex whole;        ///< without abbreviations
    GiNaC::ex form;         ///< algebraic
    std::size_t first_own;  ///< the number of the expression's first own root
  };

  /// Empty for an expression without roots of its own. Throws NotAlgebraic.
  [[nodiscard]] std::optional<Rooted> rooted(const GiNaC::ex& expression);
  /// Points for such an expression in all quadrants of its angles. Lengths are positive, but
  /// unknown ones and coordinates take either sign. The points are computed ones if there are no
  /// rational ones.
  [[nodiscard]] std::deque<Point> points_on_all_branches(const Rooted& rooted, bool assembled);
  /// The value of the form, with some of its roots negative; throws NotAlgebraic.
  [[nodiscard]] GiNaC::ex value(const Rooted& rooted, Point& point, unsigned reversed = 0);
  /// A quantity whose sign may distinguish branches.
  struct Telling {
    std::string text;
    std::optional<GiNaC::ex> quantity;  ///< empty: the determinant of the Jacobian
  };
  /// Such quantities, those of the expression first: cosines and sines of angles, lengths,
  /// derivatives; cosines and sines of sums and differences of angles, and their products;
  /// differences and sums of lengths.
  [[nodiscard]] std::vector<Telling> telling(const GiNaC::ex& expression) const;
  [[nodiscard]] Telling determinant() const;
  /// Whether the Jacobian is singular wherever such a quantity vanishes, so that its sign
  /// distinguishes assembly modes.
  [[nodiscard]] bool is_singular_with(const Telling& telling);
  /// The sign of such a quantity at a point; 0 also if it has no value.
  [[nodiscard]] int sign(const Telling& telling, Point& point);

  /// `a3 = 7/10, (cos, sin)(phi1) = (3/5, 4/5), rate(phi1) = 2, rate(x) = 1/2`: the symbols in the
  /// expressions, and all on which their derivatives depend; also those of the closures, if the
  /// expressions are compared where the closures hold.
  [[nodiscard]] std::string point_text(const Point& point, const std::vector<GiNaC::ex>& shown,
                                       bool assembled);
  /// The value of the expression's algebraic form; throws NotAlgebraic.
  [[nodiscard]] GiNaC::ex value(const GiNaC::ex& expression, Point& point);
  /// Why the expression has no algebraic form; empty if it has one.
  [[nodiscard]] std::optional<std::string> obstacle(const GiNaC::ex& expression);
  /// Whether the expression's algebraic form is zero; throws NotAlgebraic.
  [[nodiscard]] bool vanishes(const GiNaC::ex& expression);

  /// Solved configurations of some draws, on all branches. Rational points may all lie on one
  /// factor of closures that factor. Empty if the closures cannot be solved.
  [[nodiscard]] std::deque<Point>& points_of_all_factors();

 private:
  struct PointList {
    std::deque<Point> drawn;
    unsigned next_seed = 1;
    bool different_lengths = true;  ///< required of points drawn from now on
    unsigned next_solved = 1;       ///< the seed of the next parameters to solve for
  };

  void follow_system();
  [[nodiscard]] GiNaC::ex algebraic(const GiNaC::ex& expression);
  [[nodiscard]] std::optional<Point> draw(unsigned seed, bool assembled, bool different_lengths);
  [[nodiscard]] GiNaC::exmap random_values(unsigned seed) const;
  /// The configurations for random values of the parameters.
  [[nodiscard]] std::vector<Point> solved_points(unsigned seed);
  [[nodiscard]] AssemblyByNewton newton();
  [[nodiscard]] std::deque<Point> rational_points_on_all_branches(const Rooted& rooted,
                                                                  bool assembled);
  /// Whether a length is zero, or equal to another one if they must differ: with all lengths zero
  /// everything closes, and some statements hold only for equal lengths.
  [[nodiscard]] bool is_special(const GiNaC::exmap& values, bool different_lengths) const;
  /// Whether a length may be negative: it is unknown, or a coordinate.
  [[nodiscard]] bool takes_either_sign(const AuditSymbol& symbol);
  void solve_for(const GiNaC::ex& whole, Point& point);
  /// The symbols in expressions, in the closures if they hold, and in the equations of derivatives.
  [[nodiscard]] GiNaC::exset needed_symbols(const std::vector<GiNaC::ex>& shown, bool assembled);
  [[nodiscard]] bool assemble(GiNaC::exmap& values);
  /// Empty unless there are as many closures as unknowns.
  [[nodiscard]] std::optional<GiNaC::matrix> jacobian(const Point& point);
  void invert_jacobian(Point& point);
  /// Changes an angle or length so that the quantity vanishes; false for a quantity other than an
  /// angle, one of two angles, or a length.
  [[nodiscard]] bool make_zero(const GiNaC::ex& quantity, GiNaC::exmap& values) const;
  void solve(const ClosureDerivative& derivative, Point& point);
  /// r in the equations J x + r = 0 of a derivative x.
  [[nodiscard]] const std::vector<GiNaC::ex>& open_parts(const ClosureDerivative& derivative);
  [[nodiscard]] GiNaC::matrix values_of(const std::vector<GiNaC::ex>& expressions,
                                        const Point& point);
  /// The value of an algebraic form: a decimal at a computed point.
  [[nodiscard]] static GiNaC::ex value_of_form(const CircleAlgebra& algebra, const GiNaC::ex& form,
                                               const Point& point, unsigned reversed = 0);

  ClosureSystem& system_;
  bool closures_are_algebraic_ = true;                                     ///< in this revision
  bool closures_are_rational_ = true;                                      ///< without roots
  std::optional<AssemblyByLengths> assembly_;                              ///< of this revision
  std::optional<AssemblyByNewton> newton_;                                 ///< of this revision
  std::map<const ClosureDerivative*, std::vector<GiNaC::ex>> open_parts_;  ///< of this revision
  CircleAlgebra algebra_;
  unsigned rates_drawn_ = 0;  ///< number of rates of third or higher order that have a value
  std::optional<std::deque<Point>> of_all_factors_;
  unsigned revision_ = 0;            ///< of the system that the points belong to
  std::size_t angles_ = 0;           ///< number of the system's symbols in the algebra
  std::map<bool, PointList> lists_;  ///< by `assembled`
};

}  // namespace assur::generator::closures
