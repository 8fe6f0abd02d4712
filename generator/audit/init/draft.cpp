#include "audit/init/draft.hpp"

#include <assur/text/error.hpp>
#include <assur/text/input_file.hpp>
#include <sstream>

#include "audit/init/draft_text.hpp"
#include "closures/statement.hpp"

namespace assur::generator::audit::init {

std::string draft_of(const std::string& file, const std::string& named) {
  if (file.ends_with(".tex")) {
    return paper_draft(text::read_input_file(file), file);
  }
  const std::optional<Language> language = language_of_file(file);
  if (!language) {
    throw text::InputError(file +
                           ": its language is not known; --init reads .cpp, .cc, .cxx, .hpp, .h, "
                           ".c, .m, .py, .js, .mjs, .cjs and .tex");
  }
  return program_draft(text::read_input_file(file), *language, file, named);
}

void expect_filled_in(const std::string& text, const std::string& file) {
  std::istringstream lines(text);
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    if (const std::size_t at = line.find_first_not_of(" \t");
        at != std::string::npos && line.compare(at, fill_mark.size(), fill_mark) == 0) {
      throw closures::AuditSyntaxError(
          file, {number, at + 1},
          "to be filled in, and this mark removed: " + line.substr(at + fill_mark.size()));
    }
  }
}

}  // namespace assur::generator::audit::init
