// Groups scaled to lengths near one, several at once, with a bound on the rounding of their final
// polynomials.
#pragma once

#include <algorithm>
#include <array>
#include <assur/detail/batch/pack_columns.hpp>
#include <assur/detail/batch/pack_verdicts.hpp>
#include <assur/numeric/magnitude.hpp>
#include <assur/numeric/pack.hpp>
#include <assur/support/displaced_frame.hpp>
#include <assur/support/scale.hpp>
#include <cstddef>
#include <limits>
#include <tuple>
#include <type_traits>

namespace assur::detail::batch {

/// Up to `Capacity` groups of a model, number by number.
template <typename Model, std::size_t Lanes, std::size_t Capacity>
class ScaledBlock {
  using Pack = numeric::PackOf<double, Lanes>;
  using Truth = decltype(Pack() < Pack());
  template <typename Scalar>
  using Dimensions = typename Model::template Dimensions<Scalar>;
  template <typename Scalar>
  using Inputs = typename Model::template Inputs<Scalar>;
  using Places = std::array<std::size_t, Lanes>;

 public:
  void clear() { most_ = {}; }

  /// Scales several groups, whose inputs rounding has displaced, so that their longest lengths are
  /// near one, and moves the first external joint of each to the origin, which changes no unknown.
  /// Returns a bit for each, set if it can be solved together with others.
  [[nodiscard]] unsigned add(const Dimensions<Pack>& dimensions, const Inputs<Pack>& inputs,
                             const support::DisplacementOf<Pack>& displaced, std::size_t group) {
    const Pack own = [&] {
      if constexpr (has_numbers) {
        return Pack(1);
      } else {
        return sizes_of<Model, Pack>(dimensions, inputs);
      }
    }();
    const Pack places = longest_lengths(inputs);
    // Beyond these limits the search for one group chooses the reference length.
    constexpr double longest_of_all = 0x1p400;
    constexpr double farthest = 0x1p20;
    const Truth in_range = (own < Pack(longest_of_all)) & (Pack(1 / longest_of_all) < own) &
                           (places < Pack(farthest) * own) &
                           (displaced.moved * Pack(farthest) < own) &
                           (displaced.turned * Pack(farthest) < Pack(1)) &
                           are_finite_directions(dimensions) & are_finite_directions(inputs);
    const Pack scale = inverse_power_of_two(select(in_range, own, Pack(1)));
    (Pack(1) / scale).store(&units_[group]);
    const auto keep = [&](const Pack& number, Pack& largest, double* kept) {
      number.store(kept);
      largest = max EIGEN_NOT_A_MACRO(largest, select(in_range, abs(number), Pack(0)));
    };
    [[maybe_unused]] Pack* largest = first_number(most_.dimensions);
    for_each_number(dimensions, [&](const Pack& number, std::size_t place) {
      const bool is_length = SortsOf<Dimensions<double>>::lengths[place];
      keep(is_length ? number * scale : number, largest[place], &dimensions_[place][group]);
    });
    largest = first_number(most_.inputs);
    Direction<Pack> origin{Pack(0), Pack(0)};
    bool is_placed = false;
    for_each_number(inputs, [&](const Pack& number, std::size_t place) {
      constexpr auto axes = axes_of_inputs();
      if (axes[place] == 'y' && !is_placed) {
        origin.sin = number;
        is_placed = true;
      }
      if (axes[place] == 'x' && !is_placed) {
        origin.cos = number;
      }
      const Pack moved = axes[place] == 'x'   ? number - origin.cos
                         : axes[place] == 'y' ? number - origin.sin
                                              : number;
      keep(axes[place] != 0 ? moved * scale : number, largest[place], &inputs_[place][group]);
    });
    const Pack longest = max EIGEN_NOT_A_MACRO(Pack(1), places * scale);
    keep(longest, most_.places, &longest_[group]);
    keep(support::larger(displaced.moved * scale, displaced.turned), most_.off, &off_[group]);
    return in_range.bits();
  }

  /// Bound on the rounding error of a coefficient of the final polynomial of any group of the
  /// block, including rounding of the variables.
  [[nodiscard]] double error() const {
    using numeric::Magnitude;
    Dimensions<Magnitude> d;
    Inputs<Magnitude> u;
    const double longest = largest_in(most_.places);
    const double off = Magnitude::error(largest_in(most_.off)).units;
    const auto put = [](auto& to, const auto& from, double units) {
      for_each_number(from, [&](const Pack& number, std::size_t place) {
        const double size = largest_in(number);
        put_number(&to, place, Magnitude(size, units));
      });
    };
    put(d, most_.dimensions, Magnitude::given_units);
    put(u, most_.inputs, Magnitude::given_units * longest + off);
    constexpr std::size_t N = Model::polynomial_degree;
    TrigonometricPolynomial<Magnitude, N> T;
    Model::position_polynomial(d, u, T);
    double most = 0;
    for (std::size_t k = 0; k <= N; ++k) {
      most = (std::max)({most, T.cosine[k].rounding(), T.sine[k].rounding()});
    }
    return most + support::rounding_of_numbers<Model, double>();
  }

  /// The groups that fill a pack from `group` on, or those at given indices.
  [[nodiscard]] Dimensions<Pack> dimensions(std::size_t group) const {
    return loaded<Dimensions<Pack>>(dimensions_, group);
  }
  [[nodiscard]] Inputs<Pack> inputs(std::size_t group) const {
    return loaded<Inputs<Pack>>(inputs_, group);
  }
  [[nodiscard]] Dimensions<Pack> dimensions(const Places& at) const {
    return gathered<Dimensions<Pack>>(dimensions_, at);
  }
  [[nodiscard]] Inputs<Pack> inputs(const Places& at) const {
    return gathered<Inputs<Pack>>(inputs_, at);
  }
  /// The unit by which a group's lengths were divided.
  [[nodiscard]] double unit(std::size_t group) const { return units_[group]; }
  [[nodiscard]] Pack units(std::size_t group) const { return Pack::load(&units_[group]); }
  /// The longest lengths and coordinates of their inputs before the move to the origin; at least
  /// one.
  [[nodiscard]] Pack longest(const Places& at) const { return Pack::gather(longest_.data(), at); }
  /// Bound on the error of their Jacobians.
  [[nodiscard]] Pack unsure(const Places& at) const {
    return support::larger(Pack::gather(off_.data(), at),
                           Pack(std::numeric_limits<double>::epsilon()) * longest(at));
  }

 private:
  /// The largest numbers of a block, which bound the rounding of all its polynomials.
  struct Magnitudes {
    Dimensions<Pack> dimensions{};
    Inputs<Pack> inputs{};
    Pack places = Pack(1);
    Pack off = Pack(0);
  };

  template <typename Variables, std::size_t Count>
  [[nodiscard]] static Variables loaded(const std::array<std::array<double, Capacity>, Count>& kept,
                                        std::size_t group) {
    Variables result;
    for_each_number(
        result, [&](Pack& number, std::size_t place) { number = Pack::load(&kept[place][group]); });
    return result;
  }

  template <typename Variables, std::size_t Count>
  [[nodiscard]] static Variables gathered(
      const std::array<std::array<double, Capacity>, Count>& kept, const Places& at) {
    Variables result;
    for_each_number(result, [&](Pack& number, std::size_t place) {
      number = Pack::gather(kept[place].data(), at);
    });
    return result;
  }
  template <typename Variables>
  [[nodiscard]] static Pack* first_number(Variables& variables) {
    if constexpr (std::tuple_size_v<decltype(variables.members())> == 0) {
      return nullptr;
    } else {
      auto& first = std::get<0>(variables.members());
      if constexpr (is_direction<std::decay_t<decltype(first)>>) {
        return &first.cos;
      } else {
        return &first;
      }
    }
  }
  /// For each number of the inputs, the axis along which it is a coordinate, or none. A group whose
  /// functions hold joints of the ground as numbers cannot be translated.
  [[nodiscard]] static constexpr auto axes_of_inputs() {
    std::array<char, Columns<Inputs<double>>::count> axes{};
    if constexpr (!has_numbers) {
      std::size_t place = 0;
      for (const ModelVariable& input : Model::inputs) {
        axes[place] = input.is_angle ? '\0' : input.name[0];
        place += input.is_angle ? 2 : 1;
      }
    }
    return axes;
  }
  [[nodiscard]] static double largest_in(const Pack& pack) {
    double largest = 0;
    for (std::size_t lane = 0; lane < Lanes; ++lane) {
      largest = (std::max)(largest, pack[lane]);
    }
    return largest;
  }

  /// Whether a specialised group holds its dimensions as numbers, in a unit of its own.
  static constexpr bool has_numbers = Model::dimension_count == 0;
  template <std::size_t Count>
  using Kept = std::array<std::array<double, Capacity>, Count>;
  Magnitudes most_;
  Kept<Columns<Dimensions<double>>::count> dimensions_;
  Kept<Columns<Inputs<double>>::count> inputs_;
  std::array<double, Capacity> units_, longest_, off_;
};

}  // namespace assur::detail::batch
