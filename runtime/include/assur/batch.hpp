// Configurations of many groups of one model, several groups at once, from columns of inputs to
// columns of results.
#pragma once

#include <algorithm>
#include <assur/assembly.hpp>
#include <assur/columns.hpp>
#include <assur/detail/batch/closed_pack.hpp>
#include <assur/detail/batch/general_block.hpp>
#include <assur/detail/batch/pack_columns.hpp>
#include <assur/numeric/pack.hpp>
#include <cstddef>

namespace assur {

/// The caller's arrays for the assembly configurations of many groups. `status[i]`, `count[i]` and
/// `mobility[i]` are those of `Assemblies` for group i.
template <typename Model>
struct BatchAssemblies {
  using Configuration = typename Model::template Configuration<double>;

  AssemblyStatus* status = nullptr;
  int* count = nullptr;
  int* mobility = nullptr;
  /// The regularity of configuration k of group i is at [k * stride + i]. Entries beyond a group's
  /// count are undefined.
  Status* regularity = nullptr;
  /// Number p of configuration k of group i is at [(k * Columns<Configuration>::count + p) * stride
  /// + i].
  double* configurations = nullptr;
  std::size_t stride = 0;

  [[nodiscard]] Columns<Configuration> configuration(int index) const {
    return {configurations + detail::size(index) * Columns<Configuration>::count * stride, stride};
  }
};

namespace detail {

/// A batch of groups: inputs and results.
template <typename Model>
struct Batch {
  std::size_t count;
  Columns<const typename Model::template Dimensions<double>> dimensions;
  Columns<const typename Model::template Inputs<double>> inputs;
  BatchAssemblies<Model> result;

  /// Solves one group alone.
  [[gnu::noinline]] void solve_alone(std::size_t group) const {
    const Assemblies<Model> found =
        assemblies<Model>(group_of(dimensions, group), group_of(inputs, group));
    result.status[group] = found.status;
    result.count[group] = found.count;
    result.mobility[group] = found.mobility;
    for (int index = 0; index < found.count; ++index) {
      result.regularity[size(index) * result.stride + group] = entry(found.regularity, index);
      put_group(result.configuration(index), group, entry(found.configurations, index));
    }
  }
};

/// Solves one pack of groups, from `first` on. Returns a bit for each, set if the group must be
/// solved alone.
template <typename Model, std::size_t Lanes>
[[nodiscard, gnu::flatten]] unsigned solve_closed_pack(const Batch<Model>& batch,
                                                       std::size_t first) {
  using Pack = numeric::PackOf<double, Lanes>;
  const batch::ClosedPack<Model, Pack> found(
      batch::load_groups<typename Model::template Dimensions<Pack>>(batch.dimensions, first),
      batch::load_groups<typename Model::template Inputs<Pack>>(batch.inputs, first));
  const BatchAssemblies<Model> result = batch.result;
  std::fill_n(result.status + first, Lanes, AssemblyStatus::ok);
  std::fill_n(result.mobility + first, Lanes, 0);
  const unsigned assembled = found.assembled.bits();
  for (std::size_t lane = 0; lane < Lanes; ++lane) {
    result.count[first + lane] =
        Model::max_configurations * static_cast<int>(assembled >> lane & 1);
  }
#pragma GCC unroll 2
  for (int index = 0; index < Model::max_configurations; ++index) {
    std::fill_n(result.regularity + size(index) * result.stride + first, Lanes, Status::ok);
    batch::store_groups(entry(found.configurations, index), result.configuration(index), first);
  }
  return (!found.settled).bits();
}

/// Solves all groups pack by pack; the last pack overlaps the previous one. Returns how many were
/// solved alone.
template <typename Model, std::size_t Lanes>
[[nodiscard]] std::size_t solve_closed(const Batch<Model>& batch) {
  std::size_t alone = 0;
  for (std::size_t solved = 0; solved < batch.count; solved += Lanes) {
    const std::size_t first = (std::min)(solved, batch.count - Lanes);
    unsigned left = solve_closed_pack<Model, Lanes>(batch, first);
    for (std::size_t group = first; left != 0; ++group, left >>= 1) {
      if ((left & 1) != 0) {
        batch.solve_alone(group);
        alone += group < solved ? 0 : 1;
      }
    }
  }
  return alone;
}

/// Solves groups whose final polynomial has more than two roots, block by block.
template <typename Model, std::size_t Lanes>
[[nodiscard]] std::size_t solve_general(const Batch<Model>& batch) {
  batch::GeneralBlock<Model, Lanes> block;
  std::size_t alone = 0;
  for (std::size_t solved = 0; solved < batch.count;) {
    // A block that does not fill its packs overlaps the previous one, if there is one.
    const std::size_t most = (std::min)(batch.count - solved, block.capacity);
    const std::size_t left = solved < Lanes ? most / Lanes * Lanes : most;
    const std::size_t filled = (left + Lanes - 1) / Lanes * Lanes;
    const std::size_t first = solved + left - filled;
    block.solve(batch.dimensions, batch.inputs, first, filled);
    for (std::size_t place = filled - left; place < filled; ++place) {
      const std::size_t group = first + place;
      if (!block.is_settled(place) || !block.put_in_order(place)) {
        batch.solve_alone(group);
        ++alone;
        continue;
      }
      const BatchAssemblies<Model>& result = batch.result;
      result.status[group] = AssemblyStatus::ok;
      result.count[group] = static_cast<int>(block.count(place));
      result.mobility[group] = 0;
      for (std::size_t index = 0; index < block.count(place); ++index) {
        result.regularity[index * result.stride + group] = Status::ok;
        block.put(place, index, result.configuration(static_cast<int>(index)), group);
      }
    }
    solved += left;
  }
  return alone;
}

}  // namespace detail

/// Finds all assembly configurations of `count` groups of a model: for each group those of
/// `assemblies`, with the same status and in the same order, to within rounding. `Lanes` groups are
/// solved at once; a group whose list is not certain in this way is solved alone. Returns the
/// number of groups that were solved alone.
template <typename Model, std::size_t Lanes = numeric::native_lanes>
std::size_t assemblies(std::size_t count,
                       const Columns<const typename Model::template Dimensions<double>>& dimensions,
                       const Columns<const typename Model::template Inputs<double>>& inputs,
                       const BatchAssemblies<Model>& result) {
  static_assert(Model::rigid, "a degenerate model has no closed form");
  const detail::Batch<Model> batch{count, dimensions, inputs, result};
  if constexpr (detail::has_closed_form<Model>) {
    if (count >= Lanes) {
      return detail::solve_closed<Model, Lanes>(batch);
    }
  } else if (count >= Lanes && numeric::sums_are_exact<double>()) {
    return detail::solve_general<Model, Lanes>(batch);
  }
  for (std::size_t group = 0; group < count; ++group) {
    batch.solve_alone(group);
  }
  return count;
}

}  // namespace assur
