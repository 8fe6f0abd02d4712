// Isolated assemblies of a group in special position, and the mobility of its families.
//
// If the final polynomial has multiple roots, a root at infinity, or vanishes altogether, its roots
// do not determine the assemblies: several may share a root, and a root may belong to none. But
// every regular assembly persists under a small perturbation of dimensions and inputs, and in
// general position the polynomial yields them all. So dimensions and inputs are perturbed in
// several directions, in both senses; each neighbour is solved in double-double, and its assemblies
// are closed again on the equations of the group itself. Those that do not close there have gone to
// infinity. At a singular assembly a fold opens on at least one side of each direction; an assembly
// that closes along a curve moves freely.
#pragma once

#include <algorithm>
#include <array>
#include <assur/detail/closure_geometry.hpp>
#include <assur/detail/first_values.hpp>
#include <assur/detail/multiple_assembly.hpp>
#include <assur/detail/neighbourhood.hpp>
#include <assur/model.hpp>
#include <assur/numeric/double_double.hpp>
#include <cmath>
#include <cstddef>
#include <limits>

namespace assur::detail {

using PreciseVariables = FlatVariables<numeric::DoubleDouble>;

/// Assemblies that have one value of the first unknown; the best second value comes first.
struct Completions {
  std::array<FlatVariables<double>, 4> list;
  std::size_t count = 0;
};

/// The functions of a model that the search calls, on flat variables. Lengths are about one at
/// most.
struct SpecialGroup {
  Closures closures;
  /// Whether each variable is an angle.
  const bool* dimensions;
  const bool* inputs;
  std::size_t dimension_count, input_count;
  /// Whether dimensions are numbers in the functions, which cannot be perturbed.
  bool is_specialised;
  double rounding_of_inputs;
  bool first_is_angle;
  /// Finds the roots that are certain if every input has the error `within` and every dimension is
  /// rounded.
  FirstValues (*first_values)(const PreciseVariables& d, const PreciseVariables& u, double within);
  Completions (*complete)(const PreciseVariables& d, const PreciseVariables& u,
                          const FirstValue& first);
};

/// The assemblies of a group in special position.
struct SpecialAssemblies {
  static constexpr std::size_t capacity = 12;
  std::array<FlatVariables<double>, capacity> list;
  std::array<bool, capacity> singular{};
  std::size_t count = 0;
  int mobility = 0;  ///< the greatest of a family found; zero if there is none
};

template <typename Group>
class SpecialSearch {
 public:
  SpecialSearch(const Group& group, const PreciseVariables& d, const PreciseVariables& u)
      : group_(group), d_(d), u_(u) {}

  [[nodiscard]] SpecialAssemblies run();

  /// The least closure gap, by a search from several starts.
  [[nodiscard]] double least_miss();

 private:
  static constexpr int directions = 5;

  /// Whether double-double determines all assemblies: every root is simple for any rounding of the
  /// variables, and its best completion closes.
  [[nodiscard]] bool is_general(const FirstValues& values) {
    if (!values.certain()) {
      return false;
    }
    const Closures& closures = group_.closures;
    for (std::size_t index = 0; index < values.count; ++index) {
      const Completions found = group_.complete(d_, u_, values.list[index]);
      if (found.count == 0) {
        return false;
      }
      FlatVariables<double> q = found.list[0];
      closures.straighten(q);
      if (!(longest_displacement(closures, q) < farthest_configuration<double>) ||
          !(close(closures, q) < rounding(closures, q)) ||
          distance(closures, q, found.list[0]) > 1e-6 ||
          free_directions(closures, q, lost_pivot).count > 0) {
        return false;
      }
      for (std::size_t other = 0; other < result_.count; ++other) {
        if (distance(closures, q, result_.list[other]) < 1e-7) {
          return false;
        }
      }
      list(q);
    }
    return true;
  }

  /// Tries the best second value at every root before the others: its completion has more digits
  /// than theirs.
  void try_all(const PreciseVariables& d, const PreciseVariables& u, const FirstValues& values) {
    std::array<Completions, 6> found;
    for (std::size_t index = 0; index < values.count; ++index) {
      found[index] = group_.complete(d, u, values.list[index]);
      if (found[index].count > 0) {
        add(found[index].list[0]);
      }
    }
    for (std::size_t index = 0; index < values.count; ++index) {
      for (std::size_t place = 1; place < found[index].count; ++place) {
        add(found[index].list[place]);
      }
    }
  }

  /// Completes arbitrary values of the first unknown, which no design would have.
  template <typename Use>
  void for_each_sample(const Use& use) const {
    const int samples = group_.is_specialised ? 48 : 12;
    for (int sample = 0; sample < samples; ++sample) {
      const double part = (sample + 0.3) / samples;
      FirstValue first;
      first.simple = false;
      if (group_.first_is_angle) {
        first.cos = std::cos(6.2831853 * part);
        first.sin = std::sin(6.2831853 * part);
      } else {
        first.cos = (4 * part - 2) * group_.closures.longest;
      }
      const Completions found = group_.complete(d_, u_, first);
      for (std::size_t place = 0; place < found.count; ++place) {
        use(found.list[place]);
      }
    }
  }

  /// Calls `use` with random unknowns, which do not depend on the elimination.
  template <typename Use>
  void for_each_place(const Use& use) {
    constexpr int starts = 48;
    const Closures& closures = group_.closures;
    for (int start = 0; start < starts; ++start) {
      FlatVariables<double> q{};
      std::size_t place = 0;
      for (int unknown = 0; unknown < closures.size; ++unknown) {
        if (closures.unknowns[unknown].is_angle) {
          const double angle = 3.1415926535 * next_random();
          q[place++] = std::cos(angle);
          q[place++] = std::sin(angle);
        } else {
          q[place++] = 2 * next_random() * closures.longest;
        }
      }
      use(q);
    }
  }

  /// Perturbs every variable by up to `reach`: a length relative to the group's longest, an angle
  /// in radians.
  void displace(const bool* is_angle, std::size_t count, double reach, PreciseVariables& flat) {
    using numeric::DoubleDouble;
    std::size_t place = 0;
    for (std::size_t index = 0; index < count; ++index) {
      const DoubleDouble by(reach * next_random());
      if (is_angle[index]) {
        const DoubleDouble half = by / DoubleDouble(2);
        const DoubleDouble norm = DoubleDouble(1) + half * half;
        const DoubleDouble c = (DoubleDouble(1) - half * half) / norm;
        const DoubleDouble s = by / norm;
        const DoubleDouble cos = flat[place];
        flat[place] = c * cos - s * flat[place + 1];
        flat[place + 1] = s * cos + c * flat[place + 1];
        place += 2;
      } else {
        flat[place] = flat[place] + by * DoubleDouble(group_.closures.longest);
        ++place;
      }
    }
  }

  /// A random number between -1 and 1, the same on every machine.
  [[nodiscard]] double next_random() {
    random_ = random_ * 1664525U + 1013904223U;
    return static_cast<double>(random_ >> 8U) / 0x1p23 - 1;
  }

  void add(const FlatVariables<double>& start) {
    const Closures& closures = group_.closures;
    FlatVariables<double> q = start;
    if (!(longest_displacement(closures, q) < farthest_configuration<double>)) {
      return;
    }
    // A second value that does not fit leads to pairs that are no unit vectors.
    closures.straighten(q);
    const double miss = close(closures, q);
    const double displacement = longest_displacement(closures, q);
    if (!(displacement < farthest_configuration<double> && miss < rounding(closures, q))) {
      return;
    }
    const bool singular = free_directions(closures, q, singular_pivot).count > 0;
    for (std::size_t index = 0; index < result_.count; ++index) {
      if (are_one(closures, q, result_.list[index])) {
        return;
      }
    }
    if (singular) {
      const int mobility = mobility_at(closures, q);
      result_.mobility = (std::max)(result_.mobility, mobility);
      if (mobility > 0) {
        return;
      }
      settle(closures, q);
    }
    list(q);
  }

  void list(const FlatVariables<double>& q) {
    if (result_.count < result_.list.size()) {
      result_.list[result_.count] = q;
      result_.singular[result_.count] = free_directions(group_.closures, q, lost_pivot).count > 0;
      ++result_.count;
    }
  }

  const Group& group_;
  const PreciseVariables& d_;
  const PreciseVariables& u_;
  SpecialAssemblies result_;
  unsigned random_ = 0;
};

// Defined outside the class, so that an explicit instantiation can be the only one.
template <typename Group>
SpecialAssemblies SpecialSearch<Group>::run() {
  if (!group_.is_specialised &&
      is_general(group_.first_values(d_, u_, group_.rounding_of_inputs))) {
    return result_;
  }
  result_ = {};
  const FirstValues exact = group_.first_values(d_, u_, 0);
  try_all(d_, u_, exact);
  // Rounding may make a multiple root complex, and then no root is found there.
  for_each_sample([this](const FlatVariables<double>& start) { add(start); });
  // If the final polynomial vanishes, its unknown may be the free one, which does not determine the
  // others.
  if (exact.vanishing) {
    for_each_place([this](const FlatVariables<double>& start) { add(start); });
  }
  for (int direction = 0; direction < directions; ++direction) {
    for (const double side : {1.0, -1.0}) {
      PreciseVariables d = d_;
      PreciseVariables u = u_;
      const double reach = side * (direction % 2 == 0 ? 0x1p-21 : 0x1p-26);
      random_ = 1U + static_cast<unsigned>(direction);
      displace(group_.dimensions, group_.dimension_count, reach, d);
      displace(group_.inputs, group_.input_count, reach, u);
      try_all(d, u, group_.first_values(d, u, 0));
    }
  }
  return result_;
}

template <typename Group>
double SpecialSearch<Group>::least_miss() {
  double least = std::numeric_limits<double>::infinity();
  const auto try_near = [&](const FlatVariables<double>& start) {
    FlatVariables<double> q = start;
    if (longest_displacement(group_.closures, q) < farthest_configuration<double>) {
      group_.closures.straighten(q);
      close(group_.closures, q);
      least = (std::min)(least, least_miss_near(group_.closures, q));
    }
  };
  for_each_sample(try_near);
  // No sample can be completed if a link has no length, or slides are parallel.
  if (!std::isfinite(least)) {
    for_each_place(try_near);
  }
  return least * group_.closures.longest;
}

}  // namespace assur::detail
