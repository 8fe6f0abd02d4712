// Explicit instantiations of the code that the searches of all models share: declarations, or in
// one file of a program definitions. A program that instantiates many models includes this in each
// of its files, and in one of them after `#define ASSUR_SHARED_SEARCH template`.
#pragma once

#include <assur/assembly.hpp>

#ifndef ASSUR_SHARED_SEARCH
#define ASSUR_SHARED_SEARCH extern template
#endif

ASSUR_SHARED_SEARCH class assur::detail::SpecialSearch<assur::detail::SpecialGroup>;
ASSUR_SHARED_SEARCH assur::detail::FirstValues assur::detail::first_values(
    const assur::TrigonometricPolynomial<assur::numeric::Bounded<assur::numeric::DoubleDouble>,
                                         1>&);
ASSUR_SHARED_SEARCH assur::detail::FirstValues assur::detail::first_values(
    const assur::TrigonometricPolynomial<assur::numeric::Bounded<assur::numeric::DoubleDouble>,
                                         2>&);
ASSUR_SHARED_SEARCH assur::detail::FirstValues assur::detail::first_values(
    const assur::TrigonometricPolynomial<assur::numeric::Bounded<assur::numeric::DoubleDouble>,
                                         3>&);
ASSUR_SHARED_SEARCH assur::detail::FirstValues assur::detail::first_values(
    const assur::Vector<assur::numeric::Bounded<assur::numeric::DoubleDouble>, 2>&);
ASSUR_SHARED_SEARCH assur::detail::FirstValues assur::detail::first_values(
    const assur::Vector<assur::numeric::Bounded<assur::numeric::DoubleDouble>, 3>&);
ASSUR_SHARED_SEARCH assur::numeric::TrigonometricRoots<double, 1>
assur::numeric::trigonometric_roots(const assur::TrigonometricPolynomial<double, 1>&, double);
ASSUR_SHARED_SEARCH assur::numeric::TrigonometricRoots<double, 2>
assur::numeric::trigonometric_roots(const assur::TrigonometricPolynomial<double, 2>&, double);
ASSUR_SHARED_SEARCH assur::numeric::TrigonometricRoots<double, 3>
assur::numeric::trigonometric_roots(const assur::TrigonometricPolynomial<double, 3>&, double);
ASSUR_SHARED_SEARCH assur::numeric::SecondCandidates<double> assur::numeric::second_candidates(
    const assur::Matrix<double, 2, 3>&);
ASSUR_SHARED_SEARCH assur::numeric::SecondCandidates<assur::Direction<double>>
assur::numeric::second_candidates(const assur::Matrix<double, 2, 3>&);
ASSUR_SHARED_SEARCH assur::numeric::SecondCandidates<assur::numeric::DoubleDouble>
assur::numeric::second_candidates(const assur::Matrix<assur::numeric::DoubleDouble, 2, 3>&);
ASSUR_SHARED_SEARCH assur::numeric::SecondCandidates<assur::Direction<assur::numeric::DoubleDouble>>
assur::numeric::second_candidates(const assur::Matrix<assur::numeric::DoubleDouble, 2, 3>&);

#undef ASSUR_SHARED_SEARCH
