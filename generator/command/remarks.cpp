#include "command/remarks.hpp"

#include <iostream>

namespace assur::generator::command {

namespace {

std::ostream& nowhere() {
  static std::ostream stream(nullptr);
  return stream;
}

bool& silence() {
  static bool is_silent = false;
  return is_silent;
}

}  // namespace

std::ostream& remarks() { return remarks_are_silent() ? nowhere() : std::cerr; }

void silence_remarks() { silence() = true; }

bool remarks_are_silent() { return silence(); }

}  // namespace assur::generator::command
