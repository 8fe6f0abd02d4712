// Turns a part of a mechanism that cannot be used into one line that names it.
#pragma once

#include <assur/text/error.hpp>
#include <string>

namespace assur::mechanism {

using text::InputError;

/// A mechanism, or a value of one of its numbers, cannot be used. `what()` is one line: the part,
/// as a scene file would spell it (`joints.B.between[1]`), what is wrong, and the mend.
class MechanismError : public InputError {
 public:
  MechanismError(const std::string& part, const std::string& what)
      : InputError(one_line(part.empty() ? what : part + ": " + what)) {}

 private:
  /// Names may hold any character; a message may not.
  static std::string one_line(std::string text) {
    for (char& letter : text) {
      letter = static_cast<unsigned char>(letter) < 0x20 ? '?' : letter;
    }
    return text;
  }
};

}  // namespace assur::mechanism
