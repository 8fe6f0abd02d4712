#include "forces/group_forces.hpp"

#include <algorithm>
#include <variant>

namespace assur::generator::forces {

namespace {

using equations::Vector2;
using structure::JointIndex;
using structure::LinkIndex;

GiNaC::ex cross(const Vector2& left, const Vector2& right) {
  return left.x * right.y - left.y * right.x;
}

/// Builds the equations in the order in which they are solved: loads, cut joints, the other joints
/// from the leaves to the base, couples.
class ForceWalk {
 public:
  ForceWalk(const equations::ClosureEquations& equations,
            const derivatives::ExpressionMatrix& tree_motion,
            const pivoting::StructuredJacobian& jacobian)
      : equations_(equations),
        group_(*equations.model->group),
        tree_(structure::spanning_tree(group_)),
        tree_motion_(tree_motion),
        jacobian_(jacobian) {
    result_.vocabulary = jacobian.vocabulary();
    result_.joints.resize(group_.joints().size());
  }

  GroupForces run() {
    declare_loads();
    project_loads();
    solve_cut_joints();
    for (auto link = tree_.visit_order.rbegin(); link != tree_.visit_order.rend(); ++link) {
      balance_forces(*link);
    }
    for (auto tie = equations_.ties.rbegin(); tie != equations_.ties.rend(); ++tie) {
      balance_moments(*tie);
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] const structure::Joint& joint(JointIndex index) const {
    return group_.joints()[index];
  }
  [[nodiscard]] std::string letter(JointIndex index) const { return {joint(index).name}; }
  [[nodiscard]] const std::string& word(LinkIndex link) const { return group_.links()[link]; }
  [[nodiscard]] bool slides(JointIndex index) const { return equations_.model->slides(index); }
  /// 1 if a link is the second of a joint, -1 if it is the first.
  [[nodiscard]] int side(JointIndex index, LinkIndex link) const {
    return joint(index).second == link ? 1 : -1;
  }
  /// The expression under a name of its own, unless it is a number or a symbol.
  GiNaC::ex named(const std::string& name, const GiNaC::ex& value, const std::string& meaning) {
    const GiNaC::ex sum = value.expand();
    if (equations::is_plain(sum)) {
      return sum;
    }
    const GiNaC::symbol symbol(name);
    result_.vocabulary.define(symbol, sum, meaning);
    return symbol;
  }

  void declare_loads() {
    for (const LinkIndex link : group_.links().keys()) {
      const auto symbol = [&](const std::string& part) {
        return GiNaC::symbol("load_" + part + "_" + word(link));
      };
      result_.loads.add({symbol("x"), symbol("y"), symbol("moment")});
    }
  }

  /// Q: what the loads do per unit of each unknown, where the tree alone holds the links.
  void project_loads() {
    for (std::size_t unknown = 0; unknown < equations_.unknowns.size(); ++unknown) {
      GiNaC::ex sum;
      for (const LinkIndex link : group_.links().keys()) {
        const LinkLoad& load = result_.loads[link];
        const std::size_t row = 3 * link.place();
        sum += tree_motion_[row][unknown] * load.x + tree_motion_[row + 1][unknown] * load.y +
               tree_motion_[row + 2][unknown] * load.moment;
      }
      const std::string& name = equations_.unknowns[unknown].name;
      result_.generalised.push_back(named("load_" + name, sum, "load along " + name));
    }
  }

  /// The residual of a loop is the place of the cut joint on its second link, less that on its
  /// first: so lambda acts on the second.
  void solve_cut_joints() {
    const pivoting::FramedClosures& closures = jacobian_.closures();
    std::vector<GiNaC::ex> rhs;
    for (const GiNaC::ex& load : result_.generalised) {
      rhs.push_back(-load);
    }
    std::vector<GiNaC::symbol> symbols;
    for (std::size_t row = 0; row < closures.row_count(); ++row) {
      symbols.emplace_back("force_" + closures.row_name(row));
    }
    const std::vector<GiNaC::ex> framed = jacobian_.transposed().solve(
        rhs, symbols, "force in the cut joint in the frame of its loop", result_.vocabulary);
    for (std::size_t loop = 0; loop < equations_.loops.size(); ++loop) {
      const Vector2& frame = closures.frame_direction(loop);
      const GiNaC::ex& along = framed[2 * loop];
      const GiNaC::ex& across = framed[2 * loop + 1];
      const JointIndex cut = equations_.loops[loop].chord;
      set_force(cut, {along * frame.x - across * frame.y, along * frame.y + across * frame.x});
      result_.multipliers.push_back(result_.joints[cut].force);
    }
  }

  /// Sets the force on the second link.
  void set_force(JointIndex index, const Vector2& force) {
    const std::string name = "F_" + letter(index);
    const std::string meaning =
        "force in joint " + letter(index) + " on link " + word(joint(index).second);
    result_.joints[index].force = {named(name + "_x", force.x, meaning + ", x"),
                                   named(name + "_y", force.y, meaning + ", y")};
  }

  /// The joint by which the tree enters a link carries what is left of the forces on it.
  void balance_forces(LinkIndex link) {
    const JointIndex entry = tree_.entry[link];
    GiNaC::ex x = result_.loads[link].x;
    GiNaC::ex y = result_.loads[link].y;
    for (const JointIndex index : group_.joints_of(link)) {
      if (index != entry) {
        x += side(index, link) * result_.joints[index].force.x;
        y += side(index, link) * result_.joints[index].force.y;
      }
    }
    set_force(entry, {-side(entry, link) * x, -side(entry, link) * y});
  }

  /// The vector from the origin of a link's frame to a revolute joint on it.
  Vector2 arm(LinkIndex link, JointIndex index) {
    const Vector2& local = equations_.frames[link].feature_of(index).point;
    const Vector2& turned = equations_.poses[link].direction;
    return result_.vocabulary.name(
        "arm_" + letter(index) + "_" + word(link),
        {(turned.x * local.x - turned.y * local.y).expand(),
         (turned.y * local.x + turned.x * local.y).expand()},
        "vector from the origin of link " + word(link) + " to " + letter(index));
  }

  /// The displacement of a slide times the force across it: the couple about the feet on the two
  /// links differs by this.
  [[nodiscard]] GiNaC::ex shift(JointIndex index) const {
    const auto owner = std::ranges::find(equations_.owners, equations::Owner(index));
    const auto place = static_cast<std::size_t>(owner - equations_.owners.begin());
    return equations_.unknowns[place].value *
           cross(equations_.slide_directions[index], result_.joints[index].force);
  }

  /// The couple of the slide that ties a link carries what is left of the moments about the origin
  /// of the link's frame, from which the forces of its slides have no arm.
  void balance_moments(const equations::AngleTie& tie) {
    const LinkIndex link = tie.link;
    GiNaC::ex sum = result_.loads[link].moment;
    for (const JointIndex index : group_.joints_of(link)) {
      const JointReaction& reaction = result_.joints[index];
      if (!slides(index)) {
        sum += side(index, link) * cross(arm(link, index), reaction.force);
      } else if (index != tie.joint) {
        sum += side(index, link) > 0 ? *reaction.couple : -*reaction.couple - shift(index);
      }
    }
    const GiNaC::ex couple = side(tie.joint, link) > 0 ? -sum : sum - shift(tie.joint);
    result_.joints[tie.joint].couple = named("C_" + letter(tie.joint), couple,
                                             "couple of the slide at " + letter(tie.joint) +
                                                 " on link " + word(joint(tie.joint).second));
  }

  const equations::ClosureEquations& equations_;
  const structure::Group& group_;
  structure::SpanningTree tree_;
  const derivatives::ExpressionMatrix& tree_motion_;
  const pivoting::StructuredJacobian& jacobian_;
  GroupForces result_;
};

}  // namespace

GroupForces group_forces(const equations::ClosureEquations& equations,
                         const derivatives::ExpressionMatrix& tree_motion,
                         const pivoting::StructuredJacobian& jacobian) {
  return ForceWalk(equations, tree_motion, jacobian).run();
}

}  // namespace assur::generator::forces
