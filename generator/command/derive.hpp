// The kind that the argument of `assur derive` names.
#pragma once

#include <string>

#include "structure/kind.hpp"

namespace assur::generator::command {

struct DeriveOptions {
  std::string what;   ///< a model's number, or a kind
  std::string group;  ///< empty: the tetrad for a number, the group with that spelling for a kind
  std::string format = "text";
};

struct ChosenKind {
  const structure::Group* group;
  structure::Kind kind;
};

/// The kind that the options name; throws InputError if there is none, or more than one.
[[nodiscard]] ChosenKind chosen_kind(const DeriveOptions& options);

}  // namespace assur::generator::command
