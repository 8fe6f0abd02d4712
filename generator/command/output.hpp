// Turns text into standard output, or into an error where it cannot be written.
#pragma once

#include <string>

namespace assur::generator::command {

/// Nothing reads the pipe any more, as `| head` does not: there is nobody who misses the rest.
struct ClosedPipe {};

/// Writes to standard output. Throws InputError where that fails, because the disk is full for
/// instance, and ClosedPipe.
void print(const std::string& text);

/// Writes out what is still held back, and throws as `print` does.
void finish_output();

}  // namespace assur::generator::command
