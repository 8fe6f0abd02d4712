#include "program/program.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>

#include "equations/symbols.hpp"

namespace assur::generator::program {

namespace {

using Operation = ExpressionGraph::Operation;

/// The quantities that a set of expressions needs, in the order in which they were named.
std::vector<equations::NamedQuantity> needed(
    const std::vector<equations::NamedQuantity>& quantities, const std::vector<Result>& results) {
  GiNaC::exset occurring;
  for (const Result& result : results) {
    occurring.merge(equations::symbols_of(result.value));
  }
  std::vector<bool> wanted(quantities.size(), false);
  for (std::size_t back = quantities.size(); back-- > 0;) {
    if (occurring.contains(quantities[back].symbol)) {
      wanted[back] = true;
      occurring.merge(equations::symbols_of(quantities[back].definition));
    }
  }
  std::vector<equations::NamedQuantity> list;
  for (std::size_t index = 0; index < quantities.size(); ++index) {
    if (wanted[index]) {
      list.push_back(quantities[index]);
    }
  }
  return list;
}

}  // namespace

Place entry(const std::string& vector, std::size_t row) {
  return {vector, "", static_cast<int>(row), -1};
}
Place entry(const std::string& matrix, std::size_t row, std::size_t column) {
  return {matrix, "", static_cast<int>(row), static_cast<int>(column)};
}

Program::Program(const SymbolOrder& order, const std::vector<equations::NamedQuantity>& quantities,
                 const std::vector<Result>& results,
                 const std::vector<equations::NamedQuantity>& known)
    : graph_(order) {
  std::vector<equations::NamedQuantity> named = needed(quantities, results);
  std::vector<ScaledNode> roots;
  roots.reserve(named.size() + results.size());
  for (const equations::NamedQuantity& quantity : named) {
    roots.push_back(graph_.add(polynomial(quantity.definition, order)));
  }
  std::vector<Place> targets;
  for (const Result& result : results) {
    const Polynomial value = polynomial(result.value, order);
    if (!value.empty()) {
      targets.push_back(result.target);
      roots.push_back(graph_.add(value));
    }
  }
  graph_.share_pairs(roots);
  // After a part is replaced by its name, the whole may equal a named quantity, too.
  do {
    add_known(known, named, roots);
  } while (put_names(named, roots));

  const NodeTable<int> uses = graph_.uses(roots);
  names_.resize(uses.size());
  shared_.assign(uses.size(), false);
  done_.assign(uses.size(), false);
  for (const NodeIndex node : uses.keys()) {
    const ExpressionGraph::Node& content = graph_.nodes()[node];
    shared_[node] = is_computed(node) && uses[node] > 1;
    if (content.operation == Operation::symbol) {
      names_[node] = order.name(content.symbol);
    }
  }
  for (std::size_t index = 0; index < named.size(); ++index) {
    const std::string name = named[index].symbol.get_name();
    const equations::NamedQuantity::Form form = named[index].form;
    const bool plain = form == equations::NamedQuantity::Form::itself;
    definitions_[name] = {name, roots[index], form, plain ? "" : named[index].meaning};
  }
  // Given values may make a name of a definition needless.
  NodeTable<bool> read;
  read.assign(uses.size(), false);
  const std::function<void(NodeIndex)> mark = [&](NodeIndex node) {
    if (read[node]) {
      return;
    }
    read[node] = true;
    const ExpressionGraph::Node& content = graph_.nodes()[node];
    if (const auto definition = definitions_.find(names_[node]);
        content.operation == Operation::symbol && definition != definitions_.end()) {
      mark(definition->second.value.node);
    }
    std::ranges::for_each(content.factors, mark);
    std::ranges::for_each(content.terms, [&](const ScaledNode& term) { mark(term.node); });
  };
  for (std::size_t index = 0; index < targets.size(); ++index) {
    mark(roots[named.size() + index].node);
  }
  for (const equations::NamedQuantity& quantity : named) {
    if (const NodeIndex node = graph_.add(polynomial(quantity.symbol, order)).node; read[node]) {
      schedule(node, order);
    }
  }
  for (std::size_t index = 0; index < targets.size(); ++index) {
    assignments_.push_back({targets[index], roots[named.size() + index]});
    schedule(assignments_.back().value.node, order);
  }
}

bool Program::is_computed(NodeIndex node) const {
  const Operation operation = graph_.nodes()[node].operation;
  return operation == Operation::product || operation == Operation::sum;
}

void Program::add_known(const std::vector<equations::NamedQuantity>& known,
                        std::vector<equations::NamedQuantity>& named,
                        std::vector<ScaledNode>& roots) {
  const NodeTable<int> uses = graph_.uses(roots);
  std::set<std::string> names;
  std::set<NodeIndex> nodes;
  for (std::size_t index = 0; index < named.size(); ++index) {
    names.insert(named[index].symbol.get_name());
    if (!roots[index].coefficient.scales()) {
      nodes.insert(roots[index].node);
    }
  }
  for (const equations::NamedQuantity& quantity : known) {
    const ScaledNode value = graph_.add(polynomial(quantity.definition, graph_.order()));
    const bool is_shared = value.node.place() < uses.size() && uses[value.node] > 1;
    if (quantity.form == equations::NamedQuantity::Form::itself && is_computed(value.node) &&
        is_shared && !value.coefficient.scales() && !nodes.contains(value.node) &&
        names.insert(quantity.symbol.get_name()).second) {
      nodes.insert(value.node);
      roots.insert(roots.begin() + std::ssize(named), value);
      named.push_back(quantity);
    }
  }
}

bool Program::put_names(const std::vector<equations::NamedQuantity>& named,
                        std::vector<ScaledNode>& roots) {
  std::map<NodeIndex, ExpressionGraph::SymbolOfNode> symbols;
  for (std::size_t index = 0; index < named.size(); ++index) {
    const ScaledNode value = roots[index];
    if (named[index].form == equations::NamedQuantity::Form::itself && is_computed(value.node) &&
        !value.coefficient.scales()) {
      const NodeIndex symbol = graph_.add(polynomial(named[index].symbol, graph_.order())).node;
      symbols.try_emplace(value.node,
                          ExpressionGraph::SymbolOfNode{{value.coefficient, symbol}, index});
    }
  }
  return graph_.put_symbols(roots, symbols);
}

void Program::schedule(NodeIndex node, const SymbolOrder& order) {
  if (done_[node]) {
    return;
  }
  done_[node] = true;
  const ExpressionGraph::Node content = graph_.nodes()[node];
  if (content.operation == Operation::symbol) {
    const auto definition = definitions_.find(names_[node]);
    if (definition != definitions_.end()) {
      schedule(definition->second.value.node, order);
      steps_.push_back(definition->second);
    }
    return;
  }
  for (const NodeIndex factor : content.factors) {
    schedule(factor, order);
  }
  for (const ScaledNode& term : content.terms) {
    schedule(term.node, order);
  }
  if (shared_[node]) {
    do {
      ++temporaries_;
      names_[node] = (temporaries_ < 10 ? "t0" : "t") + std::to_string(temporaries_);
    } while (order.declares(names_[node]));
    steps_.push_back({names_[node], {1, node}, equations::NamedQuantity::Form::itself, ""});
  }
}

std::vector<ScaledNode> Program::values() const {
  std::vector<ScaledNode> list;
  for (const Step& step : steps_) {
    list.push_back(step.value);
  }
  for (const Assignment& assignment : assignments_) {
    list.push_back(assignment.value);
  }
  return list;
}

std::vector<NodeIndex> Program::computed() const {
  std::vector<NodeIndex> list;
  std::function<void(NodeIndex)> compute;
  const auto use = [&](NodeIndex node) {
    if (name_of(node).empty()) {
      compute(node);
    }
  };
  compute = [&](NodeIndex node) {
    list.push_back(node);
    const ExpressionGraph::Node& content = graph_.nodes()[node];
    std::for_each(content.factors.begin(), content.factors.end(), use);
    for (const ScaledNode& term : content.terms) {
      use(term.node);
    }
  };
  for (const Step& step : steps_) {
    if (name_of(step.value.node) == step.name) {
      compute(step.value.node);
    } else {
      use(step.value.node);
    }
  }
  for (const Assignment& assignment : assignments_) {
    use(assignment.value.node);
  }
  return list;
}

OperationCount Program::count() const {
  OperationCount total;
  for (const NodeIndex node : computed()) {
    total += graph_.cost(node);
  }
  for (const ScaledNode& value : values()) {
    total.multiplications += graph_.is_scaled(value) ? 1 : 0;
  }
  for (const Step& step : steps_) {
    total.divisions += step.form == equations::NamedQuantity::Form::reciprocal ? 1 : 0;
    total.square_roots += step.form == equations::NamedQuantity::Form::square_root ? 1 : 0;
  }
  return total;
}

std::vector<NodeIndex> Program::named_in(const ScaledNode& value, const std::string& name) const {
  std::vector<NodeIndex> nodes;
  const std::function<void(NodeIndex, bool)> visit = [&](NodeIndex node, bool is_value) {
    if (!name_of(node).empty() && !(is_value && name_of(node) == name)) {
      nodes.push_back(node);
      return;
    }
    const ExpressionGraph::Node& content = graph_.nodes()[node];
    for (const NodeIndex factor : content.factors) {
      visit(factor, false);
    }
    for (const ScaledNode& term : content.terms) {
      visit(term.node, false);
    }
  };
  visit(value.node, true);
  return nodes;
}

std::vector<std::string> Program::reads() const {
  std::set<SymbolRank> ranks;
  const auto add = [&](const ScaledNode& value, const std::string& name) {
    for (const NodeIndex node : named_in(value, name)) {
      const ExpressionGraph::Node& content = graph_.nodes()[node];
      if (content.operation == Operation::symbol && !definitions_.contains(name_of(node))) {
        ranks.insert(content.symbol);
      }
    }
  };
  for (const Step& step : steps_) {
    add(step.value, step.name);
  }
  for (const Assignment& assignment : assignments_) {
    add(assignment.value, "");
  }
  std::vector<std::string> names;
  names.reserve(ranks.size());
  for (const SymbolRank rank : ranks) {
    names.push_back(graph_.order().name(rank));
  }
  return names;
}

Program Program::part(const std::set<Place>& targets) const {
  Program result = *this;
  std::erase_if(result.assignments_,
                [&](const Assignment& assignment) { return !targets.contains(assignment.target); });
  std::set<std::string> needed;
  const auto need = [&](const ScaledNode& value, const std::string& name) {
    for (const NodeIndex node : named_in(value, name)) {
      needed.insert(name_of(node));
    }
  };
  for (const Assignment& assignment : result.assignments_) {
    need(assignment.value, "");
  }
  // A step reads only earlier ones.
  std::vector<Step> steps;
  for (auto step = steps_.rbegin(); step != steps_.rend(); ++step) {
    if (needed.contains(step->name)) {
      need(step->value, step->name);
      steps.push_back(*step);
    }
  }
  result.steps_.assign(steps.rbegin(), steps.rend());
  return result;
}

Program Program::filtered(const Program& other, bool in_both) const {
  std::set<std::string> names;
  for (const Step& step : other.steps_) {
    names.insert(step.name);
  }
  std::set<Place> targets;
  for (const Assignment& assignment : other.assignments_) {
    targets.insert(assignment.target);
  }
  Program result = *this;
  std::erase_if(result.steps_,
                [&](const Step& step) { return names.contains(step.name) != in_both; });
  std::erase_if(result.assignments_, [&](const Assignment& assignment) {
    return targets.contains(assignment.target) != in_both;
  });
  return result;
}

Program Program::common(const Program& other) const { return filtered(other, true); }
Program Program::without(const Program& other) const { return filtered(other, false); }

}  // namespace assur::generator::program
