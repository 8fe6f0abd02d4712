// Sensitivities and rates of many assembled configurations of one model, several configurations at
// once.
#pragma once

#include <algorithm>
#include <assur/columns.hpp>
#include <assur/detail/batch/pack_columns.hpp>
#include <assur/detail/batch/pack_verdicts.hpp>
#include <assur/kinematics.hpp>
#include <assur/numeric/pack.hpp>
#include <cstddef>

namespace assur {

/// Many configurations: dimensions, inputs and unknowns of each.
template <typename Model>
struct BatchConfigurations {
  Columns<const typename Model::template Dimensions<double>> dimensions;
  Columns<const typename Model::template Inputs<double>> inputs;
  Columns<const typename Model::template Configuration<double>> configurations;
};

/// The rates du/dt and d2u/dt2 of their inputs: the rate of input p of configuration i is
/// at [p * stride + i].
struct BatchRates {
  const double* first = nullptr;
  const double* second = nullptr;
  std::size_t stride = 0;
};

/// The caller's arrays for dq/dd and dq/du: entry (row, column) of configuration i is at [(row +
/// column * unknown_count) * stride + i], set if the status is ok or near_singular.
struct BatchSensitivities {
  Status* status = nullptr;
  double* to_dimensions = nullptr;
  double* to_inputs = nullptr;
  std::size_t stride = 0;
};

/// The caller's arrays for dq/dt and d2q/dt2: the rate of unknown p of configuration i is at [p *
/// stride + i], set if the status is ok or near_singular.
struct BatchMotion {
  double* velocity = nullptr;
  double* acceleration = nullptr;
  std::size_t stride = 0;
};

namespace detail::batch {

/// A matrix of packs, entry by entry.
template <typename Pack, int Rows, int Columns>
[[nodiscard, gnu::always_inline]] inline Matrix<Pack, Rows, Columns> load_matrix(
    const double* from, std::size_t stride, std::size_t first) {
  Matrix<Pack, Rows, Columns> matrix;
  for_each_place<Rows * Columns>(
      [&](std::size_t place) { matrix.data()[place] = Pack::load(from + place * stride + first); });
  return matrix;
}
template <typename Pack, int Rows, int Columns>
[[gnu::always_inline]] inline void store_matrix(const Matrix<Pack, Rows, Columns>& matrix,
                                                double* to, std::size_t stride, std::size_t first) {
  for_each_place<Rows * Columns>(
      [&](std::size_t place) { matrix.data()[place].store(to + place * stride + first); });
}
/// The same for one configuration.
template <int Rows>
[[nodiscard]] Vector<double, Rows> vector_of(const double* from, std::size_t stride,
                                             std::size_t index) {
  Vector<double, Rows> vector;
  for (int row = 0; row < Rows; ++row) {
    vector(row) = from[detail::size(row) * stride + index];
  }
  return vector;
}
template <int Rows, int Columns>
void put_matrix(const Matrix<double, Rows, Columns>& matrix, double* to, std::size_t stride,
                std::size_t index) {
  for (std::size_t place = 0; place < detail::size(Rows * Columns); ++place) {
    to[place * stride + index] = matrix.data()[place];
  }
}

/// Includes variables, or the entries of a vector, in the check for finite numbers.
template <typename Pack, template <typename> class Variables>
[[gnu::always_inline]] inline void look_at(const Variables<Pack>& variables,
                                           FiniteNumbers<Pack>& numbers) {
  for_each_number(variables, [&numbers](const Pack& number, std::size_t place) {
    numbers.look_at(number, place);
  });
}
template <typename Pack, int Rows>
[[gnu::always_inline]] inline void look_at(const Vector<Pack, Rows>& vector,
                                           FiniteNumbers<Pack>& numbers) {
  for_each_place<Rows>([&](std::size_t row) { numbers.look_at(vector.data()[row], row); });
}
/// The lanes in which all numbers are finite and the configuration is certainly regular. Called
/// before the derivatives are computed, so that both do not compete for registers.
template <typename Model, typename Pack, typename... Rates>
[[nodiscard, gnu::always_inline]] inline auto are_certain(
    const typename Model::template Dimensions<Pack>& d,
    const typename Model::template Inputs<Pack>& u,
    const typename Model::template Configuration<Pack>& q, const Rates&... rates) {
  FiniteNumbers<Pack> numbers;
  look_at(d, numbers);
  look_at(u, numbers);
  look_at(q, numbers);
  (look_at(rates, numbers), ...);
  return numbers.all() & are_surely_regular<Model>(d, u, q, Pack(0));
}

/// The configurations that fill a pack, and the rates of their inputs.
template <typename Model, typename Pack>
struct GivenRates {
  GivenRates(const BatchRates& rates, std::size_t first)
      : first_rates(load_matrix<Pack, Model::input_count, 1>(rates.first, rates.stride, first)),
        second_rates(load_matrix<Pack, Model::input_count, 1>(rates.second, rates.stride, first)) {}
  Vector<Pack, Model::input_count> first_rates;
  Vector<Pack, Model::input_count> second_rates;
};
template <typename Model, typename Pack>
struct GivenPack {
  GivenPack(const BatchConfigurations<Model>& given, std::size_t first)
      : d(load_groups<typename Model::template Dimensions<Pack>>(given.dimensions, first)),
        u(load_groups<typename Model::template Inputs<Pack>>(given.inputs, first)),
        q(load_groups<typename Model::template Configuration<Pack>>(given.configurations, first)) {}
  typename Model::template Dimensions<Pack> d;
  typename Model::template Inputs<Pack> u;
  typename Model::template Configuration<Pack> q;
};
template <typename Model, typename Pack>
[[gnu::always_inline]] inline void store_motion(const Motion<Model, Pack>& motion,
                                                const BatchMotion& result, std::size_t first) {
  store_matrix(motion.velocity, result.velocity, result.stride, first);
  store_matrix(motion.acceleration, result.acceleration, result.stride, first);
}
template <typename Model>
void put_motion(const Motion<Model, double>& motion, const BatchMotion& result, std::size_t index) {
  put_matrix(motion.velocity, result.velocity, result.stride, index);
  put_matrix(motion.acceleration, result.acceleration, result.stride, index);
}
template <typename Model, typename Pack>
[[gnu::always_inline]] inline void store_sensitivities(const Sensitivities<Model, Pack>& sensitive,
                                                       const BatchSensitivities& result,
                                                       std::size_t first) {
  store_matrix(sensitive.to_dimensions, result.to_dimensions, result.stride, first);
  store_matrix(sensitive.to_inputs, result.to_inputs, result.stride, first);
}
template <typename Model>
void put_sensitivities(const Sensitivities<Model, double>& sensitive,
                       const BatchSensitivities& result, std::size_t index) {
  put_matrix(sensitive.to_dimensions, result.to_dimensions, result.stride, index);
  put_matrix(sensitive.to_inputs, result.to_inputs, result.stride, index);
}

/// Calls `several` with the index of the first configuration of each pack; it returns a bit for
/// each doubtful configuration, and `alone` is called with the index of each of these. `several`
/// must make no calls of its own, which would spill packs to memory. The last pack overlaps the
/// previous one.
template <std::size_t Lanes, typename Several, typename Alone>
void for_each_pack(std::size_t count, const Several& several, const Alone& alone) {
  if (count < Lanes) {
    for (std::size_t index = 0; index < count; ++index) {
      alone(index);
    }
    return;
  }
  for (std::size_t done = 0; done < count; done += Lanes) {
    const std::size_t first = (std::min)(done, count - Lanes);
    unsigned left = several(first);
    for (std::size_t index = first; left != 0; ++index, left >>= 1) {
      if ((left & 1) != 0) {
        alone(index);
      }
    }
  }
}

}  // namespace detail::batch

/// Computes dq/dd and dq/du of `count` assembled configurations, each with the status of
/// `sensitivities`. `Lanes` configurations are computed at once, doubtful ones alone.
template <typename Model, std::size_t Lanes = numeric::native_lanes>
void sensitivities(std::size_t count, const BatchConfigurations<Model>& given,
                   const BatchSensitivities& result) {
  using Pack = numeric::PackOf<double, Lanes>;
  using namespace detail::batch;
  for_each_pack<Lanes>(
      count,
      [&](std::size_t first) __attribute__((flatten)) {
        const GivenPack<Model, Pack> at(given, first);
        const unsigned alone = (!are_certain<Model, Pack>(at.d, at.u, at.q)).bits();
        Sensitivities<Model, Pack> sensitive;
        Model::sensitivities(at.d, at.u, at.q, sensitive.to_dimensions, sensitive.to_inputs);
        store_sensitivities(sensitive, result, first);
        std::fill_n(result.status + first, Lanes, Status::ok);
        return alone;
      },
      [&](std::size_t index) {
        Sensitivities<Model, double> sensitive;
        result.status[index] = sensitivities<Model, double>(
            group_of(given.dimensions, index), group_of(given.inputs, index),
            group_of(given.configurations, index), sensitive);
        if (is_solvable(result.status[index])) {
          put_sensitivities(sensitive, result, index);
        }
      });
}

/// Computes dq/dt and d2q/dt2 for the rates of the inputs, each with the status of `motion`.
template <typename Model, std::size_t Lanes = numeric::native_lanes>
void motion(std::size_t count, const BatchConfigurations<Model>& given, const BatchRates& rates,
            Status* status, const BatchMotion& result) {
  using Pack = numeric::PackOf<double, Lanes>;
  using namespace detail::batch;
  for_each_pack<Lanes>(
      count,
      [&](std::size_t first) __attribute__((flatten)) {
        const GivenPack<Model, Pack> at(given, first);
        const GivenRates<Model, Pack> u(rates, first);
        const unsigned alone =
            (!are_certain<Model, Pack>(at.d, at.u, at.q, u.first_rates, u.second_rates)).bits();
        Motion<Model, Pack> moving;
        Model::motion(at.d, at.u, at.q, u.first_rates, u.second_rates, moving.velocity,
                      moving.acceleration);
        store_motion(moving, result, first);
        std::fill_n(status + first, Lanes, Status::ok);
        return alone;
      },
      [&](std::size_t index) {
        Motion<Model, double> moving;
        status[index] = motion<Model, double>(
            group_of(given.dimensions, index), group_of(given.inputs, index),
            group_of(given.configurations, index),
            vector_of<Model::input_count>(rates.first, rates.stride, index),
            vector_of<Model::input_count>(rates.second, rates.stride, index), moving);
        if (is_solvable(status[index])) {
          put_motion(moving, result, index);
        }
      });
}

/// Computes both at once, each with the status of `sensitivities_and_motion`.
template <typename Model, std::size_t Lanes = numeric::native_lanes>
void sensitivities_and_motion(std::size_t count, const BatchConfigurations<Model>& given,
                              const BatchRates& rates, const BatchSensitivities& result,
                              const BatchMotion& moving) {
  using Pack = numeric::PackOf<double, Lanes>;
  using namespace detail::batch;
  for_each_pack<Lanes>(
      count,
      [&](std::size_t first) __attribute__((flatten)) {
        const GivenPack<Model, Pack> at(given, first);
        const GivenRates<Model, Pack> u(rates, first);
        const unsigned alone =
            (!are_certain<Model, Pack>(at.d, at.u, at.q, u.first_rates, u.second_rates)).bits();
        Sensitivities<Model, Pack> sensitive;
        Motion<Model, Pack> motion;
        Model::sensitivities_and_motion(at.d, at.u, at.q, u.first_rates, u.second_rates,
                                        sensitive.to_dimensions, sensitive.to_inputs,
                                        motion.velocity, motion.acceleration);
        store_sensitivities(sensitive, result, first);
        store_motion(motion, moving, first);
        std::fill_n(result.status + first, Lanes, Status::ok);
        return alone;
      },
      [&](std::size_t index) {
        Sensitivities<Model, double> sensitive;
        Motion<Model, double> motion;
        result.status[index] = sensitivities_and_motion<Model, double>(
            group_of(given.dimensions, index), group_of(given.inputs, index),
            group_of(given.configurations, index),
            vector_of<Model::input_count>(rates.first, rates.stride, index),
            vector_of<Model::input_count>(rates.second, rates.stride, index), sensitive, motion);
        if (is_solvable(result.status[index])) {
          put_sensitivities(sensitive, result, index);
          put_motion(motion, moving, index);
        }
      });
}

}  // namespace assur
