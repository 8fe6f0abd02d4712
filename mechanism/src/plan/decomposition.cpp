#include "decomposition.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "strong_components.hpp"

namespace assur::mechanism::plan {

namespace {

struct Body;
using BodyIndex = Index<Body>;
struct Tie;
using TieIndex = Index<Tie>;
/// The rank of a component in the order of solving.
using RankIndex = Index<Component>;

/// A set of links that drivers connect, or the point of a pin of several links; it moves as one.
struct Body {
  LinkIndex link;                 ///< the carrier; does not exist for a pin
  int freedoms;                   ///< three for a link, two for a point
  std::vector<TieIndex> matched;  ///< for each freedom that is taken, the tie that takes it
};

/// A joint or driver between one body and another, or a placed link.
struct Tie {
  BodyIndex body;
  BodyIndex other;  ///< does not exist for a placed link
  std::string joint;
  int equations = 2;
  std::vector<LinkIndex> read = {};  ///< by the law of its driver
  int unmatched = 0;                 ///< equations that take no freedom

  [[nodiscard]] bool touches(BodyIndex at) const {
    return at.exists() && (body == at || other == at);
  }
};

/// Whether links that drivers connect are one body, or separate bodies that the drivers constrain.
enum class DrivenAs : unsigned char { one_body, bodies };

class StructuralGraph {
 public:
  StructuralGraph(const Linkage& linkage, const DrivenBodies& driven, DrivenAs driven_as)
      : linkage_(linkage), driven_(driven), driven_as_(driven_as) {
    collect_bodies();
    collect_ties();
    asked_.assign(bodies_.size(), 0);
    for (const TieIndex tie : ties_.keys()) {
      for (int equation = 0; equation < ties_[tie].equations; ++equation) {
        ++round_;
        ties_[tie].unmatched += matched(tie) ? 0 : 1;
      }
    }
  }

  /// Finds the parts that alternating paths reach from unmatched freedoms or equations.
  void find_imbalances(Decomposition& result) const {
    std::set<BodyIndex> free;
    std::set<TieIndex> overloading;
    for (const BodyIndex body : bodies_.keys()) {
      const int left = bodies_[body].freedoms - static_cast<int>(bodies_[body].matched.size());
      result.free.surplus += left;
      if (left > 0) {
        free.insert(body);
      }
    }
    for (const TieIndex tie : ties_.keys()) {
      result.overloaded.surplus += ties_[tie].unmatched;
      if (ties_[tie].unmatched > 0) {
        overloading.insert(tie);
      }
    }
    // A body is free, too, if one of its constraints could be matched with a free body instead.
    for (bool grown = true; grown;) {
      grown = false;
      for (const BodyIndex body : bodies_.keys()) {
        const bool reached = std::any_of(
            bodies_[body].matched.begin(), bodies_[body].matched.end(), [&](TieIndex tie) {
              return free.contains(ties_[tie].body) || free.contains(ties_[tie].other);
            });
        grown = (reached && free.insert(body).second) || grown;
      }
    }
    for (bool grown = true; grown;) {
      grown = false;
      for (const BodyIndex body : bodies_.keys()) {
        const bool reached = std::any_of(overloading.begin(), overloading.end(),
                                         [&](TieIndex tie) { return ties_[tie].touches(body); });
        if (reached) {
          for (const TieIndex tie : bodies_[body].matched) {
            grown = overloading.insert(tie).second || grown;
          }
        }
      }
    }
    std::set<BodyIndex> overloaded;
    for (const TieIndex tie : overloading) {
      std::vector<std::string>& joints = result.overloaded.joints;
      if (std::find(joints.begin(), joints.end(), ties_[tie].joint) == joints.end()) {
        joints.push_back(ties_[tie].joint);
      }
      overloaded.insert({ties_[tie].body, ties_[tie].other});
    }
    add_links(free, result.free);
    add_links(overloaded, result.overloaded);
  }

  void decompose(Decomposition& result) {
    rank_bodies(result);
    if (result.coupled.links.empty()) {
      resolve_pins(result.linkage);
      list_components(result);
    }
  }

 private:
  [[nodiscard]] bool is_placed(LinkIndex link) const {
    return driven_as_ == DrivenAs::one_body ? driven_.placed[link] : link == linkage_.ground;
  }
  [[nodiscard]] LinkIndex carrier(LinkIndex link) const {
    return driven_as_ == DrivenAs::one_body ? driven_.carrier[link] : link;
  }

  void collect_bodies() {
    body_of_link_.assign(linkage_.links.size(), BodyIndex());
    for (const LinkIndex link : linkage_.links.keys()) {
      if (!is_placed(link) && carrier(link) == link) {
        body_of_link_[link] = bodies_.add({link, 3, {}});
      }
    }
    for (const LinkIndex link : linkage_.links.keys()) {
      body_of_link_[link] = body_of_link_[carrier(link)];
    }
    for (const SharedPin& pin : linkage_.pins) {
      const bool holds = std::any_of(pin.links.begin(), pin.links.end(),
                                     [&](LinkIndex link) { return is_placed(link); });
      body_of_pin_.push_back(holds ? BodyIndex() : bodies_.add({LinkIndex(), 2, {}}));
    }
  }

  void tie(BodyIndex one, BodyIndex other, const std::string& joint, int equations = 2,
           std::vector<LinkIndex> read = {}) {
    if (one == other) {  // a tie within one body takes no freedom
      one = other = BodyIndex();
    }
    if (!one.exists()) {
      std::swap(one, other);
    }
    ties_.add({one, other, joint, equations, std::move(read)});
  }

  void collect_ties() {
    for (const ElementaryJointIndex index : linkage_.joints.keys()) {
      const ElementaryJoint& joint = linkage_.joints[index];
      const BodyIndex one = body_of_link_[joint.first];
      const BodyIndex other = body_of_link_[joint.second];
      if (!driven_.driven[index]) {
        tie(one, other, joint.name);
      } else if (driven_as_ == DrivenAs::bodies) {
        tie(one, other, joint.name, 3, driven_.read[index]);
      }
    }
    for (std::size_t pin = 0; pin < linkage_.pins.size(); ++pin) {
      bool holder = !body_of_pin_[pin].exists();  // the first placed link is the pin's own
      std::set<BodyIndex> tied;
      for (const LinkIndex link : linkage_.pins[pin].links) {
        const BodyIndex body = body_of_link_[link];
        if (!body.exists() && holder) {
          holder = false;
          continue;
        }
        const bool is_tied = body.exists() && !tied.insert(body).second;
        tie(is_tied ? body_of_pin_[pin] : body, body_of_pin_[pin], linkage_.pins[pin].name);
      }
    }
  }

  /// Matches one equation of a tie with a freedom, if necessary by matching other equations with
  /// other freedoms. Each body is visited once in a round. Returns whether there was a freedom.
  [[nodiscard]] bool matched(TieIndex tie) {
    for (const BodyIndex body : {ties_[tie].body, ties_[tie].other}) {
      if (!body.exists() || asked_[body] == round_) {
        continue;
      }
      asked_[body] = round_;
      if (std::ssize(bodies_[body].matched) < bodies_[body].freedoms) {
        bodies_[body].matched.push_back(tie);
        return true;
      }
      for (TieIndex& held : bodies_[body].matched) {
        if (matched(held)) {
          held = tie;
          return true;
        }
      }
    }
    return false;
  }

  void add_links(const std::set<BodyIndex>& bodies, Imbalance& part) const {
    for (const BodyIndex body : bodies) {
      if (body.exists() && bodies_[body].link.exists()) {
        part.links.push_back(linkage_.links[bodies_[body].link]);
      }
    }
  }

  /// Ranks the components: of those that depend on ranked ones only, the smallest is next, and
  /// among equal ones the one whose links' names come first. The order must not depend on the
  /// listing, since configurations may be numbered group by group.
  void rank_bodies(Decomposition& result) {
    Table<BodyIndex, std::vector<BodyIndex>> needs(bodies_.size());
    Table<BodyIndex, std::vector<BodyIndex>> read(bodies_.size());
    for (const BodyIndex body : bodies_.keys()) {
      for (const TieIndex tie : bodies_[body].matched) {
        const BodyIndex other = ties_[tie].body == body ? ties_[tie].other : ties_[tie].body;
        if (other.exists()) {
          needs[body].push_back(other);
        }
        for (const LinkIndex link : ties_[tie].read) {
          if (body_of_link_[link].exists()) {
            read[body].push_back(body_of_link_[link]);
          }
        }
      }
    }
    const StrongComponents components(needs);
    using Rank = std::pair<std::size_t, std::vector<std::string>>;  // number of links, their names
    Table<ComponentIndex, Rank> ranks(components.count());
    Table<ComponentIndex, std::set<ComponentIndex>> waits_for(components.count());
    Table<ComponentIndex, std::vector<ComponentIndex>> waited_by(components.count());
    for (const BodyIndex body : bodies_.keys()) {
      const ComponentIndex own = components.of(body);
      auto& [links, names] = ranks[own];
      if (bodies_[body].link.exists()) {
        ++links;
        names.push_back(linkage_.links[bodies_[body].link]);
      }
      for (const BodyIndex needed : needs[body]) {
        const ComponentIndex other = components.of(needed);
        if (other != own && waits_for[own].insert(other).second) {
          waited_by[other].push_back(own);
        }
      }
      for (const BodyIndex needed : read[body]) {
        if (waits_for[own].insert(components.of(needed)).second) {
          waited_by[components.of(needed)].push_back(own);
        }
      }
    }
    for (Rank& rank : ranks) {
      std::ranges::sort(rank.second);
    }
    std::set<std::pair<Rank, ComponentIndex>> ready;
    for (const ComponentIndex component : ranks.keys()) {
      if (waits_for[component].empty()) {
        ready.insert({ranks[component], component});
      }
    }
    Table<ComponentIndex, RankIndex> rank_of(components.count());
    while (!ready.empty()) {
      const ComponentIndex next = ready.begin()->second;
      ready.erase(ready.begin());
      rank_of[next] = RankIndex(rank_count_++);
      for (const ComponentIndex waiting : waited_by[next]) {
        waits_for[waiting].erase(next);
        if (waits_for[waiting].empty()) {
          ready.insert({ranks[waiting], waiting});
        }
      }
    }
    for (const BodyIndex body : bodies_.keys()) {
      rank_.add(rank_of[components.of(body)]);
    }
    if (std::ranges::any_of(rank_, [](RankIndex rank) { return !rank.exists(); })) {
      find_circle(needs, read, result.coupled);
    }
  }

  /// Finds the links that depend on themselves through the laws of drivers, without those that
  /// merely depend on these.
  void find_circle(Table<BodyIndex, std::vector<BodyIndex>> needs,
                   const Table<BodyIndex, std::vector<BodyIndex>>& read, Imbalance& coupled) const {
    for (const BodyIndex body : bodies_.keys()) {
      needs[body].insert(needs[body].end(), read[body].begin(), read[body].end());
    }
    const StrongComponents circles(needs);
    const auto is_closed = [&](BodyIndex body) {
      return std::ranges::any_of(
          read[body], [&](BodyIndex other) { return circles.of(other) == circles.of(body); });
    };
    std::set<BodyIndex> bodies;
    for (const BodyIndex closing : bodies_.keys()) {
      if (!is_closed(closing)) {
        continue;
      }
      for (const TieIndex tie : bodies_[closing].matched) {
        const std::string& joint = ties_[tie].joint;
        if (!ties_[tie].read.empty() &&
            std::ranges::find(coupled.joints, joint) == coupled.joints.end()) {
          coupled.joints.push_back(joint);
        }
      }
      for (const BodyIndex body : bodies_.keys()) {
        if (circles.of(body) == circles.of(closing)) {
          bodies.insert(body);
        }
      }
    }
    add_links(bodies, coupled);
  }

  [[nodiscard]] RankIndex rank_of_link(LinkIndex link) const {
    const BodyIndex body = body_of_link_[link];
    return body.exists() ? rank_[body] : RankIndex();
  }

  /// Joins all links of a pin to the one that is placed first.
  void resolve_pins(Linkage& linkage) const {
    for (const SharedPin& pin : linkage_.pins) {
      std::size_t hub = 0;
      for (std::size_t part = 1; part < pin.links.size(); ++part) {
        if (rank_of_link(pin.links[part]) < rank_of_link(pin.links[hub])) {
          hub = part;
        }
      }
      for (std::size_t part = 0; part < pin.links.size(); ++part) {
        if (part != hub) {
          linkage.joints.add({pin.name, pin.joint, false, pin.links[hub], pin.links[part],
                              pin.features[hub], pin.features[part]});
        }
      }
    }
  }

  void list_components(Decomposition& result) const {
    Table<RankIndex, Component> components(rank_count_);
    for (const BodyIndex body : bodies_.keys()) {
      if (bodies_[body].link.exists()) {
        components[rank_[body]].links.push_back(bodies_[body].link);
      }
    }
    for (const ElementaryJointIndex index : result.linkage.joints.keys()) {
      const ElementaryJoint& joint = result.linkage.joints[index];
      const RankIndex rank = std::max(rank_of_link(joint.first), rank_of_link(joint.second));
      const bool is_driven = index.place() < driven_.driven.size() && driven_.driven[index];
      if (rank.exists() && !is_driven) {
        components[rank].joints.push_back(index);
      }
    }
    for (Component& component : components) {
      if (!component.links.empty()) {  // the point of a pin alone is placed by its link
        result.components.push_back(std::move(component));
      }
    }
  }

  const Linkage& linkage_;
  const DrivenBodies& driven_;
  DrivenAs driven_as_;
  Table<BodyIndex, Body> bodies_;
  Table<LinkIndex, BodyIndex> body_of_link_;
  std::vector<BodyIndex> body_of_pin_;
  Table<TieIndex, Tie> ties_;
  Table<BodyIndex, int> asked_;  ///< the last round of matching that visited each body
  int round_ = 0;
  Table<BodyIndex, RankIndex> rank_;  ///< of its component
  std::size_t rank_count_ = 0;
};

}  // namespace

Decomposition decompose(const Linkage& linkage, const DrivenBodies& bodies) {
  Decomposition result;
  result.linkage = linkage;
  StructuralGraph(linkage, bodies, DrivenAs::one_body).find_imbalances(result);
  if (result.free.surplus == 0 && result.overloaded.surplus == 0) {
    StructuralGraph(linkage, bodies, DrivenAs::bodies).decompose(result);
  }
  return result;
}

}  // namespace assur::mechanism::plan
