// Assur groups of more than four links, as graphs, and chains of links as sets of joints.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <assur/mechanism/group_model.hpp>
#include <bit>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace assur::test {

/// The links that each joint of a chain joins.
using Chain = std::vector<std::pair<int, int>>;

/// Whether every part of a chain keeps at least this mobility: 3 (k - 1) - 2 e for k links and e
/// joints.
inline bool moves_in_all_parts(const Chain& chain, int links, int whole) {
  for (unsigned part = 0; part < (1U << links); ++part) {
    const int count = std::popcount(part);
    const auto joints = std::ranges::count_if(chain, [&](const auto& joint) {
      return ((part >> joint.first) & 1U) != 0 && ((part >> joint.second) & 1U) != 0;
    });
    const int least = count == links ? whole : 1;
    if (count > 1 && 3 * (count - 1) - 2 * static_cast<int>(joints) < least) {
      return false;
    }
  }
  return true;
}

/// The three chains of seven links and nine joints that do not move, and in which no part of two
/// links or more is rigid.
inline const std::vector<Chain>& seven_link_chains() {
  static const std::vector<Chain> chains = {
      {{0, 3}, {0, 4}, {1, 2}, {1, 4}, {1, 5}, {2, 6}, {3, 5}, {3, 6}, {4, 6}},
      {{0, 2}, {0, 4}, {0, 6}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {3, 6}, {5, 6}},
      {{0, 2}, {0, 3}, {1, 3}, {1, 4}, {2, 4}, {2, 5}, {3, 5}, {3, 6}, {4, 6}}};
  return chains;
}

/// The number of directions in which the slides of a chain lie: links that slides tie have one
/// angle.
inline std::size_t slide_directions(const Chain& chain, const std::vector<bool>& slides) {
  std::map<int, int> angles;  // of links
  for (const auto& [one, other] : chain) {
    angles[one] = one;
    angles[other] = other;
  }
  for (std::size_t joint = 0; joint < chain.size(); ++joint) {
    const int from = angles[chain[joint].first];
    const int to = angles[chain[joint].second];
    for (auto& [link, angle] : angles) {
      angle = slides[joint] && angle == from ? to : angle;
    }
  }
  std::set<int> directions;
  for (std::size_t joint = 0; joint < chain.size(); ++joint) {
    if (slides[joint]) {
      directions.insert(angles[chain[joint].first]);
    }
  }
  return directions.size();
}

/// A chain of seven links with some of its joints sliding.
struct ChainWithSlides {
  Chain chain;
  std::vector<bool> slides;
};

/// The kinds of the seven-link chains with slides in three directions or more: no elimination
/// reduces them to one unknown. All are rigid except those in which slides couple links in a
/// circle.
inline std::vector<ChainWithSlides> chains_with_slides_in_three_directions() {
  std::vector<ChainWithSlides> result;
  for (const Chain& chain : seven_link_chains()) {
    for (unsigned bits = 0; bits < (1U << chain.size()); ++bits) {
      std::vector<bool> slides;
      for (std::size_t joint = 0; joint < chain.size(); ++joint) {
        slides.push_back(((bits >> joint) & 1U) != 0);
      }
      if (slide_directions(chain, slides) > 2) {
        result.push_back({chain, slides});
      }
    }
  }
  return result;
}

/// The group that remains of a chain if one link is the base.
inline mechanism::GroupStructure grounded(const Chain& chain, int links, int base) {
  const auto renumbered = [base](int link) {
    return link == base ? base_link : link - (link > base ? 1 : 0);
  };
  mechanism::GroupStructure result{"larger", 0, {}, {}};
  result.link_joints.resize(static_cast<std::size_t>(links - 1));
  for (const auto& [one, other] : chain) {
    const auto [first, second] = std::minmax({renumbered(one), renumbered(other)});
    for (const int link : {first, second}) {
      if (link != base_link) {
        result.link_joints[static_cast<std::size_t>(link)].push_back(
            static_cast<int>(result.joints.size()));
      }
    }
    result.joints.push_back({'\0', first, second, false});
  }
  return result;
}

/// Its model if these joints slide; null if it has no isolated configuration.
inline const mechanism::GroupModel* model_of(const mechanism::GroupStructure& group,
                                             const std::vector<bool>& slides) {
  std::vector<ModelJoint> joints = group.joints;
  for (std::size_t joint = 0; joint < joints.size(); ++joint) {
    joints[joint].prismatic = slides[joint];
  }
  std::string obstacle;
  return mechanism::derived_model(static_cast<int>(group.link_count()), joints, obstacle);
}

/// Every chain of `links` links and `joints` joints that has the mobility `whole` and in which no
/// part is rigid, at least once up to the numbers of its links; links with more joints come first.
inline std::vector<Chain> chains_of(int links, int joints, int whole) {
  std::vector<Chain> found;
  std::vector<std::vector<std::vector<int>>> known;
  Chain chain;
  std::vector<int> degrees(static_cast<std::size_t>(links), 0);
  // For each link the number of closed walks of each length from it: enough to tell the chains of
  // eight links apart, as their number in the literature shows.
  const auto fingerprint = [&] {
    Eigen::MatrixXi adjacency = Eigen::MatrixXi::Zero(links, links);
    for (const auto& [one, other] : chain) {
      adjacency(one, other) = adjacency(other, one) = 1;
    }
    std::vector<std::vector<int>> walks(degrees.size());
    Eigen::MatrixXi power = adjacency;
    for (int length = 2; length <= links; ++length) {
      power = power * adjacency;
      for (int link = 0; link < links; ++link) {
        walks[static_cast<std::size_t>(link)].push_back(power(link, link));
      }
    }
    std::ranges::sort(walks);
    return walks;
  };
  const std::function<void(int, int)> extend = [&](int one, int other) {
    if (std::ssize(chain) == joints) {
      const bool is_sorted = std::ranges::is_sorted(degrees, std::greater<>());
      if (is_sorted && degrees.back() >= 2 && moves_in_all_parts(chain, links, whole)) {
        if (auto mark = fingerprint(); std::ranges::find(known, mark) == known.end()) {
          known.push_back(std::move(mark));
          found.push_back(chain);
        }
      }
      return;
    }
    if (other == links) {
      if (degrees[static_cast<std::size_t>(one)] < 2) {
        return;
      }
      ++one;
      other = one + 1;
    }
    if (one == links - 1) {
      return;
    }
    const auto first = static_cast<std::size_t>(one);
    const auto second = static_cast<std::size_t>(other);
    if (one == 0 || degrees[first] < degrees[first - 1]) {
      chain.emplace_back(one, other);
      ++degrees[first];
      ++degrees[second];
      extend(one, other + 1);
      chain.pop_back();
      --degrees[first];
      --degrees[second];
    }
    extend(one, other + 1);
  };
  extend(0, 1);
  return found;
}

}  // namespace assur::test
