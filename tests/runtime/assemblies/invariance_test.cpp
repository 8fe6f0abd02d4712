// Law, over all kinds: rigid motion, reflection, change of units, relabelling by the group's
// symmetries and translation far from the origin keep the configurations and their order.
#include <assur/assemblies.hpp>
#include <iostream>

#include "kind_in_space.hpp"
#include "largest.hpp"
#include "runtime/compiled_models.hpp"
#include "runtime/model_types.hpp"

namespace assur::test::invariance_test {
namespace {

constexpr unsigned samples = 10;

/// What a motion of the whole leaves unchanged in a configuration: cosines and sines of the angles
/// between links, in the order of the kind's links and in their own frames, sines with the sign of
/// the orientation; and the cosines between the model's frames, which order configurations.
struct Shape {
  std::vector<double> angles;
  std::vector<double> model_cosines;
};

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t part = 0; part < a.size(); ++part) {
    most = largest(most, std::abs(a[part] - b[part]));
  }
  return most;
}

template <typename Model>
class Invariance : public testing::Test {
 protected:
  using Space = KindInSpace<Model>;

  /// Shapes of all configurations, in the order in which they are found.
  static std::vector<Shape> shapes_of(const Space& space, double orientation = 1) {
    std::array<NormalForm<Real>, Space::link_count> forms;
    EXPECT_EQ(space.normal_forms(forms), Status::ok);
    typename Model::template Dimensions<Real> exact_d;
    EXPECT_EQ((fill_dimensions<Model, Real>(forms, exact_d)), Status::ok);
    const auto d = rounded<typename Model::template Dimensions<double>>(exact_d);
    const auto u = rounded<typename Model::template Inputs<double>>(space.inputs());
    const Assemblies<Model> found = compiled::assemblies<Model>(d, u);
    EXPECT_EQ(found.status, AssemblyStatus::ok);
    std::vector<Shape> shapes;
    for (int index = 0; index < found.count; ++index) {
      Poses<double, Model::link_count> poses;
      Model::link_poses(d, u, found.configurations[static_cast<std::size_t>(index)], poses);
      // The body's angle is that of its normal frame less the frame's angle on the body.
      std::array<double, Space::link_count> angles{};
      for (int link = 0; link < Model::link_count; ++link) {
        const auto slot = static_cast<std::size_t>(link);
        angles[static_cast<std::size_t>(space.playing_link(link))] =
            angle_of(poses[slot].direction) -
            static_cast<double>(angle_of(forms[slot].frame.direction));
      }
      Shape shape;
      for (std::size_t one = 0; one < angles.size(); ++one) {
        for (std::size_t other = one + 1; other < angles.size(); ++other) {
          shape.angles.push_back(std::cos(angles[other] - angles[one]));
          shape.angles.push_back(orientation * std::sin(angles[other] - angles[one]));
          shape.model_cosines.push_back(
              turned(poses[other].direction, reversed(poses[one].direction)).cos);
        }
      }
      shapes.push_back(std::move(shape));
    }
    return shapes;
  }

  template <typename To, typename From>
  static To rounded(const From& from) {
    To to;
    const auto round = [](const auto& value) {
      if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Real>) {
        return static_cast<double>(value);
      } else {
        return Direction<double>{static_cast<double>(value.cos), static_cast<double>(value.sin)};
      }
    };
    for_each_pair(to, from, [round](auto& target, const auto& source) { target = round(source); });
    return to;
  }

  static double largest_difference(const std::vector<Shape>& a, const std::vector<Shape>& b) {
    double most = 0;
    for (std::size_t index = 0; index < a.size() && index < b.size(); ++index) {
      most = largest(most, difference(a[index].angles, b[index].angles));
    }
    return most;
  }

  /// Exchanges neighbouring mirror twins where they fit in the other order. Their model cosines all
  /// agree, so sines decide their order; a reflection or rounding of the cosines may reverse it.
  static void match_twins(const std::vector<Shape>& before, std::vector<Shape>& after,
                          double tolerance) {
    for (std::size_t index = 0; index + 1 < before.size() && index + 1 < after.size(); ++index) {
      const Shape& one = before[index];
      const Shape& other = before[index + 1];
      if (difference(one.model_cosines, other.model_cosines) < tolerance &&
          largest_difference({one, other}, {after[index + 1], after[index]}) < tolerance) {
        std::swap(after[index], after[index + 1]);
      }
    }
  }

  /// Compares the shapes before and after a change of the group.
  template <typename Change>
  void expect_same(const char* what, double tolerance, double orientation, Change change) {
    double worst = 0;
    int compared = 0;
    for (const auto& roles : Model::kinds) {
      for (unsigned sample = 0; sample < samples; ++sample) {
        const unsigned seed = 500 * static_cast<unsigned>(Model::number) + sample;
        SCOPED_TRACE(std::string(what) + ", " + roles.kind + ", seed " + std::to_string(seed));
        const Space space(roles, seed);
        Space changed = space;
        change(changed);
        const std::vector<Shape> before = shapes_of(space);
        std::vector<Shape> after = shapes_of(changed, orientation);
        EXPECT_EQ(before.size(), after.size());
        match_twins(before, after, tolerance);
        const double changed_by = largest_difference(before, after);
        EXPECT_LT(changed_by, tolerance);
        worst = largest(worst, changed_by);
        ++compared;
      }
    }
    std::cout << model_name<Model>() << ", " << what << ": " << compared
              << " groups, largest difference " << worst << '\n';
  }
};

BodyFeature moved(const BodyFeature& place, Real dx, Real dy, Real turn) {
  return {std::cos(turn) * place.x - std::sin(turn) * place.y + dx,
          std::sin(turn) * place.x + std::cos(turn) * place.y + dy, place.angle + turn};
}

TYPED_TEST_SUITE(Invariance, AllModels, ModelNames);

TYPED_TEST(Invariance, RigidMotion) {
  if constexpr (TypeParam::rigid) {
    this->expect_same("rigid motion", 1e-8, 1, [](auto& space) {
      for (BodyJoint& joint : space.bodies.joints) {
        if (joint.first < 0) {
          joint.on_first = moved(joint.on_first, 0.7L, -1.3L, 2.1L);
        }
      }
    });
  }
}

TYPED_TEST(Invariance, TranslationFarFromTheOrigin) {
  // At 1e8 the places of the external joints are rounded to 1.5e-8, which limits the agreement.
  if constexpr (TypeParam::rigid) {
    this->expect_same("translation by 1e8", 2e-3, 1, [](auto& space) {
      for (BodyJoint& joint : space.bodies.joints) {
        if (joint.first < 0) {
          joint.on_first = moved(joint.on_first, 1e8L, -1e8L, 0);
        }
      }
    });
  }
}

TYPED_TEST(Invariance, Reflection) {
  if constexpr (TypeParam::rigid) {
    this->expect_same("reflection", 1e-8, -1, [](auto& space) {
      const auto reflect = [](BodyFeature& feature) {
        feature.y = -feature.y;
        feature.angle = -feature.angle;
      };
      for (BodyJoint& joint : space.bodies.joints) {
        reflect(joint.on_first);
        reflect(joint.on_second);
      }
    });
  }
}

TYPED_TEST(Invariance, ChangeOfUnits) {
  if constexpr (TypeParam::rigid) {
    for (const Real unit : {1e-6L, 1e-3L, 1e3L, 1e6L}) {
      this->expect_same("change of units", 1e-8, 1, [unit](auto& space) {
        for (BodyJoint& joint : space.bodies.joints) {
          for (BodyFeature* feature : {&joint.on_first, &joint.on_second}) {
            feature->x *= unit;
            feature->y *= unit;
          }
        }
      });
    }
  }
}

}  // namespace
}  // namespace assur::test::invariance_test
