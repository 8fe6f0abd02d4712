// Strongly connected components of a dependency relation.
#pragma once

#include <algorithm>
#include <assur/text/index.hpp>
#include <vector>

namespace assur::mechanism::plan {

using ComponentIndex = text::Index<struct StrongComponent>;

/// The strongly connected components of vertices that depend on one another (Tarjan).
template <typename VertexIndex>
class StrongComponents {
 public:
  /// `needs` lists for each vertex those on which it depends. It must outlive the constructor only.
  explicit StrongComponents(const text::Table<VertexIndex, std::vector<VertexIndex>>& needs)
      : needs_(needs),
        order_(needs.size(), -1),
        lowest_(needs.size(), -1),
        component_(needs.size()) {
    for (const VertexIndex vertex : needs.keys()) {
      if (order_[vertex] < 0) {
        visit(vertex);
      }
    }
  }

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] ComponentIndex of(VertexIndex vertex) const { return component_[vertex]; }

 private:
  void visit(VertexIndex vertex) {
    order_[vertex] = lowest_[vertex] = next_++;
    open_.push_back(vertex);
    for (const VertexIndex needed : needs_[vertex]) {
      if (order_[needed] < 0) {
        visit(needed);
        lowest_[vertex] = std::min(lowest_[vertex], lowest_[needed]);
      } else if (!component_[needed].exists()) {
        lowest_[vertex] = std::min(lowest_[vertex], order_[needed]);
      }
    }
    if (lowest_[vertex] == order_[vertex]) {
      const ComponentIndex component(count_++);
      VertexIndex closed;
      do {
        closed = open_.back();
        open_.pop_back();
        component_[closed] = component;
      } while (closed != vertex);
    }
  }

  const text::Table<VertexIndex, std::vector<VertexIndex>>& needs_;
  text::Table<VertexIndex, int> order_, lowest_;
  text::Table<VertexIndex, ComponentIndex> component_;
  std::vector<VertexIndex> open_;
  int next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace assur::mechanism::plan
