#include "emission/scene/specialised_group.hpp"

#include <algorithm>
#include <assur/support/discriminant.hpp>
#include <assur/support/scale.hpp>
#include <assur/text/names.hpp>
#include <cmath>
#include <complex>
#include <iterator>
#include <set>

#include "emission/cpp/cpp_text.hpp"
#include "emission/model/closed_form.hpp"
#include "emission/model/force_function.hpp"
#include "emission/model/model_view.hpp"
#include "emission/model/rigid_functions.hpp"
#include "emission/scene/specialise.hpp"
#include "emission/scene/specialised_sensitivities.hpp"

namespace assur::generator::emission::scene {

namespace {

class GroupSpecialiser {
 public:
  explicit GroupSpecialiser(const SpecialisedNumbers& numbers)
      : numbers_(numbers),
        equations_(equations::closure_equations(*numbers.model, numbers.dimension_moves)),
        derivatives_(derivatives::differentiate(equations_)) {
    if (numbers.eliminations.empty() && numbers.starts.empty()) {
      closed_.emplace(equations_);
    }
    collect_values();
    leave_out_frames();
  }

  SpecialisedGroup run(const std::string& struct_name, const std::string& title) {
    SpecialisedGroup result{};
    result.view = view(struct_name, title);
    model::ModelSpelling spelling(equations_.unknowns, equations_.dimensions, inputs_);
    cpp::View::List functions;
    std::vector<std::string> operations;
    std::set<std::string> named;
    const model::RigidFunctions rigid =
        closed_ ? model::rigid_functions(equations_, closed_->structured, closed_->elimination)
                : model::RigidFunctions{
                      {}, {}, model::known_quantities(equations_, {&equations_.vocabulary})};
    const auto add_in_order = [&](const model::ModelFunction& function,
                                  const equations::Vocabulary& vocabulary,
                                  program::SymbolOrder order) {
      for (const NamedConstant& constant : constants_) {
        order.set_constant(constant.symbol, constant.value);
      }
      const NamedResults special =
          specialised(vocabulary.quantities(), function.results, order, values_);
      model::ModelFunction folded = without_dimensions(function);
      folded.results = special.results;
      const program::Program program(order, special.quantities, special.results,
                                     specialised(rigid.known, {}, order, values_).quantities);
      operations.push_back(function.name + " " + counted(program.count()));
      functions.push_back(
          model::function_view(folded, program, spelling, model::ZeroResults::assigned));
      named.merge(cpp::constants_of(program));
      if (function.name == "position_polynomial") {
        const model::GroupRange range = {support::most_length_of_numbers, false, sizes_,
                                         support::rounding_of_named_numbers};
        result.first_key = model::show_closed_form(
            equations_, closed_->elimination, closed_->structured, program, range, result.view);
      }
    };
    const auto add = [&](const model::ModelFunction& function,
                         const equations::Vocabulary& vocabulary) {
      add_in_order(function, vocabulary,
                   program::symbol_order(equations_, vocabulary, rigid.known));
    };
    for (const model::ModelFunction& function : model::model_functions(equations_, derivatives_)) {
      if (is_wanted(function.name)) {
        add(function, equations_.vocabulary);
      }
    }
    add(link_poses(), equations_.vocabulary);
    if (parameter_count() > 0) {
      for (const model::ModelFunction& function : sensitivity_functions(numbers_, derivatives_)) {
        add(function, equations_.vocabulary);
      }
    }
    std::optional<forces::GroupForces> forces;
    std::vector<GiNaC::symbol> reciprocals;
    if (numbers_.forces) {
      forces =
          forces::group_forces(equations_, derivatives_, closed_ ? &closed_->structured : nullptr);
      reciprocals = reciprocals_of_rates(model::force_function(*forces));
    }
    for (const model::NamingFunction& entry : rigid.solutions) {
      model::ModelFunction function = entry.function;
      if (is_of_rates(function.name)) {
        model::tell_reciprocals(reciprocals, function);
      }
      if (is_wanted(function.name)) {
        add(function, entry.vocabulary);
      }
    }
    for (const model::ModelFunction& function : rigid.positions) {
      add(function, closed_->elimination.vocabulary);
    }
    if (forces) {
      const auto add_forces = [&](model::ForceFunction function) {
        function.take_reciprocals(reciprocals);
        for (const auto& [symbol, entry] : function.given) {
          spelling.take_out(symbol, entry);
        }
        add_in_order(function.naming.function, function.naming.vocabulary,
                     function.order(equations_, rigid.known));
      };
      if (!closed_) {
        add_forces(model::load_function(*forces));
      }
      add_forces(model::force_function(*forces));
    }
    result.shares_reciprocals = !reciprocals.empty();
    result.view.set("shares_reciprocals", result.shares_reciprocals);
    result.view.set("reciprocal_count", std::to_string(reciprocals.size()));
    result.view.set("functions", functions);
    result.view.set("operations", text::joined(operations, "; "));
    result.view.set("constants", constant_list(named));
    result.max_configurations =
        closed_ ? closed_->elimination.max_configurations : numbers_.complex_configurations;
    result.branch_numbers = number_count(inputs_) + number_count(equations_.unknowns) +
                            2 * equations_.loops.size() * equations_.unknowns.size() +
                            (closed_ ? closed_->structured.pivots().size() : 1);
    return result;
  }

 private:
  /// The number of parameters by which frames have derivatives.
  [[nodiscard]] Eigen::Index parameter_count() const {
    return count_of(FrameNeed::everything) > 0 ? numbers_.dimension_gradient.cols() : 0;
  }
  [[nodiscard]] std::ptrdiff_t count_of(FrameNeed need) const {
    return std::count(numbers_.frames.begin(), numbers_.frames.end(), need);
  }

  /// A dimension, or the cosine or sine of one, under a name in the functions.
  struct NamedConstant {
    GiNaC::symbol symbol;
    GiNaC::numeric value;
    std::string text;  ///< `100.0 / unit`
    std::string meaning;
  };

  void put(const equations::Variable& variable, const DimensionValue<double>& value) {
    values_[variable.cosine] = cpp::exact(value.angle.cos);
    values_[variable.sine] = cpp::exact(value.angle.sin);
    values_[variable.value] = cpp::exact(value.length);
    values_[variable.size] = cpp::exact(std::abs(value.length));
    values_[variable.rate] = 0;
    values_[variable.second_rate] = 0;
    for (const GiNaC::symbol& length : {variable.value, variable.size}) {
      sizes_[length.get_name()] = std::abs(value.length);
    }
  }

  /// Names a number, unless it is 0, 1 or -1: these are folded wherever they occur.
  void put_constant(const GiNaC::symbol& symbol, double value, const std::string& text,
                    const std::string& meaning) {
    if (value != 0 && std::abs(value) != 1) {
      values_.erase(symbol);
      constants_.push_back({symbol, cpp::exact(value), text, meaning});
    }
  }

  void put_dimension(const equations::Variable& variable, const DimensionValue<double>& value) {
    put(variable, value);
    if (variable.is_angle()) {
      put_constant(variable.cosine, value.angle.cos, cpp::round_trip(value.angle.cos),
                   "cosine of the " + variable.meaning);
      put_constant(variable.sine, value.angle.sin, cpp::round_trip(value.angle.sin),
                   "sine of the " + variable.meaning);
    } else {
      put_constant(variable.value, value.length,
                   cpp::round_trip(value.length * numbers_.unit) + " / unit", variable.meaning);
      if (!values_.contains(variable.value)) {
        values_[variable.size] = value.length < 0 ? GiNaC::ex(-variable.value) : variable.value;
      }
    }
  }

  /// The constants that the functions read.
  [[nodiscard]] cpp::View::List constant_list(const std::set<std::string>& named) const {
    cpp::View::List list;
    for (const NamedConstant& constant : constants_) {
      if (named.contains(constant.symbol.get_name())) {
        cpp::View entry;
        entry.set("name", constant.symbol.get_name());
        entry.set("value", constant.text);
        entry.set("meaning", cpp::comment_text(constant.meaning));
        list.push_back(entry);
      }
    }
    return list;
  }

  void collect_values() {
    for (std::size_t index = 0; index < equations_.inputs.size(); ++index) {
      if (numbers_.inputs[index]) {
        put(equations_.inputs[index], *numbers_.inputs[index]);
      } else {
        add_input(equations_.inputs[index], numbers_.input_moves[index]);
      }
    }
    for (std::size_t index = 0; index < equations_.dimensions.size(); ++index) {
      if (numbers_.dimensions[index]) {
        put_dimension(equations_.dimensions[index], *numbers_.dimensions[index]);
      } else {
        add_input(equations_.dimensions[index], false);
      }
    }
  }

  void add_input(const equations::Variable& variable, bool moves) {
    inputs_.push_back(variable);
    if (!moves) {
      has_varying_ = true;
      values_[variable.rate] = 0;
      values_[variable.second_rate] = 0;
    }
  }

  /// Keeps the derivatives only of frames that are needed in full.
  void leave_out_frames() {
    const auto keep = [this](derivatives::ExpressionMatrix& matrix, std::size_t rows_of_link) {
      derivatives::ExpressionMatrix kept;
      for (const std::size_t link : framed_links(numbers_.frames)) {
        for (std::size_t row = 0; row < rows_of_link; ++row) {
          if (numbers_.frames[link] == FrameNeed::everything) {
            kept.push_back(matrix[rows_of_link * link + row]);
          }
        }
      }
      matrix = std::move(kept);
    };
    keep(derivatives_.pose_velocity, 1);
    keep(derivatives_.pose_acceleration, 1);
    keep(derivatives_.pose_unknown_jacobian, 3);
    keep(derivatives_.pose_dimension_jacobian, 3);
    keep(derivatives_.pose_input_jacobian, 3);
  }

  [[nodiscard]] model::ModelFunction link_poses() const {
    model::ModelFunction poses{
        "link_poses",
        {"Frames of links in the fixed frame."},
        {{"const Inputs<Scalar>&", "u"}, {"const Configuration<Scalar>&", "q"}},
        {{count_of(FrameNeed::direction) > 0 ? "Poses<Scalar, link_count + direction_count>&"
                                             : "Poses<Scalar, link_count>&",
          "poses"}},
        {}};
    std::size_t place = 0;
    for (const std::size_t link : framed_links(numbers_.frames)) {
      model::add_frame(place++, equations_.poses[structure::LinkIndex(link)],
                       numbers_.frames[link] == FrameNeed::everything, poses.results);
    }
    return poses;
  }

  /// The dimensions are numbers, so no function takes them.
  static model::ModelFunction without_dimensions(model::ModelFunction function) {
    std::erase_if(function.inputs,
                  [](const model::Parameter& parameter) { return parameter.name == "d"; });
    return function;
  }

  [[nodiscard]] static std::string counted(const program::OperationCount& count) {
    return std::to_string(count.multiplications) + ", " + std::to_string(count.additions) + ", " +
           std::to_string(count.divisions);
  }

  /// Whether the runtime calls a function, or the wanted derivatives need it. If the final
  /// polynomial is solved by formula, the Jacobian is needed only in rare cases, and the runtime
  /// computes it from the residual. The inverse is needed to follow a branch; for two unknowns, an
  /// emitted one costs no less than that of the runtime.
  [[nodiscard]] bool is_wanted(const std::string& function) const {
    const auto any_of = [&](const std::vector<std::string>& names) {
      return std::find(names.begin(), names.end(), function) != names.end();
    };
    const bool has_rates = numbers_.order > 0 && count_of(FrameNeed::everything) > 0;
    const bool has_inverse =
        parameter_count() > 0 || numbers_.holds_groups || equations_.unknowns.size() > 2;
    return any_of({"residual", "degeneracies"}) ||
           (function == "jacobian" && !(closed_ && closed_->elimination.is_closed())) ||
           (!closed_ && numbers_.order > 0 && function == "velocity_rhs") ||
           (!closed_ && numbers_.order > 1 && function == "acceleration_rhs") ||
           (has_inverse && function == "inverse_jacobian") || is_of_rates(function) ||
           (numbers_.order == 2 && has_rates && function == "link_accelerations") ||
           (has_rates && function == "link_velocities");
  }

  [[nodiscard]] bool is_of_rates(const std::string& function) const {
    return (numbers_.order == 1 && function == "velocity") ||
           (numbers_.order == 2 && function == "motion");
  }

  /// The reciprocals that the forces need, that are not numbers here and are found with the rates.
  [[nodiscard]] std::vector<GiNaC::symbol> reciprocals_of_rates(
      const model::ForceFunction& function) const {
    std::vector<GiNaC::symbol> result;
    if (!closed_ || numbers_.order == 0) {
      return result;
    }
    program::SymbolOrder order = function.order(equations_, {});
    const NamedResults special = specialised(function.naming.vocabulary.quantities(),
                                             function.naming.function.results, order, values_);
    const program::Program program(order, special.quantities, special.results);
    for (const equations::NamedQuantity& quantity : closed_->structured.vocabulary().quantities()) {
      const bool is_needed =
          std::ranges::find(program.steps(), quantity.symbol.get_name(),
                            &program::Program::Step::name) != program.steps().end();
      if (quantity.form == equations::NamedQuantity::Form::reciprocal && is_needed) {
        result.push_back(quantity.symbol);
      }
    }
    return result;
  }

  /// A length is one number, an angle its cosine and sine.
  [[nodiscard]] static std::size_t number_count(const std::deque<equations::Variable>& variables) {
    const auto angles = std::count_if(variables.begin(), variables.end(),
                                      [](const auto& one) { return one.is_angle(); });
    return variables.size() + static_cast<std::size_t>(angles);
  }

  [[nodiscard]] cpp::View view(const std::string& struct_name, const std::string& title) const {
    cpp::View view;
    view.set("struct", struct_name);
    view.set("title", title);
    view.set("unit", cpp::round_trip(numbers_.unit));
    view.set("own_length", cpp::round_trip(numbers_.size));
    view.set("has_parameters", parameter_count() > 0);
    view.set("parameter_count", std::to_string(parameter_count()));
    std::vector<std::string> closure = model::closure_lines(equations_);
    if (closed_) {
      const std::vector<std::string> steps = model::elimination_steps(closed_->elimination);
      closure.insert(closure.end(), steps.begin(), std::prev(steps.end()));  // the count has a name
      model::show_solution(closed_->structured, equations_, closed_->elimination, view);
      view.set("has_second_unknown", closed_->elimination.second != nullptr);
    } else {
      closure.emplace_back(
          numbers_.starts.empty()
              ? "all complex configurations by the determinant of Dixon"
              : "all complex configurations along paths from those of other numbers");
      show_eliminations(view);
      show_starts(view);
    }
    view.set("is_closed_form", closed_.has_value());
    view.set("closure", cpp::line_list(closure, ""));
    view.set("frames", model::link_list(equations_));
    view.set("link_count", std::to_string(count_of(FrameNeed::everything)));
    view.set("direction_count", std::to_string(count_of(FrameNeed::direction)));
    view.set("holds_groups", cpp::boolean(numbers_.holds_groups));
    view.set("gives_forces", numbers_.forces);
    view.set("joint_count", std::to_string(equations_.model->group->joints().size()));
    view.set("equation_count", std::to_string(2 * equations_.loops.size()));
    model::show_variables(equations_.unknowns, "unknown", view, equations_.owners);
    model::show_variables(inputs_, "input", view);
    view.set("has_varying", has_varying_);
    return view;
  }

  /// Shows the tables from which the runtime finds all complex configurations.
  void show_eliminations(cpp::View& view) const {
    std::vector<std::string> sets;
    std::vector<std::string> powers;
    std::vector<std::string> entries;
    int eigenvalues = 0;
    const auto offset = [](const std::string& table, const std::vector<std::string>& of) {
      return table + ".data() + " + std::to_string(of.size());
    };
    for (const loops::Elimination& one : numbers_.eliminations) {
      eigenvalues = std::max(eigenvalues, one.eigenvalues());
      std::string entry = "{" + std::to_string(one.ground) + ", " + std::to_string(one.hidden) +
                          ", " + std::to_string(one.size) + ", " + std::to_string(one.degree) +
                          ", " + offset("angle_sets", sets);
      if (!std::equal(one.sets, one.sets + one.size, one.products)) {
        std::ranges::transform(one.sets, one.sets + one.size, std::back_inserter(sets), set_text);
      }
      entry += ", " + offset("angle_sets", sets);
      std::ranges::transform(one.products, one.products + one.size, std::back_inserter(sets),
                             set_text);
      entry += ", " + offset("lowest_powers", powers) + "}";
      std::ranges::transform(one.lowest_powers, one.lowest_powers + one.size,
                             std::back_inserter(powers),
                             [](int power) { return std::to_string(power); });
      entries.push_back(std::move(entry));
    }
    std::vector<std::string> slide_angles;
    for (const int angle : numbers_.slide_angles) {
      slide_angles.push_back(std::to_string(angle));
    }
    const std::size_t slides = slide_angles.size();
    show_table("angle_sets", sets, view);
    show_table("lowest_powers", powers, view);
    show_table("eliminations", entries, view);
    show_table("slide_angles", slide_angles, view);
    view.set("loop_count", std::to_string(equations_.loops.size()));
    view.set("angle_count", std::to_string(equations_.unknowns.size() - slides));
    view.set("slide_count", std::to_string(slides));
    view.set("eigenvalue_count", std::to_string(eigenvalues));
    view.set("max_configurations", std::to_string(numbers_.complex_configurations));
  }
  /// Shows the configurations of other numbers, from which the runtime continues.
  void show_starts(cpp::View& view) const {
    view.set("has_starts", !numbers_.starts.empty());
    if (numbers_.starts.empty()) {
      return;
    }
    const loops::Start& first = numbers_.starts.front();
    const std::size_t loops = equations_.loops.size();
    const std::size_t slides = numbers_.slide_angles.size();
    const std::size_t directions = equations_.unknowns.size() - slides + 1;
    const auto count = static_cast<std::size_t>(first.configurations);
    std::vector<std::string> table;
    std::string of_all = "{" + std::to_string(count);
    const auto put = [&](const std::complex<double>* from, std::size_t size) {
      of_all += ", start_numbers.data() + " + std::to_string(table.size());
      std::transform(from, from + size, std::back_inserter(table), complex_text);
    };
    put(first.of_angles, loops * directions);
    put(first.of_slides, loops * slides);
    put(first.theta, count * directions);
    put(first.s, count * slides);
    std::vector<std::string> entries;
    for (const loops::Start& one : numbers_.starts) {
      entries.push_back(of_all + ", " + complex_text(one.turn) + "}");
    }
    show_table("start_numbers", table, view);
    show_table("starts", entries, view);
  }
  static void show_table(const std::string& name, const std::vector<std::string>& list,
                         cpp::View& view) {
    view.set(name, text::joined(list, ", "));
    view.set(name + "_count", std::to_string(list.size()));
  }
  [[nodiscard]] static std::string complex_text(const std::complex<double>& of) {
    return "{" + cpp::round_trip(of.real()) + ", " + cpp::round_trip(of.imag()) + "}";
  }
  [[nodiscard]] static std::string set_text(loops::AngleSet set) {
    return std::to_string(set) + "U";
  }

  /// The method by which a group with a final polynomial is solved.
  struct ClosedForm {
    explicit ClosedForm(const equations::ClosureEquations& equations)
        : structured(equations), elimination(elimination::eliminate(equations)) {}

    pivoting::StructuredJacobian structured;
    elimination::Elimination elimination;
  };

  const SpecialisedNumbers& numbers_;
  equations::ClosureEquations equations_;
  derivatives::Derivatives derivatives_;
  std::optional<ClosedForm> closed_;  ///< empty for a group of more than four links
  GiNaC::exmap values_;
  std::vector<NamedConstant> constants_;
  model::Sizes sizes_;  ///< of the lengths that are numbers
  std::deque<equations::Variable> inputs_;
  bool has_varying_ = false;  ///< inputs that variable parameters change
};

}  // namespace

std::vector<std::size_t> framed_links(const std::vector<FrameNeed>& frames) {
  std::vector<std::size_t> links;
  for (const FrameNeed need : {FrameNeed::everything, FrameNeed::direction}) {
    for (std::size_t link = 0; link < frames.size(); ++link) {
      if (frames[link] == need) {
        links.push_back(link);
      }
    }
  }
  return links;
}

SpecialisedGroup specialised_group(const SpecialisedNumbers& numbers,
                                   const std::string& struct_name, const std::string& title) {
  return GroupSpecialiser(numbers).run(struct_name, title);
}

}  // namespace assur::generator::emission::scene
