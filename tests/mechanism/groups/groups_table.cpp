// Prints the table of all Assur groups of up to eight links and revolute joints, by the chains from
// which they arise, as in docs/method/groups.md. Given that page's name as an argument, it exits
// with 1 if the page differs.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "mechanism/larger_groups.hpp"

namespace assur::test {
namespace {

/// The number of different bases of a chain: links that no symmetry of the chain exchanges.
class DifferentBases {
 public:
  DifferentBases(const Chain& chain, int links)
      : links_(static_cast<std::size_t>(links)), joined_(links_, std::vector<bool>(links_, false)) {
    for (const auto& [one, other] : chain) {
      joined_[static_cast<std::size_t>(one)][static_cast<std::size_t>(other)] = true;
      joined_[static_cast<std::size_t>(other)][static_cast<std::size_t>(one)] = true;
    }
  }
  [[nodiscard]] int count() const {
    std::vector<std::size_t> found;
    for (std::size_t link = 0; link < links_; ++link) {
      if (std::ranges::none_of(found,
                               [&](std::size_t other) { return extends({}, link, other); })) {
        found.push_back(link);
      }
    }
    return static_cast<int>(found.size());
  }

 private:
  /// Whether a symmetry that preserves all joints maps the first links to the given images and
  /// `link` to `to`.
  [[nodiscard]] bool extends(const std::vector<std::size_t>& images, std::size_t link,
                             std::size_t to) const {
    const std::size_t next = images.size();
    if (next == links_) {
      return true;
    }
    for (std::size_t image = 0; image < links_; ++image) {
      bool fits =
          (next == link) == (image == to) && std::ranges::find(images, image) == images.end();
      for (std::size_t before = 0; before < next && fits; ++before) {
        fits = joined_[before][next] == joined_[images[before]][image];
      }
      if (fits) {
        std::vector<std::size_t> longer = images;
        longer.push_back(image);
        if (extends(longer, link, to)) {
          return true;
        }
      }
    }
    return false;
  }

  std::size_t links_;
  std::vector<std::vector<bool>> joined_;
};

std::string named(int link) { return {static_cast<char>('A' + link)}; }

/// Numbers of configurations that others found, by the joints of the chain.
const std::map<std::string, const char*>& published() {
  static const std::map<std::string, const char*> numbers = {
      {"AB AC BC", "2, two circles"},
      {"AC AD AE BC BD BE", "6, a coupler curve and a circle"},
      {"AB AC AD BE BF CE CG DF DG", "14, Rojas and Thomas"},
      {"AB AC AE BD BF CF CG DE DG", "16, Rojas and Thomas"},
      {"AD AE AF AG BC BD BE CF CG", "18, Rojas and Thomas"},
      {"AF AG AH AI BC BD BF CE CG DE DH EI", "56, Lösch"}};
  return numbers;
}

std::string table() {
  std::ostringstream text;
  text << "| links | joints | of the chain's links | groups | configurations | published |\n"
       << "|---|---|---|---|---|---|\n";
  for (const auto& [links, joints] : {std::pair{3, 3}, {5, 6}, {7, 9}, {9, 12}}) {
    for (const Chain& chain : chains_of(links, joints, 0)) {
      std::vector<int> degrees(static_cast<std::size_t>(links), 0);
      std::string pairs;
      for (const auto& [one, other] : chain) {
        ++degrees[static_cast<std::size_t>(one)];
        ++degrees[static_cast<std::size_t>(other)];
        pairs += (pairs.empty() ? "" : " ") + named(one) + named(other);
      }
      std::string numbers;
      for (const int degree : degrees) {
        numbers += std::to_string(degree);
      }
      const mechanism::GroupModel* model =
          model_of(grounded(chain, links, links - 1), std::vector<bool>(chain.size(), false));
      const auto found = published().find(pairs);
      text << "| " << links - 1 << " | " << pairs << " | " << numbers << " | "
           << DifferentBases(chain, links).count() << " | "
           << (model == nullptr ? 0 : model->max_configurations) << " | "
           << (found == published().end() ? "" : found->second) << " |\n";
    }
  }
  return text.str();
}

}  // namespace
}  // namespace assur::test

int main(int argc, char** argv) {
  const std::string table = assur::test::table();
  if (argc < 2) {
    std::cout << table;
    return 0;
  }
  std::ifstream file(argv[1]);
  const std::string page(std::istreambuf_iterator<char>(file), {});
  if (page.find(table) == std::string::npos) {
    std::cout << argv[1] << " does not hold this table:\n" << table;
    return 1;
  }
  return 0;
}
