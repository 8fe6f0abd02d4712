// Turns what is worth knowing beside an answer into lines on standard error, unless `--quiet` is
// given.
#pragma once

#include <ostream>

namespace assur::generator::command {

/// Standard error, or nowhere after `silence_remarks`. Errors are not remarks: always shown.
[[nodiscard]] std::ostream& remarks();

void silence_remarks();
[[nodiscard]] bool remarks_are_silent();

}  // namespace assur::generator::command
