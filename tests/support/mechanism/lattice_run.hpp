// The library's faults by kind, with their scenes, over rows of the table of exact answers.
#pragma once

#include <filesystem>
#include <fstream>
#include <iomanip>
#include <ostream>

#include "mechanism/lattice_comparison.hpp"

namespace assur::test {

/// What is wrong over many scenes.
struct LatticeTally {
  int scenes = 0;
  int untold = 0;   ///< scenes of which there is no exact answer
  int faulty = 0;   ///< scenes with a wrong answer
  int serious = 0;  ///< of these, with wrong configurations or verdicts
  int configurations = 0;
  double residual = 0;          ///< the largest of a closed configuration
  double smallest_apart = 1e9;  ///< distance of two regular configurations of one scene
  double smallest = 1e9;        ///< singular value of a configuration called regular
  LatticeFaults faults;
};

class LatticeRun {
 public:
  /// Reports faulty scenes to `out`, and writes them as files to `directory` unless that is empty.
  LatticeRun(std::ostream& out, std::string directory)
      : out_(out), directory_(std::move(directory)), kinds_(lattice_kinds()) {}

  /// Solves a scene in two listings; returns whether both answers are right and equal.
  bool run(const LatticeTruth& truth) {
    LatticeTally& tally = tallies_[truth.kind];
    LatticeTally& of_class = by_class_[truth.exactness];
    ++tally.scenes;
    ++of_class.scenes;
    if (!truth.known) {
      ++tally.untold;
      return true;
    }
    const LatticeScene scene(kind_spelled(truth.kind), truth.seed);
    LatticeFaults faults;
    try {
      const LatticeAnswer answer = lattice_answer(scene, scene.text(1, 0));
      faults = lattice_faults(truth, answer);
      if (!same_answer(answer, lattice_answer(scene, scene.text(2, 1)))) {
        const bool same = same_answer(answer, lattice_answer(scene, scene.text(2, 0)));
        ++(same ? faults.exchanged : faults.renumbered);
      }
      measure(answer, tally);
    } catch (const mechanism::MechanismError& error) {
      out_ << scene.name() << ": " << error.what() << '\n';
      faults.refused = 1;
    }
    tally.faults.add(faults);
    of_class.faults.add(faults);
    tally.serious += faults.serious() ? 1 : 0;
    of_class.serious += faults.serious() ? 1 : 0;
    if (faults.any()) {
      ++tally.faulty;
      ++of_class.faulty;
      out_ << scene.name() << " (mobility " << truth.mobility << ", isolated " << truth.isolated
           << ", singular " << truth.singular << "): " << faults << '\n';
      dump(scene);
    }
    return !faults.any();
  }

  /// Totals by kind, of the kinds that have faults, and over all.
  void print() const {
    LatticeTally all;
    const auto row = [this](const std::string& name, const LatticeTally& tally) {
      const LatticeFaults& faults = tally.faults;
      out_ << std::left << std::setw(10) << name << std::right << std::setw(8) << tally.scenes
           << std::setw(8) << tally.faulty << std::setw(9) << tally.serious << std::setw(8)
           << faults.lost << std::setw(8) << faults.hidden << std::setw(10) << faults.invented
           << std::setw(10) << faults.verdicts() << std::setw(10) << faults.wrong_mobility
           << std::setw(9) << faults.renumbered << std::setw(11) << faults.exchanged << std::setw(9)
           << faults.refused << '\n';
    };
    out_ << "kind        scenes  faulty  serious    lost  hidden  invented  verdicts  mobility  "
            "relisted  exchanged  refused\n";
    for (const auto& [name, tally] : tallies_) {
      if (tally.faulty != 0) {
        row(name, tally);
      }
      all.scenes += tally.scenes;
      all.untold += tally.untold;
      all.faulty += tally.faulty;
      all.serious += tally.serious;
      all.configurations += tally.configurations;
      all.residual = std::max(all.residual, tally.residual);
      all.smallest_apart = std::min(all.smallest_apart, tally.smallest_apart);
      all.smallest = std::min(all.smallest, tally.smallest);
      all.faults.add(tally.faults);
    }
    for (const auto& [name, tally] : by_class_) {
      row(name, tally);
    }
    row("all", all);
    out_ << all.faults << "\n"
         << all.untold << " scenes without an exact answer; " << all.configurations
         << " configurations, largest residual of what closes " << all.residual
         << ", smallest distance of two regular ones " << all.smallest_apart
         << ", smallest singular value of what is called regular " << all.smallest << '\n';
  }

 private:
  [[nodiscard]] const LatticeKind& kind_spelled(const std::string& spelling) const {
    return *std::find_if(kinds_.begin(), kinds_.end(),
                         [&](const LatticeKind& kind) { return kind.spelling == spelling; });
  }

  static void measure(const LatticeAnswer& answer, LatticeTally& tally) {
    for (std::size_t index = 0; index < answer.configurations.size(); ++index) {
      const ListedConfiguration& at = answer.configurations[index];
      ++tally.configurations;
      if (at.residual <= closes) {
        tally.residual = std::max(tally.residual, at.residual);
      }
      if (at.regular) {
        tally.smallest = std::min(tally.smallest, at.smallest);
      }
      for (std::size_t before = 0; before < index; ++before) {
        const ListedConfiguration& other = answer.configurations[before];
        if (at.regular && other.regular) {
          tally.smallest_apart = std::min(tally.smallest_apart, difference(other, at));
        }
      }
    }
  }

  void dump(const LatticeScene& scene) const {
    if (directory_.empty()) {
      return;
    }
    std::string name = scene.name();
    std::replace(name.begin(), name.end(), ' ', '_');
    for (unsigned listing = 1; listing <= 2; ++listing) {
      std::ofstream(std::filesystem::path(directory_) /
                    (name + "_listing_" + std::to_string(listing) + ".json"))
          << scene.text(listing, listing - 1);
    }
  }

  std::ostream& out_;
  std::string directory_;
  std::vector<LatticeKind> kinds_;
  std::map<std::string, LatticeTally> tallies_;
  std::map<std::string, LatticeTally> by_class_;
};

}  // namespace assur::test
