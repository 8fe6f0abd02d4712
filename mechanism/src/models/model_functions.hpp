// Kernels of a group's generated models, and their rows in the list of models.
#pragma once

#include <algorithm>
#include <assur/mechanism/group_model.hpp>
#include <assur/support/displacement.hpp>
#include <assur/support/flat_variables.hpp>
#include <assur/support/scale.hpp>
#include <assur/support/shared_search.hpp>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "models/degenerate_functions.hpp"
#include "models/model_kernel.hpp"

namespace assur::mechanism::models {

/// The functions of a model on flat variables.
template <typename Model>
class ModelFunctions final : public ModelKernel {
  using Dimensions = typename Model::template Dimensions<double>;
  using Inputs = typename Model::template Inputs<double>;
  using Configuration = typename Model::template Configuration<double>;
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

 public:
  void assemble(const FlatVariables& d, const FlatVariables& u,
                const support::Displacement& displaced, GroupAssemblies& result) const override {
    const Assemblies<Model> found =
        assemblies<Model>(read<Dimensions>(d), read<Inputs>(u), displaced);
    result.status = found.status;
    result.mobility = found.mobility;
    result.count = static_cast<std::size_t>(found.count);
    result.configurations.resize(Model::max_configurations);
    result.regularity.resize(Model::max_configurations);
    for (std::size_t index = 0; index < result.count; ++index) {
      support::flatten(found.configurations[index], result.configurations[index]);
      result.regularity[index] = found.regularity[index];
    }
  }

  Status gap(const FlatVariables& d, const FlatVariables& u, double& result) const override {
    return closure_gap<Model>(read<Dimensions>(d), read<Inputs>(u), result);
  }

  void stand(const FlatVariables& d, const FlatVariables& u, const FlatVariables& q,
             GroupPoses& result) const override {
    Poses<double, Model::link_count> poses;
    Model::link_poses(read<Dimensions>(d), read<Inputs>(u), read<Configuration>(q), poses);
    std::copy(poses.begin(), poses.end(), result.begin());
  }

  void move(const FlatVariables& flat_d, const FlatVariables& flat_u, const FlatVariables& flat_q,
            const MotionQuery& query, GroupMotion& motion) const override {
    const auto d = read<Dimensions>(flat_d);
    const auto u = read<Inputs>(flat_u);
    const auto q = read<Configuration>(flat_q);
    Vector<double, Model::equation_count> f;
    Model::residual(d, u, q, f);
    motion.residual = largest(f.data(), Model::equation_count);
    Poses<double, Model::link_count> poses;
    Model::link_poses(d, u, q, poses);
    std::copy(poses.begin(), poses.end(), motion.poses.begin());

    Vector<double, Model::input_count> u_rate;
    Vector<double, Model::input_count> u_second_rate;
    fetch(query.input_rate, u_rate);
    fetch(query.input_second_rate, u_second_rate);
    const bool moves = is_finite(u_rate) && is_finite(u_second_rate);
    const support::DisplacedGroup<Model> among(d, u, query.displaced);
    motion.standing = among.regularity(d, u, q);
    motion.size = among.size();
    motion.held = among.held();
    const bool solvable = is_solvable(motion.standing.status);
    Matrix<double, Model::unknown_count, Model::equation_count> inverse;
    if (solvable) {
      Model::inverse_jacobian(d, u, q, inverse);
    } else {
      forget(inverse);
    }
    Vector<double, Model::unknown_count> q_rate;
    Vector<double, Model::unknown_count> q_second_rate;
    Matrix<double, Model::unknown_count, Model::dimension_count> q_d;
    Matrix<double, Model::unknown_count, Model::input_count> q_u;
    if (solvable) {
      Model::motion(d, u, q, u_rate, u_second_rate, q_rate, q_second_rate);
    }
    if (!solvable || !moves) {
      forget(q_rate);
      forget(q_second_rate);
    }
    if (solvable && query.derivatives) {
      Model::sensitivities(d, u, q, q_d, q_u);
    } else {
      forget(q_d);
      forget(q_u);
    }
    motion.displaced = among.displaced(q, inverse);

    Matrix<double, Model::link_count, 3> velocities;
    Matrix<double, Model::link_count, 3> accelerations;
    Model::link_velocities(d, u, q, q_rate, u_rate, velocities);
    Model::link_accelerations(d, u, q, q_rate, q_second_rate, u_rate, u_second_rate, accelerations);
    store(inverse, motion.inverse);
    store(q_rate, motion.rate);
    store(q_second_rate, motion.second_rate);
    store(velocities, motion.velocities);
    store(accelerations, motion.accelerations);
    if (query.derivatives) {
      Matrix<double, 3 * Model::link_count, Model::unknown_count> p_q;
      Matrix<double, 3 * Model::link_count, Model::dimension_count> p_d;
      Matrix<double, 3 * Model::link_count, Model::input_count> p_u;
      Model::pose_jacobians(d, u, q, p_q, p_d, p_u);
      store(q_d, motion.q_d);
      store(q_u, motion.q_u);
      store(p_q, motion.p_q);
      store(p_d, motion.p_d);
      store(p_u, motion.p_u);
    }
  }

  void bend(const FlatVariables& d, const FlatVariables& u, const FlatVariables& q,
            const SmallVector& q_x, const SmallVector& d_x, const SmallVector& u_x,
            Curvature& along_x) const override {
    Vector<double, Model::unknown_count> q_rate;
    Vector<double, Model::dimension_count> d_rate;
    Vector<double, Model::input_count> u_rate;
    fetch(q_x, q_rate);
    fetch(d_x, d_rate);
    fetch(u_x, u_rate);
    Vector<double, Model::equation_count> rhs;
    Matrix<double, Model::link_count, 3> p;
    const auto dimensions = read<Dimensions>(d);
    const auto inputs = read<Inputs>(u);
    const auto configuration = read<Configuration>(q);
    Model::curvature_rhs(dimensions, inputs, configuration, q_rate, d_rate, u_rate, rhs);
    Model::pose_curvatures(dimensions, inputs, configuration, q_rate, d_rate, u_rate, p);
    store(rhs, along_x.closures);
    along_x.poses.resize(3 * Model::link_count);
    for (int link = 0; link < Model::link_count; ++link) {
      for (int coordinate = 0; coordinate < 3; ++coordinate) {
        along_x.poses(3 * link + coordinate) = p(link, coordinate);
      }
    }
  }

  void expand(const FlatSeries& flat_d, const FlatSeries& flat_u, const FlatSeries& flat_q,
              MovingGroup& moving) const override {
    const auto as_it_is = [](const auto& value) { return Series(value); };
    const auto d =
        support::unflattened<typename Model::template Dimensions<Series>>(flat_d, as_it_is);
    const auto u = support::unflattened<typename Model::template Inputs<Series>>(flat_u, as_it_is);
    const auto q =
        support::unflattened<typename Model::template Configuration<Series>>(flat_q, as_it_is);
    Vector<Series, Model::equation_count> f;
    Model::residual(d, u, q, f);
    std::copy_n(f.data(), Model::equation_count, moving.closures.begin());
    Poses<Series, Model::link_count> poses;
    Model::link_poses(d, u, q, poses);
    std::copy(poses.begin(), poses.end(), moving.poses.begin());
  }

 private:
  // Plain loops: Eigen's expressions would be compiled separately for the sizes of every model.
  static double largest(const double* numbers, int count) {
    double result = 0;
    for (int index = 0; index < count; ++index) {
      result = !(std::abs(numbers[index]) <= result) ? std::abs(numbers[index]) : result;
    }
    return result;
  }
  template <int Rows, int Columns>
  static void forget(Matrix<double, Rows, Columns>& matrix) {
    std::fill_n(matrix.data(), Rows * Columns, unknown);
  }
  template <int Rows>
  static void fetch(const SmallVector& from, Vector<double, Rows>& to) {
    std::copy_n(from.data(), Rows, to.data());
  }
  template <int Rows, int Columns, typename Target>
  static void store(const Matrix<double, Rows, Columns>& matrix, Target& target) {
    target.resize(Rows, Columns);
    std::copy_n(matrix.data(), Rows * Columns, target.data());
  }

  template <typename Variables>
  static Variables read(const FlatVariables& flat) {
    return support::unflattened<Variables>(flat);
  }
};

/// The kernel of a model; a degenerate one has no configuration whose motion could be computed.
template <typename Model>
[[nodiscard]] const ModelKernel* kernel_of() {
  if constexpr (Model::rigid) {
    static_assert(Model::link_count <= most_links && Model::unknown_count <= most_unknowns &&
                  Model::dimension_count <= most_rows && Model::input_count <= most_rows &&
                  Model::max_configurations <= most_configurations);
    static const ModelFunctions<Model> kernel;
    return &kernel;
  } else {
    static const DegenerateFunctions<Model> kernel;
    return &kernel;
  }
}

template <typename Model>
[[nodiscard]] constexpr int most_configurations_of() {
  if constexpr (Model::rigid) {
    return Model::max_configurations;
  } else {
    return 0;
  }
}

/// Whether each of a model's variables is an angle.
template <typename Variables>
[[nodiscard]] std::vector<bool> sorts_of() {
  constexpr auto& angles = support::are_angles<Variables>;
  return std::vector<bool>(angles.begin(), angles.end());
}

/// The row of a model, without its group.
template <typename Model>
[[nodiscard]] GroupModel row_of() {
  GroupModel row{nullptr,
                 Model::number,
                 Model::rigid,
                 Model::mobility,
                 most_configurations_of<Model>(),
                 {},
                 {},
                 {Model::unknowns.begin(), Model::unknowns.end()},
                 static_cast<std::size_t>(Model::dimension_count),
                 static_cast<std::size_t>(Model::input_count),
                 sorts_of<typename Model::template Dimensions<double>>(),
                 sorts_of<typename Model::template Inputs<double>>(),
                 kernel_of<Model>(),
                 {},
                 {},
                 {}};
  for (const ModelJoint& joint : Model::joints) {
    row.prismatic.push_back(joint.prismatic);
  }
  for (const auto& kind : Model::kinds) {
    row.kinds.emplace_back(kind.kind);
  }
  return row;
}

/// The graph of a group, from the tables of one of its models: all of them have the same.
template <typename Model>
[[nodiscard]] GroupStructure structure_of() {
  GroupStructure structure{Model::group, 0, {Model::joints.begin(), Model::joints.end()}, {}};
  for (const ModelLink& link : Model::links) {
    std::vector<int> joints(link.joints.begin(), link.joints.end());
    joints.erase(std::remove(joints.begin(), joints.end(), -1), joints.end());
    structure.link_joints.push_back(std::move(joints));
  }
  std::vector<JointPair> pairs;
  for (const ModelJoint& joint : structure.joints) {
    pairs.push_back({joint.first, joint.second});
  }
  structure.assur_class = assur_class_of(Model::link_count, pairs);
  return structure;
}

/// A group with its models from one index on, in the order of their numbers.
template <typename Models, std::size_t First, std::size_t... Place>
[[nodiscard]] GroupModels models_from(std::index_sequence<Place...>) {
  return {structure_of<std::tuple_element_t<0, Models>>(),
          {row_of<std::tuple_element_t<First + Place, Models>>()...}};
}

/// The group with one of `parts` parts of its models, which are compiled in parallel.
template <typename Models, std::size_t part, std::size_t parts>
[[nodiscard]] GroupModels part_of() {
  constexpr std::size_t count = std::tuple_size_v<Models>;
  constexpr std::size_t first = count * part / parts;
  return models_from<Models, first>(std::make_index_sequence<count*(part + 1) / parts - first>());
}

}  // namespace assur::mechanism::models
