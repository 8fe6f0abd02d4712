// The arguments of a function, and a name for each number in them.
#pragma once

#include "audit/init/function_assignments.hpp"

namespace assur::generator::audit::init {

/// An argument of a function.
struct Argument {
  enum class Kind : unsigned char { number, list, object, output };

  std::string name;
  std::string type;  ///< as it is declared, without `const`, `&` and the size of an array
  Kind kind = Kind::number;
  bool is_array = false;           ///< `q[2]` or `*q`
  std::vector<std::string> parts;  ///< a name for each number; for an object, its members
  std::vector<std::string> members;
  std::size_t size = 0;  ///< for a list
};

/// The arguments of a function's head; their numbers have no names yet.
[[nodiscard]] std::vector<Argument> declared_arguments(Words parameters, Language language);

/// The argument of that name, or nullptr.
[[nodiscard]] const Argument* find_argument(const std::vector<Argument>& arguments,
                                            const std::string& name);

/// Names the parts of lists and objects, in the order of their indices or members, by the
/// statements that read them. `records`: structures of C++ and C, with their members.
void name_parts(std::vector<Argument>& arguments, const Source& source, Language language,
                const Assignments& assignments,
                const std::map<std::string, std::vector<std::string>>& records);

/// Gives an argument with parts the same parts in all functions that have an argument of that name,
/// also where they only pass it on.
void unite_arguments(const std::vector<std::span<Argument>>& functions, Language language);

}  // namespace assur::generator::audit::init
