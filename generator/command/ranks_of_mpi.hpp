// The functions of MPI that the program needs, for a module.
#pragma once

#include <cstdint>

namespace assur::generator::command {

extern "C" {
struct AssurMpiRank {
  std::uint64_t number, count;
};
/// Begins MPI.
[[nodiscard]] AssurMpiRank assur_mpi_begin();
/// The smallest of the numbers of all ranks.
[[nodiscard]] std::uint64_t assur_mpi_least(std::uint64_t own);
void assur_mpi_end();
}

}  // namespace assur::generator::command
