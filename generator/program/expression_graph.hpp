// A graph of sums and products for polynomials, in which every common part is computed once.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "program/polynomial.hpp"

namespace assur::generator::program {

/// Additions (including subtractions), multiplications, divisions and square roots. A change of
/// sign is free, and so are operations on numbers only, which a compiler folds. A product with a
/// number is a multiplication, even for a power of two.
struct OperationCount {
  std::size_t multiplications = 0;
  std::size_t additions = 0;
  std::size_t divisions = 0;
  std::size_t square_roots = 0;

  OperationCount& operator+=(const OperationCount& other);
};

using NodeIndex = text::Index<class ExpressionGraph>;
/// An item for each node of a graph.
template <typename Item>
using NodeTable = text::Table<NodeIndex, Item>;

/// A multiple of a node of the graph.
struct ScaledNode {
  Coefficient coefficient;
  NodeIndex node;
};

/// A directed acyclic graph of n-ary sums and products over symbols. Equal nodes are one node, and
/// all orders are by rank and by age, so that the graph depends only on its input.
class ExpressionGraph {
 public:
  enum class Operation : unsigned char { constant, symbol, product, sum };
  struct Node {
    Operation operation;
    SymbolRank symbol;               ///< exists only if the node is a symbol
    std::vector<NodeIndex> factors;  ///< of a product, ascending, repeated for squares
    std::vector<ScaledNode> terms;   ///< of a sum, a positive one first if there is one
  };

  explicit ExpressionGraph(const SymbolOrder& order) : order_(&order) {}

  /// Adds a polynomial as nested sums and products, extracting the most frequent factor first.
  ScaledNode add(const Polynomial& polynomial);

  /// Makes nodes of pairs of factors and pairs of terms that occur in several nodes, the most
  /// frequent first. `roots` are the results, which remain.
  void share_pairs(std::vector<ScaledNode>& roots);

  /// Replaces nodes by symbols wherever they are used. The function returns, for each node, the
  /// multiple of a symbol that equals it, and the index of the root that defines the symbol and
  /// keeps the node. Returns false if no root changes.
  struct SymbolOfNode {
    ScaledNode value;
    std::size_t definition;
  };
  bool put_symbols(std::vector<ScaledNode>& roots,
                   const std::map<NodeIndex, SymbolOfNode>& symbols);

  [[nodiscard]] const NodeTable<Node>& nodes() const { return nodes_; }
  [[nodiscard]] const SymbolOrder& order() const { return *order_; }
  /// Whether a coefficient costs a multiplication.
  [[nodiscard]] bool is_scaled(const ScaledNode& value) const;
  /// The measure of a node.
  [[nodiscard]] Measure measure(NodeIndex index) const;
  /// The operations of one node with known children.
  [[nodiscard]] OperationCount cost(NodeIndex index) const;
  /// The number of uses of each node by the nodes reachable from the roots, and by the roots.
  [[nodiscard]] NodeTable<int> uses(const std::vector<ScaledNode>& roots) const;

 private:
  /// The identity of a node: its operation, symbol, children, and coefficients as texts.
  using Key = std::tuple<Operation, SymbolRank, std::vector<NodeIndex>, std::vector<NodeIndex>,
                         std::string>;

  NodeIndex intern(Node node);
  ScaledNode make_product(std::vector<NodeIndex> factors);
  ScaledNode make_sum(std::vector<ScaledNode> terms);
  static Key key_of(const Node& node);
  /// Replaces the most frequent pair everywhere; returns false if there is no pair to share.
  bool share_factor_pair(std::vector<ScaledNode>& roots);
  bool share_term_pair(std::vector<ScaledNode>& roots);
  [[nodiscard]] NodeTable<bool> reachable(const std::vector<ScaledNode>& roots) const;
  /// Rebuilds the nodes reachable from the roots after some were rewritten or became symbols, and
  /// merges equal ones.
  void rebuild(std::vector<ScaledNode>& roots, const std::map<NodeIndex, Node>& rewritten,
               const std::map<NodeIndex, SymbolOfNode>& symbols = {});

  const SymbolOrder* order_;
  NodeTable<Node> nodes_;
  std::map<Key, NodeIndex> index_;
};

}  // namespace assur::generator::program
