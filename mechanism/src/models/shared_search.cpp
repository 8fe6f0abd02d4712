// Compiles what the searches of all models share.
#define ASSUR_SHARED_SEARCH template
#include <assur/support/shared_search.hpp>
