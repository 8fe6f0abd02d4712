// The processes that `mpirun` has started, as ranks that wait for one another.
#pragma once

#include <cstdint>
#include <exception>
#include <functional>

namespace assur::generator::command {

/// Another process started together with this one has failed and reported its error.
class OtherRankFailed : public std::exception {};

/// This process among those that MPI has started together; a single one if MPI has not started it.
class Ranks {
 public:
  Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  ~Ranks();

  [[nodiscard]] std::uint64_t number() const { return number_; }  ///< from 0
  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] bool is_first() const { return number_ == 0; }

  /// Does a part of the work, and waits until all have done theirs. The first rank whose part
  /// throws rethrows the exception, all others throw OtherRankFailed.
  void together(const std::function<void()>& part) const;

 private:
  /// The smallest of the ranks' numbers.
  [[nodiscard]] std::uint64_t least_of(std::uint64_t own) const;

  std::uint64_t number_ = 0, count_ = 1;
};

}  // namespace assur::generator::command
