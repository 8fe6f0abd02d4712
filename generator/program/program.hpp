// Straight-line programs for named quantities and results, with each step computed once.
#pragma once

#include <compare>
#include <set>
#include <string>
#include <vector>

#include "equations/vocabulary.hpp"
#include "program/expression_graph.hpp"

namespace assur::generator::program {

/// The place of a number: an argument of a function, or an entry or a member of it.
struct Place {
  std::string argument;
  std::string member;         ///< `.direction.cos` of a frame; empty for entries
  int row = -1, column = -1;  ///< of an entry; a vector has no columns
  [[nodiscard]] bool is_entry() const { return row >= 0; }
  friend auto operator<=>(const Place&, const Place&) = default;
};
/// An entry of a vector or a matrix.
[[nodiscard]] Place entry(const std::string& vector, std::size_t row);
[[nodiscard]] Place entry(const std::string& matrix, std::size_t row, std::size_t column);

/// One result of a program: its target and its value.
struct Result {
  Place target;
  GiNaC::ex value;
};

/// A straight-line program without branches.
class Program {
 public:
  /// A step names a node: by a geometric quantity, or `t01` if there is none.
  struct Step {
    std::string name;
    ScaledNode value;
    equations::NamedQuantity::Form form =
        equations::NamedQuantity::Form::itself;  ///< the value, its reciprocal or its root
    std::string degeneracy;  ///< the meaning of a value without a reciprocal or root
  };
  struct Assignment {
    Place target;
    ScaledNode value;
  };

  /// `order` ranks every symbol, also those of the quantities. Only quantities that the results
  /// need are computed, and results that are zero are left out. A value that is read several times
  /// takes its name from the `known` quantities of other programs, if it has one there.
  Program(const SymbolOrder& order, const std::vector<equations::NamedQuantity>& quantities,
          const std::vector<Result>& results,
          const std::vector<equations::NamedQuantity>& known = {});

  /// The part that assigns to these targets, with the steps that it needs.
  [[nodiscard]] Program part(const std::set<Place>& targets) const;
  /// The computations that two parts of one program share.
  [[nodiscard]] Program common(const Program& other) const;
  /// The computations of this part of a program that are not in another part.
  [[nodiscard]] Program without(const Program& other) const;

  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
  [[nodiscard]] const std::vector<Assignment>& assignments() const { return assignments_; }
  [[nodiscard]] const ExpressionGraph& graph() const { return graph_; }
  /// The name of a node after its step; empty if it has none.
  [[nodiscard]] const std::string& name_of(NodeIndex node) const { return names_[node]; }
  /// The values of all steps, then of all assignments.
  [[nodiscard]] std::vector<ScaledNode> values() const;
  /// The computed nodes, each as many times as it is computed: once if it has a name, else wherever
  /// it is read.
  [[nodiscard]] std::vector<NodeIndex> computed() const;
  [[nodiscard]] OperationCount count() const;
  /// Names of the symbols that the program reads and no step computes, in order of rank, without
  /// those that another part of the program computes.
  [[nodiscard]] std::vector<std::string> reads() const;

 private:
  /// Adds the shared known quantities to the named ones, and their values to the roots.
  void add_known(const std::vector<equations::NamedQuantity>& known,
                 std::vector<equations::NamedQuantity>& named, std::vector<ScaledNode>& roots);
  /// Replaces nodes by the names of equal quantities; false if nothing changes.
  bool put_names(const std::vector<equations::NamedQuantity>& named,
                 std::vector<ScaledNode>& roots);
  [[nodiscard]] bool is_computed(NodeIndex node) const;
  /// The named nodes that the value of a step or of an assignment reads.
  [[nodiscard]] std::vector<NodeIndex> named_in(const ScaledNode& value,
                                                const std::string& name) const;
  /// The steps and assignments whose names and targets are in both programs, or only in this one.
  [[nodiscard]] Program filtered(const Program& other, bool in_both) const;
  void schedule(NodeIndex node, const SymbolOrder& order);

  ExpressionGraph graph_;
  std::vector<Step> steps_;
  std::vector<Assignment> assignments_;
  NodeTable<std::string> names_;
  // For scheduling: the definition of each computed symbol, and the nodes that become steps.
  std::map<std::string, Step> definitions_;
  NodeTable<bool> shared_;
  NodeTable<bool> done_;
  int temporaries_ = 0;
};

}  // namespace assur::generator::program
