// The assignments of a function's statements, and the sizes of matrices by their types.
#pragma once

#include <map>
#include <optional>
#include <set>

#include "audit/init/program_sources.hpp"

namespace assur::generator::audit::init {

/// A matrix with more entries is not a Jacobian that anybody audits.
inline constexpr std::size_t most_entries = 100;
/// The longest chain of variables that stand for each other.
inline constexpr int most_hops = 20;
/// Longer types and names of functions are not among the known ones.
inline constexpr std::size_t longest_type = 200;

struct MatrixSize {
  std::size_t rows = 0;
  std::size_t columns = 0;
};

/// The size that a C++ type states.
[[nodiscard]] std::optional<MatrixSize> size_of_type(const std::string& type);

/// Assignments by the names of the variables.
struct Assignments {
  std::map<std::string, Words> first_values;
  std::map<std::string, Words> last_values;
  std::map<std::string, std::map<std::pair<std::size_t, std::size_t>, Words>> elements;  ///< from 0
  std::map<std::string, Words> streamed;      ///< `a, b` of `A << a, b`
  std::map<std::string, std::string> types;   ///< as declared
  std::map<std::string, MatrixSize> lengths;  ///< `[2][2]` of `double A[2][2]`
  /// Arguments, and the variables that take their elements in order, or their members by name.
  std::map<std::string, std::vector<std::string>> unpacked;
  std::set<std::string> unpacked_by_name;
  Words returned;
};

/// A statement `x, y = q` with an argument `q` gives its variables meanings; their words are added
/// to `more_words`.
[[nodiscard]] Assignments assignments_of(const Source& source, Language language,
                                         const std::vector<std::string>& arguments,
                                         std::vector<std::vector<Word>>& more_words);

}  // namespace assur::generator::audit::init
