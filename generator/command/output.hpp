// Turns text into standard output, or into an error where it cannot be written.
#pragma once

#include <string>

namespace assur::generator::command {

/// Writes to standard output. Throws InputError where that fails: the disk is full, or nothing
/// reads the pipe any more.
void print(const std::string& text);

/// Writes out what is still held back, and throws as `print` does.
void finish_output();

}  // namespace assur::generator::command
