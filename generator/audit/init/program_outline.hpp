// The functions of a program: their arguments, and the positions or matrices that they return.
#pragma once

#include "audit/init/given_matrix.hpp"

namespace assur::generator::audit::init {

struct ProgramFunction {
  std::string name;
  std::vector<Argument> arguments;
  std::vector<Given> given;             ///< several if it returns several matrices or columns
  std::map<std::string, Words> locals;  ///< variables and their assigned words
  std::string space;                    ///< the enclosing namespace of C++
  std::set<std::string> angles;         ///< symbols whose sine or cosine it takes

  [[nodiscard]] std::vector<std::string> symbols() const;
};

struct ProgramOutline {
  std::vector<ProgramFunction> functions;  ///< the functions that rows of an audit file may call
  bool has_numpy = false;                  ///< imported as `np`
  bool of_symbols = false;                 ///< the one function is a module of SymPy
  std::vector<Word> words;                 ///< storage of the words that everything else refers to
  std::vector<std::vector<Word>> more_words;
};

[[nodiscard]] ProgramOutline program_outline(const std::string& code, Language language);

/// `a`, `p.r`, `q[0]` or `q(1)` at a place as the name of a symbol, `p_r`, `q_0`, and its end.
struct SymbolAt {
  std::string name;
  std::size_t end;
};
[[nodiscard]] SymbolAt symbol_at(Words words, std::size_t at);

}  // namespace assur::generator::audit::init
