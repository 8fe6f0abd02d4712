#include "program/expression_graph.hpp"

#include <algorithm>
#include <functional>

namespace assur::generator::program {

namespace {

/// The symbol in the largest number of terms, at least two; of several, the first.
SymbolRank most_frequent_factor(const Polynomial& polynomial) {
  std::map<SymbolRank, int> counts;
  for (const auto& [monomial, coefficient] : polynomial) {
    SymbolRank last;
    for (const SymbolRank symbol : monomial) {
      if (symbol != last) {
        ++counts[symbol];
      }
      last = symbol;
    }
  }
  SymbolRank best;
  int best_count = 1;
  for (const auto& [symbol, count] : counts) {
    if (count > best_count) {
      best = symbol;
      best_count = count;
    }
  }
  return best;
}

/// The number of multiplications by coefficients in a polynomial after division by `divisor`.
std::ptrdiff_t scalings(const Polynomial& polynomial, const GiNaC::numeric& divisor) {
  return std::count_if(polynomial.begin(), polynomial.end(), [&](const auto& term) {
    return !term.first.empty() && GiNaC::abs(term.second.value()) != divisor;
  });
}

/// The positive rational number that divides all coefficients into coprime integers; one instead if
/// these integers would be large, as for unrelated decimal fractions, or if the division saves no
/// multiplication.
Coefficient content_of(const Polynomial& polynomial) {
  constexpr int large = 20;
  GiNaC::numeric numerators = 0;
  GiNaC::numeric denominators = 1;
  for (const auto& [monomial, coefficient] : polynomial) {
    numerators = GiNaC::gcd(numerators, coefficient.value().numer());
    denominators = GiNaC::lcm(denominators, coefficient.value().denom());
  }
  if (numerators.is_zero()) {
    return 1;
  }
  const GiNaC::numeric content = GiNaC::abs(numerators / denominators);
  const bool in_common = std::all_of(polynomial.begin(), polynomial.end(), [&](const auto& term) {
    return GiNaC::abs(term.second.value()) / content < large;
  });
  if (!in_common || scalings(polynomial, content) + 1 >= scalings(polynomial, 1)) {
    return 1;
  }
  // If a coefficient equals the content, the content takes its name.
  const auto same = std::find_if(polynomial.begin(), polynomial.end(), [&](const auto& term) {
    return GiNaC::abs(term.second.value()) == content;
  });
  return same == polynomial.end() ? Coefficient(content) : same->second.size();
}

}  // namespace

OperationCount& OperationCount::operator+=(const OperationCount& other) {
  multiplications += other.multiplications;
  additions += other.additions;
  divisions += other.divisions;
  square_roots += other.square_roots;
  return *this;
}

ExpressionGraph::Key ExpressionGraph::key_of(const Node& node) {
  std::vector<NodeIndex> terms;
  std::string coefficients;
  for (const ScaledNode& term : node.terms) {
    terms.push_back(term.node);
    coefficients += term.coefficient.text() + " ";
  }
  return {node.operation, node.symbol, node.factors, terms, coefficients};
}

NodeIndex ExpressionGraph::intern(Node node) {
  const auto [entry, fresh] = index_.try_emplace(key_of(node));
  if (fresh) {
    entry->second = nodes_.add(std::move(node));
  }
  return entry->second;
}

ScaledNode ExpressionGraph::make_product(std::vector<NodeIndex> factors) {
  if (factors.empty()) {
    return {1, intern({Operation::constant, {}, {}, {}})};
  }
  if (factors.size() == 1) {
    return {1, factors.front()};
  }
  std::sort(factors.begin(), factors.end());
  return {1, intern({Operation::product, {}, std::move(factors), {}})};
}

ScaledNode ExpressionGraph::make_sum(std::vector<ScaledNode> terms) {
  // Equal nodes are added up; terms are sorted by age with a positive one in front, and the sign of
  // the whole goes to the user of the sum, so that a - b and b - a are one node.
  std::map<NodeIndex, Coefficient> sums;
  for (const ScaledNode& term : terms) {
    sums[term.node] += term.coefficient;
  }
  terms.clear();
  for (const auto& [node, coefficient] : sums) {
    if (!coefficient.is_zero()) {
      terms.push_back({coefficient, node});
    }
  }
  if (terms.empty()) {
    return {0, intern({Operation::constant, {}, {}, {}})};
  }
  if (terms.size() == 1) {
    return terms.front();
  }
  const bool negate = terms.front().coefficient.is_negative();
  if (negate) {
    for (ScaledNode& term : terms) {
      term.coefficient = -term.coefficient;
    }
  }
  return {negate ? -1 : 1, intern({Operation::sum, {}, {}, std::move(terms)})};
}

ScaledNode ExpressionGraph::add(const Polynomial& polynomial) {
  const Coefficient content = content_of(polynomial);
  if (content.scales()) {
    Polynomial primitive = polynomial;
    for (auto& [monomial, coefficient] : primitive) {
      coefficient /= content;
    }
    const ScaledNode result = add(primitive);
    return {content * result.coefficient, result.node};
  }
  const SymbolRank factor = most_frequent_factor(polynomial);
  if (!factor.exists()) {
    std::vector<ScaledNode> terms;
    for (const auto& [monomial, coefficient] : polynomial) {
      std::vector<NodeIndex> factors;
      for (const SymbolRank symbol : monomial) {
        factors.push_back(intern({Operation::symbol, symbol, {}, {}}));
      }
      const ScaledNode product = make_product(std::move(factors));
      terms.push_back({coefficient * product.coefficient, product.node});
    }
    return make_sum(std::move(terms));
  }
  Polynomial divided;
  Polynomial rest;
  for (const auto& [monomial, coefficient] : polynomial) {
    const auto found = std::find(monomial.begin(), monomial.end(), factor);
    if (found == monomial.end()) {
      rest.emplace(monomial, coefficient);
    } else {
      Monomial quotient(monomial.begin(), found);
      quotient.insert(quotient.end(), found + 1, monomial.end());
      divided.emplace(quotient, coefficient);
    }
  }
  const ScaledNode inner = add(divided);
  std::vector<NodeIndex> factors = {intern({Operation::symbol, factor, {}, {}})};
  if (const Node& quotient = nodes_[inner.node]; quotient.operation == Operation::product) {
    factors.insert(factors.end(), quotient.factors.begin(), quotient.factors.end());
  } else {
    factors.push_back(inner.node);
  }
  const ScaledNode product = make_product(std::move(factors));
  ScaledNode head{inner.coefficient * product.coefficient, product.node};
  if (rest.empty()) {
    return head;
  }
  const ScaledNode tail = add(rest);
  std::vector<ScaledNode> terms = {head};
  if (const Node& remainder = nodes_[tail.node]; remainder.operation == Operation::sum) {
    for (const ScaledNode& term : remainder.terms) {
      terms.push_back({tail.coefficient * term.coefficient, term.node});
    }
  } else {
    terms.push_back(tail);
  }
  return make_sum(std::move(terms));
}

NodeTable<bool> ExpressionGraph::reachable(const std::vector<ScaledNode>& roots) const {
  NodeTable<bool> reached(nodes_.size(), false);
  const std::function<void(NodeIndex)> visit = [&](NodeIndex index) {
    if (reached[index]) {
      return;
    }
    reached[index] = true;
    for (const NodeIndex factor : nodes_[index].factors) {
      visit(factor);
    }
    for (const ScaledNode& term : nodes_[index].terms) {
      visit(term.node);
    }
  };
  for (const ScaledNode& root : roots) {
    visit(root.node);
  }
  return reached;
}

NodeTable<int> ExpressionGraph::uses(const std::vector<ScaledNode>& roots) const {
  NodeTable<int> counts(nodes_.size(), 0);
  const NodeTable<bool> reached = reachable(roots);
  for (const ScaledNode& root : roots) {
    ++counts[root.node];
  }
  for (const NodeIndex index : nodes_.keys()) {
    if (!reached[index]) {
      continue;
    }
    for (const NodeIndex factor : nodes_[index].factors) {
      ++counts[factor];
    }
    for (const ScaledNode& term : nodes_[index].terms) {
      ++counts[term.node];
    }
  }
  return counts;
}

void ExpressionGraph::rebuild(std::vector<ScaledNode>& roots,
                              const std::map<NodeIndex, Node>& rewritten,
                              const std::map<NodeIndex, SymbolOfNode>& symbols) {
  // The replacement of a node: itself, another node, or a multiple of one.
  std::map<NodeIndex, ScaledNode> image;
  for (const auto& [node, symbol] : symbols) {
    image.emplace(node, symbol.value);
  }
  std::function<ScaledNode(NodeIndex)> moved;
  const auto remade = [&](NodeIndex index) -> ScaledNode {
    const auto found = rewritten.find(index);
    const Node content = found == rewritten.end() ? nodes_[index] : found->second;
    if (content.operation == Operation::product) {
      std::vector<NodeIndex> factors;
      Coefficient coefficient = 1;
      for (const NodeIndex factor : content.factors) {
        const ScaledNode part = moved(factor);
        factors.push_back(part.node);
        coefficient *= part.coefficient;
      }
      ScaledNode result = make_product(std::move(factors));
      result.coefficient *= coefficient;
      return result;
    }
    if (content.operation == Operation::sum) {
      std::vector<ScaledNode> terms;
      for (const ScaledNode& term : content.terms) {
        const ScaledNode part = moved(term.node);
        terms.push_back({term.coefficient * part.coefficient, part.node});
      }
      return make_sum(std::move(terms));
    }
    return {1, index};
  };
  moved = [&](NodeIndex index) -> ScaledNode {
    const auto known = image.find(index);
    return known != image.end() ? known->second : image.emplace(index, remade(index)).first->second;
  };
  for (std::size_t place = 0; place < roots.size(); ++place) {
    const auto symbol = symbols.find(roots[place].node);
    const bool defines = symbol != symbols.end() && symbol->second.definition == place;
    const ScaledNode part = defines ? remade(roots[place].node) : moved(roots[place].node);
    roots[place] = {roots[place].coefficient * part.coefficient, part.node};
  }
}

bool ExpressionGraph::put_symbols(std::vector<ScaledNode>& roots,
                                  const std::map<NodeIndex, SymbolOfNode>& symbols) {
  const std::vector<ScaledNode> before = roots;
  rebuild(roots, {}, symbols);
  return !std::equal(
      before.begin(), before.end(), roots.begin(),
      [](const ScaledNode& left, const ScaledNode& right) { return left.node == right.node; });
}

bool ExpressionGraph::is_scaled(const ScaledNode& value) const {
  return value.coefficient.scales() && nodes_[value.node].operation != Operation::constant;
}

Measure ExpressionGraph::measure(NodeIndex index) const {
  const Node& at = nodes_[index];
  Measure measure;
  if (at.operation == Operation::symbol) {
    return order_->measure(at.symbol);
  }
  for (const NodeIndex factor : at.factors) {
    const Measure part = this->measure(factor);
    measure.length += part.length;
    measure.time += part.time;
  }
  // All terms have the same measure, except that constant lengths do not count.
  for (const ScaledNode& term : at.terms) {
    const Measure part = this->measure(term.node);
    const bool more = part.time != 0 || (measure.time == 0 && part.length != 0);
    measure = more ? part : measure;
  }
  return measure;
}

OperationCount ExpressionGraph::cost(NodeIndex index) const {
  const Node& at = nodes_[index];
  OperationCount count;
  if (at.operation == Operation::product) {
    count.multiplications = at.factors.size() - 1;
  } else if (at.operation == Operation::sum) {
    count.additions = at.terms.size() - 1;
    for (const ScaledNode& term : at.terms) {
      count.multiplications += is_scaled(term) ? 1 : 0;
    }
  }
  return count;
}

}  // namespace assur::generator::program
