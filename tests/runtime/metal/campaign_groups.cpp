// Writes the input of the campaign on bare metal: first the groups in special position in the table
// of exact answers (tests/mechanism/solve/lattice), of the kinds of the campaign's models, then
// random ones.
//   campaign_groups COUNT > groups
#include <algorithm>
#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <assur/mechanism/values.hpp>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "campaign_models.hpp"
#include "mechanism/lattice_scene.hpp"

namespace assur::test::metal {
namespace {

constexpr unsigned lattice_seeds = 174;  ///< of each kind, from 1

void put(double number) { std::fwrite(&number, sizeof(number), 1, stdout); }
void put(const Direction<double>& direction) {
  put(direction.cos);
  put(direction.sin);
}

/// A group as the library measures it, its links in normal form.
void put_group(std::size_t model, const mechanism::Plan& plan) {
  const mechanism::Values values = plan.values();
  const mechanism::GroupIndex group = *plan.structure().groups.keys().begin();
  const mechanism::GroupGeometry<mechanism::Dual>& geometry = values.group(group);
  put(static_cast<double>(model));
  for (const auto& dimension : geometry.dimensions()) {
    if (dimension.is_angle) {
      put(Direction<double>{dimension.angle.cos.value(), dimension.angle.sin.value()});
    } else {
      put(dimension.length.value());
    }
  }
  const auto& linkage = plan.structure().linkage;
  for (const mechanism::ElementaryJointIndex index : geometry.roles->joints) {
    const mechanism::ElementaryJoint& joint = linkage.joints[index];
    if (joint.touches(linkage.ground)) {
      const auto at = values.feature(joint, linkage.ground);
      put(at.x.value());
      put(at.y.value());
      if (joint.prismatic) {
        put(Direction<double>{at.along.cos.value(), at.along.sin.value()});
      }
    }
  }
}

template <typename Model>
bool serves(const LatticeKind& kind) {
  return kind.group->name == Model::group &&
         std::any_of(Model::kinds.begin(), Model::kinds.end(),
                     [&kind](const auto& one) { return kind.spelling == one.kind; });
}

/// A random group: lengths from -2 to 2, directions all around.
template <typename Model>
void put_random(std::size_t model, std::mt19937& engine) {
  const auto drawn = [&engine] { return std::ldexp(static_cast<double>(engine()), -30) - 2; };
  put(static_cast<double>(model));
  const auto put_variable = [&drawn](const ModelVariable& variable) {
    if (variable.is_angle) {
      const double angle = 2 * drawn();
      put(Direction<double>{std::cos(angle), std::sin(angle)});
    } else {
      put(drawn());
    }
  };
  std::for_each(Model::dimensions.begin(), Model::dimensions.end(), put_variable);
  std::for_each(Model::inputs.begin(), Model::inputs.end(), put_variable);
}

template <std::size_t... Place>
void run(int count, std::index_sequence<Place...>) {
  for (const LatticeKind& kind : lattice_kinds()) {
    for (unsigned seed = 1; seed <= lattice_seeds; ++seed) {
      (
          [&] {
            if (serves<std::tuple_element_t<Place, Models>>(kind) && count > 0) {
              const mechanism::Scene scene =
                  mechanism::parse_scene(LatticeScene(kind, seed).text(1, 0), "lattice");
              put_group(Place, mechanism::Plan(scene));
              --count;
            }
          }(),
          ...);
    }
  }
  std::mt19937 engine(57721);
  for (; count > 0; --count) {
    const std::size_t model = engine() % sizeof...(Place);
    ((model == Place ? put_random<std::tuple_element_t<Place, Models>>(Place, engine) : void()),
     ...);
  }
}

}  // namespace
}  // namespace assur::test::metal

int main(int, char** arguments) {
  using assur::test::metal::Models;
  assur::test::metal::run(std::atoi(arguments[1]),
                          std::make_index_sequence<std::tuple_size_v<Models>>());
  return 0;
}
