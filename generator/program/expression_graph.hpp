// Turns polynomials into one graph of sums and products in which every common part is computed
// once.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "program/polynomial.hpp"

namespace assur::generator::program {

/// Additions (subtractions among them), multiplications, divisions and
/// square roots; changes of sign are free.
struct OperationCount {
  int multiplications = 0;
  int additions = 0;
  int divisions = 0;
  int square_roots = 0;

  OperationCount& operator+=(const OperationCount& other);
};

/// A node of the graph, or its negative, or any multiple.
struct ScaledNode {
  GiNaC::numeric coefficient;
  int node;
};

/// A directed acyclic graph of n-ary sums and products over symbols. Equal nodes are one node, and
/// all orders are by rank and by age, so that the graph depends on its input alone.
class ExpressionGraph {
 public:
  enum class Operation : unsigned char { constant, symbol, product, sum };
  struct Node {
    Operation operation;
    int symbol = -1;                ///< rank of a symbol
    std::vector<int> factors;       ///< of a product, ascending, repeated for squares
    std::vector<ScaledNode> terms;  ///< of a sum, a positive one first if there is any
  };

  explicit ExpressionGraph(const SymbolOrder& order) : order_(&order) {}

  /// Adds a polynomial as nested sums and products, taking out the most frequent factor first.
  ScaledNode add(const Polynomial& polynomial);

  /// Gives pairs of factors and pairs of terms that occur in several nodes a node of their own,
  /// most frequent first. `roots` are the results that must remain.
  void share_pairs(std::vector<ScaledNode>& roots);

  [[nodiscard]] const Node& node(int index) const {
    return nodes_[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] int size() const { return static_cast<int>(nodes_.size()); }
  [[nodiscard]] const SymbolOrder& order() const { return *order_; }
  /// Operations that one node costs once its children are known.
  [[nodiscard]] OperationCount cost(int index) const;
  /// How often each node is used by the nodes that the roots reach, and by the roots.
  [[nodiscard]] std::vector<int> uses(const std::vector<ScaledNode>& roots) const;

 private:
  using Key = std::pair<std::vector<int>, std::string>;

  int intern(Node node);
  ScaledNode make_product(std::vector<int> factors);
  ScaledNode make_sum(std::vector<ScaledNode> terms);
  static Key key_of(const Node& node);
  /// Replaces the pair everywhere; returns false if no pair occurs twice.
  bool share_factor_pair(std::vector<ScaledNode>& roots);
  bool share_term_pair(std::vector<ScaledNode>& roots);
  [[nodiscard]] std::vector<bool> reachable(const std::vector<ScaledNode>& roots) const;
  /// Rebuilds what the roots reach after `rewrite` changed nodes, merging equal nodes.
  void rebuild(std::vector<ScaledNode>& roots, const std::map<int, Node>& rewritten);

  const SymbolOrder* order_;
  std::vector<Node> nodes_;
  std::map<Key, int> index_;
};

}  // namespace assur::generator::program
