// What the result of a program is compared with at points, entry by entry, and within which bound.
#pragma once

#include "audit/asked_points.hpp"

namespace assur::generator::audit {

/// The arithmetic of a program.
struct Precision {
  double unit;          ///< half a unit in the last place of 1
  double other_orders;  ///< by which another order of operations may exceed a bound on rounding
  double blurred;       ///< a larger relative error by rounding makes a point useless
};
inline constexpr Precision in_double{0x1p-53, 4096, 1e-6};
inline constexpr Precision in_single{0x1p-24, 64, 1e-2};

struct ExpectedValue {
  double value = 0;
  std::optional<double> tolerance;  ///< nothing where the value cannot be told closely enough
  std::string obstacle{};           ///< why the entry has no value at any point, if so
  bool exists = true;               ///< whether there is a value at the point at all
};

/// A quantity that a program is given: a symbol, or its rate of the first or second order.
struct GivenQuantity {
  std::string name;
  const closures::AuditSymbol* of;
  int order;
  GiNaC::symbol symbol;
};
[[nodiscard]] std::vector<GivenQuantity> given_quantities(const closures::ClosureSystem& system,
                                                          const AskedPoints& drawing);

class RunReference {
 public:
  RunReference() = default;
  RunReference(const RunReference&) = delete;
  RunReference& operator=(const RunReference&) = delete;
  virtual ~RunReference() = default;

  /// What the points have to provide values for.
  [[nodiscard]] virtual const ExpectedMatrix& drawn() const = 0;
  /// The expressions of the entries, without abbreviations, in symbols that have values at points
  /// once `at` was called for them.
  [[nodiscard]] virtual const std::vector<GiNaC::ex>& expressions() const = 0;
  /// The same as a report shows them.
  [[nodiscard]] virtual std::string text(std::size_t entry) const = 0;
  /// Whether an entry is an angle, so that whole turns do not count.
  [[nodiscard]] virtual bool is_angle(std::size_t entry) const = 0;
  /// The values of all entries at each point of a list.
  [[nodiscard]] virtual std::vector<std::vector<ExpectedValue>> at(std::vector<Asked>& list,
                                                                   AskedPoints& drawing,
                                                                   const Precision& precision) = 0;
  /// How the values were found, for a report; empty if by the derivation.
  [[nodiscard]] virtual std::string remark() const { return ""; }
  /// By how much of its error bound a guess at a slip may be off.
  [[nodiscard]] virtual double slack(const Precision& precision) const = 0;
};

/// What is derived from the closures.
class DerivedReference : public RunReference {
 public:
  DerivedReference(closures::ClosurePoints& points, const ExpectedMatrix& expected,
                   double rounding);

  [[nodiscard]] const ExpectedMatrix& drawn() const override { return drawn_; }
  [[nodiscard]] const std::vector<GiNaC::ex>& expressions() const override { return expressions_; }
  [[nodiscard]] std::string text(std::size_t entry) const override;
  [[nodiscard]] bool is_angle(std::size_t entry) const override { return angles_[entry]; }
  [[nodiscard]] std::vector<std::vector<ExpectedValue>> at(std::vector<Asked>& list,
                                                           AskedPoints& drawing,
                                                           const Precision& precision) override;
  [[nodiscard]] double slack(const Precision& precision) const override;

 private:
  [[nodiscard]] ExpectedValue value_at(std::size_t entry, Asked& asked, AskedPoints& drawing,
                                       const Precision& precision) const;

  const ExpectedMatrix& expected_;
  double rounding_;  ///< a relative error that is allowed in addition
  ExpectedMatrix drawn_;
  std::vector<GiNaC::ex> expressions_;
  std::vector<bool> angles_;
};

}  // namespace assur::generator::audit
