// Turns text into standard output, or into an error where it cannot be written.
#pragma once

#include <string>

namespace assur::generator::command {

/// Thrown when the reader has closed the pipe, as `| head` does, and wants no more output.
struct ClosedPipe {};

/// Writes to standard output. Throws InputError where that fails, because the disk is full for
/// instance, and ClosedPipe.
void print(const std::string& text);

/// Writes out what is still buffered, and throws as `print` does.
void finish_output();

}  // namespace assur::generator::command
