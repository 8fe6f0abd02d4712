#include "equations/symbols.hpp"

#include <algorithm>
#include <iterator>

namespace assur::generator::equations {

GiNaC::exset symbols_of(const GiNaC::ex& expression) {
  GiNaC::exset symbols;
  std::copy_if(expression.preorder_begin(), expression.preorder_end(),
               std::inserter(symbols, symbols.end()),
               [](const GiNaC::ex& part) { return GiNaC::is_a<GiNaC::symbol>(part); });
  return symbols;
}

}  // namespace assur::generator::equations
