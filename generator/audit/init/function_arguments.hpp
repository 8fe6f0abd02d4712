// The arguments of a function, and a name for each number that they hold.
#pragma once

#include "audit/init/function_assignments.hpp"

namespace assur::generator::audit::init {

/// What a function takes.
struct Argument {
  enum class Kind : unsigned char { number, list, object, output };

  std::string name;
  std::string type;  ///< as it is declared, without `const`, `&` and the size of an array
  Kind kind = Kind::number;
  bool is_array = false;           ///< `q[2]` or `*q`
  std::vector<std::string> parts;  ///< names for a number each; of an object, its members
  std::vector<std::string> members;
  std::size_t size = 0;  ///< of a list
};

/// As they stand in the function's head; their numbers have no names yet.
[[nodiscard]] std::vector<Argument> declared_arguments(Words parameters, Language language);

/// The argument of that name, or nullptr.
[[nodiscard]] const Argument* find_argument(const std::vector<Argument>& arguments,
                                            const std::string& name);

/// Names the parts of lists and objects, in the order of their indices or members, by what the
/// statements read of them. `records` are types of C++ and C, and their members.
void name_parts(std::vector<Argument>& arguments, const Source& source, Language language,
                const Assignments& assignments,
                const std::map<std::string, std::vector<std::string>>& records);

/// What has parts in one function has them in all that take it by the same name, also where they
/// only pass it on.
void unite_arguments(const std::vector<std::span<Argument>>& functions, Language language);

}  // namespace assur::generator::audit::init
