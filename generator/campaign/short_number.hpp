// Turns a number into the fewest digits that tell it from all others.
#pragma once

namespace assur::generator::campaign {

/// Writes what `std::to_chars(at, at + 32, number)` writes, and returns its end. Numbers of a
/// common size, with as many digits as most results have, take a third of the time.
[[nodiscard]] char* put_shortest(double number, char* at);

}  // namespace assur::generator::campaign
