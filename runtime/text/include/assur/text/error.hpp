// The error for unusable input: one line that states the place, the fault and the remedy.
#pragma once

#include <stdexcept>

namespace assur::text {

/// Input by the user that cannot be used; the text is one line with the place, the fault and the
/// remedy.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace assur::text
