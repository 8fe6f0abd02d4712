// Reference values and error bounds for the results of a program, entry by entry.
#pragma once

#include "audit/asked_points.hpp"

namespace assur::generator::audit {

/// The arithmetic of a program.
struct Precision {
  double unit;          ///< half a unit in the last place of 1
  double other_orders;  ///< allowance for another order of operations
  double blurred;       ///< a point with a larger relative rounding error is useless
};
inline constexpr Precision in_double{0x1p-53, 4096, 1e-6};
inline constexpr Precision in_single{0x1p-24, 64, 1e-2};

struct ExpectedValue {
  double value = 0;
  std::optional<double> tolerance;  ///< empty if the value is not known closely enough
  std::string obstacle{};           ///< why the entry has no value at any point, if so
  bool exists = true;               ///< whether the entry has a value at the point
};

/// A quantity that a program receives: a symbol, or its first or second rate.
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

  /// The matrix for whose entries the points must have values.
  [[nodiscard]] virtual const ExpectedMatrix& drawn() const = 0;
  /// The expressions of the entries, without abbreviations, in symbols that have values at the
  /// points once `at` has been called.
  [[nodiscard]] virtual const std::vector<GiNaC::ex>& expressions() const = 0;
  /// An entry as shown in a report.
  [[nodiscard]] virtual std::string text(std::size_t entry) const = 0;
  /// Whether an entry is an angle, so that whole turns do not count.
  [[nodiscard]] virtual bool is_angle(std::size_t entry) const = 0;
  /// The values of all entries at each point of a list.
  [[nodiscard]] virtual std::vector<std::vector<ExpectedValue>> at(std::vector<Asked>& list,
                                                                   AskedPoints& drawing,
                                                                   const Precision& precision) = 0;
  /// The origin of the values, for a report; empty for the derivation.
  [[nodiscard]] virtual std::string remark() const { return ""; }
  /// The reason why an entry has no comparable value at nearly all points.
  [[nodiscard]] virtual std::string why_untold() const = 0;
  /// The part of its error bound by which a guess at a slip may be off.
  [[nodiscard]] virtual double slack(const Precision& precision) const = 0;
};

/// The values derived from the closures.
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
  [[nodiscard]] std::string why_untold() const override {
    return "rounding hides its value at nearly all points";
  }
  [[nodiscard]] double slack(const Precision& precision) const override;

 private:
  [[nodiscard]] ExpectedValue value_at(std::size_t entry, Asked& asked, AskedPoints& drawing,
                                       const Precision& precision) const;

  const ExpectedMatrix& expected_;
  double rounding_;  ///< relative error allowed in addition
  ExpectedMatrix drawn_;
  std::vector<GiNaC::ex> expressions_;
  std::vector<bool> angles_;
};

}  // namespace assur::generator::audit
