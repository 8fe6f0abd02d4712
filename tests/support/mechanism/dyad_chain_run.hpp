// Faults of the library's answers for chains of dyads on a lattice.
#pragma once

#include <algorithm>
#include <array>
#include <complex>
#include <cstdlib>
#include <fstream>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "mechanism/dyad_chain.hpp"
#include "mechanism/dyad_chain_truth.hpp"
#include "mechanism/named_counts.hpp"
#include "mechanism/solved.hpp"

namespace assur::test {

/// How often something is wrong.
struct ChainFaults {
  int refused = 0;
  int lost = 0;
  int invented = 0;
  int called_regular = 0;   ///< that are singular in truth
  int called_singular = 0;  ///< that are regular in truth
  int no_family = 0;        ///< families that are not told
  int false_family = 0;     ///< families that do not exist, or that are told twice
  int wrong_mobility = 0;
  int wrong_after = 0;  ///< families with other links placed than those that hold them
  int renumbered = 0;   ///< another listing or place has another order
  int rescaled = 0;     ///< another unit changes the answer

  [[nodiscard]] std::array<NamedCount, 11> named() const {
    return {{{"refused", refused},
             {"lost", lost},
             {"invented", invented},
             {"called regular", called_regular},
             {"called singular", called_singular},
             {"family not told", no_family},
             {"family invented", false_family},
             {"wrong mobility", wrong_mobility},
             {"wrong links placed", wrong_after},
             {"renumbered", renumbered},
             {"changed by the unit", rescaled}}};
  }
  [[nodiscard]] int count() const {
    int sum = 0;
    for (const auto& [name, number] : named()) {
      sum += number;
    }
    return sum;
  }
  void add(const ChainFaults& other) {
    refused += other.refused;
    lost += other.lost;
    invented += other.invented;
    called_regular += other.called_regular;
    called_singular += other.called_singular;
    no_family += other.no_family;
    false_family += other.false_family;
    wrong_mobility += other.wrong_mobility;
    wrong_after += other.wrong_after;
    renumbered += other.renumbered;
    rescaled += other.rescaled;
  }
};

inline std::ostream& operator<<(std::ostream& out, const ChainFaults& faults) {
  return print_counts(out, faults.named());
}

/// What a campaign has met.
struct ChainTally {
  int chains = 0;
  int untold = 0;  ///< of which there is no exact answer
  int solved = 0;  ///< scenes, several listings of each chain
  int wrong = 0;   ///< of these
  int configurations = 0, singular = 0, families = 0;
  ChainFaults faults;
};

class DyadChainRun {
 public:
  /// Reports scenes that are answered wrongly to `out`, and writes them to the directory unless its
  /// name is empty.
  DyadChainRun(std::ostream& out, std::string directory)
      : out_(out), directory_(std::move(directory)) {}

  /// Solves a chain in several listings, places and units.
  void run(unsigned seed) {
    const DyadChain chain(seed);
    const ChainTruth truth = ExactChain(chain).truth();
    ++tally_.chains;
    if (!truth.known) {
      ++tally_.untold;
      return;
    }
    tally_.configurations += static_cast<int>(truth.configurations.size());
    tally_.families += static_cast<int>(truth.families.size());
    tally_.singular +=
        static_cast<int>(std::count_if(truth.configurations.begin(), truth.configurations.end(),
                                       [](const ChainConfiguration& at) { return !at.regular; }));
    std::mt19937 engine(seed);
    ChainListing listing;
    std::vector<std::complex<double>> first = solve(chain, truth, listing);
    const std::vector<std::complex<double>> as_made = first;
    const auto expect_same_order = [&] {
      if (!same_numbers(as_made, first, listing)) {
        report(chain, listing, {.renumbered = 1});
      }
    };
    for (unsigned place = 0; place < places; ++place) {
      listing = {place + 1, place % 2 == 1, 0, 0, static_cast<int>(place % 4), place >= 2, 0};
      if (place + 1 == places) {
        listing.x = 1 << 10;
        listing.y = -(1 << 8);
      } else {
        // One of the joints stands at the origin.
        const auto joint = engine() % chain.joint_count();
        const auto at = DyadChain::ground_of(listing).turn * chain.place_of(joint);
        listing.x = -static_cast<int>(std::lround(at.real()));
        listing.y = -static_cast<int>(std::lround(at.imag()));
      }
      first = solve(chain, truth, listing);
      expect_same_order();
      for (const int unit : {-300, 37 + static_cast<int>(place), 300}) {
        listing.unit = unit;
        const std::vector<std::complex<double>> other = solve(chain, truth, listing);
        if (!same_numbers(first, other, {})) {
          report(chain, listing, {.rescaled = 1});
        }
      }
    }
  }

  void print() const {
    out_ << tally_.chains << " chains, " << tally_.untold << " without an exact answer; "
         << tally_.configurations << " configurations, " << tally_.singular << " of them singular, "
         << tally_.families << " families; " << tally_.solved << " scenes solved, " << tally_.wrong
         << " answered wrongly: " << tally_.faults << '\n';
  }
  [[nodiscard]] const ChainTally& tally() const { return tally_; }

 private:
  static constexpr unsigned places = 5;

  /// All numbers of the answer, lengths in the listing's unit; nothing where it is refused.
  std::vector<std::complex<double>> solve(const DyadChain& chain, const ChainTruth& truth,
                                          const ChainListing& listing) {
    ++tally_.solved;
    try {
      const Solved solved(mechanism::parse_scene(chain.text(listing), "scene"));
      report(chain, listing, faults_of(chain, truth, listing, solved));
      return numbers_of(chain, listing, solved);
    } catch (const mechanism::MechanismError& error) {
      out_ << error.what() << '\n';
      report(chain, listing, {.refused = 1});
      return {};
    }
  }

  using Poses = std::vector<ChainPose<std::complex<double>>>;

  template <typename Frames>
  static Poses poses_of(const DyadChain& chain, const ChainListing& listing, const Frames& frame) {
    Poses poses;
    for (const ChainLink& link : chain.links()) {
      const auto& pose = frame(link.name).pose;
      poses.push_back({{pose.direction.cos, pose.direction.sin},
                       {std::ldexp(pose.x, -listing.unit), std::ldexp(pose.y, -listing.unit)}});
    }
    return poses;
  }
  static Poses poses_of(const DyadChain& chain, const ChainListing& listing,
                        const Configuration& configuration) {
    return poses_of(
        chain, listing, [&configuration](const std::string& name) -> const auto& {
          return configuration.link(name);
        });
  }

  /// The regularity and the poses of all configurations, and the mobilities of all families, as
  /// numbers to compare with those of another listing.
  static std::vector<std::complex<double>> numbers_of(const DyadChain& chain,
                                                      const ChainListing& listing,
                                                      const Solved& solved) {
    std::vector<std::complex<double>> numbers;
    for (const Configuration& configuration : solved.configurations()) {
      numbers.emplace_back(configuration.regularity == Status::ok ? 1 : 0);
      for (const auto& pose : poses_of(chain, listing, configuration)) {
        numbers.push_back(pose.turn);
        numbers.push_back(pose.origin);
      }
    }
    for (const mechanism::Family& family : solved.solution.families) {
      numbers.emplace_back(family.mobility);
    }
    return numbers;
  }

  /// Whether configurations have the same numbers in another listing, up to the tolerance.
  static bool same_numbers(const std::vector<std::complex<double>>& as_made,
                           const std::vector<std::complex<double>>& other,
                           const ChainListing& listing) {
    if (as_made.size() != other.size()) {
      return false;
    }
    // The directions of links against the first of them do not change, and distinguish
    // configurations.
    const auto ground = DyadChain::ground_of(listing);
    for (std::size_t index = 0; index < as_made.size(); ++index) {
      const std::complex<double> turned = as_made[index] * ground.turn;
      const bool same = std::abs(other[index] - as_made[index]) < same_configuration ||
                        std::abs(other[index] - turned) < same_configuration ||
                        std::abs(other[index] - turned - ground.origin) < same_configuration;
      if (!same) {
        return false;
      }
    }
    return true;
  }

  /// Different configurations on the lattice are further apart; where two meet, they are known only
  /// to the root of rounding.
  static constexpr double same_configuration = 5e-3;

  static double difference(const Poses& one, const Poses& other) {
    double largest = 0;
    for (std::size_t link = 1; link < one.size(); ++link) {
      largest = std::max({largest, std::abs(one[link].turn - other[link].turn),
                          std::abs(one[link].origin - other[link].origin)});
    }
    return largest;
  }

  static ChainFaults faults_of(const DyadChain& chain, const ChainTruth& truth,
                               const ChainListing& listing, const Solved& solved) {
    ChainFaults faults;
    std::vector<bool> met(solved.configurations().size(), false);
    const auto ground = DyadChain::ground_of(listing);
    for (const ChainConfiguration& known : truth.configurations) {
      Poses poses;
      for (const auto& pose : known.poses) {
        poses.push_back({ground.turn * pose.turn, ground(pose.origin)});
      }
      bool found = false;
      for (std::size_t index = 0; index < met.size() && !found; ++index) {
        const Configuration& listed = solved.configurations()[index];
        found =
            !met[index] && difference(poses, poses_of(chain, listing, listed)) < same_configuration;
        if (found) {
          met[index] = true;
          const bool regular = listed.regularity == Status::ok;
          faults.called_regular += regular && !known.regular ? 1 : 0;
          faults.called_singular += !regular && known.regular ? 1 : 0;
        }
      }
      faults.lost += found ? 0 : 1;
    }
    faults.invented = static_cast<int>(std::count(met.begin(), met.end(), false));
    const auto& families = solved.solution.families;
    const int known = static_cast<int>(truth.families.size());
    const int told = static_cast<int>(families.size());
    faults.no_family = std::max(0, known - told);
    faults.false_family = std::max(0, told - known);
    int mobility = 0;
    std::multiset<std::set<std::string>> placed;
    for (const mechanism::Family& family : families) {
      mobility = std::max(mobility, family.mobility);
      std::set<std::string> links;
      for (const mechanism::LinkIndex link : solved.plan.mechanism().links().keys()) {
        if (family.is_placed[link]) {
          links.insert(solved.plan.mechanism().links()[link].name);
        }
      }
      placed.insert(links);
    }
    faults.wrong_mobility = known == told && mobility != truth.mobility ? 1 : 0;
    faults.wrong_after = known == told && placed != truth.families ? 1 : 0;
    return faults;
  }

  void report(const DyadChain& chain, const ChainListing& listing, const ChainFaults& faults) {
    if (faults.count() == 0) {
      return;
    }
    tally_.faults.add(faults);
    ++tally_.wrong;
    std::ostringstream name;
    name << chain.name() << " order " << listing.order << " at " << listing.x << ',' << listing.y
         << " turned " << listing.quarters << " unit " << listing.unit
         << (listing.expressed ? " expressed" : "");
    out_ << name.str() << ": " << faults << '\n';
    if (!directory_.empty()) {
      std::string file = name.str();
      std::replace(file.begin(), file.end(), ' ', '_');
      std::ofstream(directory_ + "/" + file + ".json") << chain.text(listing);
    }
  }

  std::ostream& out_;
  std::string directory_;
  ChainTally tally_;
};

}  // namespace assur::test
