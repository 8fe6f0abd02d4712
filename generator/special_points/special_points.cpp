#include "special_points/special_points.hpp"

#include <algorithm>

#include "elimination/reduction.hpp"

namespace assur::generator::special_points {

namespace {

using structure::JointIndex;
using structure::LinkIndex;

/// A vector rotated by a right angle, counter-clockwise.
equations::Vector2 turned(const equations::Vector2& vector) { return {-vector.y, vector.x}; }
equations::Vector2 operator+(const equations::Vector2& left, const equations::Vector2& right) {
  return {(left.x + right.x).expand(), (left.y + right.y).expand()};
}
equations::Vector2 operator-(const equations::Vector2& left, const equations::Vector2& right) {
  return {(left.x - right.x).expand(), (left.y - right.y).expand()};
}
equations::Vector2 operator*(const GiNaC::ex& factor, const equations::Vector2& vector) {
  return {(factor * vector.x).expand(), (factor * vector.y).expand()};
}

/// The motion of the origin of a closure link's frame, reached from one side: dp/dq, the velocity
/// without the unknowns' rates, and the acceleration without their second rates.
struct Origin {
  std::vector<equations::Vector2> by_unknown;
  equations::Vector2 velocity;
  equations::Vector2 acceleration;
};

class SpecialPointDerivation {
 public:
  SpecialPointDerivation(const equations::ClosureEquations& equations,
                         const derivatives::Derivatives& derivatives)
      : equations_(equations), derivatives_(derivatives), group_(*equations.model->group) {}

  SpecialPoints run() {
    const std::vector<LinkIndex> links = closure_links(group_);
    if (links.empty()) {
      return {{}, false, "every link has an external joint"};
    }
    for (const LinkIndex link : links) {
      add_point(link);
      if (!result_.reason.empty()) {
        result_.defined = false;
        return std::move(result_);
      }
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] const std::string& word(LinkIndex link) const { return group_.links()[link]; }
  [[nodiscard]] GiNaC::ex in_variables(const GiNaC::ex& expression) const {
    return elimination::on_circle(equations_.vocabulary.expand(expression), equations_);
  }
  [[nodiscard]] bool vanishes(const GiNaC::ex& expression) const {
    return in_variables(expression).is_zero();
  }
  [[nodiscard]] bool vanishes(const equations::Vector2& vector) const {
    return vanishes(vector.x) && vanishes(vector.y);
  }

  void add_point(LinkIndex link) {
    const std::vector<JointIndex> joints = group_.joints_of(link);
    std::vector<std::size_t> loops;
    for (std::size_t loop = 0; loop < equations_.loops.size(); ++loop) {
      if (std::find(joints.begin(), joints.end(), equations_.loops[loop].chord) != joints.end()) {
        loops.push_back(loop);
      }
    }
    if (loops.size() != 1) {
      result_.reason = "link " + word(link) + " does not close exactly one loop";
      return;
    }
    const structure::Joint& chord = group_.joints()[equations_.loops[loops[0]].chord];
    const structure::Joint& entry = group_.joints()[structure::spanning_tree(group_).entry[link]];

    SpecialPoint point{
        link, GiNaC::symbol("S_" + word(link) + "_x"), GiNaC::symbol("S_" + word(link) + "_y"), {}};
    const Origin along_tree = tree_origin(link);
    // The residual is the chord's position on its second link minus that on its first.
    const int ahead = chord.second == link ? 1 : -1;
    const Origin through_chord = chord_origin(along_tree, loops[0], ahead);
    point.sides[0] = side(point, entry.other(link), along_tree);
    point.sides[1] = side(point, chord.other(link), through_chord);
    for (SpecialPointSide& at : point.sides) {
      if (result_.reason.empty()) {
        result_.reason = find_line(point, at);
      }
    }
    if (result_.reason.empty() && vanishes(point.sides[0].normal.x * point.sides[1].normal.y -
                                           point.sides[0].normal.y * point.sides[1].normal.x)) {
      result_.reason = "the two lines of link " + word(link) + " are always parallel";
    }
    result_.points.push_back(std::move(point));
  }

  /// The expression with all second rates of unknowns zero.
  [[nodiscard]] GiNaC::ex unaccelerated(GiNaC::ex expression) const {
    for (const equations::Variable& unknown : equations_.unknowns) {
      expression = expression.subs(unknown.second_rate == 0);
    }
    return expression;
  }
  [[nodiscard]] GiNaC::ex at_rest(GiNaC::ex expression) const {
    for (const equations::Variable& unknown : equations_.unknowns) {
      expression = expression.subs(unknown.rate == 0);
    }
    return expression;
  }

  [[nodiscard]] Origin tree_origin(LinkIndex link) const {
    Origin origin;
    const std::size_t row = 3 * link.place();
    for (std::size_t k = 0; k < equations_.unknowns.size(); ++k) {
      origin.by_unknown.push_back({derivatives_.pose_unknown_jacobian[row][k],
                                   derivatives_.pose_unknown_jacobian[row + 1][k]});
    }
    const std::vector<GiNaC::ex>& velocity = derivatives_.pose_velocity[link.place()];
    const std::vector<GiNaC::ex>& acceleration = derivatives_.pose_acceleration[link.place()];
    origin.velocity = {at_rest(velocity[0]), at_rest(velocity[1])};
    origin.acceleration = {unaccelerated(acceleration[0]), unaccelerated(acceleration[1])};
    return origin;
  }

  /// Through the chord, the origin is its position by the tree minus `ahead` times the residual.
  /// The residual is zero, but its derivatives contain other unknowns. The right-hand sides are the
  /// negatives of its time derivatives without the unknowns' rates, or without their second rates.
  [[nodiscard]] Origin chord_origin(Origin origin, std::size_t loop, int ahead) const {
    const std::size_t row = 2 * loop;
    for (std::size_t k = 0; k < equations_.unknowns.size(); ++k) {
      origin.by_unknown[k] =
          origin.by_unknown[k] - ahead * equations::Vector2{derivatives_.jacobian[row][k],
                                                            derivatives_.jacobian[row + 1][k]};
    }
    origin.velocity =
        origin.velocity + ahead * equations::Vector2{derivatives_.velocity_rhs[row],
                                                     derivatives_.velocity_rhs[row + 1]};
    origin.acceleration =
        origin.acceleration + ahead * equations::Vector2{derivatives_.acceleration_rhs[row],
                                                         derivatives_.acceleration_rhs[row + 1]};
    return origin;
  }

  /// The motion of S as a point of a rigid link whose frame has this origin.
  [[nodiscard]] SpecialPointSide side(const SpecialPoint& point, LinkIndex by,
                                      const Origin& origin) const {
    const equations::Vector2 arm{point.x, point.y};
    SpecialPointSide side;
    side.by = by;
    for (std::size_t k = 0; k < equations_.unknowns.size(); ++k) {
      const int turns = equations_.poses[point.link].angle.factor(equations_.unknowns[k]);
      const equations::Vector2 contribution = origin.by_unknown[k] + turns * turned(arm);
      const bool moves = !vanishes(contribution);
      side.contributions.push_back(moves ? contribution : equations::Vector2{0, 0});
      if (moves) {
        side.moving.push_back(k);
      }
    }
    const GiNaC::ex omega = derivatives_.pose_velocity[point.link.place()][2];
    const GiNaC::ex known_alpha =
        unaccelerated(derivatives_.pose_acceleration[point.link.place()][2]);
    side.known_velocity = origin.velocity + at_rest(omega) * turned(arm);
    side.known_acceleration =
        origin.acceleration + known_alpha * turned(arm) - (omega * omega) * arm;
    return side;
  }

  /// Sets the line on which the two contributions of a side are parallel: their cross product is
  /// zero. Returns the reason if there is no such line, else an empty text.
  [[nodiscard]] std::string find_line(const SpecialPoint& point, SpecialPointSide& side) const {
    const std::string where = "by " + word(side.by) + " link " + word(point.link);
    std::string movers;
    for (const std::size_t k : side.moving) {
      movers += (movers.empty() ? "" : " and ") + equations_.unknowns[k].name;
    }
    if (side.moving.size() != 2) {
      return where + " is moved by " + (movers.empty() ? "no unknown" : movers) +
             (side.moving.size() < 2 ? " alone, which singles out no line" : "");
    }
    const equations::Vector2& first = side.contributions[side.moving[0]];
    const equations::Vector2& second = side.contributions[side.moving[1]];
    const GiNaC::ex cross = (first.x * second.y - first.y * second.x).expand();
    side.normal = {cross.diff(point.x), cross.diff(point.y)};
    side.offset = -cross.subs(GiNaC::lst{point.x == 0, point.y == 0});
    const auto varies = [&](const GiNaC::ex& part) {
      const GiNaC::ex plain = in_variables(part);
      return plain.has(point.x) || plain.has(point.y);
    };
    if (varies(side.normal.x) || varies(side.normal.y)) {
      return where + " is moved in parallel by " + movers + " on a curve";
    }
    if (vanishes(side.normal)) {
      return where + " is only shifted, by " + movers + ", which are not parallel";
    }
    return "";
  }

  const equations::ClosureEquations& equations_;
  const derivatives::Derivatives& derivatives_;
  const structure::Group& group_;
  SpecialPoints result_;
};

}  // namespace

std::vector<LinkIndex> closure_links(const structure::Group& group) {
  std::vector<LinkIndex> links;
  for (const LinkIndex link : group.links().keys()) {
    const std::vector<JointIndex> joints = group.joints_of(link);
    if (std::none_of(joints.begin(), joints.end(),
                     [&](JointIndex index) { return group.joints()[index].external(); })) {
      links.push_back(link);
    }
  }
  return links;
}

SpecialPoints special_points(const equations::ClosureEquations& equations,
                             const derivatives::Derivatives& derivatives) {
  return SpecialPointDerivation(equations, derivatives).run();
}

}  // namespace assur::generator::special_points
