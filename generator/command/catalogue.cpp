#include "command/catalogue.hpp"

#include <algorithm>
#include <assur/text/json.hpp>
#include <assur/text/names.hpp>
#include <vector>

#include "derivatives/mobility.hpp"
#include "elimination/eliminate.hpp"
#include "pivoting/structured_jacobian.hpp"
#include "structure/printed_table.hpp"

namespace assur::generator::command {

namespace {

using text::Json;

struct CatalogueEntry {
  const structure::Model* model;
  derivatives::Mobility mobility;
  std::size_t max_configurations;           ///< zero for a degenerate model
  std::string determinant;                  ///< of the Jacobian, factored; empty if degenerate
  std::vector<std::string> singular_where;  ///< the zeros of its factors
  const structure::PrintedRow* printed;
  std::vector<std::string> kinds;
  std::vector<std::string> disagreements;  ///< between the derivation and the printed row
};

void compare(CatalogueEntry& entry) {
  std::vector<std::string> missing;
  for (const std::string& kind : entry.kinds) {
    if (std::find(entry.printed->kinds.begin(), entry.printed->kinds.end(), kind) ==
        entry.printed->kinds.end()) {
      missing.push_back(kind);
    }
  }
  std::vector<std::string> foreign;
  for (const std::string& kind : entry.printed->kinds) {
    if (std::find(entry.kinds.begin(), entry.kinds.end(), kind) == entry.kinds.end()) {
      foreign.push_back(kind);
    }
  }
  if (!foreign.empty()) {
    entry.disagreements.push_back("printed " + text::joined(foreign, ", ") +
                                  " belongs to another row");
  }
  if (!missing.empty()) {
    entry.disagreements.push_back(text::joined(missing, ", ") + " is not printed");
  }
  if (entry.printed->rigid() != entry.mobility.rigid) {
    entry.disagreements.push_back("printed family " + entry.printed->family + " makes it " +
                                  (entry.printed->rigid() ? "a structure" : "a mechanism") +
                                  ", derived rank makes it " +
                                  (entry.mobility.rigid ? "a structure" : "a mechanism"));
  }
}

std::vector<CatalogueEntry> entries_of(const structure::Group& group) {
  const std::vector<structure::PrintedRow>* printed = structure::printed_table(group);
  std::vector<CatalogueEntry> entries;
  for (const structure::Model& model : structure::models_of(group)) {
    const equations::ClosureEquations equations = equations::closure_equations(model);
    const derivatives::Mobility mobility =
        derivatives::mobility_of(equations, derivatives::closure_jacobian(equations));
    const std::size_t most =
        mobility.rigid ? elimination::eliminate(equations).max_configurations : 0;
    CatalogueEntry entry{&model, mobility, most, "", {}, nullptr, {}, {}};
    if (mobility.rigid) {
      const pivoting::StructuredJacobian jacobian(equations);
      entry.determinant = jacobian.determinant_text();
      for (const pivoting::Pivot& pivot : jacobian.pivots()) {
        entry.singular_where.push_back(pivot.cause);
      }
    }
    for (const structure::Relabelling& member : model.members) {
      entry.kinds.push_back(structure::spell(group, member.kind));
    }
    if (printed != nullptr) {
      entry.printed = &*std::find_if(
          printed->begin(), printed->end(),
          [&](const structure::PrintedRow& row) { return row.number == model.number; });
      compare(entry);
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::string verdict(const CatalogueEntry& entry) {
  return entry.mobility.rigid ? "rigid" : "degenerate";
}

Json group_json(const structure::Group& group) {
  Json root;
  root["group"] = group.name();
  root["class"] = group.assur_class();
  root["kinds"] = structure::all_kinds(group).size();
  root["models"] = Json::array();
  for (const CatalogueEntry& entry : entries_of(group)) {
    Json row;
    row["model"] = entry.model->number;
    row["kinds"] = entry.kinds;
    row["mobility"] = entry.mobility.freedom;
    row["max_configurations"] = entry.mobility.rigid ? Json(entry.max_configurations) : Json();
    row["verdict"] = verdict(entry);
    row["reason"] = entry.mobility.reason;
    if (entry.mobility.rigid) {
      row["jacobian_determinant"] = entry.determinant;
      row["singular_where"] = entry.singular_where;
    }
    if (entry.printed != nullptr) {
      row["paper"] = {{"family", entry.printed->family},
                      {"kinds", entry.printed->kinds},
                      {"disagreements", entry.disagreements}};
    }
    root["models"].push_back(std::move(row));
  }
  return root;
}

/// Two tables: the models, with the columns of a printed table if there is one, and the
/// singularities of their Jacobians.
std::string group_markdown(const structure::Group& group) {
  const bool printed = structure::printed_table(group) != nullptr;
  const std::vector<CatalogueEntry> entries = entries_of(group);
  std::string text = "## " + group.name() + "\n\n" +
                     std::to_string(structure::all_kinds(group).size()) + " kinds, " +
                     std::to_string(entries.size()) + " models.\n\n" +
                     "| model | kinds | verdict | mobility | configurations at most |" +
                     (printed ? " printed family | disagreement |\n|---|---|---|---|---|---|---|\n"
                              : "\n|---|---|---|---|---|\n");
  for (const CatalogueEntry& entry : entries) {
    text += "| " + std::to_string(entry.model->number) + " | " + text::joined(entry.kinds, ", ") +
            " | " + verdict(entry) + " | " + std::to_string(entry.mobility.freedom) + " | " +
            (entry.mobility.rigid ? std::to_string(entry.max_configurations) : "") + " |" +
            (printed ? " " + entry.printed->family + " | " +
                           text::joined(entry.disagreements, "; ") + " |"
                     : "") +
            "\n";
  }
  text += "\n| model | determinant of the Jacobian | singular where |\n|---|---|---|\n";
  for (const CatalogueEntry& entry : entries) {
    if (entry.mobility.rigid) {
      text += "| " + std::to_string(entry.model->number) + " | `" + entry.determinant + "` | " +
              text::joined(entry.singular_where, ", ") + " |\n";
    }
  }
  return text;
}

/// A line that is continued on indented lines if it is wider than a terminal.
std::string wrapped(const std::string& line) {
  constexpr std::size_t width = 80;
  const std::string indent(9, ' ');
  std::string text;
  std::size_t begin = 0;
  std::size_t room = width;
  while (line.size() - begin > room) {
    std::size_t end = line.rfind(' ', begin + room);
    if (end == std::string::npos || end <= begin) {
      break;  // a single word is wider
    }
    text += line.substr(begin, end - begin) + "\n" + indent;
    begin = end + 1;
    room = width - indent.size();
  }
  return text + line.substr(begin) + "\n";
}

}  // namespace

std::string catalogue_json() {
  const structure::Group& tetrad = structure::group_named("tetrad");
  Json root = group_json(tetrad);
  root["other_groups"] = Json::array();
  for (const structure::Group& group : structure::known_groups()) {
    if (&group != &tetrad) {
      root["other_groups"].push_back(group_json(group));
    }
  }
  return root.dump() + "\n";
}

std::string catalogue_text() {
  std::string text;
  for (const structure::Group& group : structure::known_groups()) {
    text += group.name() + ": " + std::to_string(structure::all_kinds(group).size()) + " kinds, " +
            std::to_string(structure::models_of(group).size()) + " models\n";
    for (const CatalogueEntry& entry : entries_of(group)) {
      const std::string number = std::to_string(entry.model->number);
      text +=
          wrapped(std::string(5 - number.size(), ' ') + number + "  " + verdict(entry) + ", " +
                  (entry.mobility.rigid
                       ? "at most " + std::to_string(entry.max_configurations) +
                             (entry.max_configurations == 1 ? " configuration" : " configurations")
                       : "mobility " + std::to_string(entry.mobility.freedom)) +
                  "  " + text::joined(entry.kinds, ", "));
      if (!entry.mobility.rigid) {
        text += wrapped("         " + entry.mobility.reason);
      }
      for (const std::string& disagreement : entry.disagreements) {
        text += wrapped("         Table 2: " + disagreement);
      }
    }
  }
  return text;
}

std::string catalogue_markdown() {
  std::string text;
  for (const structure::Group& group : structure::known_groups()) {
    text += (text.empty() ? "" : "\n") + group_markdown(group);
  }
  return text;
}

}  // namespace assur::generator::command
