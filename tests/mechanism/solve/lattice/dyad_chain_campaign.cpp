// Campaign over chains of dyads in special position: the library's answers against exact ones.
// `dyad_chain_campaign CHAINS [FIRST [DIRECTORY]]`: FIRST is a seed; DIRECTORY gets faulty scenes.
#include <cstdlib>
#include <iostream>

#include "mechanism/dyad_chain_run.hpp"

int main(int argc, char** argv) {
  using namespace assur::test;
  const unsigned count = argc > 1 ? static_cast<unsigned>(std::strtoul(argv[1], nullptr, 10)) : 200;
  const unsigned first = argc > 2 ? static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10)) : 1;
  DyadChainRun run(std::cout, argc > 3 ? argv[3] : "");
  for (unsigned seed = first; seed < first + count; ++seed) {
    run.run(seed);
  }
  run.print();
  return run.tally().wrong == 0 ? 0 : 1;
}
