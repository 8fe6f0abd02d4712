// Turns families of tetrads into the configurations that each method loses and invents:
// stability_configurations.json and the columns of the chart, into a directory; the table of
// docs/stability.md, on standard output.
#include "output.hpp"

int main(int count, char** arguments) {
  using namespace assur::stability;
  if (count != 2) {
    std::cerr << "usage: configurations_lab DIRECTORY\n";
    return 2;
  }
  const std::filesystem::path directory = arguments[1];
  std::vector<ListingRow> rows;
  bool is_vouched = true;
  std::apply(
      [&](auto... family) {
        ((is_vouched = append_listing_rows<decltype(family)>(rows) && is_vouched), ...);
      },
      ConfigurationFamilies{});
  if (!is_vouched) {
    std::cerr << "error: Sturm's theorem counts otherwise than the truth\n";
    return 1;
  }
  const std::filesystem::path file = directory / "stability_configurations.json";
  std::ofstream json(file);
  write_listing_json(rows, json);
  if (!json.flush()) {
    std::cerr << "error: cannot write " << file.string() << '\n';
    return 2;
  }
  write_listing_columns(rows, directory);
  std::cout << "seed " << seed << "\n\n";
  write_listing_table(rows, std::cout);
  return 0;
}
