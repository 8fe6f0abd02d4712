// Turns functions that compute the same terms into ones that compute them in one place.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "emission/model/model_view.hpp"
#include "emission/model/solution_functions.hpp"

namespace assur::generator::emission::model {

/// The terms that several functions compute, as a struct that (d, u, q) make: a member for each
/// step, and a function `put` that assigns the results which all of them have.
struct SharedTerms {
  std::string name;      ///< of the struct
  std::string variable;  ///< that holds one
  std::vector<std::string> doc;
  std::set<std::string> functions;  ///< that compute them
};

struct SharedTermsViews {
  cpp::View terms;
  cpp::View::List functions;
};

/// The functions, of which the last has the results and the names of all. They are parts of one
/// program, and none computes a step that it does not need.
[[nodiscard]] SharedTermsViews shared_terms_views(
    const SharedTerms& terms, const std::vector<NamingFunction>& functions,
    const program::SymbolOrder& order, const std::vector<equations::NamedQuantity>& known,
    const ModelSpelling& spelling);

}  // namespace assur::generator::emission::model
