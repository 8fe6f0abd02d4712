#include "scene/decomposition.hpp"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/max_cardinality_matching.hpp>
#include <boost/graph/strong_components.hpp>
#include <limits>
#include <set>
#include <tuple>

namespace assur::generator {

namespace {

/// What moves as one: a link, or the point of a pin of several links.
struct Body {
  int link;  ///< or -1
  int pin;   ///< or -1
};

/// What ties one body to another, or to what is placed: two equations.
struct Tie {
  int body;
  int other;  ///< or -1 for what is placed
  std::string joint;
};

constexpr int placed_body = -1;

class StructuralGraph {
 public:
  StructuralGraph(const Mechanism& mechanism, const std::vector<bool>& placed,
                  const std::vector<bool>& spent)
      : mechanism_(mechanism), placed_(placed) {
    collect_bodies();
    collect_ties(spent);
    match();
  }

  Decomposition run() {
    Decomposition result;
    result.mechanism = mechanism_;
    find_imbalances(result);
    if (result.free.surplus > 0 || result.overloaded.surplus > 0) {
      return result;
    }
    order_components();
    resolve_pins(result.mechanism);
    list_components(result);
    return result;
  }

 private:
  using Vertex = std::size_t;
  using MatchingGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
  using DependencyGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS>;

  static constexpr int constraints_of_a_tie = 2;
  [[nodiscard]] int freedoms(int body) const {
    return bodies_[static_cast<std::size_t>(body)].link >= 0 ? 3 : 2;
  }

  void collect_bodies() {
    body_of_link_.assign(mechanism_.links.size(), placed_body);
    for (std::size_t link = 0; link < mechanism_.links.size(); ++link) {
      if (!placed_[link]) {
        body_of_link_[link] = static_cast<int>(bodies_.size());
        bodies_.push_back({static_cast<int>(link), -1});
      }
    }
    for (std::size_t pin = 0; pin < mechanism_.pins.size(); ++pin) {
      const std::vector<int>& links = mechanism_.pins[pin].links;
      const bool holds = std::any_of(links.begin(), links.end(), [&](int link) {
        return placed_[static_cast<std::size_t>(link)];
      });
      body_of_pin_.push_back(holds ? placed_body : static_cast<int>(bodies_.size()));
      if (!holds) {
        bodies_.push_back({-1, static_cast<int>(pin)});
      }
    }
  }

  void tie(int one, int other, const std::string& joint) {
    if (one == placed_body) {
      std::swap(one, other);
    }
    ties_.push_back({one, other, joint});
  }

  void collect_ties(const std::vector<bool>& spent) {
    for (std::size_t index = 0; index < mechanism_.joints.size(); ++index) {
      const MechanismJoint& joint = mechanism_.joints[index];
      if (!spent[index]) {
        tie(body_of_link_[static_cast<std::size_t>(joint.first)],
            body_of_link_[static_cast<std::size_t>(joint.second)], joint.name);
      }
    }
    for (std::size_t pin = 0; pin < mechanism_.pins.size(); ++pin) {
      bool holder = body_of_pin_[pin] == placed_body;  // the first placed link is the pin's own
      for (const int link : mechanism_.pins[pin].links) {
        const int body = body_of_link_[static_cast<std::size_t>(link)];
        if (body == placed_body && holder) {
          holder = false;
          continue;
        }
        tie(body, body_of_pin_[pin], mechanism_.pins[pin].name);
      }
    }
  }

  /// Vertices: the freedoms, body by body, then the constraints, tie by tie.
  void match() {
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
      for (int copy = 0; copy < freedoms(static_cast<int>(body)); ++copy) {
        body_of_freedom_.push_back(static_cast<int>(body));
      }
    }
    const std::size_t freedom_count = body_of_freedom_.size();
    const std::size_t total = freedom_count + constraints_of_a_tie * ties_.size();
    MatchingGraph graph(total);
    for (std::size_t constraint = freedom_count; constraint < total; ++constraint) {
      const Tie& at = tie_of(constraint);
      for (std::size_t freedom = 0; freedom < freedom_count; ++freedom) {
        if (body_of_freedom_[freedom] == at.body || body_of_freedom_[freedom] == at.other) {
          boost::add_edge(freedom, constraint, graph);
        }
      }
    }
    mate_.assign(total, boost::graph_traits<MatchingGraph>::null_vertex());
    boost::edmonds_maximum_cardinality_matching(graph, mate_.data());
  }

  [[nodiscard]] const Tie& tie_of(Vertex constraint) const {
    return ties_[(constraint - body_of_freedom_.size()) / constraints_of_a_tie];
  }
  [[nodiscard]] bool matched(Vertex vertex) const {
    return mate_[vertex] != boost::graph_traits<MatchingGraph>::null_vertex();
  }

  /// What alternating paths from the unmatched vertices of one side reach.
  void find_imbalances(Decomposition& result) const {
    const std::size_t freedom_count = body_of_freedom_.size();
    std::set<int> free_bodies;
    std::set<std::size_t> overloaded_ties;
    for (Vertex vertex = 0; vertex < mate_.size(); ++vertex) {
      if (!matched(vertex)) {
        ++(vertex < freedom_count ? result.free : result.overloaded).surplus;
        if (vertex < freedom_count) {
          free_bodies.insert(body_of_freedom_[vertex]);
        } else {
          overloaded_ties.insert((vertex - freedom_count) / constraints_of_a_tie);
        }
      }
    }
    const auto touches = [](const Tie& at, int body) {
      return at.body == body || at.other == body;
    };
    // A free body frees what the constraints matched elsewhere could release in its favour.
    for (bool grown = true; grown;) {
      grown = false;
      for (Vertex constraint = freedom_count; constraint < mate_.size(); ++constraint) {
        const Tie& at = tie_of(constraint);
        const bool reached = std::any_of(free_bodies.begin(), free_bodies.end(),
                                         [&](int body) { return touches(at, body); });
        if (reached && matched(constraint)) {
          grown = free_bodies.insert(body_of_freedom_[mate_[constraint]]).second || grown;
        }
      }
    }
    for (bool grown = true; grown;) {
      grown = false;
      for (Vertex freedom = 0; freedom < freedom_count; ++freedom) {
        const bool reached = std::any_of(
            overloaded_ties.begin(), overloaded_ties.end(),
            [&](std::size_t index) { return touches(ties_[index], body_of_freedom_[freedom]); });
        if (reached && matched(freedom)) {
          const std::size_t index = (mate_[freedom] - freedom_count) / constraints_of_a_tie;
          grown = overloaded_ties.insert(index).second || grown;
        }
      }
    }
    std::set<int> overloaded_bodies;
    for (const std::size_t index : overloaded_ties) {
      add_joint(ties_[index].joint, result.overloaded);
      overloaded_bodies.insert({ties_[index].body, ties_[index].other});
    }
    add_links(free_bodies, result.free);
    add_links(overloaded_bodies, result.overloaded);
  }

  static void add_joint(const std::string& joint, Imbalance& part) {
    if (std::find(part.joints.begin(), part.joints.end(), joint) == part.joints.end()) {
      part.joints.push_back(joint);
    }
  }
  void add_links(const std::set<int>& bodies, Imbalance& part) const {
    for (const int body : bodies) {
      if (body != placed_body && bodies_[static_cast<std::size_t>(body)].link >= 0) {
        part.links.push_back(
            mechanism_
                .links[static_cast<std::size_t>(bodies_[static_cast<std::size_t>(body)].link)]);
      }
    }
  }

  void order_components() {
    DependencyGraph graph(bodies_.size());
    for (Vertex freedom = 0; freedom < body_of_freedom_.size(); ++freedom) {
      const int body = body_of_freedom_[freedom];
      const Tie& at = tie_of(mate_[freedom]);
      const int other = at.body == body ? at.other : at.body;
      if (other != placed_body) {
        boost::add_edge(static_cast<Vertex>(body), static_cast<Vertex>(other), graph);
      }
    }
    std::vector<int> component(bodies_.size());
    const int count = boost::strong_components(graph, component.data());
    // Of the components that depend on ranked ones only, the smallest goes next.
    rank_.assign(bodies_.size(), -1);
    for (int rank = 0; rank < count; ++rank) {
      std::tuple<std::size_t, std::size_t, int> best{std::numeric_limits<std::size_t>::max(), 0,
                                                     -1};
      for (int candidate = 0; candidate < count; ++candidate) {
        std::size_t links = 0;
        std::size_t lowest = bodies_.size();
        bool ready = true;
        for (Vertex body = 0; body < bodies_.size(); ++body) {
          if (component[body] != candidate) {
            continue;
          }
          links += bodies_[body].link >= 0 ? 1 : 0;
          lowest = std::min(lowest, body);
          for (auto [edge, end] = boost::out_edges(body, graph); edge != end; ++edge) {
            const Vertex needed = boost::target(*edge, graph);
            ready = ready && (component[needed] == candidate || rank_[needed] >= 0);
          }
          ready = ready && rank_[body] < 0;
        }
        if (ready) {
          best = std::min(best, std::tuple(links, lowest, candidate));
        }
      }
      for (Vertex body = 0; body < bodies_.size(); ++body) {
        rank_[body] = component[body] == std::get<2>(best) ? rank : rank_[body];
      }
    }
  }

  [[nodiscard]] int rank_of_link(int link) const {
    const int body = body_of_link_[static_cast<std::size_t>(link)];
    return body == placed_body ? -1 : rank_[static_cast<std::size_t>(body)];
  }

  /// The links of a pin all join the one that is placed first.
  void resolve_pins(Mechanism& mechanism) const {
    for (const MechanismPin& pin : mechanism_.pins) {
      std::size_t hub = 0;
      for (std::size_t part = 1; part < pin.links.size(); ++part) {
        if (rank_of_link(pin.links[part]) < rank_of_link(pin.links[hub])) {
          hub = part;
        }
      }
      for (std::size_t part = 0; part < pin.links.size(); ++part) {
        if (part != hub) {
          mechanism.joints.push_back({pin.name, pin.scene_joint, false, pin.links[hub],
                                      pin.links[part], pin.features[hub], pin.features[part]});
        }
      }
    }
  }

  void list_components(Decomposition& result) const {
    const int count = rank_.empty() ? 0 : *std::max_element(rank_.begin(), rank_.end()) + 1;
    for (int rank = 0; rank < count; ++rank) {
      Component component;
      for (std::size_t body = 0; body < bodies_.size(); ++body) {
        if (rank_[body] == rank && bodies_[body].link >= 0) {
          component.links.push_back(bodies_[body].link);
        }
      }
      const std::vector<MechanismJoint>& joints = result.mechanism.joints;
      for (std::size_t index = 0; index < joints.size(); ++index) {
        const int first = rank_of_link(joints[index].first);
        const int second = rank_of_link(joints[index].second);
        if (std::max(first, second) == rank) {
          component.joints.push_back(static_cast<int>(index));
        }
      }
      if (!component.links.empty()) {  // the point of a pin alone is placed by its link
        result.components.push_back(std::move(component));
      }
    }
  }

  const Mechanism& mechanism_;
  const std::vector<bool>& placed_;
  std::vector<Body> bodies_;
  std::vector<int> body_of_link_, body_of_pin_;
  std::vector<Tie> ties_;
  std::vector<int> body_of_freedom_;
  std::vector<Vertex> mate_;
  std::vector<int> rank_;  ///< of each body: the number of its component in the order
};

}  // namespace

Decomposition decompose(const Mechanism& mechanism, const std::vector<bool>& placed,
                        const std::vector<bool>& spent) {
  return StructuralGraph(mechanism, placed, spent).run();
}

}  // namespace assur::generator
