// One-line messages for command lines that CLI11 rejects.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace assur::generator::command {

/// The subcommand, if there is one, the error, and where to find help. `words` is the command line
/// without the program's name.
[[nodiscard]] std::string command_line_error(const CLI::App& app, const CLI::ParseError& error,
                                             const std::vector<std::string>& words);

}  // namespace assur::generator::command
