// Counts lost and invented configurations against Sturm's theorem: random groups of every rigid
// model, and families that approach what root finders fail at. Prints Markdown; exits 1 on a loss.
// position_campaign RANDOM_GROUPS_PER_MODEL FAMILY_MEMBERS_PER_DISTANCE
#include <array>
#include <assur/assemblies.hpp>
#include <assur/tetrad/models.hpp>
#include <cstdlib>
#include <iostream>

#include "largest.hpp"
#include "least_change.hpp"
#include "runtime/compiled_models.hpp"
#include "runtime/exact.hpp"
#include "runtime/reference_roots.hpp"
#include "runtime/sturm.hpp"

namespace assur::test {
namespace {

constexpr unsigned seed = 57721;

/// Outcomes of one method. A group whose configurations meet too closely to be told apart may be
/// answered `near_singular`: that is no loss, but it is counted.
struct Tally {
  int groups = 0;
  int roots = 0;
  int lost = 0;
  int invented = 0;
  int undecided = 0;
  double residual = 0;

  void add(int found, int expected, bool declared) {
    ++groups;
    roots += expected;
    if (found != expected && declared) {
      ++undecided;
    } else if (found < expected) {
      lost += expected - found;
    } else {
      invented += found - expected;
    }
  }
  Tally& operator+=(const Tally& other) {
    groups += other.groups;
    roots += other.roots;
    lost += other.lost;
    invented += other.invented;
    undecided += other.undecided;
    residual = largest(residual, other.residual);
    return *this;
  }
};

template <typename Model>
struct Group {
  typename Model::template Dimensions<double> d;
  typename Model::template Inputs<double> u;
};

template <typename Model>
Group<Model> random_group(RandomInputs& random) {
  return {random.variables<typename Model::template Dimensions<double>>(),
          random.variables<typename Model::template Inputs<double>>()};
}

template <typename Model>
void judge(const Group<Model>& group, Tally& tally) {
  const Assemblies<Model> found = compiled::assemblies<Model>(group.d, group.u);
  bool declared = found.status == AssemblyStatus::degenerate;
  double longest = 1e-300;
  longest = std::max({longest, longest_length(group.d), longest_length(group.u)});
  for (int index = 0; index < found.count; ++index) {
    const auto slot = static_cast<std::size_t>(index);
    declared = declared || found.regularity[slot] != Status::ok;
    const auto& q = found.configurations[slot];
    longest = std::max(longest, longest_length(q));
    Vector<double, Model::equation_count> f;
    Model::residual(group.d, group.u, q, f);
    if (found.regularity[slot] == Status::ok) {
      tally.residual = largest(tally.residual, f.cwiseAbs().maxCoeff() / longest);
    }
  }
  tally.add(found.count, compiled::exact_assembly_count<Model>(group.d, group.u), declared);
}

/// A group between two others: lengths and angles are interpolated.
template <typename Variables>
Variables between(const Variables& from, const Variables& to, double part) {
  const auto mix = [part](const auto& a, const auto& b) {
    if constexpr (std::is_same_v<std::decay_t<decltype(a)>, double>) {
      return a + part * (b - a);
    } else {
      return turned(a, direction_of(part * angle_of(turned(b, reversed(a)))));
    }
  };
  Variables result = from;
  for_each_pair(result, to, [mix](auto& a, const auto& b) { a = mix(a, b); });
  return result;
}

/// Walks to where the number of configurations changes, and `distance` past or before it.
template <typename Model>
Group<Model> near_fold(RandomInputs& random, double distance) {
  while (true) {
    const Group<Model> a = random_group<Model>(random);
    const Group<Model> b = random_group<Model>(random);
    const auto at = [&](double part) {
      return Group<Model>{between(a.d, b.d, part), between(a.u, b.u, part)};
    };
    const auto count = [&](double part) {
      const Group<Model> group = at(part);
      return compiled::assemblies<Model>(group.d, group.u).count;
    };
    double low = 0;
    double high = 1;
    const int at_low = count(low);
    if (count(high) == at_low) {
      if (Model::max_configurations == 1) {
        return a;
      }
      continue;
    }
    for (int step = 0; step < 60; ++step) {
      const double centre = (low + high) / 2;
      (count(centre) == at_low ? low : high) = centre;
    }
    return at(random.integer(0, 1) == 0 ? low - distance : high + distance);
  }
}

/// Turns the base so that a configuration's first unknown is `distance` from pi.
template <typename Model>
Group<Model> near_pi(RandomInputs& random, double distance) {
  Group<Model> group = random_group<Model>(random);
  const Assemblies<Model> found = compiled::assemblies<Model>(group.d, group.u);
  const auto& first =
      std::get<static_cast<std::size_t>(Model::first_unknown)>(found.configurations[0].members());
  if constexpr (std::is_same_v<std::decay_t<decltype(first)>, Direction<double>>) {
    const Direction<double> turn =
        turned(direction_of(3.14159265358979323846 + distance), reversed(first));
    // Coordinates stand in pairs; an angle follows its pair where the joint slides.
    double* x = nullptr;
    const auto rotate = [&](auto& member) {
      if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
        if (x == nullptr) {
          x = &member;
        } else {
          const double old = *x;
          *x = turn.cos * old - turn.sin * member;
          member = turn.sin * old + turn.cos * member;
          x = nullptr;
        }
      } else {
        member = turned(member, turn);
      }
    };
    for_each_member(group.u, [&](auto& member, std::size_t) { rotate(member); });
  }
  return group;
}

/// Lengths changed as little as possible so that a chosen configuration closes.
template <typename Model>
Group<Model> closed_at(Group<Model> group,
                       const typename Model::template Configuration<double>& q) {
  for (int pass = 0; pass < 3; ++pass) {
    Vector<double, Model::equation_count> f;
    Model::residual(group.d, group.u, q, f);
    Matrix<double, Model::equation_count, Model::dimension_count> f_d;
    Model::dimension_jacobian(group.d, group.u, q, f_d);
    Matrix<double, Model::equation_count, Model::input_count> f_u;
    Model::input_jacobian(group.d, group.u, q, f_u);
    for (int column = 0; column < Model::dimension_count; ++column) {
      if (Model::dimensions[static_cast<std::size_t>(column)].is_angle) {
        f_d.col(column).setZero();
      }
    }
    for (int column = 0; column < Model::input_count; ++column) {
      if (Model::inputs[static_cast<std::size_t>(column)].is_angle) {
        f_u.col(column).setZero();
      }
    }
    Eigen::MatrixXd all(Model::equation_count, Model::dimension_count + Model::input_count);
    all << f_d, f_u;
    const Eigen::VectorXd change = least_change(all, -f);
    advance(group.d,
            Vector<double, Model::dimension_count>(change.template head<Model::dimension_count>()));
    advance(group.u,
            Vector<double, Model::input_count>(change.template tail<Model::input_count>()));
  }
  return group;
}

/// All unknown angles `distance` from one direction: links nearly parallel, special-point lines
/// too.
template <typename Model>
Group<Model> flattened(RandomInputs& random, double distance) {
  auto q = random.variables<typename Model::template Configuration<double>>();
  const double common = random.angle();
  const auto align = [&](auto& member) {
    if constexpr (!std::is_same_v<std::decay_t<decltype(member)>, double>) {
      member = direction_of(common + distance * random.length());
    }
  };
  for_each_member(q, [&](auto& member, std::size_t) { align(member); });
  return closed_at(random_group<Model>(random), q);
}

/// External joints `distance` from each other.
template <typename Model>
Group<Model> joined_externals(RandomInputs& random, double distance) {
  Group<Model> group = random_group<Model>(random);
  std::array<double*, 2> coordinates{};
  std::size_t place = 0;
  const auto join = [&](auto& member) {
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
      if (place < 2) {
        coordinates[place] = &member;
      } else {
        member = *coordinates[place % 2] + distance * random.length();
      }
      ++place;
    }
  };
  for_each_member(group.u, [&](auto& member, std::size_t) { join(member); });
  return group;
}

/// One length of the group `distance` times as long.
template <typename Model>
Group<Model> short_length(RandomInputs& random, double distance) {
  Group<Model> group = random_group<Model>(random);
  const int chosen = random.integer(0, Model::dimension_count - 1);
  int place = 0;
  const auto shorten = [&](auto& member) {
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
      member *= place == chosen ? distance : 1;
    }
    ++place;
  };
  for_each_member(group.d, [&](auto& member, std::size_t) { shorten(member); });
  return group;
}

template <typename Use>
void for_each_rigid_model(Use use) {
  std::apply(
      [&](auto... model) {
        (
            [&] {
              if constexpr (decltype(model)::rigid) {
                use(model);
              }
            }(),
            ...);
      },
      tetrad::Models());
}

Tally random_campaign(int groups) {
  std::cout << "| model | configurations at most | groups | real roots | lost | invented | "
               "undecided | largest relative residual |\n|---|---|---|---|---|---|---|---|\n";
  Tally all;
  for_each_rigid_model([&](auto model) {
    using Model = decltype(model);
    RandomInputs random(seed + static_cast<unsigned>(Model::number));
    Tally tally;
    for (int index = 0; index < groups; ++index) {
      judge(random_group<Model>(random), tally);
    }
    std::cout << "| " << Model::number << " | " << Model::max_configurations << " | "
              << tally.groups << " | " << tally.roots << " | " << tally.lost << " | "
              << tally.invented << " | " << tally.undecided << " | " << tally.residual << " |\n";
    all += tally;
  });
  return all;
}

struct Family {
  const char* name;
  int index;
};

template <typename Model>
Group<Model> member(const Family& family, RandomInputs& random, double distance) {
  switch (family.index) {
    case 0:
      return near_fold<Model>(random, distance);
    case 1:
      return near_pi<Model>(random, distance);
    case 2:
      return flattened<Model>(random, distance);
    case 3:
      return joined_externals<Model>(random, distance);
    default:
      return short_length<Model>(random, distance);
  }
}

Tally family_campaign(int members) {
  constexpr std::array<Family, 5> families = {{{"fold", 0},
                                               {"an angle of pi, leading coefficient", 1},
                                               {"links parallel", 2},
                                               {"external joints coincide", 3},
                                               {"a length vanishes", 4}}};
  std::cout << "\n| family | distance | groups | real roots | lost | invented | undecided | "
               "companion of RRR-RRR lost, invented | half angle | subdivision |\n"
               "|---|---|---|---|---|---|---|---|---|---|\n";
  Tally all;
  for (const Family& family : families) {
    for (int exponent = 1; exponent <= 14; ++exponent) {
      const double distance = std::pow(10.0, -exponent);
      Tally ours;
      std::array<Tally, 3> references;
      for_each_rigid_model([&](auto model) {
        using Model = decltype(model);
        RandomInputs random(seed + 100 * static_cast<unsigned>(Model::number) +
                            static_cast<unsigned>(exponent));
        for (int index = 0; index < members; ++index) {
          const Group<Model> group = member<Model>(family, random, distance);
          judge(group, ours);
          if constexpr (std::is_same_v<Model,
                                       tetrad::Model01>) {  // other models would show the same
            TrigonometricPolynomial<double, Model::polynomial_degree> T;
            Model::position_polynomial(group.d, group.u, T);
            const int expected = compiled::exact_assembly_count<Model>(group.d, group.u);
            references[0].add(companion_roots<Model::polynomial_degree, Eigen::MatrixXcd>(T).count,
                              expected, false);
            references[1].add(half_angle_roots<Model::polynomial_degree, Eigen::Dynamic>(T).count,
                              expected, false);
            references[2].add(subdivision_roots(T).count, expected, false);
          }
        }
      });
      std::cout << "| " << family.name << " | 1e-" << exponent << " | " << ours.groups << " | "
                << ours.roots << " | " << ours.lost << " | " << ours.invented << " | "
                << ours.undecided;
      for (const Tally& reference : references) {
        std::cout << " | " << reference.lost << ", " << reference.invented;
      }
      std::cout << " |\n";
      all += ours;
    }
  }
  return all;
}

int run(int groups, int members) {
  std::cout << "seed " << seed << "\n\n";
  Tally all = random_campaign(groups);
  all += family_campaign(members);
  std::cout << "\nIn all " << all.groups << " groups, " << all.roots << " real roots: " << all.lost
            << " lost, " << all.invented << " invented, " << all.undecided << " undecided.\n";
  return all.lost == 0 && all.invented == 0 ? 0 : 1;
}

}  // namespace
}  // namespace assur::test

int main(int argc, char** argv) {
  const int groups = argc > 1 ? std::atoi(argv[1]) : 200;
  const int members = argc > 2 ? std::atoi(argv[2]) : 2;
  return assur::test::run(groups, members);
}
