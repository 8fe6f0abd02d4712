#include "command/ranks.hpp"

#include <algorithm>
#include <array>
#include <assur/text/error.hpp>
#include <cstdlib>

#include "campaign/module.hpp"
#include "command/ranks_of_mpi.hpp"

namespace assur::generator::command {

namespace {

/// Whether this process was started with others, by the variables that Open MPI and others set.
bool is_one_of_many() {
  constexpr std::array<const char*, 2> variables = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"};
  return std::any_of(variables.begin(), variables.end(), [](const char* variable) {
    const char* const size = std::getenv(variable);
    return size != nullptr && std::atoi(size) > 1;
  });
}

template <typename Function>
Function* of_mpi(const char* name) {
  void* const found = campaign::function_of_module("assur_mpi", name);
  if (found == nullptr) {
    throw text::InputError(
        "this assur was built without MPI; use --shard, or install libopenmpi-dev and build it "
        "again");
  }
  return reinterpret_cast<Function*>(found);
}

}  // namespace

Ranks::Ranks() {
  if (is_one_of_many()) {
    const AssurMpiRank rank = of_mpi<decltype(assur_mpi_begin)>("assur_mpi_begin")();
    number_ = rank.number;
    count_ = rank.count;
  }
}

Ranks::~Ranks() {
  if (count_ > 1) {
    of_mpi<decltype(assur_mpi_end)>("assur_mpi_end")();
  }
}

std::uint64_t Ranks::least_of(std::uint64_t own) const {
  return count_ > 1 ? of_mpi<decltype(assur_mpi_least)>("assur_mpi_least")(own) : own;
}

void Ranks::together(const std::function<void()>& part) const {
  std::exception_ptr error;
  try {
    part();
  } catch (...) {
    error = std::current_exception();
  }
  const std::uint64_t first_failed = least_of(error ? number_ : count_);
  if (first_failed == number_) {
    std::rethrow_exception(error);
  }
  if (first_failed < count_) {
    throw OtherRankFailed();
  }
}

}  // namespace assur::generator::command
