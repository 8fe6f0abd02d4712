// Turns the subcommands of `assur` into options of a command line, and into what each of them does.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace assur::generator::command {

/// The exit statuses of a command that has done its work: the answer may be negative.
inline constexpr int exit_done = 0;
inline constexpr int exit_negative = 1;

/// What the command line asks for; returns an exit status.
using Chosen = std::function<int()>;

/// Adds every subcommand with its options; while `app` parses a command line, `chosen` becomes what
/// the one that is named there does. It throws what the subcommands throw.
void add_subcommands(CLI::App& app, Chosen& chosen);

}  // namespace assur::generator::command
