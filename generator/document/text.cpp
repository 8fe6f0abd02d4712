// Renders a derivation as text that is also an audit file.
#include <algorithm>
#include <assur/text/names.hpp>
#include <sstream>

#include "document/document.hpp"
#include "document/phrases.hpp"
#include "document/render.hpp"

namespace assur::generator::document {

namespace {

constexpr std::size_t line_width = 100;

/// A line broken at spaces, or before a factor if a product is too long; every line after the first
/// begins with `lead`.
std::string broken(const std::string& line, const std::string& lead) {
  std::string text;
  std::string rest = line;
  while (rest.size() > line_width) {
    std::size_t at = rest.rfind(' ', line_width);
    // A sign stays with the term after it.
    while (at != std::string::npos && at > lead.size() &&
           std::string("+-").find(rest[at - 1]) != std::string::npos && rest[at - 2] == ' ') {
      at = rest.rfind(' ', at - 1);
    }
    std::size_t next = at + 1;
    if (at == std::string::npos || at <= lead.size()) {
      next = rest.rfind('*', line_width - 1);
      if (next == std::string::npos || next <= lead.size()) {
        break;
      }
      at = next - 1;
    }
    text += rest.substr(0, rest.find_last_not_of(' ', at) + 1) + "\n";
    rest = lead + rest.substr(next);
  }
  return text + rest + "\n";
}

/// Prose without backquotes.
std::string plain(std::string text) {
  std::erase(text, '`');
  return text;
}

std::string comment(const std::string& line) { return broken("# " + line, "# "); }
std::string statement(const std::string& line) { return broken(line, "    "); }

class TextRenderer {
 public:
  std::string run(const Document& document) {
    text_ = comment(document.title);
    if (document.is_audited) {
      text_ += "# An audit file: statements are results, and comments are the steps to them.\n";
      text_ += "source assur derive " + document.kind + "\n";
      text_ += "model " + document.kind + "\n";
    } else {
      text_ += "# To read: only models that have a number can be audited.\n";
    }
    int number = 0;
    for (const Section& section : document.sections) {
      const std::string title = std::to_string(++number) + " " + section.title;
      text_ += "\n# " + title + "\n# " + std::string(title.size(), '-') + "\n";
      for (const Block& block : section.blocks) {
        std::visit([&](const auto& each) { show(each); }, block);
      }
    }
    return std::move(text_);
  }

 private:
  void show(const Prose& prose) { text_ += comment(plain(prose.text)); }
  void show(const Heading& heading) {
    separate();
    text_ += comment(heading.text);
  }
  /// Adds an empty comment line, unless the text ends with one.
  void separate() { text_ += text_.ends_with("\n#\n") ? "" : "#\n"; }

  void show(const Table& table) {
    std::vector<std::size_t> widths;
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
      widths.push_back(table.columns[column].title.size());
      for (const auto& row : table.rows) {
        widths.back() = std::max(widths.back(), row[column].size());
      }
    }
    std::vector<std::string> titles;
    for (const Table::Column& column : table.columns) {
      titles.push_back(column.title);
    }
    const auto line = [&](const std::vector<std::string>& cells) {
      std::string text = "#   ";
      std::string indentation = "#   ";
      for (std::size_t column = 0; column < cells.size(); ++column) {
        text += cells[column];
        if (column + 1 < cells.size()) {
          text += std::string(widths[column] - cells[column].size() + 2, ' ');
          indentation += std::string(widths[column] + 2, ' ');
        }
      }
      text_ += broken(text, indentation.size() < line_width / 2 ? indentation : "#       ");
    };
    separate();
    line(titles);
    for (const auto& row : table.rows) {
      line(row);
    }
    separate();
  }

  void show(const Definitions& definitions) {
    for (const DerivedQuantity& quantity : definitions.quantities) {
      const std::string line = "let " + quantity.name + " = " + quantity.value;
      const std::string meaning = quantity.meaning + (quantity.vanishes ? ": zero" : "");
      if (line.size() + 4 + meaning.size() <= line_width) {
        text_ += line + "  # " + meaning + "\n";
      } else {
        text_ += comment(quantity.name + ": " + meaning) + statement(line);
      }
      if (quantity.vanishes) {
        text_ += "printed equation " + quantity.name + " : " + quantity.name + " = 0\n";
      }
    }
  }

  void show(const Given& given) {
    text_ += statement("length " + text::joined(given.names, " ") + " : " + given.meaning);
  }
  void show(const Equation& equation) {
    text_ += statement("printed equation (" + std::to_string(equation.number) +
                       ") : " + equation.value + " = 0");
  }

  void show(const Formula& formula) {
    text_ +=
        broken("#   " + formula.text + "   (" + std::to_string(formula.number) + ")", "#       ");
  }
  void show(const ScalarClosure& closure) {
    text_ += statement("printed closure (" + std::to_string(closure.number) + ") " + closure.name +
                       " : " + closure.value + " = 0");
  }

  void show(const MatrixDisplay& display) {
    const DerivedMatrix& matrix = display.matrix;
    const std::string number = "(" + std::to_string(display.number) + ")";
    if (display.derivatives) {
      // Every line after the first is read as a row, so the first is never broken.
      text_ += "# " + number + "\nprinted matrix " + matrix.name + " of " +
               text::joined(matrix.rows, " ") + " by " + text::joined(matrix.columns, " ") + "\n";
      for (const auto& row : matrix.entries) {
        text_ += "  " + text::joined(row, ", ") + "\n";
      }
      return;
    }
    Table table{{{number, false}}, {}};
    for (const std::string& column : matrix.columns) {
      table.columns.push_back({column, true});
    }
    for (std::size_t row = 0; row < matrix.rows.size(); ++row) {
      table.rows.push_back({matrix.rows[row]});
      table.rows.back().insert(table.rows.back().end(), matrix.entries[row].begin(),
                               matrix.entries[row].end());
    }
    show(table);
  }

  std::string text_;
};

}  // namespace

std::string derivation_text(const Derivation& derivation) {
  return TextRenderer().run(document_of(derivation));
}

}  // namespace assur::generator::document
