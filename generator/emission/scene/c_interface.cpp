#include "emission/scene/c_interface.hpp"

#include <algorithm>
#include <assur/text/identifiers.hpp>
#include <assur/text/names.hpp>

namespace assur::generator::emission::scene {

namespace {

/// The prefix of all names. A keyword with a suffix is an ordinary name, so `class` is kept.
std::string prefix_of(const std::string& stem) {
  std::string prefix = text::member_names({stem + "_"}, {}).front();
  if (prefix.back() == '_') {
    prefix.pop_back();
  }
  return prefix;
}

cpp::View::List columns_of(const std::vector<std::string>& parameters) {
  cpp::View::List columns;
  for (const std::string& member : text::member_names(parameters, {})) {
    cpp::View column("member", member);
    column.set("column", std::to_string(columns.size()));
    columns.push_back(column);
  }
  return columns;
}

bool stands(const cpp::View& view, const std::string& section) {
  return std::get<bool>(view.values().at(section));
}

/// The arguments of a solver, as the C functions take and forward them.
void show_given(const std::string& prefix, const std::string& real, cpp::View& view) {
  std::string given;
  std::vector<std::string> defaults;
  std::vector<std::string> handed;
  std::vector<std::string> addresses;
  std::string at_place;
  for (const auto& [section, word] :
       {std::pair("has_drivers", "drivers"), std::pair("has_variables", "parameters")}) {
    if (stands(view, section)) {
      given += "const " + prefix + "_" + word + "* " + word + ",\n    ";
      defaults.push_back(prefix + "_" + word + "* " + word);
      addresses.push_back(std::string("&") + word);
      handed.push_back(std::string("cpp_of(*") + word + ")");
      at_place += std::string(word) + " + place, ";
    } else if (std::string(word) == "drivers") {
      handed.emplace_back("Solver::Drivers<" + real + ">{}");
    }
  }
  const auto joined = [](const std::vector<std::string>& texts, const std::string& between) {
    return text::joined(texts, between, [](const std::string& one) { return one; });
  };
  view.set("c_given", given);
  view.set("given_at_place", at_place);
  view.set("cpp_given", joined(handed, ", "));
  view.set("defaults", joined(defaults, ",\n    "));
  view.set("addresses", joined(addresses, ", "));
  view.set("addresses_before", joined(addresses, ", ") + (addresses.empty() ? "" : ", "));
  view.set("has_given", !defaults.empty());
}

}  // namespace

std::vector<cpp::EmittedFile> c_interface(const std::filesystem::path& header, cpp::View solver,
                                          const std::vector<std::string>& parameters,
                                          std::size_t branch_numbers, const std::string& real) {
  const std::string stem = header.stem().string();
  const std::string prefix = prefix_of(stem);
  solver.set("prefix", prefix);
  solver.set("columns", columns_of(parameters));
  // C has no empty arrays.
  solver.set("branch_numbers", std::to_string(std::max<std::size_t>(branch_numbers, 1)));
  solver.set("real", real);
  solver.set("is_float", real == "float");
  solver.set("interface", real == "double" ? "c" : "c-float");
  show_given(prefix, real, solver);
  // C has no empty structures: points without wanted quantities are left out.
  const bool moves = stands(solver, "velocity") || stands(solver, "acceleration");
  const bool has_vectors = stands(solver, "position") || moves || stands(solver, "tolerances");
  const bool has_outputs = stands(solver, "has_outputs");
  solver.set("shows_outputs", has_outputs && (has_vectors || stands(solver, "sensitivity")));
  solver.set("copies_vectors", (has_outputs && has_vectors) ||
                                   (stands(solver, "has_links") && moves) ||
                                   stands(solver, "has_forces") || stands(solver, "has_dynamics"));
  return {
      {std::filesystem::path(header).replace_extension(".h"), cpp::page("c_header.h", solver)},
      {std::filesystem::path(header).replace_extension(".cpp"), cpp::page("c_source.cpp", solver)}};
}

}  // namespace assur::generator::emission::scene
