// Shared terms of several functions, moved to one struct that computes them once.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "emission/model/model_view.hpp"
#include "emission/model/solution_functions.hpp"

namespace assur::generator::emission::model {

/// The terms that several functions compute, as a struct constructed from (d, u, q): a member for
/// each step, and a function `put` that assigns the results common to all functions.
struct SharedTerms {
  std::string name;      ///< of the struct
  std::string variable;  ///< that holds the struct
  std::vector<std::string> doc;
  std::set<std::string> functions;  ///< that use the terms
};

struct SharedTermsViews {
  cpp::View terms;
  cpp::View::List functions;
};

/// The functions; the last one has the results and the names of all. They are parts of one program,
/// and none computes a step that it does not need.
[[nodiscard]] SharedTermsViews shared_terms_views(
    const SharedTerms& terms, const std::vector<NamingFunction>& functions,
    const program::SymbolOrder& order, const std::vector<equations::NamedQuantity>& known,
    const ModelSpelling& spelling);

}  // namespace assur::generator::emission::model
