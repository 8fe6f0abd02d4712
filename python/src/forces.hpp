// Dictionaries of arrays from the columns of forces.
#pragma once

#include <pybind11/pybind11.h>

#include <assur/mechanism/force_columns.hpp>
#include <functional>
#include <vector>

#include "rows.hpp"

namespace assur::python {

/// The numbers from a column on, in an array of this shape, or with one more axis in front.
using ForcesAt =
    std::function<pybind11::object(std::size_t column, const std::vector<std::ptrdiff_t>& shape)>;

/// `efforts`, `joints` and `ground`, with the numbers under the names of the report.
[[nodiscard]] pybind11::dict forces_by_names(const std::vector<mechanism::ForceColumn>& columns,
                                             const ForcesAt& at);

/// The forces of rows, with `reason`; with sensitivities wanted, also these, with worst case and
/// rss. Throws NotWanted if the scene does not request forces.
[[nodiscard]] pybind11::dict forces_in(const RowsView& of, const pybind11::object& owner);

}  // namespace assur::python
