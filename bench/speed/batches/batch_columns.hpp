// Groups and configurations stored as the columns that batch functions take.
#pragma once

#include <assur/batch.hpp>
#include <assur/batch_kinematics.hpp>
#include <vector>

#include "positions/position_samples.hpp"

namespace assur::speed {

/// Variables of many groups.
template <typename Variables>
struct VariableColumns {
  std::size_t stride;
  std::vector<double> numbers;

  /// The stride is no multiple of 512, so that a group's numbers do not share the lines of a cache.
  explicit VariableColumns(std::size_t count)
      : stride(count + 8), numbers(Columns<Variables>::count * stride) {}
  void put(std::size_t group, const Variables& variables) {
    put_group({numbers.data(), stride}, group, variables);
  }
  /// The columns from group `first` on.
  [[nodiscard]] Columns<const Variables> from(std::size_t first) const {
    return {numbers.data() + first, stride};
  }
};

/// Storage for the configurations of a number of groups.
template <typename Model>
class AssemblyColumns {
  using Configuration = typename Model::template Configuration<double>;
  static constexpr auto capacity = static_cast<std::size_t>(Model::max_configurations);

 public:
  explicit AssemblyColumns(std::size_t count)
      : stride_(count + 8),
        status_(stride_),
        counts_(stride_),
        mobility_(stride_),
        regularity_(capacity * stride_),
        configurations_(capacity * Columns<Configuration>::count * stride_) {}

  [[nodiscard]] BatchAssemblies<Model> result() {
    return {status_.data(),     counts_.data(),         mobility_.data(),
            regularity_.data(), configurations_.data(), stride_};
  }
  [[nodiscard]] Found<Model> found(std::size_t group) {
    Found<Model> list;
    for (int index = 0; index < counts_[group]; ++index) {
      list.add(group_of(result().configuration(index), group));
    }
    return list;
  }

 private:
  std::size_t stride_;
  std::vector<AssemblyStatus> status_;
  std::vector<int> counts_, mobility_;
  std::vector<Status> regularity_;
  std::vector<double> configurations_;
};

/// Storage for the derivatives of a number of configurations.
template <typename Model>
class DerivativeColumns {
  static constexpr auto unknowns = static_cast<std::size_t>(Model::unknown_count);
  static constexpr auto dimensions = static_cast<std::size_t>(Model::dimension_count);
  static constexpr auto inputs = static_cast<std::size_t>(Model::input_count);

 public:
  explicit DerivativeColumns(std::size_t count)
      : stride_(count + 8),
        status_(stride_),
        to_dimensions_(unknowns * dimensions * stride_),
        to_inputs_(unknowns * inputs * stride_),
        velocity_(unknowns * stride_),
        acceleration_(unknowns * stride_) {}

  [[nodiscard]] BatchSensitivities sensitivities() {
    return {status_.data(), to_dimensions_.data(), to_inputs_.data(), stride_};
  }
  [[nodiscard]] BatchMotion motion() { return {velocity_.data(), acceleration_.data(), stride_}; }
  /// Reads the answer of one configuration.
  void read(std::size_t index, Sensitivities<Model, double>& sensitive,
            Motion<Model, double>& moving, Status& status) const {
    status = status_[index];
    read(index, to_dimensions_, sensitive.to_dimensions);
    read(index, to_inputs_, sensitive.to_inputs);
    read(index, velocity_, moving.velocity);
    read(index, acceleration_, moving.acceleration);
  }

 private:
  template <typename Entries>
  void read(std::size_t index, const std::vector<double>& from, Entries& to) const {
    for (Eigen::Index place = 0; place < to.size(); ++place) {
      to.data()[place] = from[static_cast<std::size_t>(place) * stride_ + index];
    }
  }

  std::size_t stride_;
  std::vector<Status> status_;
  std::vector<double> to_dimensions_, to_inputs_, velocity_, acceleration_;
};

}  // namespace assur::speed
