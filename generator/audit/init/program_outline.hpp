// Turns the words of a program into its functions: what they take, and the positions or matrices
// that they give.
#pragma once

#include <map>
#include <set>

#include "audit/init/program_words.hpp"

namespace assur::generator::audit::init {

/// What a function takes.
struct Argument {
  enum class Kind : unsigned char { number, list, object, output };

  std::string name;
  std::string type;  ///< as it is declared, without `const`, `&` and the size of an array
  Kind kind = Kind::number;
  bool is_array = false;           ///< `q[2]` or `*q`
  std::vector<std::string> parts;  ///< names for a number each; of an object, its members
  std::vector<std::string> members;
  std::size_t size = 0;  ///< of a list
};

/// What a function gives: a column, or a matrix.
struct Given {
  std::string name;  ///< of the variable that holds it; empty if it has none
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<Words> entries;      ///< row by row; empty where they cannot be told
  std::vector<std::string> names;  ///< of the variables that are its entries; may be empty
  std::vector<std::string> by;     ///< what a matrix of `jacobian([...])` is differentiated by
};

struct ProgramFunction {
  std::string name;
  std::vector<Argument> arguments;
  std::vector<Given> given;             ///< several where it returns several matrices or columns
  std::map<std::string, Words> locals;  ///< variables and what they are set to
  std::string space;                    ///< the namespace of C++ around it
  std::set<std::string> angles;         ///< symbols whose sine or cosine it takes

  [[nodiscard]] std::vector<std::string> symbols() const;
};

struct ProgramOutline {
  std::vector<ProgramFunction> functions;  ///< those that rows of an audit file may call
  bool has_numpy = false;                  ///< imported as `np`
  bool of_symbols = false;                 ///< the one function is a module of SymPy
  std::vector<Word> words;                 ///< that all else points to
  std::vector<std::vector<Word>> more_words;
};

[[nodiscard]] ProgramOutline program_outline(const std::string& code, Language language);

/// `a`, `p.r`, `q[0]` or `q(1)` at a place as the name of a symbol, `p_r`, `q_0`, and where it
/// ends.
struct SymbolAt {
  std::string name;
  std::size_t end;
};
[[nodiscard]] SymbolAt symbol_at(Words words, std::size_t at);

}  // namespace assur::generator::audit::init
