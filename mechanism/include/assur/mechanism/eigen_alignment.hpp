// Link-time check that a program and the library agree on the alignment of Eigen's matrices.
#pragma once

#include <Eigen/Core>

namespace assur::mechanism {

/// Eigen allocates matrices by the instruction set that a file is compiled for: with AVX it aligns
/// them to 32 bytes, and expects the same alignment when it frees them. The library exists for one
/// alignment; a program compiled for another fails to link with an undefined reference to this.
/// Compile both for the same instruction set (`-march`, `-mavx`).
template <int Bytes>
struct LibraryForEigenAlignment {
  static const bool exists;
};
template <>
const bool LibraryForEigenAlignment<EIGEN_DEFAULT_ALIGN_BYTES>::exists;

/// Refers to `exists` from every file that includes a header of the library. Without the attribute,
/// some compilers would leave out an unused variable, and with it the reference.
[[gnu::used]] inline const bool eigen_alignments_agree =
    LibraryForEigenAlignment<EIGEN_DEFAULT_ALIGN_BYTES>::exists;

}  // namespace assur::mechanism
