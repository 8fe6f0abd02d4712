#include "command/ranks_of_mpi.hpp"

#include <mpi.h>

namespace assur::generator::command {

AssurMpiRank assur_mpi_begin() {
  int rank = 0;
  int size = 1;
  (void)MPI_Init(nullptr, nullptr);
  (void)MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  (void)MPI_Comm_size(MPI_COMM_WORLD, &size);
  return {static_cast<std::uint64_t>(rank), static_cast<std::uint64_t>(size)};
}

std::uint64_t assur_mpi_least(std::uint64_t own) {
  std::uint64_t least = own;
  (void)MPI_Allreduce(&own, &least, 1, MPI_UINT64_T, MPI_MIN, MPI_COMM_WORLD);
  return least;
}

void assur_mpi_end() { (void)MPI_Finalize(); }

}  // namespace assur::generator::command
