// All configurations of many instances of an emitted solver, several at once, as columns of
// numbers.
#pragma once

#include <algorithm>
#include <array>
#include <assur/numeric/arithmetic.hpp>
#include <assur/numeric/pack.hpp>
#include <assur/support/batch_order.hpp>
#include <assur/support/batch_search.hpp>
#include <assur/support/scene_columns.hpp>
#include <assur/support/scene_solve.hpp>
#include <cstddef>
#include <tuple>

namespace assur::support {

/// Drivers, or variable parameters, of many instances of a solver: data[p * stride + i] is number p
/// (see `column_numbers`) of instance i.
struct GivenColumns {
  const double* data = nullptr;
  std::size_t stride = 0;
};

/// The caller's arrays for the configurations of many instances. Entry i of the first arrays is the
/// member of `Solution` for instance i.
template <typename Solver>
struct BatchSolutions {
  AssemblyStatus* status = nullptr;
  int* count = nullptr;
  int* families = nullptr;
  int* mobility = nullptr;
  int* left_out = nullptr;  ///< only for the solver of a scene with limits
  /// The regularity of configuration k of instance i is at [k * stride + i]. Entries beyond an
  /// instance's count are undefined.
  Status* regularity = nullptr;
  /// Number p (see `column_numbers`) of configuration k of instance i is at [(k *
  /// column_count<Solver::State<double>> + p) * stride + i].
  double* states = nullptr;
  std::size_t stride = 0;

  [[nodiscard]] double* column(std::size_t configuration, std::size_t number) const {
    return states +
           (configuration * column_count<typename Solver::template State<double>> + number) *
               stride;
  }
};

/// Instances of a solver, solved one by one: inputs and results.
template <typename Solver>
struct LoneInstances {
  GivenColumns drivers;
  GivenColumns parameters;
  BatchSolutions<Solver> result;

  /// The arguments of instances from `instance` on; `load` reads a scalar at a number's address.
  template <typename Scalar, typename Load>
  [[nodiscard]] typename Access<Solver, Scalar>::Given given_at(std::size_t instance,
                                                                const Load& load) const {
    typename Access<Solver, Scalar>::Given given;
    const auto read = [&](auto& variables, const GivenColumns& columns) {
      for_each_column(variables, [&](Scalar& number, std::size_t column) {
        number = load(columns.data + column * columns.stride + instance);
      });
    };
    read(Access<Solver, Scalar>::drivers_of(given), drivers);
    if constexpr (has_parameters<Solver>) {
      read(given.parameters, parameters);
    }
    return given;
  }

  [[gnu::noinline]] void solve(std::size_t instance) const {
    const auto given = given_at<double>(instance, [](const double* number) { return *number; });
    std::array<typename Solver::template State<double>,
               static_cast<std::size_t>(Solver::max_configurations)>
        states;
    const auto found = support::solve<Solver, Unresolved::ask_double, double>(given, states);
    result.status[instance] = found.status;
    result.count[instance] = found.count;
    result.families[instance] = found.families;
    result.mobility[instance] = found.mobility;
    if constexpr (Access<Solver, double>::has_limits) {
      result.left_out[instance] = found.left_out;
    }
    for (std::size_t index = 0; index < static_cast<std::size_t>(found.count); ++index) {
      result.regularity[index * result.stride + instance] = states[index].regularity;
      for_each_column(states[index], [&](const double& number, std::size_t column) {
        result.column(index, column)[instance] = number;
      });
    }
  }
};

/// Instances of a solver, solved several at once.
template <typename Solver, std::size_t Lanes>
class SceneBatch {
  using Pack = numeric::PackOf<double, Lanes>;
  using Truth = decltype(Pack() < Pack());
  using Own = Access<Solver, Pack>;
  template <typename Scalar>
  using State = typename Solver::template State<Scalar>;
  static constexpr auto capacity = static_cast<std::size_t>(Solver::max_configurations);
  static constexpr std::size_t numbers = column_count<State<double>>;
  using Search = BatchSearch<Solver, Lanes, SceneBatch>;
  static constexpr std::size_t packs = Search::packs;
  using Sets = typename Search::Sets;

 public:
  explicit SceneBatch(const LoneInstances<Solver>& lone) : lone_(lone), result_(lone.result) {}

  /// Solves `count` instances, at least one pack. Returns how many were solved alone.
  [[nodiscard]] std::size_t run(std::size_t count) {
    std::size_t alone = 0;
    for (std::size_t solved = 0; solved < count;) {
      // Packs that are not full overlap the previous ones, if there are enough instances.
      const std::size_t most = (std::min)(count - solved, packs * Lanes);
      const std::size_t left = solved < Lanes ? most / Lanes * Lanes : most;
      const std::size_t filled = (left + Lanes - 1) / Lanes;
      const std::size_t first = solved + left - filled * Lanes;
      const Sets unsure = solve_together(first, filled);
      for (std::size_t place = 0; place < filled * Lanes; ++place) {
        if ((unsure[place / Lanes] >> place % Lanes & 1U) != 0) {
          lone_.solve(first + place);
          alone += first + place < solved ? 0 : 1;
        }
      }
      solved += left;
    }
    return alone;
  }

  /// Lists one configuration of several instances of a pack. Returns those for which joint limits
  /// are not decided with certainty.
  [[nodiscard]] unsigned operator()(std::size_t pack, const typename Own::Placed& placed,
                                    unsigned lanes) {
    unsigned unsure = 0;
    if constexpr (Own::has_limits) {
      const auto limits = Own::keeps_limits(placed);
      unsure = lanes & ~limits.certain.bits();
      lanes &= limits.certain.bits();
      const unsigned beyond = lanes & ~limits.kept.bits();
      for (std::size_t lane = 0; lane < Lanes; ++lane) {
        left_out_[pack * Lanes + lane] += static_cast<int>(beyond >> lane & 1U);
      }
      lanes &= limits.kept.bits();
    }
    if (lanes == 0) {
      return unsure;
    }
    State<Pack> state;
    Own::list_moderate(placed, state);
    if constexpr (Solver::order > 0 && Own::has_own_rates) {
      const unsigned finite = is_sum_of_rates_finite(state).bits();
      unsure |= lanes & ~finite;
      lanes &= finite;
    }
    if constexpr (has_parameters<Solver>) {
      const unsigned finite = are_places_finite(state).bits();
      unsure |= lanes & ~finite;
      lanes &= finite;
    }
    typename Own::Key key;
    Own::key(placed, key);
    put(pack, lanes, state, key);
    return unsure;
  }

 private:
  /// Solves the instances from `first` on that fill `filled` packs. Returns those that must be
  /// solved alone, a bit for each lane of each pack.
  [[nodiscard]] Sets solve_together(std::size_t first, std::size_t filled) {
    first_ = first;
    most_ = {};
    left_out_ = {};
    typename Search::Given given;
    Sets immoderate{};
    for (std::size_t pack = 0; pack < filled; ++pack) {
      Truth below = Pack(0) == Pack(0);
      given[pack] = lone_.template given_at<Pack>(first + pack * Lanes, [&](const double* number) {
        const Pack loaded = Pack::load(number);
        below = below & (abs(loaded) < Pack(moderate<double>));
        return loaded;
      });
      immoderate[pack] = (!below).bits();
    }
    Sets unsure = Search(*this).run(given, filled);
    for (std::size_t pack = 0; pack < filled; ++pack) {
      unsure[pack] |= immoderate[pack];
      if constexpr (capacity > 1) {
        unsure[pack] |= put_in_order(pack);
      }
      finish(pack);
    }
    return unsure;
  }

  /// Appends a configuration to those of the lanes.
  void put(std::size_t pack, unsigned lanes, State<Pack>& state, const typename Own::Key& key) {
    const std::size_t at = first_ + pack * Lanes;
    auto& having = having_[pack];
    std::size_t& most = most_[pack];
    const auto reaching = [&](std::size_t index) {
      return index == 0 ? all_lanes : having[index - 1];
    };
    if ((lanes & ~reaching(most)) == 0) {
      // No lane has a configuration at this index yet, so the other lanes may receive any.
      for_each_column(state, [&](const Pack& number, std::size_t column) {
        number.store(result_.column(most, column) + at);
      });
      std::copy(key.begin() + Own::first_key, key.end(),
                keys_[pack][most].begin() + Own::first_key);
      having[most++] = lanes;
      return;
    }
    for (std::size_t index = most + 1; index-- > 0;) {
      const unsigned here = lanes & reaching(index) & ~(index < most ? having[index] : 0U);
      for (std::size_t lane = 0; lane < Lanes; ++lane) {
        if ((here >> lane & 1U) == 0) {
          continue;
        }
        for_each_column(state, [&](const Pack& number, std::size_t column) {
          result_.column(index, column)[at + lane] = number[lane];
        });
        for (std::size_t place = Own::first_key; place < key.size(); ++place) {
          keys_[pack][index][place].put(lane, key[place][lane]);
        }
      }
      if (here != 0 && index == most) {
        having[most++] = here;
      } else if (here != 0) {
        having[index] |= here;
      }
      lanes &= ~here;
    }
  }

  [[nodiscard]] static Truth where(unsigned lanes) {
    Pack one(0);
    for (std::size_t lane = 0; lane < Lanes; ++lane) {
      one.put(lane, static_cast<double>(lanes >> lane & 1U));
    }
    return one > Pack(0);
  }
  /// The longest displacement of a slide in each lane, the unit of all displacements.
  [[nodiscard]] Pack longest(std::size_t pack) const {
    Pack result(0);
    for (std::size_t index = 0; index < most_[pack]; ++index) {
      const Truth has = where(having_[pack][index]);
      const auto& key = keys_[pack][index];
      for (std::size_t place = Own::lengths_from; place < key.size(); ++place) {
        result = larger(result, select(has, abs(key[place]), Pack(0)));
      }
    }
    return result;
  }

  /// Sorts the configurations of a pack by insertion, in the order of `support::put_in_order`.
  /// Returns the lanes in which rounding might decide the order.
  [[nodiscard]] unsigned put_in_order(std::size_t pack) {
    auto& keys = keys_[pack];
    constexpr bool has_lengths = std::tuple_size_v < typename Own::Key >> Own::lengths_from;
    const Pack unit = has_lengths ? longest(pack) : Pack(0);
    unsigned unsure = 0;
    for (std::size_t last = 1; last < most_[pack]; ++last) {
      unsigned moving = having_[pack][last];
      for (std::size_t place = last; place > 0 && moving != 0; --place) {
        const PackOrder<Pack> order(keys[place], keys[place - 1], Own::lengths_from, unit,
                                    Own::first_key);
        unsure |= moving & ~order.certain.bits();
        moving &= order.certain.bits() & order.before.bits();
        if (moving != 0) {
          exchange(pack, place, moving);
        }
      }
    }
    return unsure;
  }
  /// Exchanges a configuration of some lanes with the previous one.
  void exchange(std::size_t pack, std::size_t place, unsigned lanes) {
    const Truth moving = where(lanes);
    const std::size_t at = first_ + pack * Lanes;
    for (std::size_t column = 0; column < numbers; ++column) {
      double* const left = result_.column(place - 1, column) + at;
      double* const right = result_.column(place, column) + at;
      const Pack before = Pack::load(left);
      const Pack after = Pack::load(right);
      select(moving, after, before).store(left);
      select(moving, before, after).store(right);
    }
    for (std::size_t number = Own::first_key; number < keys_[pack][place].size(); ++number) {
      Pack& before = keys_[pack][place - 1][number];
      Pack& after = keys_[pack][place][number];
      const Pack kept = before;
      before = select(moving, after, before);
      after = select(moving, kept, after);
    }
  }

  /// Writes the results of the instances of a pack.
  void finish(std::size_t pack) const {
    const std::size_t at = first_ + pack * Lanes;
    std::fill_n(result_.status + at, Lanes, AssemblyStatus::ok);
    std::fill_n(result_.count + at, Lanes, 0);
    std::fill_n(result_.families + at, Lanes, 0);
    std::fill_n(result_.mobility + at, Lanes, 0);
    if constexpr (Own::has_limits) {
      std::copy_n(&left_out_[pack * Lanes], Lanes, result_.left_out + at);
    }
    for (std::size_t index = 0; index < most_[pack]; ++index) {
      std::fill_n(result_.regularity + index * result_.stride + at, Lanes, Status::ok);
      for (std::size_t lane = 0; lane < Lanes; ++lane) {
        result_.count[at + lane] += static_cast<int>(having_[pack][index] >> lane & 1U);
      }
    }
  }

  static constexpr unsigned all_lanes = (1U << Lanes) - 1;
  const LoneInstances<Solver>& lone_;
  const BatchSolutions<Solver>& result_;
  std::size_t first_ = 0;
  /// For each pack and each k, the lanes with more than k configurations, a bit each; and the
  /// largest number of configurations in a lane.
  std::array<std::array<unsigned, capacity>, packs> having_;
  std::array<std::size_t, packs> most_{};
  std::array<int, packs * Lanes> left_out_{};
  std::array<std::array<typename Own::Key, capacity>, packs> keys_;
};

/// Whether several instances of a solver are solved at once: its code compiles with packs as
/// numbers, and the data of all configurations fit on the stack.
template <typename Solver>
inline constexpr bool is_solved_in_packs =
    Access<Solver, double>::in_packs&& Solver::max_configurations <= 256;

/// Solves `count` instances of an emitted solver. Returns how many were solved alone.
template <typename Solver, std::size_t Lanes>
std::size_t solve_batch(std::size_t count, const GivenColumns& drivers,
                        const GivenColumns& parameters, const BatchSolutions<Solver>& result) {
  const LoneInstances<Solver> lone{drivers, parameters, result};
  if constexpr (is_solved_in_packs<Solver>) {
    if (count >= Lanes && numeric::sums_are_exact<double>()) {
      return SceneBatch<Solver, Lanes>(lone).run(count);
    }
  }
  for (std::size_t instance = 0; instance < count; ++instance) {
    lone.solve(instance);
  }
  return count;
}

}  // namespace assur::support
