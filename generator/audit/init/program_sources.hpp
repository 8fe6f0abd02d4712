// The functions of a program as written: heads and statements.
#pragma once

#include <map>

#include "audit/init/program_words.hpp"

namespace assur::generator::audit::init {

/// A function's head and the statements of its body.
struct Source {
  std::string name;
  std::string space;  ///< the namespace around it
  Words head;         ///< the tokens before the name: the return type
  Words parameters;
  std::vector<std::string> outputs;  ///< for MATLAB
  std::vector<Words> statements;
};

struct ProgramSources {
  std::vector<Source> functions;
  std::map<std::string, std::vector<std::string>> records;  ///< types of C++ and C, their members
  std::vector<std::vector<Word>> more_words;                ///< words that are not in the file
};

/// The functions that rows of an audit file may call. The words must outlive the result.
[[nodiscard]] ProgramSources program_sources(Words words, Language language);

}  // namespace assur::generator::audit::init
