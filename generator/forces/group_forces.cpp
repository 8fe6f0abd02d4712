#include "forces/group_forces.hpp"

#include <algorithm>
#include <variant>

namespace assur::generator::forces {

namespace {

using equations::NamedQuantity;
using equations::Vector2;
using structure::JointIndex;
using structure::LinkIndex;

GiNaC::ex cross(const Vector2& left, const Vector2& right) {
  return left.x * right.y - left.y * right.x;
}

GiNaC::ex dot(const Vector2& left, const Vector2& right) {
  return left.x * right.x + left.y * right.y;
}

/// Builds the equations in the order of solution: loads, cut joints, the other joints from the
/// leaves to the base, couples.
class ForceWalk {
 public:
  ForceWalk(const equations::ClosureEquations& equations,
            const derivatives::Derivatives& derivatives,
            const pivoting::StructuredJacobian* jacobian)
      : equations_(equations),
        group_(*equations.model->group),
        tree_(structure::spanning_tree(group_)),
        tree_motion_(derivatives.pose_unknown_jacobian),
        loop_motion_(derivatives.jacobian),
        jacobian_(jacobian),
        parts_(equations.unknowns.size()) {
    result_.joints.resize(group_.joints().size());
  }

  GroupForces run() {
    declare_loads();
    result_.vocabulary = jacobian_ != nullptr ? jacobian_->vocabulary() : equations_.vocabulary;
    if (jacobian_ != nullptr) {
      name_projections();
    }
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
  /// The expression under a name, unless it is a number or a symbol.
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

  /// Q: the work of the loads per unit of each unknown, with the links placed by the tree.
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

  [[nodiscard]] std::size_t row_count() const { return equations_.unknowns.size(); }
  /// The motion of the end of a loop per unit of an unknown.
  [[nodiscard]] Vector2 motion_of(std::size_t loop, std::size_t unknown) const {
    return {loop_motion_[2 * loop][unknown], loop_motion_[2 * loop + 1][unknown]};
  }
  /// The unit vector of a row, along or across the frame of a loop.
  [[nodiscard]] Vector2 unit_of(std::size_t row) const {
    const Vector2& frame = jacobian_->closures().frame_direction(row / 2);
    return row % 2 == 0 ? frame : Vector2{-frame.y, frame.x};
  }

  /// Whether the motion of a loop's end is along or across a single named vector.
  [[nodiscard]] static bool is_named(const Vector2& motion) {
    return equations::is_plain(motion.x) && equations::is_plain(motion.y);
  }

  /// The components of a vector in the frame of its loop are projections, so the vector itself is
  /// needed.
  void name_projections() {
    for (std::size_t row = 0; row < row_count(); ++row) {
      for (std::size_t unknown = 0; unknown < row_count(); ++unknown) {
        const GiNaC::ex& entry = jacobian_->entry(row, unknown);
        const Vector2 motion = motion_of(row / 2, unknown);
        const GiNaC::ex projection = dot(motion, unit_of(row));
        for (const int sign : {1, -1}) {
          const GiNaC::ex symbol = sign * entry;
          if (is_named(motion) && GiNaC::is_a<GiNaC::symbol>(symbol)) {
            result_.vocabulary.rewrite(GiNaC::ex_to<GiNaC::symbol>(symbol), sign * projection);
          }
        }
      }
    }
  }

  /// The residual of a loop is the position of the cut joint on its second link minus that on its
  /// first, so lambda acts on the second.
  void solve_cut_joints() {
    if (jacobian_ == nullptr) {
      declare_multipliers();
    } else if (!intersect_lines()) {
      eliminate();
    }
    for (const equations::LoopClosure& loop : equations_.loops) {
      result_.multipliers.push_back(result_.joints[loop.chord].force);
    }
  }

  void declare_multipliers() {
    for (const equations::LoopClosure& loop : equations_.loops) {
      const GiNaC::symbol x("lambda_x_" + letter(loop.chord));
      const GiNaC::symbol y("lambda_y_" + letter(loop.chord));
      result_.given.insert(result_.given.end(), {x, y});
      set_force(loop.chord, {x, y});
    }
  }

  /// A single loop has two unknowns, and the load along each is the moment of one force about a
  /// point, or its component in a direction. So the force lies on two lines, which intersect. If
  /// the frame of the loop makes a pivot one, elimination takes fewer operations.
  bool intersect_lines() {
    if (equations_.loops.size() != 1 || jacobian_->pivots().size() != row_count()) {
      return false;
    }
    const Vector2 one = motion_of(0, 0);
    const Vector2 other = motion_of(0, 1);
    const auto& quantities = result_.vocabulary.quantities();
    const auto inverse =
        std::ranges::find(quantities, NamedQuantity::Form::reciprocal, &NamedQuantity::form);
    const int sign = jacobian_->sign();
    const GiNaC::ex factor = sign * inverse->symbol;
    result_.vocabulary.rewrite(GiNaC::ex_to<GiNaC::symbol>(inverse->definition),
                               sign * cross(one, other));
    const Vector2 lines{result_.generalised[1] * one.y - result_.generalised[0] * other.y,
                        result_.generalised[0] * other.x - result_.generalised[1] * one.x};
    set_force(equations_.loops[0].chord, {factor * lines.x, factor * lines.y});
    return true;
  }

  /// Finds the components of the forces along and across the frames of their loops by the steps of
  /// the elimination in reverse. Next to single unknowns a component is treated as a vector.
  void eliminate() {
    const pivoting::FramedClosures& closures = jacobian_->closures();
    std::vector<GiNaC::ex> rhs;
    for (const GiNaC::ex& load : result_.generalised) {
      rhs.push_back(-load);
    }
    std::vector<GiNaC::symbol> symbols;
    for (std::size_t row = 0; row < row_count(); ++row) {
      symbols.emplace_back("force_" + closures.row_name(row));
    }
    const std::vector<GiNaC::ex> framed = jacobian_->transposed().solve(
        rhs, symbols, "force in the cut joint in the frame of its loop", result_.vocabulary,
        [&](std::size_t unknown, const std::vector<GiNaC::ex>& solved) {
          return known_part(unknown, solved);
        });
    for (std::size_t loop = 0; loop < equations_.loops.size(); ++loop) {
      set_force(equations_.loops[loop].chord, force_in(loop, framed));
    }
  }

  /// The work of the known components of the forces per unit of an unknown.
  GiNaC::ex known_part(std::size_t unknown, const std::vector<GiNaC::ex>& solved) {
    GiNaC::ex sum;
    for (std::size_t row = 0; row < row_count(); ++row) {
      const GiNaC::ex& entry = jacobian_->entry(row, unknown);
      if (entry.is_zero() || solved[row].is_zero()) {
        continue;
      }
      const Vector2 motion = motion_of(row / 2, unknown);
      sum += is_named(motion) && is_computed(entry) ? dot(motion, vector_of(row, solved[row]))
                                                    : entry * solved[row];
    }
    const std::string& name = equations_.unknowns[unknown].name;
    return named("known_" + name, sum, "the known forces along " + name);
  }
  /// Whether an entry of the Jacobian is neither a number nor a dimension.
  [[nodiscard]] bool is_computed(const GiNaC::ex& entry) const {
    const auto is_known = [&](const GiNaC::ex& value) {
      return std::ranges::any_of(result_.vocabulary.quantities(), [&](const auto& quantity) {
        return value.is_equal(quantity.symbol);
      });
    };
    return !equations::is_plain(entry) || is_known(entry) || is_known(-entry);
  }
  /// One component of the force in a cut joint as a vector, under a name.
  Vector2 vector_of(std::size_t row, const GiNaC::ex& size) {
    std::optional<Vector2>& part = parts_[row];
    if (!part) {
      const Vector2 unit = unit_of(row);
      const std::string name = "F_" + jacobian_->closures().row_name(row);
      const std::string meaning = "part of the force in the cut joint, ";
      part = Vector2{named(name + "_x", size * unit.x, meaning + "x"),
                     named(name + "_y", size * unit.y, meaning + "y")};
    }
    return *part;
  }
  /// The force in the cut joint of a loop: the sum of its components.
  [[nodiscard]] Vector2 force_in(std::size_t loop, const std::vector<GiNaC::ex>& framed) const {
    Vector2 sum;
    for (const std::size_t row : {2 * loop, 2 * loop + 1}) {
      const Vector2 unit = unit_of(row);
      const Vector2 part =
          parts_[row].value_or(Vector2{framed[row] * unit.x, framed[row] * unit.y});
      sum = {sum.x + part.x, sum.y + part.y};
    }
    return sum;
  }

  /// Sets the force on the second link.
  void set_force(JointIndex index, const Vector2& force) {
    const std::string name = "F_" + letter(index);
    const std::string meaning =
        "force in joint " + letter(index) + " on link " + word(joint(index).second);
    result_.joints[index].force = {named(name + "_x", force.x, meaning + ", x"),
                                   named(name + "_y", force.y, meaning + ", y")};
  }

  /// The joint by which the tree enters a link carries the resultant of the other forces on it.
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

  /// The displacement of a slide times the force across it: the difference of the couples about the
  /// feet on the two links.
  [[nodiscard]] GiNaC::ex shift(JointIndex index) const {
    const auto owner = std::ranges::find(equations_.owners, equations::Owner(index));
    const auto place = static_cast<std::size_t>(owner - equations_.owners.begin());
    return equations_.unknowns[place].value *
           cross(equations_.slide_directions[index], result_.joints[index].force);
  }

  /// The couple of the slide that ties a link balances the moments about the origin of the link's
  /// frame, from which the forces of its slides have no arm.
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
  const derivatives::ExpressionMatrix& loop_motion_;
  const pivoting::StructuredJacobian* jacobian_;  ///< null if lambda is given
  std::vector<std::optional<Vector2>> parts_;     ///< needed as vectors in the elimination, by row
  GroupForces result_;
};

}  // namespace

GroupForces group_forces(const equations::ClosureEquations& equations,
                         const derivatives::Derivatives& derivatives,
                         const pivoting::StructuredJacobian* jacobian) {
  return ForceWalk(equations, derivatives, jacobian).run();
}

}  // namespace assur::generator::forces
