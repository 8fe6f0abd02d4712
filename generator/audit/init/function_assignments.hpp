// What the statements of a function assign, and the matrices' sizes that its types say.
#pragma once

#include <map>
#include <optional>
#include <set>

#include "audit/init/program_sources.hpp"

namespace assur::generator::audit::init {

/// More entries than this are of no Jacobian that anybody audits.
inline constexpr std::size_t most_entries = 100;
/// How often one variable may stand for another.
inline constexpr int most_hops = 20;
/// Types and names of functions that are longer are none that are known here.
inline constexpr std::size_t longest_type = 200;

struct MatrixSize {
  std::size_t rows = 0;
  std::size_t columns = 0;
};

/// The size that a type of C++ says.
[[nodiscard]] std::optional<MatrixSize> size_of_type(const std::string& type);

/// By the names of the variables.
struct Assignments {
  std::map<std::string, Words> first_values;
  std::map<std::string, Words> last_values;
  std::map<std::string, std::map<std::pair<std::size_t, std::size_t>, Words>> elements;  ///< from 0
  std::map<std::string, Words> streamed;      ///< `a, b` of `A << a, b`
  std::map<std::string, std::string> types;   ///< as they are declared
  std::map<std::string, MatrixSize> lengths;  ///< `[2][2]` of `double A[2][2]`
  /// Arguments, and the variables that take their elements in order, or their members by name.
  std::map<std::string, std::vector<std::string>> unpacked;
  std::set<std::string> unpacked_by_name;
  Words returned;
};

/// What the variables of a statement `x, y = q` stand for, with an argument `q`, becomes more
/// words.
[[nodiscard]] Assignments assignments_of(const Source& source, Language language,
                                         const std::vector<std::string>& arguments,
                                         std::vector<std::vector<Word>>& more_words);

}  // namespace assur::generator::audit::init
