// Turns the last equations and the final polynomial into steps for people to read and to check.
#pragma once

#include <array>
#include <vector>

#include "elimination/record.hpp"

namespace assur::generator::elimination {

/// Two equations as polynomials in `second`, with coefficients that contain no unknown but `first`.
[[nodiscard]] RecordedStep ordered_by_second(const std::vector<std::array<GiNaC::ex, 3>>& equations,
                                             const equations::Variable& second,
                                             const equations::Variable& first);

/// The coefficients of the final polynomial; its only formula is the polynomial in their names.
/// Above its degree, up to `formal_degree`, coefficients were found to vanish.
[[nodiscard]] RecordedStep final_coefficients(const std::vector<equations::Vector2>& polynomial,
                                              const equations::Variable& unknown,
                                              std::size_t formal_degree);

/// (1 + t^2)^n T with cos kx + i sin kx = ((1 + i t)^2 / (1 + t^2))^k, t = tan(x/2), from the
/// quantities of `final_coefficients`.
[[nodiscard]] RecordedStep half_angle_form(const std::vector<RecordedQuantity>& coefficients,
                                           const equations::Variable& unknown);

}  // namespace assur::generator::elimination
