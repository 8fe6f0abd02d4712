// The command `assur`: runs one subcommand and returns its exit status.
#include <CLI/CLI.hpp>
#include <assur/text/error.hpp>
#include <assur/text/quoted.hpp>
#include <csignal>
#include <iostream>
#include <new>
#include <string>

#include "command/command_line_error.hpp"
#include "command/output.hpp"
#include "command/ranks.hpp"
#include "command/subcommands.hpp"

namespace {

using namespace assur::generator::command;
using assur::text::InputError;

constexpr int exit_unusable = 2;

/// Prints one line, whatever the words of the command line and the names of files contain.
void print_error(const std::string& text) {
  std::cerr << "error: " << assur::text::on_one_line(text) << '\n';
}

int run(int argc, char** argv) {
  CLI::App app{"Derives the kinematics of planar linkages and emits closed-form solvers."};
  app.name("assur");
  app.set_version_flag("--version", "assur " ASSUR_VERSION);
  app.require_subcommand(1);
  Chosen chosen;
  add_subcommands(app, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    print_error(command_line_error(app, error, {argv + 1, argv + argc}));
    return exit_unusable;
  }
  return chosen();
}

}  // namespace

int main(int argc, char** argv) {
  // Writing to a closed pipe, or to a file that may not grow, must fail with an error instead of
  // ending the process by a signal.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    const int status = run(argc, argv);
    finish_output();
    return status;
  } catch (const InputError& error) {
    print_error(error.what());
  } catch (const std::bad_alloc&) {
    print_error("out of memory; compute less in one run");
  } catch (const OtherRankFailed&) {  // that rank has reported the error
  } catch (const ClosedPipe&) {       // the reader closed it on purpose
  } catch (const std::exception& error) {
    print_error(std::string("internal: ") + error.what() + "; please report this with its input");
  }
  return exit_unusable;
}
