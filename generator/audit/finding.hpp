// The findings of an audit: the printed items of a source and the verdict on each.
#pragma once

#include <string>
#include <vector>

#include "audit/comparison.hpp"
#include "closures/statement.hpp"

namespace assur::generator::audit {

/// One printed entry, equation, kind or number, and its comparison with the derivation.
struct Finding {
  std::string item;  ///< `(4,3) d f4/d a3`
  closures::Place place;
  Comparison comparison;
  std::string printed;
  std::string derived;
  std::string note;    ///< an explanation of the difference, if there is one
  std::string line{};  ///< the line of the file at the place, for display

  [[nodiscard]] bool agrees() const { return comparison.verdict == Verdict::agrees; }
  [[nodiscard]] bool is_wrong() const {
    return comparison.verdict == Verdict::differs ||
           comparison.verdict == Verdict::differs_by_sign || comparison.verdict == Verdict::fails;
  }
};

/// The findings of one `printed` statement; those of a matrix are row by row.
struct AuditedStatement {
  std::string label;  ///< `matrix (8)`
  closures::Place place;
  std::size_t columns = 0;  ///< of a matrix; zero for anything else
  std::vector<Finding> findings;
  std::string file;      ///< the file of the findings' places; empty for the audit file itself
  std::string remark{};  ///< how a program was run, and the reminder that this is not a proof
};

struct AuditReport {
  std::string file;
  std::string source;
  std::vector<AuditedStatement> statements;

  [[nodiscard]] bool agrees() const;
};

/// Fills in the findings' lines; `text` is that of the report's own file.
void quote_lines(AuditReport& report, const std::string& text);

}  // namespace assur::generator::audit
