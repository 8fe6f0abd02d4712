// The subcommands of `assur` with their options.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace assur::generator::command {

/// The exit statuses of a command that has done its work: the answer may be negative.
inline constexpr int exit_done = 0;
inline constexpr int exit_negative = 1;

/// The action that the command line selects; returns an exit status.
using Chosen = std::function<int()>;

/// Adds every subcommand with its options; when `app` parses a command line, `chosen` becomes the
/// action of the subcommand named there. It throws what the subcommands throw.
void add_subcommands(CLI::App& app, Chosen& chosen);

}  // namespace assur::generator::command
