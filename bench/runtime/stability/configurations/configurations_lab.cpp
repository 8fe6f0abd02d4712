// Counts the configurations that each method loses and invents on families of tetrads. Writes
// stability_configurations.json and the columns of the chart into a directory, and the table of
// docs/reports/stability.md to standard output.
#include "output.hpp"

namespace assur::stability {
namespace {

/// The library, and the root finders of the speed chart, which complete and polish each root of the
/// same polynomial. Newton's iteration from many starts does not use it.
template <typename Model>
[[nodiscard]] std::vector<ListingMethod<Model>> listing_methods() {
  using Sample = speed::PositionSample<Model>;
  using T = speed::Polynomial<Model>;
  return {
      {"generated", speed::closed_form<Model>},
      {"companion eigenvalues",
       [](const Sample& sample) {
         return speed::from_roots<Model>(sample, speed::patient_effort, [](const T& t) {
           return test::companion_roots(t, speed::nearly_real);
         });
       }},
      {"half-angle polynomial",
       [](const Sample& sample) {
         return speed::from_roots<Model>(sample, speed::patient_effort,
                                         [](const T& t) { return speed::half_angle_roots(t); });
       }},
      {"grid of 360",
       [](const Sample& sample) {
         return speed::from_roots<Model>(sample, speed::patient_effort,
                                         [](const T& t) { return test::subdivision_roots(t); });
       }},
      {"Newton from 64 starts",
       [](const Sample& sample) {
         return speed::MultiStartNewton<Model>::find(sample, speed::patient_effort);
       }},
  };
}

}  // namespace
}  // namespace assur::stability

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
        ((is_vouched = append_listing_rows<decltype(family)>(
                           listing_methods<typename decltype(family)::Model>(), rows) &&
                       is_vouched),
         ...);
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
