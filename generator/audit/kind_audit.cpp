#include "audit/kind_audit.hpp"

#include <algorithm>
#include <charconv>
#include <set>

#include "derivatives/mobility.hpp"
#include "structure/kind.hpp"

namespace assur::generator::audit {

namespace {

derivatives::Mobility mobility(const structure::Model& model) {
  const equations::ClosureEquations equations = equations::closure_equations(model);
  return derivatives::mobility_of(equations, derivatives::closure_jacobian(equations));
}

std::size_t row_number(const closures::PlacedText& text, std::size_t most,
                       const std::string& file) {
  std::size_t number = 0;
  const char* const end = text.text.data() + text.text.size();
  const auto [at, error] = std::from_chars(text.text.data(), end, number);
  if (error != std::errc() || at != end || number < 1 || number > most) {
    throw closures::AuditSyntaxError(file, text.place,
                                     "expected the number of a model, 1 to " +
                                         std::to_string(most) + ", found '" + text.text + "'");
  }
  return number;
}

Finding answer(const std::string& item, const closures::PlacedText& printed, bool agrees,
               const std::string& derived) {
  const Verdict verdict = agrees ? Verdict::agrees : Verdict::differs;
  return {item,         printed.place, {verdict, "by the group's symmetry", "", ""},
          printed.text, derived,       ""};
}

}  // namespace

std::vector<Finding> audit_kinds(const structure::Group& group,
                                 const std::vector<closures::PlacedText>& rows,
                                 const std::string& file) {
  const std::vector<structure::Model>& models = structure::models_of(group);
  std::vector<Finding> findings;
  for (const closures::PlacedText& row : rows) {
    const std::vector<closures::PlacedText> parts = closures::split(row, ':');
    if (parts.size() < 2 || parts.size() > 3) {
      throw closures::AuditSyntaxError(file, row.place,
                                       "expected 'NUMBER : KIND, KIND, ... [: FAMILY]'");
    }
    const std::size_t number = row_number(parts[0], models.size(), file);
    const structure::Model& model = models[number - 1];
    const std::string title = "row " + std::to_string(number) + ", ";
    std::set<std::string> printed;
    for (const closures::PlacedText& kind_text : closures::split(parts[1], ',')) {
      const std::optional<structure::Kind> kind = structure::parse_kind(group, kind_text.text);
      if (!kind) {
        findings.push_back(
            {title + kind_text.text,
             kind_text.place,
             {Verdict::unreadable, "it is not a kind of the " + group.name(), "", ""},
             kind_text.text,
             "",
             ""});
        continue;
      }
      printed.insert(kind_text.text);
      const structure::Model& owner = structure::model_of(group, *kind);
      findings.push_back(answer(title + kind_text.text, kind_text, owner.number == model.number,
                                "row " + std::to_string(owner.number)));
    }
    for (const structure::Relabelling& member : model.members) {
      const std::string kind = structure::spell(group, member.kind);
      if (!printed.contains(kind)) {
        findings.push_back(answer(title + kind + " left out", {"", row.place}, false,
                                  kind + " belongs to row " + std::to_string(number)));
      }
    }
    if (parts.size() == 3) {
      const derivatives::Mobility derived = mobility(model);
      Finding family = answer(title + "family " + parts[2].text, parts[2],
                              (parts[2].text == "3") == derived.rigid,
                              derived.rigid ? "a structure: family 3" : "not a structure");
      family.comparison.evidence = "by the exact rank of the Jacobian";
      family.note = family.agrees() ? "" : derived.reason;
      findings.push_back(family);
    }
  }
  return findings;
}

std::map<std::string, double> group_numbers(const structure::Group& group) {
  std::map<std::string, double> numbers;
  for (const char* name : {"kinds", "models", "rigid_models", "degenerate_models", "rigid_kinds"}) {
    numbers[name] = 0;
  }
  for (const structure::Model& model : structure::models_of(group)) {
    const derivatives::Mobility derived = mobility(model);
    const auto kinds = static_cast<double>(model.members.size());
    numbers["kinds"] += kinds;
    numbers["models"] += 1;
    numbers[derived.rigid ? "rigid_models" : "degenerate_models"] += 1;
    numbers["rigid_kinds"] += derived.rigid ? kinds : 0;
    numbers["mobility_" + std::to_string(model.number)] = derived.freedom;
  }
  return numbers;
}

}  // namespace assur::generator::audit
