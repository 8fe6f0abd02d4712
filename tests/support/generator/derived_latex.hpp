// The LaTeX that `assur derive` writes for a model, and the map that reads it.
#pragma once

#include <string>

#include "document/derivation.hpp"
#include "document/render.hpp"

namespace assur::test {

/// `d(f?, x)*rate(x) + ...` over the unknowns: the right-hand side of J q' = b.
inline std::string product_with_jacobian(const generator::document::Derivation& derivation,
                                         const std::string& rate) {
  std::string text;
  for (const generator::document::DerivedVariable& unknown : derivation.unknowns) {
    text += (text.empty() ? "" : " + ") + std::string("d(f?, ") + unknown.name + ")*" + rate + "(" +
            unknown.name + ")";
  }
  return text;
}

/// Whether there are as many closures as unknowns, so that the closures determine rates.
inline bool is_square(const generator::document::Derivation& derivation) {
  return derivation.jacobian.rows.size() == derivation.jacobian.columns.size();
}

/// The map from the notation of a derivation to the model's quantities.
inline std::string map_of(const generator::document::Derivation& derivation) {
  std::string map =
      "model " +
      generator::structure::spell(*derivation.model->group, derivation.model->representative) + R"(
display \numbered{EQUATION}{NUMBER}
display \defined{EQUATION}{MEANING}
blanks are zero
\varphi_? = phi_?
\omega_? = rate(theta_?)
\alpha_? = rate2(theta_?)
\overline{?}_? = as printed
\cos\vartheta_? = as printed
\sin\vartheta_? = as printed
\cos\sigma_? = as printed
\sin\sigma_? = as printed
f_{?,?} = as printed
J = matrix by its titles
F_? = matrix by its titles
skip sections Structure, Variables, Mobility and singularities
)";
  map += "\\partial f/\\partial ? = matrix of f1.." +
         std::to_string(derivation.jacobian.rows.size()) + " by ?\n";
  map += "b_? = " + product_with_jacobian(derivation, "rate") + "\n";
  map += "c_? = " + product_with_jacobian(derivation, "rate2") + "\n";
  for (const generator::document::DerivedVariable& input : derivation.inputs) {
    if (input.is_angle) {  // a slide of the base turns with phi, not with a theta
      const std::string joint = input.name.substr(4);
      map += "\\omega_{" + joint + "} = rate(" + input.name + ")\n";
      map += "\\alpha_{" + joint + "} = rate2(" + input.name + ")\n";
    }
  }
  int number = 1;
  map += "skip";
  for (std::size_t loop = 0; loop < derivation.closures.size(); ++loop, number += 3) {
    map += " (" + std::to_string(number) + ")";  // as vectors
  }
  for (std::size_t sum = 0; sum < derivation.compatibility.size(); ++sum) {
    map += " (" + std::to_string(number++) + ")";  // sums of angles
  }
  if (!is_square(derivation)) {
    number += derivation.dimension_jacobian.columns.empty() ? 2 : 3;  // the matrices
    for (std::size_t row = 0; row < 2 * derivation.jacobian.rows.size(); ++row) {
      map += " (" + std::to_string(number++) + ")";
    }
  }
  return map + "\n";
}

}  // namespace assur::test
