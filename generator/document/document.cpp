#include "document/document.hpp"

#include <algorithm>
#include <assur/text/counts.hpp>
#include <assur/text/names.hpp>
#include <iterator>
#include <utility>

#include "document/phrases.hpp"

namespace assur::generator::document {

namespace {

class DocumentBuilder {
 public:
  explicit DocumentBuilder(const Derivation& derivation)
      : from_(derivation), group_(*derivation.model->group) {}

  Document run() {
    document_.title = "Derivation of " + from_.model->title();
    document_.kind = structure::spell(group_, from_.model->representative);
    document_.is_audited = from_.model->is_numbered();
    structure();
    variables();
    closures();
    derivatives();
    singularities();
    if (from_.elimination) {
      elimination();
      forces();
    }
    if (from_.eigenproblem) {
      eigenproblem(*from_.eigenproblem);
    }
    return std::move(document_);
  }

 private:
  void begin(const std::string& title) { document_.sections.push_back({title, {}}); }
  void add(Block block) { document_.sections.back().blocks.push_back(std::move(block)); }
  void formula(const std::string& text, bool vectors = false) {
    add(Formula{++number_, text, vectors});
  }
  void prose(const std::string& text) { add(Prose{text}); }

  void structure() {
    begin("Structure");
    const structure::JointTable<structure::Joint>& joints = group_.joints();
    prose("The " + group_.name() + " is an Assur group of class " +
          std::to_string(group_.assur_class()) + ": " +
          text::with_noun(group_.links().size(), "link") + ", " +
          text::with_noun(joints.size(), "joint") + ", " +
          text::with_noun(from_.closures.size(), "independent loop") + " (" +
          text::joined(from_.closures, ", ", [](const DerivedClosure& each) { return each.loop; }) +
          "). Its kinds are spelled " + group_.spelling() +
          ", R for a revolute and P for a prismatic joint.");
    prose(
        !from_.model->is_numbered()
            ? "It is derived from its graph, for a scene; its joints are named in the order of the "
              "scene, and its links keep the axes that they have there."
            : "Model " + std::to_string(from_.model->number) + " holds the kinds " +
                  text::joined(from_.model->members, ", ",
                               [&](const structure::Relabelling& member) {
                                 return structure::spell(group_, member.kind);
                               }) +
                  "; the equations are those of " + document_.kind + ".");
    if (from_.kind != from_.model->representative) {
      relabelling();
    }
    Table links{{{"link", false}, {"frame", false}, {"angle", true}}, {}};
    for (const structure::LinkIndex link : group_.links().keys()) {
      links.rows.push_back({group_.links()[link], from_.frames[link], from_.angles[link]});
    }
    add(std::move(links));
    const auto link_name = [&](structure::LinkIndex link) {
      return link == structure::base_link ? std::string("base") : group_.links()[link];
    };
    Table table{{{"joint", false}, {"type", false}, {"between", false}}, {}};
    for (const structure::JointIndex joint : joints.keys()) {
      table.rows.push_back(
          {{joints[joint].name},
           from_.model->representative[joint] == structure::JointType::prismatic ? "prismatic"
                                                                                 : "revolute",
           link_name(joints[joint].first) + " and " + link_name(joints[joint].second)});
    }
    add(std::move(table));
  }

  void relabelling() {
    const std::string asked = structure::spell(group_, from_.kind);
    prose("The requested kind is " + asked + "; its joints play these joints of the model.");
    Table table{{{"joint of " + asked, false}, {"plays joint", false}}, {}};
    for (const structure::JointIndex joint : from_.roles.keys()) {
      table.rows.push_back({{group_.joints()[joint].name}, from_.roles[joint]});
    }
    add(std::move(table));
  }

  void variables() {
    begin("Variables");
    prose(
        "Lengths share one unit of the user's choice, angles are radians, counter-clockwise; "
        "rates are per unit of time. Joints without an angle or a displacement here add no "
        "unknown: "
        "angles that prismatic joints tie together are one.");
    list_variables("unknown", from_.unknowns, true);
    list_variables("dimension", from_.dimensions, false);
    list_variables("input", from_.inputs, true);
  }

  void list_variables(const std::string& what, const std::vector<DerivedVariable>& variables,
                      bool moving) {
    Table table{{{what, true}}, {}};
    if (moving) {
      table.columns.push_back({"rates", true});
    }
    table.columns.push_back({"unit", false});
    table.columns.push_back({"meaning", false});
    for (const DerivedVariable& variable : variables) {
      std::vector<std::string> row{variable.name};
      if (moving) {
        row.push_back(variable.rate + ", " + variable.second_rate);
      }
      row.emplace_back(variable.is_angle ? "rad" : "length");
      row.push_back(variable.meaning);
      table.rows.push_back(std::move(row));
    }
    add(std::move(table));
  }

  void closures() {
    begin("Loop closure");
    if (!from_.quantities.empty()) {
      prose("Vectors in the fixed frame, and directions, by their components:");
      add(Definitions{from_.quantities});
    }
    for (const DerivedClosure& closure : from_.closures) {
      prose("Loop " + closure.loop + ", as vectors and by components:");
      formula(closure.equation, true);
      for (std::size_t axis = 0; axis < 2; ++axis) {
        add(ScalarClosure{++number_, closure.names[axis], closure.values[axis]});
      }
    }
    if (!from_.compatibility.empty()) {
      prose("Prismatic joints alone close a loop, so its angles must also satisfy:");
      for (const std::string& sum : from_.compatibility) {
        formula(sum + " = 0");
      }
    }
  }

  void derivatives() {
    begin("Derivatives");
    prose(
        "`J`, F_d and F_u are the Jacobians of the closures `f` by the unknowns `q`, the "
        "dimensions "
        "`d` and the inputs `u`. The unknowns' sensitivities solve `J*dq/dd = -F_d` "
        "and `J*dq/du = -F_u`.");
    for (const DerivedMatrix* matrix :
         {&from_.jacobian, &from_.dimension_jacobian, &from_.input_jacobian}) {
      add_fitting(*matrix);
    }
    right_hand_side("Velocity: the rates of the unknowns solve `J*dq/dt = b` with", "b",
                    from_.velocity_rhs);
    right_hand_side("Acceleration: their second rates solve `J*d2q/dt2 = c` with", "c",
                    from_.acceleration_rhs);
  }

  /// A matrix of derivatives. Its longest entries get names if a row would not fit on a line.
  void add_fitting(DerivedMatrix matrix) {
    constexpr std::size_t longest_row = 96;
    Definitions named;
    for (std::size_t row = 0; row < matrix.rows.size(); ++row) {
      std::vector<std::string>& entries = matrix.entries[row];
      while (text::joined(entries, ", ").size() > longest_row) {
        const auto longest = std::max_element(
            entries.begin(), entries.end(),
            [](const std::string& a, const std::string& b) { return a.size() < b.size(); });
        const std::string& closure = matrix.rows[row];
        const std::string& column = *std::next(matrix.columns.begin(), longest - entries.begin());
        const std::string name = closure + "_" + column;
        if (name.size() >= longest->size()) {
          break;
        }
        named.quantities.push_back(
            {name, *longest, "derivative of " + closure + " by " + column, false});
        *longest = name;
      }
    }
    if (!named.quantities.empty()) {
      add(std::move(named));
    }
    add(MatrixDisplay{++number_, std::move(matrix), true});
  }

  void right_hand_side(const std::string& what, const std::string& letter,
                       const std::vector<std::string>& rows) {
    prose(what);
    for (std::size_t row = 0; row < rows.size(); ++row) {
      formula(letter + std::to_string(row + 1) + " = " + rows[row]);
    }
  }

  void singularities() {
    begin("Mobility and singularities");
    prose(std::string(from_.rigid ? "Rigid" : "Degenerate") + ": " + from_.reason +
          (from_.rigid ? "."
                       : ". Where it can be assembled its mobility is " +
                             std::to_string(from_.mobility) + ". There is no final polynomial."));
    if (!from_.determinant) {
      return;
    }
    const DerivedDeterminant& determinant = *from_.determinant;
    prose(
        "Each loop, turned into the frame of the vector that closes it, gives a row along and a "
        "row across that vector. This keeps the determinant and makes zeros:");
    add(Definitions{determinant.quantities});
    add(MatrixDisplay{++number_, determinant.framed, false});
    prose(
        "Rows with one unknown and unknowns in one row are expanded first; the rest is the core. "
        "So the determinant is the product");
    formula("det(J) = " + determinant.value);
    prose("`J` is singular where one of its factors vanishes:");
    Table table{{{"factor", true}, {"zero where", false}, {"meaning", false}}, {}};
    for (const DerivedPivot& pivot : determinant.pivots) {
      table.rows.push_back({pivot.value, pivot.zero, pivot.meaning});
    }
    add(std::move(table));
  }

  void elimination() {
    begin("Elimination");
    const DerivedElimination& elimination = *from_.elimination;
    int count = 0;
    for (const DerivedStep& step : elimination.steps) {
      add(Heading{"Step " + std::to_string(++count) + ": " + step.title});
      prose(sentence(step.rule));
      for (const std::string& text : step.formulas) {
        formula(text);
      }
      for (const DerivedSeries& series : step.series) {
        formula(series_text(series));
      }
      add(Definitions{step.quantities});
      if (!step.eliminated.empty()) {
        prose("Eliminated: " + text::joined(step.eliminated, ", ") + ".");
      }
    }
    add(Heading{"Step " + std::to_string(++count) + ": the way back"});
    prose("Each root gives the unknowns that the steps eliminated:");
    for (const DerivedBackSubstitution& back : elimination.back_substitution) {
      back_substitution(back);
    }
    prose("The polynomial has degree " + std::to_string(elimination.degree) + " in " +
          (elimination.is_angle ? "(cos, sin) of " : "") + elimination.unknown + ": at most " +
          text::with_noun(elimination.max_configurations, "configuration") + ".");
  }

  void eigenproblem(const DerivedEigenproblem& of) {
    begin("All configurations");
    if (of.equations.empty()) {
      prose("Slides fix all angles, and the closures are linear in the displacements.");
      return;
    }
    prose(
        "With unit complex numbers e of the angles and t = 1/e, the loops are linear in e and "
        "their "
        "conjugates in t. All angles are measured against " +
        of.ground + "; x is e of " + of.hidden +
        ", and the coefficients contain it. For every set of the other angles, e of those outside "
        "it, t of those in it and the displacements are eliminated by one determinant: `[e(a)]`, "
        "`[t(a)]` and `[1]` are the determinants of the columns of e(a), of t(a) and of the "
        "constants, those of the ground, beside the eliminated ones.");
    for (const std::string& equation : of.equations) {
      formula(equation);
    }
    prose("The products of t are the unknowns of these equations, linear in them: " +
          std::to_string(of.size) + " equations, polynomials of degree " +
          std::to_string(of.degree) +
          " in x, an eigenproblem. Each eigenvalue with its vector is a configuration in complex "
          "numbers; where |e| = 1 for all angles it is real. Of " +
          text::with_noun(of.choices, "choice") +
          " of ground and hidden angle this is the first; the others serve where configurations "
          "meet.");
  }

  void back_substitution(const DerivedBackSubstitution& back) {
    const bool whole = back.denominator == "1";
    for (std::size_t part = 0; part < back.numerators.size(); ++part) {
      const std::string name =
          !back.is_angle ? back.unknown : (part == 0 ? "cos(" : "sin(") + back.unknown + ")";
      formula(name + " = " +
              (whole ? back.numerators[part]
                     : bracketed(back.numerators[part]) + "/" + bracketed(back.denominator)));
    }
    if (!whole) {
      prose("The denominator vanishes where " + back.degeneracy + ".");
    }
  }

  void forces() {
    begin("Forces");
    const DerivedForces& forces = *from_.forces;
    prose(
        "On each link act a force and a moment about the origin of its frame, in the directions "
        "of the fixed frame: weight, inertia, and the loads from other groups.");
    for (const structure::LinkIndex link : group_.links().keys()) {
      const auto& load = forces.loads[link];
      add(Given{{load.begin(), load.end()}, "force and moment on link " + group_.links()[link]});
    }
    add(Heading{"Step 1: the loads along the unknowns"});
    prose("The links move along the tree that cuts one joint of each loop.");
    add(Definitions{forces.generalised});
    add(Heading{"Step 2: the forces in the cut joints"});
    prose(
        "They are the multipliers of the closures, and the steps that solve for rates solve for "
        "them in reverse, with the same pivots: the transposed Jacobian times the multipliers is "
        "minus the loads.");
    add(Definitions{forces.multipliers});
    for (const std::string& equation : forces.equations) {
      add(Equation{++number_, equation});
    }
    add(Heading{"Step 3: the other forces"});
    prose("From the leaves of the tree to the base, the forces on a link add up to zero.");
    add(Definitions{forces.reactions});
    if (!forces.couples.empty()) {
      add(Heading{"Step 4: the couples of slides"});
      prose("From the last links that slides tie, the moments on a link add up to zero.");
      add(Definitions{forces.couples});
    }
    prose(
        "A force acts on the second link of its joint, and the opposite one on the first: at the "
        "joint, or at a slide at the foot of the perpendicular from the origin of the second "
        "link's frame, with the couple.");
    add(reactions(forces.joints));
    prose("Loads on the neighbours of the group:");
    add(reactions(forces.neighbours));
    prose("In all " + operations(forces.operations) +
          ", of which the loads along the unknowns take " + operations(forces.of_loads) + ".");
  }

  [[nodiscard]] static Table reactions(const std::vector<DerivedReaction>& list) {
    Table table{{{"joint", false}, {"on", false}, {"force, x", true}, {"force, y", true}}, {}};
    const bool has_couples = std::ranges::any_of(
        list, [](const DerivedReaction& reaction) { return !reaction.couple.empty(); });
    if (has_couples) {
      table.columns.push_back({"couple", true});
    }
    for (const DerivedReaction& reaction : list) {
      table.rows.push_back({reaction.joint, reaction.on, reaction.force[0], reaction.force[1]});
      if (has_couples) {
        table.rows.back().push_back(reaction.couple.empty() ? "0" : reaction.couple);
      }
    }
    return table;
  }

  [[nodiscard]] static std::string operations(const program::OperationCount& count) {
    return text::with_noun(count.multiplications, "multiplication") + ", " +
           text::with_noun(count.additions, "addition") + " and " +
           text::with_noun(count.divisions, "division");
  }

  const Derivation& from_;
  const structure::Group& group_;
  Document document_;
  int number_ = 0;
};

}  // namespace

Document document_of(const Derivation& derivation) { return DocumentBuilder(derivation).run(); }

}  // namespace assur::generator::document
