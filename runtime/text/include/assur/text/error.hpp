// Turns input that cannot be used into one line: where, what is wrong, and the remedy.
#pragma once

#include <stdexcept>

namespace assur::text {

/// The user's input cannot be used; the text is one line: where, what and the remedy.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace assur::text
