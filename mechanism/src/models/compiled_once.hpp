// Turns what the searches of all models share into code of one object instead of each.
#pragma once

#include <assur/assembly.hpp>

extern template class assur::detail::SpecialSearch<double>;
extern template assur::detail::FirstValues assur::detail::first_values(
    const assur::TrigonometricPolynomial<assur::numeric::Bounded<assur::numeric::DoubleDouble>,
                                         1>&);
extern template assur::detail::FirstValues assur::detail::first_values(
    const assur::TrigonometricPolynomial<assur::numeric::Bounded<assur::numeric::DoubleDouble>,
                                         2>&);
extern template assur::detail::FirstValues assur::detail::first_values(
    const assur::TrigonometricPolynomial<assur::numeric::Bounded<assur::numeric::DoubleDouble>,
                                         3>&);
extern template assur::detail::FirstValues assur::detail::first_values(
    const assur::Vector<assur::numeric::Bounded<assur::numeric::DoubleDouble>, 2>&);
extern template assur::detail::FirstValues assur::detail::first_values(
    const assur::Vector<assur::numeric::Bounded<assur::numeric::DoubleDouble>, 3>&);
extern template assur::numeric::TrigonometricRoots<double, 1> assur::numeric::trigonometric_roots(
    const assur::TrigonometricPolynomial<double, 1>&, double);
extern template assur::numeric::TrigonometricRoots<double, 2> assur::numeric::trigonometric_roots(
    const assur::TrigonometricPolynomial<double, 2>&, double);
extern template assur::numeric::TrigonometricRoots<double, 3> assur::numeric::trigonometric_roots(
    const assur::TrigonometricPolynomial<double, 3>&, double);
extern template assur::numeric::SecondCandidates<double> assur::numeric::second_candidates(
    const assur::Matrix<double, 2, 3>&);
extern template assur::numeric::SecondCandidates<assur::Direction<double>>
assur::numeric::second_candidates(const assur::Matrix<double, 2, 3>&);
extern template assur::numeric::SecondCandidates<assur::numeric::DoubleDouble>
assur::numeric::second_candidates(const assur::Matrix<assur::numeric::DoubleDouble, 2, 3>&);
extern template assur::numeric::SecondCandidates<assur::Direction<assur::numeric::DoubleDouble>>
assur::numeric::second_candidates(const assur::Matrix<assur::numeric::DoubleDouble, 2, 3>&);
