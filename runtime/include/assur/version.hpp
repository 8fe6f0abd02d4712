// Version of the runtime, as macros and as text.
#pragma once

/// The version of the headers; a minor version may change the interface, a patch does not.
#define ASSUR_VERSION_MAJOR 0
#define ASSUR_VERSION_MINOR 2
#define ASSUR_VERSION_PATCH 0

namespace assur {

/// "major.minor.patch".
inline constexpr const char* version = "0.2.0";

}  // namespace assur
