// Campaign over groups in special position on a lattice: the library's answers against exact ones.
// `lattice_campaign SCENES [DIRECTORY]`: faulty scenes are written to DIRECTORY.
#include <cstdlib>
#include <iostream>

#include "mechanism/lattice_run.hpp"

// NOLINTNEXTLINE(bugprone-exception-escape): what a campaign throws ends it with its message
int main(int argc, char** argv) {
  using namespace assur::test;
  const auto scenes = static_cast<std::size_t>(argc > 1 ? std::atol(argv[1]) : 500);
  LatticeRun run(std::cout, argc > 2 ? argv[2] : "");
  bool right = true;
  for (const LatticeTruth& truth : read_lattice_truth(ASSUR_LATTICE_TRUTH, scenes)) {
    right = run.run(truth) && right;
  }
  run.print();
  return right ? 0 : 1;
}
