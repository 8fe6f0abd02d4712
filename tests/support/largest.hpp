// The largest of many errors; NaN is not overlooked.
#pragma once

namespace assur::test {

/// The larger of both; NaN if the new value is NaN, which std::max would drop.
template <typename Number>
[[nodiscard]] Number largest(Number so_far, Number value) {
  return value <= so_far ? so_far : value;
}

}  // namespace assur::test
