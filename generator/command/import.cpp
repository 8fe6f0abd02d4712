// The command `assur import`: scenes from files of other programs.
#include <assur/mechanism/imported_scene.hpp>
#include <assur/text/input_file.hpp>
#include <assur/text/quoted.hpp>
#include <filesystem>

#include "campaign/partial_file.hpp"
#include "command/commands.hpp"
#include "command/output.hpp"
#include "emission/cpp/files.hpp"

namespace assur::generator::command {

bool import_file(const ImportOptions& options) {
  const std::filesystem::path output = options.output;
  const bool is_text = mechanism::is_shared_mechanism(options.source);
  campaign::expect_writable(output);
  campaign::expect_new(output, options.replace);
  if (!is_text) {
    campaign::expect_other(output, {options.source});
  }
  const std::string name = is_text ? "the link" : options.source;
  const mechanism::ImportedScene scene = mechanism::import_scene(
      is_text ? options.source : text::read_input_file(options.source), name, options.driver);
  emission::cpp::write_files({{output.filename(), scene.text}},
                             output.has_parent_path() ? output.parent_path() : ".");
  for (const std::string& line : scene.remarks) {
    remarks() << "note: " << text::on_one_line(name) << ": " << text::on_one_line(line) << '\n';
  }
  return scene.complete;
}

}  // namespace assur::generator::command
