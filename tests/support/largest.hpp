// Keeps the largest of many errors, and does not let one that is no number pass unseen.
#pragma once

namespace assur::test {

/// The larger of both; NaN if the new value is NaN, which std::max would drop.
template <typename Number>
[[nodiscard]] Number largest(Number so_far, Number value) {
  return value <= so_far ? so_far : value;
}

}  // namespace assur::test
