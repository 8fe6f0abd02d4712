#include "structure/printed_table.hpp"

namespace assur::generator::structure {

const std::vector<PrintedRow>* printed_table(const Group& group) {
  // Copied as printed: rows 9, 14, 15 and 18 contain misprints, which the catalogue reports.
  static const std::vector<PrintedRow> tetrad = {
      {1, {"RRR-RRR"}, "3"},
      {2, {"RPR-RRR", "RRP-RRR", "RRR-RPR", "RRR-RRP"}, "3"},
      {3, {"RPR-RRP", "RRP-RPR"}, "3"},
      {4, {"RPR-RPR", "RRP-RRP"}, "3"},
      {5, {"RPP-RRR", "RRR-RPP"}, "3"},
      {6, {"RPP-RPR", "RPP-RRP", "RPR-RPP", "RRP-RPP"}, "3"},
      {7, {"RPP-RPP"}, "3"},
      {8, {"PRR-RRR", "RRR-PRR"}, "3"},
      {9, {"PRR-RPR", "PRR-RRP", "PPR-PRR", "RRP-PRR"}, "3"},
      {10, {"PRR-RPP", "RPP-PRR"}, "3"},
      {11, {"PRR-PRR"}, "3"},
      {12, {"PPR-RRP", "RRP-PPR", "PRP-RPR", "RPR-PRP"}, "3+4"},
      {13, {"PPR-RRR", "PRP-RRR", "RRR-PPR", "RRR-PRP"}, "3"},
      {14, {"PPR-RPP", "RPR-PPR", "PRP-RRP", "RRP-PRP"}, "3"},
      {15, {"PPR-RPR", "PRP-RPP", "RPP-PPR", "RPP-PRP"}, "3+4"},
      {16, {"PPR-PRR", "PRP-PRR", "PRR-PPR", "PRR-PRP"}, "3+4"},
      {17, {"PPR-PRP", "PRP-PPR"}, "4"},
      {18, {"PPR-PPR", "PRP-PRR"}, "3+4"},
      {19, {"PPP-RRR", "RRR-PPP"}, "3"},
      {20, {"PPP-RPR", "PPP-RRP", "RPR-PPP", "RRP-PPP"}, "3+4"},
      {21, {"PPP-RPP", "RPP-PPP"}, "4"},
      {22, {"PPP-PRR", "PRR-PPP"}, "4"},
      {23, {"PPP-PPR", "PPP-PRP", "PPR-PPP", "PRP-PPP"}, "4"},
      {24, {"PPP-PPP"}, "4"},
  };
  return group.name() == "tetrad" ? &tetrad : nullptr;
}

}  // namespace assur::generator::structure
