// Turns a joint whose coordinate has no sense into the error that names it and the mend.
#pragma once

#include <assur/mechanism/error.hpp>
#include <string>

namespace assur::mechanism::description {

/// The error where `part` reads the coordinate of a joint of two links, of which nobody has said
/// from which to which it is measured; `other_mend` follows the mend.
[[nodiscard]] inline MechanismError refusal_of_measure(const std::string& part,
                                                       const std::string& joint,
                                                       const std::string& first,
                                                       const std::string& second,
                                                       const std::string& other_mend = "") {
  return {part, "the joint " + joint + " joins the moving links " + first + " and " + second +
                    R"(; say from which to which it is measured: "joints": {")" + joint +
                    R"(": {"type": "revolute", "links": [")" + first + R"(", ")" + second +
                    R"("]}})" + other_mend};
}

}  // namespace assur::mechanism::description
