// The numbers of each link, slide and output in rows, by name.
#pragma once

#include <cstddef>

#include "rows.hpp"

namespace assur::python {

/// The parts of one kind, as a mapping from names.
template <typename Part>
struct Parts {
  RowsView of;
};

/// One of these parts.
template <typename Part>
struct PartState {
  RowsView of;
  std::size_t place;
};

}  // namespace assur::python
