#include "audit/map_of_efforts.hpp"

#include <algorithm>

namespace assur::generator::audit {

namespace {

/// The largest matrix that is inverted: the formulas of the inverse grow with the factorial.
constexpr std::size_t most_inverted = 3;

/// What is printed instead, and its note.
struct Mistake {
  GiNaC::matrix matrix;
  const char* note;
};

std::vector<Mistake> mistakes(const GiNaC::matrix& efforts) {
  const GiNaC::matrix velocities = efforts.transpose();
  std::vector<Mistake> list = {
      {velocities, "printed is the map of velocities itself; its transpose maps efforts"}};
  if (velocities.rows() <= most_inverted && !velocities.determinant().normal().is_zero()) {
    const GiNaC::matrix inverse = velocities.inverse();
    list.push_back(
        {inverse, "printed is the inverse of the map of velocities; its transpose maps efforts"});
    list.push_back({inverse.transpose(),
                    "printed is the transposed inverse, which maps efforts the other way"});
  }
  return list;
}

}  // namespace

void explain_map_of_efforts(closures::ClosurePoints& points, const PrintedMatrix& matrix,
                            std::vector<Finding>& findings) {
  const bool is_wrong = std::ranges::any_of(findings, &Finding::is_wrong);
  if (!matrix.is_transposed || matrix.height() != matrix.width() || !is_wrong) {
    return;
  }
  const auto size = static_cast<unsigned>(matrix.width());
  GiNaC::matrix efforts(size, size);
  GiNaC::matrix printed(size, size);
  for (unsigned place = 0; place < size * size; ++place) {
    const PrintedEntry& entry = matrix.entries[place];
    if (findings[place].comparison.verdict == Verdict::unreadable) {
      return;
    }
    efforts(place / size, place % size) = derived_entry(points.system(), matrix, place).value;
    printed(place / size, place % size) = entry.text.empty() ? GiNaC::ex(0)
                                          : entry.value
                                              ? entry.value()
                                              : closures::read_formula(entry.text, points.system());
  }
  for (const Mistake& mistake : mistakes(efforts)) {
    bool is_this = true;
    for (unsigned place = 0; place < size * size && is_this; ++place) {
      is_this = compare(points, printed(place / size, place % size),
                        mistake.matrix(place / size, place % size), false)
                    .verdict == Verdict::agrees;
    }
    if (is_this) {
      for (Finding& finding : findings) {
        finding.note = finding.is_wrong() ? mistake.note : finding.note;
      }
      return;
    }
  }
}

}  // namespace assur::generator::audit
