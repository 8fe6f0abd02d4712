// Exact configurations of a chain of dyads in Gaussian rationals.
#pragma once

#include <array>
#include <complex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "mechanism/dyad_chain.hpp"

namespace assur::test {

/// An exact position of a dyad, or a rounded one where it is irrational.
struct DyadPosition {
  bool regular = true;
  std::array<ChainPose<std::complex<double>>, 2> rounded;
  std::optional<std::array<ChainPose<Gaussian>, 2>> exact;
};

/// The exact answer for a dyad with fixed bases.
struct DyadAnswer {
  int mobility = 0;           ///< of a dyad that moves
  bool inconsistent = false;  ///< its slides are parallel, and it does not close
  std::vector<DyadPosition> positions;
};

/// The answer to a dyad in Gaussian rationals.
class ExactDyad {
 public:
  ExactDyad(const ChainDyad& dyad, const ChainPose<Gaussian>& first,
            const ChainPose<Gaussian>& second)
      : dyad_(dyad), first_(first), second_(second) {}

  [[nodiscard]] DyadAnswer answer() const {
    const auto& f = dyad_.features;
    switch (dyad_.kind) {
      case ChainDyad::Kind::rrr: {
        const Gaussian across = second_(f[5].at) - first_(f[0].at);
        const Rational one = norm(f[2].at - f[1].at);
        const Rational other = norm(f[3].at - f[4].at);
        if (across.is_zero()) {
          return one == other ? moving() : DyadAnswer{};
        }
        const Rational square = norm(across);
        const Rational along = (square + one - other) / (Rational(2) * square);
        return by_root(one / square - along * along, along);
      }
      case ChainDyad::Kind::rpr: {
        const Gaussian across = second_(f[5].at) - first_(f[0].at);
        const Rational offset = aside(f[2], f[1].at) - aside(f[3], f[4].at);
        if (across.is_zero()) {
          return offset.is_zero() ? moving() : DyadAnswer{};
        }
        return by_root(norm(across) - offset * offset, offset);
      }
      case ChainDyad::Kind::rrp: {
        const Gaussian from_pivot =
            (second_(f[5].at) - first_(f[0].at)) / (second_.turn * f[5].along);
        const Rational height = from_pivot.im + aside(f[4], f[3].at);
        return by_root(norm(f[2].at - f[1].at) - height * height, height);
      }
      case ChainDyad::Kind::prp: {
        const Gaussian one = first_.turn * f[0].along;
        const Gaussian other = second_.turn * f[5].along;
        const Gaussian from = first_(f[0].at) + one * upright(aside(f[1], f[2].at));
        const Gaussian to = second_(f[5].at) + other * upright(aside(f[4], f[3].at));
        return where_lines_cross(one, from, other, to);
      }
      case ChainDyad::Kind::rpp: {
        const Gaussian other = second_.turn * f[5].along;
        const Gaussian turn = other / f[4].along;
        const Gaussian one = turn * f[3].along;
        // The second link's origin on one of the slides alone.
        const ChainPose<Gaussian> pinned{one / f[2].along, {}};
        const Gaussian on_first = first_(f[0].at) + pinned(f[2].at - f[1].at) - turn * f[3].at;
        const Gaussian on_second = second_(f[5].at) - turn * f[4].at;
        return where_lines_cross(one, on_first, other, on_second);
      }
    }
    return {};
  }

 private:
  static DyadAnswer moving() { return {1, false, {}}; }
  static Gaussian upright(const Rational& height) { return {0, height}; }
  /// How far a point is to the left of a line.
  static Rational aside(const ChainFeature& line, const Gaussian& point) {
    return ((point - line.at) / line.along).im;
  }

  /// Two positions that differ by the sign of a root.
  [[nodiscard]] DyadAnswer by_root(const Rational& square, const Rational& given) const {
    DyadAnswer answer;
    if (square < Rational(0)) {
      return answer;
    }
    const bool regular = !square.is_zero();
    Rational root;
    const bool rational = is_square(square, root);
    for (const int sign : {1, -1}) {
      DyadPosition position{regular, {}, {}};
      if (rational) {
        position.exact = completed<Gaussian>(Gaussian{Rational(sign) * root}, Gaussian{given});
        position.rounded = rounded(*position.exact);
      } else {
        position.rounded =
            completed<std::complex<double>>(sign * std::sqrt(square.rounded()), given.rounded());
      }
      answer.positions.push_back(position);
      if (!regular) {
        break;
      }
    }
    return answer;
  }

  /// The answer for two slides, each of which runs along a direction through a place.
  [[nodiscard]] DyadAnswer where_lines_cross(const Gaussian& one, const Gaussian& from,
                                             const Gaussian& other, const Gaussian& to) const {
    const Rational sine = (other / one).im;
    const Rational apart = ((to - from) / one).im;
    if (sine.is_zero()) {
      return apart.is_zero() ? moving() : DyadAnswer{0, true, {}};
    }
    DyadAnswer answer;
    const Gaussian place = to - other * Gaussian{apart / sine};
    DyadPosition position{true, {}, completed<Gaussian>(place, {})};
    position.rounded = rounded(*position.exact);
    answer.positions.push_back(position);
    return answer;
  }

  static std::array<ChainPose<std::complex<double>>, 2> rounded(
      const std::array<ChainPose<Gaussian>, 2>& exact) {
    return {{{exact[0].turn.rounded(), exact[0].origin.rounded()},
             {exact[1].turn.rounded(), exact[1].origin.rounded()}}};
  }

  static Gaussian as(const Gaussian& number, const Gaussian& /*like*/) { return number; }
  static std::complex<double> as(const Gaussian& number, const std::complex<double>& /*like*/) {
    return number.rounded();
  }

  /// The poses of both links for a root, or for the crossing of slides.
  template <typename Number>
  [[nodiscard]] std::array<ChainPose<Number>, 2> completed(const Number& root,
                                                           const Number& given) const {
    const auto number = [&root](const Gaussian& exact) { return as(exact, root); };
    const Number i = number({0, 1});
    const auto& f = dyad_.features;
    const Number base = number(first_(f[0].at));
    const Number far = number(second_(f[5].at));
    std::array<Number, 6> at;
    std::array<Number, 6> along;
    for (std::size_t index = 0; index < f.size(); ++index) {
      at[index] = number(f[index].at);
      along[index] = number(f[index].along);
    }
    const Number slide = number(second_.turn) * along[5];
    std::array<ChainPose<Number>, 2> poses;
    const auto stand = [&poses](std::size_t link, const Number& turn, const Number& own,
                                const Number& place) {
      poses[link] = {turn, place - turn * own};
    };
    switch (dyad_.kind) {
      case ChainDyad::Kind::rrr: {
        const Number pin = base + (far - base) * (given + i * root);
        stand(0, (pin - base) / (at[2] - at[1]), at[1], base);
        stand(1, (pin - far) / (at[3] - at[4]), at[4], far);
        break;
      }
      case ChainDyad::Kind::rpr: {
        // The line passes each pivot at the distance that its link gives, from foot to foot.
        const Number line = (far - base) / (root - i * given);
        stand(0, line / along[2], at[1], base);
        stand(1, line / along[3], at[4], far);
        break;
      }
      case ChainDyad::Kind::rrp: {
        const Number pin = base + slide * (root + i * given);
        stand(0, (pin - base) / (at[2] - at[1]), at[1], base);
        stand(1, slide / along[4], at[3], pin);
        break;
      }
      case ChainDyad::Kind::prp:
        stand(0, number(first_.turn) * along[0] / along[1], at[2], root);
        stand(1, slide / along[4], at[3], root);
        break;
      case ChainDyad::Kind::rpp: {
        const Number turn = slide / along[4];
        poses[1] = {turn, root};
        stand(0, turn * along[3] / along[2], at[1], base);
        break;
      }
    }
    return poses;
  }

  const ChainDyad& dyad_;
  const ChainPose<Gaussian>& first_;
  const ChainPose<Gaussian>& second_;
};

/// One configuration of a chain: the poses of its links.
struct ChainConfiguration {
  bool regular = true;
  std::vector<ChainPose<std::complex<double>>> poses;
};

/// The exact answer to a chain.
struct ChainTruth {
  /// False if the answer depends on an irrational position, or on one known only to the square root
  /// of epsilon, or if slides are parallel and do not close.
  bool known = true;
  std::vector<ChainConfiguration> configurations;
  /// For each family the fixed links: the ground, the cranks, and the dyads that hold it.
  std::multiset<std::set<std::string>> families;
  int mobility = 0;
};

/// The exact answer to a chain, depth first through its dyads.
class ExactChain {
 public:
  explicit ExactChain(const DyadChain& chain) : chain_(chain) {}

  [[nodiscard]] ChainTruth truth() const {
    ChainTruth truth;
    Walk walk{std::vector<std::optional<ChainPose<Gaussian>>>(chain_.links().size()),
              std::vector<ChainPose<std::complex<double>>>(chain_.links().size()),
              std::vector<bool>(chain_.links().size(), false),
              std::vector<int>(chain_.dyads().size(), 0),
              true,
              {}};
    for (std::size_t link = 0; link < chain_.driven(); ++link) {
      walk.exact[link] = chain_.links()[link].known;
      walk.rounded[link] = {chain_.links()[link].known.turn.rounded(),
                            chain_.links()[link].known.origin.rounded()};
    }
    std::set<std::vector<int>> families;
    descend(0, walk, families, truth);
    for (const std::vector<int>& family : families) {
      truth.families.insert(placed_links(family));
    }
    return truth;
  }

 private:
  /// The fixed links of a family, which is given by the number of the moving dyad and by the
  /// choices of the dyads that hold it.
  [[nodiscard]] std::set<std::string> placed_links(const std::vector<int>& family) const {
    std::set<std::string> placed;
    for (std::size_t link = 0; link < chain_.driven(); ++link) {
      placed.insert(chain_.links()[link].name);
    }
    for (std::size_t dyad = 0; dyad + 1 < family.size(); ++dyad) {
      for (const std::size_t link : chain_.dyads()[dyad].links) {
        if (family[dyad + 1] >= 0) {
          placed.insert(chain_.links()[link].name);
        }
      }
    }
    return placed;
  }

  struct Walk {
    std::vector<std::optional<ChainPose<Gaussian>>> exact;
    std::vector<ChainPose<std::complex<double>>> rounded;
    std::vector<bool> loose;  ///< links of dyads that move, or are held by such
    std::vector<int> choices;
    bool regular;
    std::vector<std::vector<int>> families;
  };

  /// Marks the dyads that hold one, and those that hold these.
  void mark_holders(std::size_t dyad, std::vector<bool>& marked) const {
    for (const std::size_t base : chain_.dyads()[dyad].bases) {
      for (std::size_t before = 0; before < dyad; ++before) {
        if (!marked[before] &&
            (chain_.dyads()[before].links[0] == base || chain_.dyads()[before].links[1] == base)) {
          marked[before] = true;
          mark_holders(before, marked);
        }
      }
    }
  }

  void descend(std::size_t depth, const Walk& walk, std::set<std::vector<int>>& families,
               ChainTruth& truth) const {
    if (depth == chain_.dyads().size()) {
      families.insert(walk.families.begin(), walk.families.end());
      if (!walk.families.empty()) {
        truth.mobility = 1;
      } else {
        truth.configurations.push_back({walk.regular, walk.rounded});
      }
      return;
    }
    const ChainDyad& dyad = chain_.dyads()[depth];
    Walk next = walk;
    if (walk.loose[dyad.bases[0]] || walk.loose[dyad.bases[1]]) {
      next.loose[dyad.links[0]] = next.loose[dyad.links[1]] = true;
      descend(depth + 1, next, families, truth);
      return;
    }
    if (!walk.exact[dyad.bases[0]] || !walk.exact[dyad.bases[1]]) {
      truth.known = false;
      return;
    }
    const DyadAnswer answer =
        ExactDyad(dyad, *walk.exact[dyad.bases[0]], *walk.exact[dyad.bases[1]]).answer();
    std::vector<bool> holds(chain_.dyads().size(), false);
    mark_holders(depth, holds);
    truth.known = truth.known && !answer.inconsistent;
    if (answer.mobility > 0) {
      std::vector<int> family = {static_cast<int>(depth)};
      for (std::size_t before = 0; before < depth; ++before) {
        family.push_back(holds[before] ? walk.choices[before] : -1);
      }
      next.families.push_back(family);
      next.loose[dyad.links[0]] = next.loose[dyad.links[1]] = true;
      descend(depth + 1, next, families, truth);
    }
    for (std::size_t index = 0; index < answer.positions.size(); ++index) {
      const DyadPosition& position = answer.positions[index];
      next = walk;
      next.choices[depth] = static_cast<int>(index);
      next.regular = walk.regular && position.regular;
      for (std::size_t link = 0; link < 2; ++link) {
        // The first last: a block's frame is not that of a link.
        const std::size_t from = 1 - link;
        next.rounded[dyad.links[from]] = position.rounded[from];
        next.exact[dyad.links[from]] =
            position.exact && position.regular
                ? std::optional<ChainPose<Gaussian>>((*position.exact)[from])
                : std::nullopt;
      }
      descend(depth + 1, next, families, truth);
    }
  }

  const DyadChain& chain_;
};

}  // namespace assur::test
