#include "equations/closure.hpp"

#include <algorithm>
#include <optional>

#include "error.hpp"

namespace assur::generator::equations {

namespace {

using structure::JointIndex;
using structure::LinkIndex;

Vector2 operator+(const Vector2& left, const Vector2& right) {
  return {left.x + right.x, left.y + right.y};
}
Vector2 operator-(const Vector2& left, const Vector2& right) {
  return {left.x - right.x, left.y - right.y};
}
Vector2 rotated(const Vector2& direction, const Vector2& local) {
  return {(direction.x * local.x - direction.y * local.y).expand(),
          (direction.y * local.x + direction.x * local.y).expand()};
}
bool is_zero(const Vector2& vector) { return vector.x.is_zero() && vector.y.is_zero(); }

/// A point reached by a walk: its position, and the names of the vectors walked.
struct Place {
  Vector2 position;
  std::vector<std::string> vectors;
};

/// Builds the equations of one model in the order of the pipeline below.
class ClosureWalk {
 public:
  ClosureWalk(const structure::Model& model, const std::vector<bool>& moves)
      : group_(*model.group),
        tree_(structure::spanning_tree(group_)),
        moves_(moves),
        result_(model) {}

  ClosureEquations run() {
    declare_inputs();
    declare_frames();
    merge_angles();
    declare_displacements();
    close_loops();
    place_links();
    return std::move(result_);
  }

 private:
  [[nodiscard]] const structure::Joint& joint(JointIndex index) const {
    return group_.joints()[index];
  }
  [[nodiscard]] std::string letter(JointIndex index) const { return {joint(index).name}; }
  [[nodiscard]] const std::string& word(LinkIndex link) const { return group_.links()[link]; }
  [[nodiscard]] bool slides(JointIndex index) const { return result_.model->slides(index); }
  [[nodiscard]] const LinkFrame& frame(LinkIndex link) const { return result_.frames[link]; }
  [[nodiscard]] LinkPose& pose(LinkIndex link) { return result_.poses[link]; }
  [[nodiscard]] static const Variable& find(const std::deque<Variable>& list,
                                            const std::string& name) {
    return *std::find_if(list.begin(), list.end(),
                         [&](const Variable& variable) { return variable.name == name; });
  }

  void declare_frames() {
    std::size_t count = 0;
    const auto declare = [&](const std::string& name, Variable::Quantity quantity,
                             const std::string& meaning) -> const Variable& {
      const bool moves = count < moves_.size() && moves_[count];
      ++count;
      return (moves ? result_.inputs : result_.dimensions).emplace_back(name, quantity, meaning);
    };
    for (const LinkIndex link : group_.links().keys()) {
      result_.frames.add(link_frame(*result_.model, link, declare));
    }
  }

  void declare_inputs() {
    using Quantity = Variable::Quantity;
    for (const JointIndex index : group_.joints().keys()) {
      if (!joint(index).external()) {
        continue;
      }
      const std::string name = letter(index);
      const std::string what =
          slides(index) ? "a point on the base's slide at " + name : "external joint " + name;
      result_.inputs.emplace_back("x_" + name, Quantity::length, "x of " + what);
      result_.inputs.emplace_back("y_" + name, Quantity::length, "y of " + what);
      if (slides(index)) {
        result_.inputs.emplace_back("phi_" + name, Quantity::angle,
                                    "angle of the base's slide at " + name);
      }
    }
  }

  /// The direction of a joint's line on one of its links.
  [[nodiscard]] AngleSum line_angle(JointIndex index, LinkIndex link) {
    if (link == structure::base_link) {
      return AngleSum(find(result_.inputs, "phi_" + letter(index)));
    }
    return pose(link).angle + frame(link).feature_of(index).direction;
  }

  /// Gives every link its angle: first the links that the base holds by prismatic joints, then,
  /// from each link still free, one unknown angle and the links that turn with it. A prismatic
  /// joint between links with related angles is a compatibility condition.
  void merge_angles() {
    result_.poses.resize(group_.links().size());
    structure::LinkTable<bool> tied(group_.links().size(), false);
    structure::JointTable<bool> crossed(group_.joints().size(), false);
    const auto is_tied = [&](LinkIndex link) { return link == structure::base_link || tied[link]; };
    // Ties one more link by the first joint that can tie it; returns false if there is none.
    const auto tie_one = [&] {
      for (const JointIndex index : crossed.keys()) {
        const structure::Joint& at = joint(index);
        if (!slides(index) || crossed[index] || is_tied(at.first) == is_tied(at.second)) {
          continue;
        }
        const LinkIndex from = is_tied(at.first) ? at.first : at.second;
        const LinkIndex to = at.other(from);
        pose(to).angle = line_angle(index, from) - frame(to).feature_of(index).direction;
        tied[to] = true;
        crossed[index] = true;
        result_.ties.push_back({index, to});
        return true;
      }
      return false;
    };
    const auto spread = [&] {
      while (tie_one()) {
      }
    };
    spread();
    for (const LinkIndex link : group_.links().keys()) {
      if (is_tied(link)) {
        continue;
      }
      pose(link).angle = AngleSum(result_.unknowns.emplace_back(
          "theta_" + word(link), Variable::Quantity::angle, "angle of link " + word(link)));
      result_.owners.emplace_back(link);
      tied[link] = true;
      spread();
    }
    for (const JointIndex index : group_.joints().keys()) {
      if (slides(index) && !crossed[index]) {
        result_.compatibility.push_back(line_angle(index, joint(index).first) -
                                        line_angle(index, joint(index).second));
      }
    }
    for (const LinkIndex link : group_.links().keys()) {
      const Vector2 direction = pose(link).angle.direction();
      pose(link).direction = {result_.vocabulary.name("cos_" + word(link), direction.x,
                                                      "cosine of the angle of link " + word(link)),
                              result_.vocabulary.name("sin_" + word(link), direction.y,
                                                      "sine of the angle of link " + word(link))};
    }
  }

  void declare_displacements() {
    result_.slide_directions.resize(group_.joints().size());
    for (const JointIndex index : group_.joints().keys()) {
      if (slides(index)) {
        const LinkIndex first = joint(index).first;
        result_.owners.emplace_back(index);
        result_.unknowns.emplace_back(
            "s_" + letter(index), Variable::Quantity::length,
            "displacement along the slide at " + letter(index) + " of link " +
                word(joint(index).second) + " against " +
                (first == structure::base_link ? std::string("the base") : "link " + word(first)));
      }
    }
  }

  /// The vector by which a joint's slide moves its second link against its first.
  Vector2 slide(JointIndex index) {
    const LinkIndex first = joint(index).first;
    // Either link gives the direction; the shorter sum of angles is easier to read.
    const bool first_is_plain =
        first == structure::base_link || frame(first).feature_of(index).direction.text() == "0";
    const AngleSum angle = line_angle(index, first_is_plain ? first : joint(index).second);
    const Vector2 plain = angle.direction();
    const Vector2 along = {
        result_.vocabulary.name("cos_slide_" + letter(index), plain.x,
                                "cosine of the angle of the slide at " + letter(index)),
        result_.vocabulary.name("sin_slide_" + letter(index), plain.y,
                                "sine of the angle of the slide at " + letter(index))};
    result_.slide_directions[index] = along;
    const GiNaC::ex displacement = find(result_.unknowns, "s_" + letter(index)).value;
    return result_.vocabulary.name("slide_" + letter(index),
                                   Vector2{displacement * along.x, displacement * along.y},
                                   "displacement vector at " + letter(index));
  }

  /// The vector between two joints of a link, in the fixed frame.
  Vector2 link_vector(LinkIndex link, JointIndex from, JointIndex to) {
    const Vector2 local = frame(link).feature_of(to).point - frame(link).feature_of(from).point;
    return result_.vocabulary.name(
        letter(from) + letter(to), rotated(pose(link).direction, local),
        "vector from " + letter(from) + " to " + letter(to) + " on link " + word(link));
  }

  /// Steps from a joint's feature on one link to its feature on the other.
  Place across(Place place, JointIndex index, LinkIndex from) {
    if (slides(index)) {
      const bool forward = joint(index).first == from;
      const Vector2 step = slide(index);
      place.position = forward ? place.position + step : place.position - step;
      place.vectors.push_back((forward ? "+ slide_" : "- slide_") + letter(index));
    }
    return place;
  }

  /// The feature of a joint on a link, reached along the tree.
  Place feature_place(LinkIndex link, JointIndex index) {
    const JointIndex entry = tree_.entry[link];
    const LinkIndex before = joint(entry).other(link);
    Place place;
    if (before == structure::base_link) {
      place = {{find(result_.inputs, "x_" + letter(entry)).value,
                find(result_.inputs, "y_" + letter(entry)).value},
               {"+ " + letter(entry)}};
    } else {
      place = feature_place(before, entry);
    }
    place = across(place, entry, before);
    if (index != entry) {
      const Vector2 step = link_vector(link, entry, index);
      if (!is_zero(step)) {
        place.position = place.position + step;
        place.vectors.push_back("+ " + letter(entry) + letter(index));
      }
    }
    return place;
  }

  void place_links() {
    for (const LinkIndex link : tree_.visit_order) {
      const JointIndex entry = tree_.entry[link];
      const Vector2 local = frame(link).feature_of(entry).point;
      const Vector2 offset = result_.vocabulary.name(
          "origin_" + word(link), rotated(pose(link).direction, local),
          "vector from the origin of link " + word(link) + " to " + letter(entry));
      pose(link).origin = feature_place(link, entry).position - offset;
    }
  }

  void close_loops() {
    for (const JointIndex chord : tree_.chords) {
      const structure::Joint& at = joint(chord);
      Place near = feature_place(at.second, chord);
      Place far = across(feature_place(at.first, chord), chord, at.first);
      std::string equation;
      for (const std::string& vector : near.vectors) {
        equation += equation.empty() ? vector.substr(2) : " " + vector;
      }
      std::ranges::reverse(far.vectors);  // the way back around the loop
      for (const std::string& vector : far.vectors) {
        equation += (vector[0] == '+' ? " - " : " + ") + vector.substr(2);
      }
      result_.loops.push_back({structure::loop_name(group_, tree_, chord), chord, equation + " = 0",
                               near.position - far.position});
      result_.residuals.push_back(result_.loops.back().residual.x.expand());
      result_.residuals.push_back(result_.loops.back().residual.y.expand());
    }
  }

  const structure::Group& group_;
  structure::SpanningTree tree_;
  const std::vector<bool>& moves_;
  ClosureEquations result_;
};

}  // namespace

ClosureEquations::ClosureEquations(const structure::Model& of_model) : model(&of_model) {
  residuals_meaning = "the x and y of each loop closure";
}

ClosureEquations closure_equations(const structure::Model& model, const std::vector<bool>& moves) {
  return ClosureWalk(model, moves).run();
}

}  // namespace assur::generator::equations
