// Turns named quantities and results into a straight-line program: each step computed once, in
// order.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "equations/vocabulary.hpp"
#include "program/expression_graph.hpp"

namespace assur::generator::program {

/// One result of a program: where it goes and what it is.
struct Result {
  std::string target;  ///< `jacobian(0, 1)`
  GiNaC::ex value;
};

/// A straight-line program without branches.
class Program {
 public:
  /// A step gives a node its name: that of a geometric quantity, or `t01` where none exists.
  struct Step {
    std::string name;
    ScaledNode value;
    equations::NamedQuantity::Form form =
        equations::NamedQuantity::Form::itself;  ///< the value, its reciprocal or its root
    std::string degeneracy;  ///< what it means that no reciprocal or root of the value exists
  };
  struct Assignment {
    std::string target;
    ScaledNode value;
  };

  /// `order` ranks every symbol, also those of the quantities. Only quantities that the results
  /// need are computed, and results that are zero are left out. A value that is read several times
  /// gets the name that it has among the `known` quantities of other programs, if it has one there.
  Program(const SymbolOrder& order, const std::vector<equations::NamedQuantity>& quantities,
          const std::vector<Result>& results,
          const std::vector<equations::NamedQuantity>& known = {});

  /// The part that assigns to these targets, with the steps that this needs.
  [[nodiscard]] Program part(const std::set<std::string>& targets) const;
  /// Of two parts of one program: what both compute.
  [[nodiscard]] Program common(const Program& other) const;
  /// Of two parts of one program: what this one computes and the other does not.
  [[nodiscard]] Program without(const Program& other) const;

  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
  [[nodiscard]] const std::vector<Assignment>& assignments() const { return assignments_; }
  [[nodiscard]] const ExpressionGraph& graph() const { return graph_; }
  /// The name under which a node is known once its step is done; empty if it has none.
  [[nodiscard]] const std::string& name_of(NodeIndex node) const { return names_[node]; }
  /// The values of all steps, then of all assignments.
  [[nodiscard]] std::vector<ScaledNode> values() const;
  /// The nodes that are computed, each as often as it is computed: once where it gets a name, and
  /// otherwise wherever it is read.
  [[nodiscard]] std::vector<NodeIndex> computed() const;
  [[nodiscard]] OperationCount count() const;
  /// Names of the symbols that the program reads, i.e. that no step computes, in order of rank.
  /// What another part of the program computes is not among them.
  [[nodiscard]] std::vector<std::string> reads() const;

 private:
  /// Adds the known quantities that are shared to the named ones, and their values to the roots.
  void add_known(const std::vector<equations::NamedQuantity>& known,
                 std::vector<equations::NamedQuantity>& named, std::vector<ScaledNode>& roots);
  /// Replaces nodes by the names of the quantities that they equal; false if that changes nothing.
  bool put_names(const std::vector<equations::NamedQuantity>& named,
                 std::vector<ScaledNode>& roots);
  [[nodiscard]] bool is_computed(NodeIndex node) const;
  /// The nodes with names that the value of a step or of an assignment reads.
  [[nodiscard]] std::vector<NodeIndex> named_in(const ScaledNode& value,
                                                const std::string& name) const;
  /// The steps and assignments whose names and targets are in both or in one of two programs.
  [[nodiscard]] Program filtered(const Program& other, bool in_both) const;
  void schedule(NodeIndex node, const SymbolOrder& order);

  ExpressionGraph graph_;
  std::vector<Step> steps_;
  std::vector<Assignment> assignments_;
  NodeTable<std::string> names_;
  // What scheduling needs: the definition of each computed symbol, and the nodes worth a step.
  std::map<std::string, Step> definitions_;
  NodeTable<bool> shared_;
  NodeTable<bool> done_;
  int temporaries_ = 0;
};

}  // namespace assur::generator::program
