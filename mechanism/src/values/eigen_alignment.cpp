// Turns the alignment that the library is compiled with into the symbol that programs ask for.
#include <assur/mechanism/eigen_alignment.hpp>

namespace assur::mechanism {

template <>
const bool LibraryForEigenAlignment<EIGEN_DEFAULT_ALIGN_BYTES>::exists = true;

}  // namespace assur::mechanism
