// Errors about the parts of a mechanism, each one line that names the part.
#pragma once

#include <assur/text/error.hpp>
#include <assur/text/quoted.hpp>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace assur::mechanism {

using text::InputError;

/// An unusable part of a mechanism, or an unusable value of one of its numbers. `what()` is one
/// line: the part, as a scene file spells it (`joints.B.between[1]`), the fault, and the remedy.
class MechanismError : public InputError {
 public:
  MechanismError(const std::string& part, const std::string& what)
      : InputError(text::on_one_line(part.empty() ? what : part + ": " + what)) {}
};

/// The message for the number of a configuration (or branch, as `what` says) above `highest`, the
/// highest number that exists (zero if there is none).
[[nodiscard]] inline std::string no_configuration(std::size_t number, std::size_t highest,
                                                  const std::string& what = "configuration") {
  return highest == 0 ? "there is no " + what
                      : "there is no " + what + " " + std::to_string(number) +
                            "; the highest number is " + std::to_string(highest);
}

/// The requested number of a configuration or branch exceeds the highest one.
class NoSuchConfiguration : public MechanismError {
 public:
  NoSuchConfiguration(std::size_t number, std::size_t highest,
                      const std::string& what = "configuration")
      : MechanismError("", no_configuration(number, highest, what)) {}
};

/// There are more constraints than the links have degrees of freedom.
class OverConstrained : public MechanismError {
 public:
  OverConstrained(const std::string& part, const std::string& what, int by,
                  std::vector<std::string> at, int free_elsewhere = 0)
      : MechanismError(part, what), surplus(by), lack(free_elsewhere), joints(std::move(at)) {}

  int surplus;                      ///< the number of excess constraints
  int lack;                         ///< degrees of freedom that other links keep
  std::vector<std::string> joints;  ///< the joints among which the excess occurs
  /// The least gap by which these constraints fail to hold, if the mechanism without them can be
  /// assembled.
  double gap = std::numeric_limits<double>::infinity();
};

}  // namespace assur::mechanism
