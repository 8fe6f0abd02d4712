// A derivation as a document: sections of prose, tables and numbered formulas in reading order.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "document/derivation.hpp"

namespace assur::generator::document {

struct Prose {
  std::string text;
};

/// The title of one step within a section.
struct Heading {
  std::string text;
};

struct Table {
  struct Column {
    std::string title;
    bool formula;  ///< the cells are formulas
  };
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;
};

/// Quantities with names.
struct Definitions {
  std::vector<DerivedQuantity> quantities;
};

/// Symbols for given numbers.
struct Given {
  std::vector<std::string> names;
  std::string meaning;
};

/// A numbered formula that is zero.
struct Equation {
  int number;
  std::string value;
};

/// A numbered formula.
struct Formula {
  int number;
  std::string text;
  bool vectors = false;  ///< its names denote vectors
};

/// A numbered scalar loop closure, name = value = 0.
struct ScalarClosure {
  int number;
  std::string name;
  std::string value;
};

/// A numbered matrix; if it is one of `derivatives`, its entries are d row / d column.
struct MatrixDisplay {
  int number;
  DerivedMatrix matrix;
  bool derivatives;
};

using Block = std::variant<Prose, Heading, Table, Definitions, Given, Equation, Formula,
                           ScalarClosure, MatrixDisplay>;

struct Section {
  std::string title;
  std::vector<Block> blocks;
};

struct Document {
  std::string title;
  std::string kind;        ///< the kind for which the equations are derived
  bool is_audited = true;  ///< whether `assur audit` reads its statements
  std::vector<Section> sections;
};

[[nodiscard]] Document document_of(const Derivation& derivation);

}  // namespace assur::generator::document
