// Renders a derivation as a LaTeX document.
#include <algorithm>
#include <assur/text/names.hpp>
#include <vector>

#include "document/document.hpp"
#include "document/latex_formula.hpp"
#include "document/phrases.hpp"
#include "document/render.hpp"

namespace assur::generator::document {

namespace {

constexpr double text_width = 44;  ///< in ems

// Formulas are paragraphs in math mode, which TeX breaks before signs if they are too long for a
// line.
const std::string preamble = R"(\documentclass[10pt,a4paper]{article}
\usepackage{amsmath}
\usepackage[margin=22mm]{geometry}
\setlength{\parindent}{0pt}
\setlength{\parskip}{3pt plus 1pt}
\setlength{\emergencystretch}{3em}
\binoppenalty=10000
\relpenalty=500
\renewcommand{\arraystretch}{1.35}
\setlength{\arraycolsep}{3pt}
\newcommand{\numbered}[2]{{\raggedright\hangindent=4em\hangafter=1\leftskip=1.5em
  $\displaystyle #1$\hspace*{\fill}\mbox{\quad(#2)}\par}}
\newcommand{\defined}[2]{{\raggedright\hangindent=4em\hangafter=1\leftskip=1.5em
  $\displaystyle #1$\quad{\footnotesize\itshape #2}\par}}
)";

class LatexRenderer {
 public:
  std::string run(const Document& document) {
    text_ = preamble + "\\begin{document}\n{\\Large\\bfseries " + latex_prose(document.title) +
            "\\par}\n";
    for (const Section& section : document.sections) {
      text_ += "\n\\section{" + section.title + "}\n";
      for (const Block& block : section.blocks) {
        std::visit([&](const auto& each) { show(each); }, block);
      }
    }
    return text_ + "\\end{document}\n";
  }

 private:
  void show(const Prose& prose) { text_ += latex_prose(prose.text) + "\\par\n"; }
  void show(const Heading& heading) {
    text_ += "\\subsection*{" + latex_prose(heading.text) + "}\n";
  }

  void show(const Table& table) {
    constexpr double widest_plain = 16;
    const auto plain_width = [](const std::string& cell) {
      constexpr double letter = 0.47;
      return letter * static_cast<double>(cell.size());
    };
    std::string columns;
    double left = text_width;
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
      const Table::Column& of = table.columns[column];
      double width = plain_width(of.title);
      for (const auto& row : table.rows) {
        width = std::max(width, of.formula ? formula_width(row[column]) : plain_width(row[column]));
      }
      const double most = column + 1 == table.columns.size() ? left - 2 : widest_plain;
      columns += width <= most ? "l" : paragraph(most);
      left -= std::min(width, widest_plain) + 1.5;
    }
    text_ += "\\medskip\\begin{tabular}{" + columns + "}\n";
    std::vector<std::string> titles;
    for (const Table::Column& column : table.columns) {
      titles.push_back("\\textit{" + latex_prose(column.title) + "}");
    }
    text_ += text::joined(titles, " & ") + " \\\\\n\\hline\n";
    for (const auto& row : table.rows) {
      std::vector<std::string> cells;
      for (std::size_t column = 0; column < row.size(); ++column) {
        cells.push_back((table.columns[column].formula ? "$" + latex_formula(row[column]) + "$"
                                                       : latex_prose(row[column])));
      }
      text_ += text::joined(cells, " & ") + " \\tabularnewline\n";
    }
    text_ += "\\end{tabular}\\par\\medskip\n";
  }

  /// A column whose cells are broken at a given width.
  static std::string paragraph(double width) {
    return "p{" + std::to_string(static_cast<int>(std::max(width, 8.0))) + "em}";
  }

  void show(const Definitions& definitions) {
    for (const DerivedQuantity& quantity : definitions.quantities) {
      text_ += "\\defined{" + latex_formula(quantity.name + " = " + quantity.value) +
               (quantity.vanishes ? " = 0" : "") + "}{" + latex_prose(quantity.meaning) + "}\n";
    }
  }

  void show(const Given& given) {
    text_ += "\\defined{" +
             text::joined(given.names, ",\\; ",
                          [](const std::string& name) { return latex_formula(name); }) +
             "}{" + latex_prose(given.meaning) + "}\n";
  }
  void show(const Equation& equation) {
    numbered(latex_formula(equation.value + " = 0"), equation.number);
  }

  void numbered(const std::string& latex, int number) {
    text_ += "\\numbered{" + latex + "}{" + std::to_string(number) + "}\n";
  }
  void show(const Formula& formula) {
    numbered(formula.vectors ? latex_vectors(formula.text) : latex_formula(formula.text),
             formula.number);
  }
  void show(const ScalarClosure& closure) {
    numbered(latex_formula(closure.name + " = " + closure.value + " = 0"), closure.number);
  }

  /// A matrix as an array if it fits, else one column per line.
  void show(const MatrixDisplay& display) {
    const DerivedMatrix& matrix = display.matrix;
    double width = display.derivatives ? 7 : 11;
    for (std::size_t column = 0; column < matrix.columns.size(); ++column) {
      double widest = formula_width(matrix.columns[column]);
      for (const auto& row : matrix.entries) {
        widest = std::max(widest, formula_width(row[column]));
      }
      width += widest + 0.7;
    }
    if (width > text_width) {
      show_columns(display);
      return;
    }
    // Names of framed components have marks above and below.
    std::string latex = display.derivatives ? "" : "\\renewcommand{\\arraystretch}{1.6}";
    latex += latex_formula(matrix.name) + " = \\begin{array}{c|" +
             std::string(matrix.columns.size(), 'c') + "}\n";
    for (const std::string& column : matrix.columns) {
      latex += " & " + latex_formula(column);
    }
    latex += " \\\\\n\\hline\n";
    for (std::size_t row = 0; row < matrix.rows.size(); ++row) {
      latex += row_title(display, row);
      for (const std::string& entry : matrix.entries[row]) {
        latex += " & " + (entry == "0" ? "" : latex_formula(entry));
      }
      latex += " \\\\\n";
    }
    numbered(latex + "\\end{array}", display.number);
  }

  /// `f_{1}`, or in words `along slide_C` for `along_slide_C`.
  static std::string row_title(const MatrixDisplay& display, std::size_t row) {
    const std::string& name = display.matrix.rows[row];
    const std::size_t at = name.find('_');
    return display.derivatives
               ? latex_formula(name)
               : "\\text{" + name.substr(0, at) + " $" + latex_formula(name.substr(at + 1)) + "$}";
  }

  void show_columns(const MatrixDisplay& display) {
    const DerivedMatrix& matrix = display.matrix;
    for (std::size_t column = 0; column < matrix.columns.size(); ++column) {
      std::vector<std::string> entries;
      for (const auto& row : matrix.entries) {
        entries.push_back(latex_formula(row[column]));
      }
      const std::string variable = latex_formula(matrix.columns[column]);
      const std::string left = display.derivatives
                                   ? "\\partial f/\\partial " + variable
                                   : latex_formula(matrix.name) + "_{" + variable + "}";
      const std::string latex =
          left + " = (" + text::joined(entries, ",\\allowbreak\\; ") + ")^{\\mathrm{T}}";
      if (column == 0) {
        numbered(latex, display.number);
      } else {
        text_ += "\\defined{" + latex + "}{}\n";
      }
    }
  }

  std::string text_;
};

}  // namespace

std::string derivation_latex(const Derivation& derivation) {
  return LatexRenderer().run(document_of(derivation));
}

}  // namespace assur::generator::document
