// Adapter from a model to the functions that the search in special position calls.
#pragma once

#include <assur/assemblies.hpp>
#include <assur/detail/index.hpp>
#include <assur/detail/numbers.hpp>
#include <assur/detail/special_search.hpp>
#include <assur/kinematics.hpp>
#include <assur/numeric/bounded.hpp>
#include <assur/numeric/second_unknown.hpp>
#include <assur/support/scale.hpp>
#include <assur/variables.hpp>
#include <tuple>
#include <type_traits>

namespace assur::detail {

using CertifiedVariables = FlatVariables<numeric::Bounded<numeric::DoubleDouble>>;

/// Variables with the error bound `within`.
[[nodiscard]] inline CertifiedVariables in_bounds(const PreciseVariables& variables,
                                                  double within) {
  CertifiedVariables result;
  for (std::size_t place = 0; place < variables.size(); ++place) {
    result[place] = {variables[place], within};
  }
  return result;
}

/// Lists a completion, if it is finite. If a direction or a displacement is not determined, for a
/// bar of zero length or between parallel slides, the search may start from any.
inline void add_completion(const PreciseVariables& q, const ModelUnknown* unknowns, int count,
                           Completions& completions) {
  FlatVariables<double>& found = completions.list[completions.count];
  bool finite = true;
  const auto add = [&](std::size_t place, const numeric::DoubleDouble& value) {
    found[place] = static_cast<double>(value);
    finite = finite && std::isfinite(found[place]);
  };
  std::size_t place = 0;
  for (int unknown = 0; unknown < count; ++unknown) {
    if (unknowns[unknown].is_angle) {
      const bool known = is_number(q[place]) && is_number(q[place + 1]);
      add(place, known ? q[place] : 1);
      add(place + 1, known ? q[place + 1] : 0);
      place += 2;
    } else {
      add(place, is_number(q[place]) ? q[place] : 0);
      ++place;
    }
  }
  completions.count += finite ? 1 : 0;
}

/// A group of a model, scaled so that its longest length is near one.
template <typename Model>
class SpecialGroupOf {
  template <typename Scalar>
  using Dimensions = typename Model::template Dimensions<Scalar>;
  template <typename Scalar>
  using Inputs = typename Model::template Inputs<Scalar>;
  template <typename Scalar>
  using Configuration = typename Model::template Configuration<Scalar>;
  using Precise = numeric::DoubleDouble;
  using Certified = numeric::Bounded<Precise>;

 public:
  SpecialGroupOf(const Dimensions<double>& d, const Inputs<double>& u, double displaced)
      : d_(d), u_(u), displaced_(displaced) {
    support::flatten(d, flat_d_);
    support::flatten(u, flat_u_);
  }

  [[nodiscard]] SpecialAssemblies search() const {
    const SpecialGroup group = functions();
    return SpecialSearch<SpecialGroup>(group, flat_d_, flat_u_).run();
  }
  /// The least closure gap of a group that cannot be assembled.
  [[nodiscard]] double least_miss() const {
    const SpecialGroup group = functions();
    return SpecialSearch<SpecialGroup>(group, flat_d_, flat_u_).least_miss();
  }

 private:
  /// The unit of a specialised group may be much longer than the group.
  [[nodiscard]] static constexpr double longest() {
    if constexpr (Model::dimension_count == 0) {
      return (std::min)(1.0, Model::own_length);
    } else {
      return 1;
    }
  }
  [[nodiscard]] SpecialGroup functions() const {
    return {{&evaluate, &differentiate, this, Model::unknowns.data(), Model::unknown_count,
             longest_length(u_), displaced_, longest()},
            SortsOf<Dimensions<double>>::angles.data(),
            SortsOf<Inputs<double>>::angles.data(),
            SortsOf<Dimensions<double>>::angles.size(),
            SortsOf<Inputs<double>>::angles.size(),
            Model::dimension_count == 0,
            support::rounding_of_inputs(u_, displaced_),
            is_angle<Model>(Model::first_unknown),
            &values,
            &complete};
  }
  template <typename Variables>
  [[nodiscard]] static Variables in_double(const FlatVariables<double>& flat) {
    return support::unflattened<Variables>(flat);
  }
  template <typename Variables>
  [[nodiscard]] static Variables precise(const PreciseVariables& flat) {
    return support::unflattened<Variables>(flat);
  }
  template <typename Variables>
  [[nodiscard]] static Variables certified(const PreciseVariables& flat, double within) {
    return support::unflattened<Variables>(in_bounds(flat, within));
  }

  static void evaluate(const void* group, const FlatVariables<double>& q, numeric::Vector4& f) {
    const auto& self = *static_cast<const SpecialGroupOf*>(group);
    Vector<double, Model::equation_count> result;
    Model::residual(self.d_, self.u_, in_double<Configuration<double>>(q), result);
    std::copy_n(result.data(), Model::equation_count, f.entries.data());
  }

  static void differentiate(const void* group, const FlatVariables<double>& q,
                            numeric::Matrix4& j) {
    const auto& self = *static_cast<const SpecialGroupOf*>(group);
    Matrix<double, Model::equation_count, Model::unknown_count> result;
    Model::jacobian(self.d_, self.u_, in_double<Configuration<double>>(q), result);
    for (int column = 0; column < Model::unknown_count; ++column) {
      std::copy_n(result.col(column).data(), Model::equation_count,
                  j.column(column).entries.data());
    }
  }

  static FirstValues values(const PreciseVariables& d, const PreciseVariables& u, double within) {
    const double own = (std::min)(within, support::rounding_of_one<double>);
    constexpr auto degree = Model::polynomial_degree;
    if constexpr (is_angle<Model>(Model::first_unknown)) {
      TrigonometricPolynomial<Certified, degree> polynomial;
      Model::position_polynomial(certified<Dimensions<Certified>>(d, own),
                                 certified<Inputs<Certified>>(u, within), polynomial);
      return first_values(polynomial);
    } else {
      Vector<Certified, static_cast<int>(degree) + 1> polynomial;
      Model::position_polynomial(certified<Dimensions<Certified>>(d, own),
                                 certified<Inputs<Certified>>(u, within), polynomial);
      return first_values(polynomial);
    }
  }

  static Completions complete(const PreciseVariables& flat_d, const PreciseVariables& flat_u,
                              const FirstValue& first) {
    const auto d = precise<Dimensions<Precise>>(flat_d);
    const auto u = precise<Inputs<Precise>>(flat_u);
    Configuration<Precise> q;
    auto& first_unknown = std::get<size(Model::first_unknown)>(q.members());
    if constexpr (is_angle<Model>(Model::first_unknown)) {
      first_unknown = {first.cos, first.sin};
    } else {
      first_unknown = first.cos;
    }
    Completions result;
    const auto add = [&] {
      Model::complete(d, u, q);
      PreciseVariables flat{};
      support::flatten(q, flat);
      add_completion(flat, Model::unknowns.data(), Model::unknown_count, result);
    };
    if constexpr (Model::second_unknown >= 0) {
      auto& second = std::get<size(Model::second_unknown)>(q.members());
      Matrix<Precise, 2, 3> e;
      Model::second_equations(d, u, q, e);
      const auto candidates = numeric::second_candidates<std::decay_t<decltype(second)>>(e);
      for (std::size_t index = 0; index < candidates.count; ++index) {
        second = candidates.list[index].value;
        add();
      }
    } else {
      add();
    }
    return result;
  }

  const Dimensions<double>& d_;
  const Inputs<double>& u_;
  double displaced_;
  PreciseVariables flat_d_{}, flat_u_{};
};

/// Lists the assemblies of a group that may be in special position. An assembly is marked
/// near_singular if the closures are singular, or if it is not regular for a Jacobian with the
/// error `unsure`; a family of assemblies sets the mobility.
template <typename Model>
void search_in_special_position(const typename Model::template Dimensions<double>& d,
                                const typename Model::template Inputs<double>& u, double displaced,
                                double unsure, Assemblies<Model>& result) {
  using Configuration = typename Model::template Configuration<double>;
  const SpecialAssemblies found = SpecialGroupOf<Model>(d, u, displaced).search();
  result.count = 0;
  for (std::size_t index = 0; index < found.count && result.count < Model::max_configurations;
       ++index) {
    const auto q = support::unflattened<Configuration>(found.list[index]);
    const Status regularity = assur::regularity<Model, double>(d, u, q, unsure).status;
    entry(result.configurations, result.count) = q;
    entry(result.regularity, result.count) =
        regularity == Status::ok && !found.singular[index] ? Status::ok : Status::near_singular;
    ++result.count;
  }
  result.mobility = found.mobility;
  const bool only_moves = result.count == 0 && found.mobility > 0;
  result.status = only_moves ? AssemblyStatus::degenerate : AssemblyStatus::ok;
}

}  // namespace assur::detail
