// Turns the words of a program into its functions as they stand there: heads and statements.
#pragma once

#include <map>

#include "audit/init/program_words.hpp"

namespace assur::generator::audit::init {

/// A function's head and the statements of its body.
struct Source {
  std::string name;
  std::string space;  ///< the namespace around it
  Words head;         ///< before the name: the type of what it returns
  Words parameters;
  std::vector<std::string> outputs;  ///< of MATLAB
  std::vector<Words> statements;
};

struct ProgramSources {
  std::vector<Source> functions;
  std::map<std::string, std::vector<std::string>> records;  ///< types of C++ and C, their members
  std::vector<std::vector<Word>> more_words;                ///< that are not in the file
};

/// The functions that rows of an audit file may call. The words have to live on.
[[nodiscard]] ProgramSources program_sources(Words words, Language language);

}  // namespace assur::generator::audit::init
