// The commands for audits, pictures, emitted files and scenes, with their options.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <string>
#include <vector>

namespace assur::generator::command {

struct AuditOptions {
  std::vector<std::string> files;
  std::string map;  ///< the map of the notation of papers in LaTeX
  std::string format = "text";
  bool run = false;     ///< whether programs may be run
  std::string flags;    ///< for their compiler, separated by spaces
  double seconds = 10;  ///< the time limit of a program
  bool draft = false;   ///< the files are programs or papers; write drafts of their audit files
  std::string output;   ///< the file of a draft; empty: standard output
  bool force = false;   ///< whether that file may be replaced
};

/// Prints the reports and returns whether everything agrees.
[[nodiscard]] bool run_audit(const AuditOptions& options);

/// Writes a draft of the audit file for a program, or of the map for a paper.
void draft_audit(const AuditOptions& options);

struct DrawOptions {
  std::string scene;
  std::vector<std::string> settings;
  std::string output;     ///< the file; its extension selects the format
  int configuration = 0;  ///< 0 for all
  bool nearest = false;   ///< the configuration nearest to the scene's reference
  bool moving = false;    ///< a branch of the sweep in motion
};

/// Draws the scene and writes the file. Throws InputError for invalid input, for an unknown
/// extension, and if the file cannot be written, which is then as before.
void draw_scene(const DrawOptions& options);

struct EmitOptions {
  bool all = false;
  int model = 0;
  std::string group = "tetrad";
  std::string scene;
  std::vector<std::string> variables;  ///< of the scene's parameters
  std::vector<std::string> wants;      ///< empty: the scene's
  std::vector<std::string> with;       ///< optional functions of a model's header
  std::string interface = "cpp";       ///< cpp, c or c-float
  std::string closures;
  std::string output;
  bool check = false;
};

/// Writes the files; with `check`, prints which are missing or differ instead, and returns false if
/// there are any. Throws InputError for input that cannot be emitted.
[[nodiscard]] bool run_emit(const EmitOptions& options);

struct ImportOptions {
  std::string source;  ///< a file, or a shared link or an expression
  std::string output;
  std::string driver;  ///< of an expression of Pyslvs: the point of the driven joint
  bool replace = false;
};

/// Writes the scene, and a line to standard error for each part that it does not contain. Returns
/// whether it contains all joints and drivers. Throws InputError for input that cannot be read, and
/// if the scene cannot be written: then nothing is written.
[[nodiscard]] bool import_file(const ImportOptions& options);

struct SweepOptions {
  std::string scene;
  std::vector<std::string> settings;
  int branch = 0;          ///< only the rows of this branch; 0 for those of all, and of events
  bool nearest = false;    ///< only the rows of the branch nearest to the scene's reference
  bool unwrapped = false;  ///< angles continue by whole turns along a branch
};

/// Follows the branches over the scene's sweep, prints their rows to standard output as they are
/// computed, and returns whether the result is negative: the structure is degenerate at a step.
/// Throws InputError for invalid input, before anything is printed, except for a branch that does
/// not exist.
[[nodiscard]] bool run_sweep(const SweepOptions& options);

/// The same for a scene that is read and planned. Also throws MechanismError.
[[nodiscard]] bool print_sweep(const SweepOptions& options, const mechanism::Scene& scene,
                               const mechanism::Plan& plan);

/// Options shared with a sweep, and those of a solution only.
struct SolveOptions : SweepOptions {
  std::string format = "text";  ///< csv: over the scene's sweep, if it has one
  bool prove = false;           ///< enclose all complex configurations of every group
  bool circuits = false;        ///< also the branch and circuit of each configuration in the sweep
};

/// Solves or sweeps the scene, prints the result to standard output, and returns whether it is
/// negative: the structure is degenerate. Throws InputError for invalid input; in a sweep, before
/// anything is printed, except for a branch that does not exist.
[[nodiscard]] bool print_solution(const SolveOptions& options);

}  // namespace assur::generator::command
