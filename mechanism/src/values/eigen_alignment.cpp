// Symbol for the alignment of Eigen's matrices in the library, which programs must match.
#include <assur/mechanism/eigen_alignment.hpp>

namespace assur::mechanism {

template <>
const bool LibraryForEigenAlignment<EIGEN_DEFAULT_ALIGN_BYTES>::exists = true;

}  // namespace assur::mechanism
