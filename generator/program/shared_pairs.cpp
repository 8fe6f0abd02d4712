// Makes a node of every pair of factors or terms that several nodes of an expression graph share.
#include <algorithm>

#include "program/expression_graph.hpp"

namespace assur::generator::program {

namespace {

template <typename Pair>
const Pair* most_frequent(const std::map<Pair, int>& counts) {
  const auto best = std::max_element(
      counts.begin(), counts.end(),
      [](const auto& left, const auto& right) { return left.second < right.second; });
  return best == counts.end() || best->second < 2 ? nullptr : &best->first;
}

}  // namespace

bool ExpressionGraph::share_factor_pair(std::vector<ScaledNode>& roots) {
  using Pair = std::pair<NodeIndex, NodeIndex>;
  const NodeTable<bool> reached = reachable(roots);
  std::map<Pair, int> counts;
  for (const NodeIndex index : reached.keys()) {
    const std::vector<NodeIndex>& factors = nodes_[index].factors;
    if (!reached[index]) {
      continue;
    }
    std::map<Pair, int> here;
    for (std::size_t i = 0; i < factors.size(); ++i) {
      for (std::size_t j = i + 1; j < factors.size(); ++j) {
        here[{factors[i], factors[j]}] = 1;
      }
    }
    for (const auto& [pair, count] : here) {
      counts[pair] += count;
    }
  }
  const Pair* best = most_frequent(counts);
  if (best == nullptr) {
    return false;
  }
  const auto [first, second] = *best;
  const NodeIndex shared = make_product({first, second}).node;
  std::map<NodeIndex, Node> rewritten;
  for (const NodeIndex index : reached.keys()) {
    if (!reached[index] || nodes_[index].factors.size() < 3) {
      continue;
    }
    std::vector<NodeIndex> factors = nodes_[index].factors;
    const auto one = std::find(factors.begin(), factors.end(), first);
    if (one == factors.end()) {
      continue;
    }
    const auto other = std::find(one + 1, factors.end(), second);
    if (other == factors.end()) {
      continue;
    }
    factors.erase(other);
    factors.erase(one);
    factors.push_back(shared);
    rewritten[index] = {Operation::product, {}, std::move(factors), {}};
  }
  rebuild(roots, rewritten);
  return true;
}

bool ExpressionGraph::share_term_pair(std::vector<ScaledNode>& roots) {
  // A pair is two nodes and the ratio of their coefficients.
  using Pair = std::pair<std::pair<NodeIndex, NodeIndex>, std::string>;
  const NodeTable<bool> reached = reachable(roots);
  const auto ratio = [](const ScaledNode& first, const ScaledNode& second) {
    return (second.coefficient / first.coefficient).text();
  };
  // The pair as a sum, with a coefficient of one where that saves a multiplication.
  const auto sum_of = [&](const ScaledNode& first, const ScaledNode& second) {
    const bool number = nodes_[first.node].operation == Operation::constant;
    const Coefficient unit = number ? second.coefficient : first.coefficient;
    return std::pair(unit, std::vector<ScaledNode>{{first.coefficient / unit, first.node},
                                                   {second.coefficient / unit, second.node}});
  };
  const auto scalings = [&](const std::vector<ScaledNode>& terms) {
    return static_cast<int>(std::count_if(terms.begin(), terms.end(),
                                          [&](const ScaledNode& term) { return is_scaled(term); }));
  };
  std::map<Pair, int> counts;
  std::map<Pair, int> savings;
  for (const NodeIndex index : reached.keys()) {
    const std::vector<ScaledNode>& terms = nodes_[index].terms;
    if (!reached[index]) {
      continue;
    }
    for (std::size_t i = 0; i < terms.size(); ++i) {
      for (std::size_t j = i + 1; j < terms.size(); ++j) {
        const Pair pair{{terms[i].node, terms[j].node}, ratio(terms[i], terms[j])};
        const auto [unit, alone] = sum_of(terms[i], terms[j]);
        ++counts[pair];
        savings.try_emplace(pair, -1 - scalings(alone)).first->second +=
            1 + scalings({terms[i], terms[j]}) - (unit.scales() ? 1 : 0);
      }
    }
  }
  std::erase_if(counts, [&](const auto& entry) { return savings.at(entry.first) <= 0; });
  const Pair* best = most_frequent(counts);
  if (best == nullptr) {
    return false;
  }
  const Pair pair = *best;
  ScaledNode shared{0, {}};
  std::map<NodeIndex, Node> rewritten;
  for (const NodeIndex index : reached.keys()) {
    if (!reached[index] || nodes_[index].terms.size() < 2) {
      continue;
    }
    // A copy: creating the shared node may move the nodes.
    const std::vector<ScaledNode> terms = nodes_[index].terms;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      for (std::size_t j = i + 1; j < terms.size(); ++j) {
        if (std::pair(terms[i].node, terms[j].node) != pair.first ||
            ratio(terms[i], terms[j]) != pair.second || rewritten.contains(index)) {
          continue;
        }
        const auto [unit, alone] = sum_of(terms[i], terms[j]);
        if (!shared.node.exists()) {
          shared = make_sum(alone);
        }
        if (shared.node == index) {
          i = j = terms.size();
          continue;
        }
        std::vector<ScaledNode> rest;
        for (std::size_t k = 0; k < terms.size(); ++k) {
          if (k != i && k != j) {
            rest.push_back(terms[k]);
          }
        }
        rest.push_back({unit * shared.coefficient, shared.node});
        rewritten[index] = {Operation::sum, {}, {}, std::move(rest)};
        i = j = terms.size();
      }
    }
  }
  rebuild(roots, rewritten);
  return true;
}

void ExpressionGraph::share_pairs(std::vector<ScaledNode>& roots) {
  while (share_factor_pair(roots)) {
  }
  while (share_term_pair(roots)) {
  }
}

}  // namespace assur::generator::program
