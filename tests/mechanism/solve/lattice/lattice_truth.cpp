// Writes a program for Singular that counts the real configurations of groups in special position
// on a lattice exactly. For COUNT scenes of every kind (174 in the stored table): `lattice_truth
// COUNT | Singular -q | grep -v // > tests/data/lattice_truth.txt`.
#include <array>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "mechanism/lattice_scene.hpp"

namespace assur::test {
namespace {

/// Coordinates as texts of polynomials.
using Polynomials = std::array<std::string, 2>;

/// The loop equations of a group. Every link is described by how it has moved from the known
/// configuration: turned about the origin by (c, s), then shifted. Therefore every joint starts
/// where the lattice has it, links with a slide between them turn alike, and neither the frames of
/// a scene nor its points on a slide's line matter. At the known configuration c is 1 and the other
/// unknowns are 0.
class LatticeEquations {
 public:
  explicit LatticeEquations(const LatticeScene& scene) : scene_(scene) {
    find_turns();
    find_shifts();
  }

  /// The unknowns of the ring, rotations first.
  [[nodiscard]] const std::vector<std::string>& unknowns() const { return unknowns_; }
  [[nodiscard]] const std::vector<std::string>& equations() const { return equations_; }

 private:
  /// Links that slides join, directly or not, have one rotation; the base does not turn.
  void find_turns() {
    turn_.resize(scene_.links().size());
    for (std::size_t link = 0; link < turn_.size(); ++link) {
      turn_[link] = static_cast<int>(link);
    }
    for (std::size_t pass = 0; pass < turn_.size(); ++pass) {
      for (const LatticeJoint& joint : scene_.joints()) {
        if (joint.prismatic) {
          const int least = std::min(turn_of(joint.first), turn_of(joint.second));
          turn_[static_cast<std::size_t>(joint.second)] = least;
          if (joint.first != base_link) {
            turn_[static_cast<std::size_t>(joint.first)] = least;
          }
        }
      }
    }
    for (std::size_t link = 0; link < turn_.size(); ++link) {
      if (turn_[link] == static_cast<int>(link)) {
        const std::string number = std::to_string(link);
        unknowns_.push_back("c" + number);
        unknowns_.push_back("s" + number);
        equations_.push_back("c" + number + "^2+s" + number + "^2-1");
      }
    }
    for (const LatticeJoint& joint : scene_.joints()) {
      if (joint.prismatic) {
        unknowns_.push_back(slide_name(joint));
      }
    }
  }

  /// Walks over the joints until every link has its shift; a joint between two links that have one
  /// closes a loop.
  void find_shifts() {
    std::vector<Polynomials> shift(scene_.links().size());
    std::vector<bool> used(scene_.joints().size(), false);
    const auto known = [&shift](int link) {
      return link == base_link || !shift[static_cast<std::size_t>(link)][0].empty();
    };
    const auto shift_of = [&shift](int link, std::size_t row) {
      return link == base_link ? "0" : shift[static_cast<std::size_t>(link)][row];
    };
    for (std::size_t pass = 0; pass < shift.size(); ++pass) {
      for (std::size_t index = 0; index < used.size(); ++index) {
        const LatticeJoint& joint = scene_.joints()[index];
        if (used[index] || known(joint.first) == known(joint.second)) {
          continue;
        }
        used[index] = true;
        const bool forward = known(joint.first);
        const int from = forward ? joint.first : joint.second;
        const int to = forward ? joint.second : joint.first;
        const Polynomials step = moved(joint);
        for (std::size_t row = 0; row < 2; ++row) {
          shift[static_cast<std::size_t>(to)][row] =
              shift_of(from, row) + (forward ? "+(" : "-(") + step[row] + ")";
        }
      }
    }
    for (std::size_t index = 0; index < used.size(); ++index) {
      const LatticeJoint& joint = scene_.joints()[index];
      const Polynomials step = moved(joint);
      for (std::size_t row = 0; row < 2 && !used[index]; ++row) {
        equations_.push_back(shift_of(joint.first, row) + "+(" + step[row] + ")-(" +
                             shift_of(joint.second, row) + ")");
      }
    }
  }

  /// The difference between the shifts of a joint's second link and of its first.
  [[nodiscard]] Polynomials moved(const LatticeJoint& joint) const {
    const Polynomials first = turned(joint.prismatic ? joint.along : joint.at, joint.first);
    const Polynomials second = turned(joint.at, joint.second);
    Polynomials result;
    for (std::size_t row = 0; row < 2; ++row) {
      result[row] = joint.prismatic ? slide_name(joint) + "*(" + first[row] + ")"
                                    : first[row] + "-(" + second[row] + ")";
    }
    return result;
  }

  [[nodiscard]] Polynomials turned(const LatticeVector& vector, int link) const {
    const std::string x = std::to_string(vector.x);
    const std::string y = std::to_string(vector.y);
    const int turn = turn_of(link);
    if (turn == base_link) {
      return {x, y};
    }
    const std::string number = std::to_string(turn);
    const std::string c = "*c" + number;
    const std::string s = "*s" + number;
    return {x + c + "-(" + y + ")" + s, x + s + "+(" + y + ")" + c};
  }

  [[nodiscard]] int turn_of(int link) const {
    return link == base_link ? base_link : turn_[static_cast<std::size_t>(link)];
  }
  static std::string slide_name(const LatticeJoint& joint) { return std::string("t") + joint.name; }

  const LatticeScene& scene_;
  std::vector<int> turn_;  ///< of each link the least link that has turned alike, or the base
  std::vector<std::string> unknowns_;
  std::vector<std::string> equations_;
};

std::string listed(const std::vector<std::string>& texts) {
  std::string result;
  for (const std::string& text : texts) {
    result += (result.empty() ? "" : ", ") + text;
  }
  return result;
}

/// What makes Singular print the line of one scene.
std::string question(const LatticeKind& kind, unsigned seed) {
  const LatticeScene scene(kind, seed);
  const LatticeEquations equations(scene);
  std::string known;
  for (const std::string& unknown : equations.unknowns()) {
    known += std::string(known.empty() ? "" : ",") + (unknown[0] == 'c' ? "1" : "0");
  }
  return "ring r = 0, (" + listed(equations.unknowns()) +
         "), dp;\nideal I = " + listed(equations.equations()) + ";\nideal K = " + known +
         ";\nanswer(\"" + scene.name() + "\", I, K);\nkill r;\n";
}

}  // namespace
}  // namespace assur::test

int main(int argc, char** argv) {
  using namespace assur::test;
  const unsigned count = argc > 1 ? static_cast<unsigned>(std::atoi(argv[1])) : 5;
  const unsigned first = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 0;
  std::ifstream procedures(ASSUR_LATTICE_PROCEDURES);
  std::cout << procedures.rdbuf()
            << "print(\"# kind, seed, exactness, mobility, isolated, of those singular\");\n";
  const std::vector<LatticeKind> kinds = lattice_kinds();
  for (unsigned seed = first; seed < first + count; ++seed) {
    for (const LatticeKind& kind : kinds) {
      std::cout << question(kind, seed);
    }
  }
  return 0;
}
