// Measures the errors and failures of every method on families of tetrads. Writes stability.json
// and the columns of the chart into a directory, and the tables of docs/reports/stability.md to
// standard output.
#include "output.hpp"

int main(int count, char** arguments) {
  using namespace assur::stability;
  if (count != 2) {
    std::cerr << "usage: stability_lab DIRECTORY\n";
    return 2;
  }
  const std::filesystem::path directory = arguments[1];
  const std::vector<Row> rows = all_rows();
  const std::vector<BadInputRow> bad = bad_input_rows();
  std::ofstream json(directory / "stability.json");
  write_json(rows, bad, json);
  if (!json.flush()) {
    std::cerr << "error: cannot write " << (directory / "stability.json").string() << '\n';
    return 2;
  }
  write_columns(rows, directory);
  write_worst(rows, std::cout);
  std::cout << '\n';
  write_bad_input(bad, std::cout);
  return 0;
}
