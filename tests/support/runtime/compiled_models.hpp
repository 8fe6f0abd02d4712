// Functions that many tests call for every rigid model, compiled once for all.
//
// Each is a template whose instances are in the library `compiled_models`; a test that includes
// this header instantiates nothing of the search for configurations itself.
#pragma once

#include <assur/assemblies.hpp>
#include <assur/support/displaced_frame.hpp>

namespace assur::test::compiled {

/// assur::assemblies.
template <typename Model>
[[nodiscard]] Assemblies<Model> assemblies(const typename Model::template Dimensions<double>& d,
                                           const typename Model::template Inputs<double>& u,
                                           const support::Displacement& displaced = {});

/// Returns the number of configurations that Sturm's theorem counts over rational numbers:
/// exact_assembly_count of sturm.hpp.
template <typename Model>
[[nodiscard]] int exact_assembly_count(const typename Model::template Dimensions<double>& d,
                                       const typename Model::template Inputs<double>& u);

}  // namespace assur::test::compiled
