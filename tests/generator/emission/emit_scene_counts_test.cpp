// Law: every function of an emitted solver's groups performs as many operations as its header
// states, counted by a scalar that counts.
#include <gtest/gtest.h>

#include <regex>

#include "counting.hpp"
#include "generator/scene_files.hpp"
#include "generator/solver_comparison.hpp"
#include "whole_campaign.hpp"

namespace assur::test::emit_scene_counts_test {
namespace {

namespace fs = std::filesystem;

Count count_in(const std::smatch& match, std::size_t first) {
  return {std::stoi(match[first]), std::stoi(match[first + 1]), std::stoi(match[first + 2])};
}

/// The groups' structs of a header, without the solver, which costs most to compile.
std::string groups_of(const std::string& header) {
  const std::regex struct_head(R"(struct \w+Group\d+ \{)");
  std::string structs;
  for (std::sregex_iterator at(header.begin(), header.end(), struct_head), end; at != end; ++at) {
    const auto start = static_cast<std::size_t>(at->position());
    const std::string last_line = "\n};\n";
    structs += header.substr(start, header.find(last_line, start) - start) + last_line;
  }
  return structs;
}

/// What a header states of its functions: `Group1::residual`.
std::map<std::string, Count> stated_counts(const std::string& header) {
  const std::regex group(R"(/// Operations ([^.]*)\.\nstruct (\w+) \{)");
  const std::regex function(R"((\w+) (\d+), (\d+), (\d+))");
  const std::regex line_break(R"(\n/// +)");
  std::map<std::string, Count> counts;
  for (std::sregex_iterator at(header.begin(), header.end(), group), end; at != end; ++at) {
    const std::string list = std::regex_replace((*at)[1].str(), line_break, " ");
    for (std::sregex_iterator each(list.begin(), list.end(), function); each != end; ++each) {
      counts[(*at)[2].str() + "::" + (*each)[1].str()] = count_in(*each, 2);
    }
  }
  return counts;
}

/// The table of docs/reports/specialised.md: function, general model, specialised.
void compare_with_page(const std::map<std::string, Count>& stated) {
  const std::regex row(R"(\| (\w+) \| \d+, \d+, \d+ \| (\d+), (\d+), (\d+) \|)");
  std::istringstream lines(read_file(ASSUR_DOCS "/reports/specialised.md"));
  int rows = 0;
  std::string line;
  while (std::getline(lines, line)) {
    std::smatch match;
    if (std::regex_match(line, match, row)) {
      EXPECT_EQ(count_in(match, 2), stated.at("Quintero2011RrpRrrGroup1::" + match[1].str()))
          << line;
      ++rows;
    }
  }
  EXPECT_EQ(rows, 10);
}

/// Forces take the reciprocals that the rates have found, and divide by nothing themselves. Returns
/// how many groups have both.
int expect_one_division(const std::map<std::string, Count>& stated) {
  int groups = 0;
  for (const auto& [name, count] : stated) {
    const std::string group = name.substr(0, name.find("::"));
    const bool has_rates =
        stated.contains(group + "::motion") || stated.contains(group + "::velocity");
    if (name == group + "::forces" && has_rates) {
      EXPECT_EQ(count.divisions, 0) << name;
      ++groups;
    }
  }
  return groups;
}

TEST(EmitSceneCounts, AreWhatTheFunctionsOfAllExamplesDo) {
  const TemporaryDirectory directory;
  std::map<std::string, Count> stated;
  std::string structs;
  const std::set<fs::path> files = scene_files({ASSUR_EXAMPLES, ASSUR_SCENES});
  for (const fs::path& scene : share_of(std::vector<fs::path>(files.begin(), files.end()), 2)) {
    const std::string stem = scene.stem().string();
    emit_solver({scene, stem, "", {}}, directory);
    const std::string header = read_file(directory.path() / "assur/scenes" / (stem + ".hpp"));
    structs += groups_of(header);
    stated.merge(stated_counts(header));
  }
  std::string calls;
  for (const auto& [name, count] : stated) {
    calls += "  print(\"" + name + "\", &assur::scenes::" + name + "<assur::test::Counting>);\n";
  }
  const std::string head =
      "#include <assur/model.hpp>\n#include <cstdio>\n#include \"" ASSUR_TESTS
      "/counting.hpp\"\n"
      "template <typename Function> void print(const char* name, Function function) {\n"
      "  const auto count = assur::test::operations_of(function);\n"
      "  std::printf(\"%s %d %d %d\\n\", name, count.multiplications, count.additions,\n"
      "              count.divisions);\n}\nnamespace assur::scenes {\n";
  const fs::path source =
      directory.write("counts.cpp", head + structs + "}\nint main() {\n" + calls + "}\n");
  const std::string program = (directory.path() / "counts").string();
  compile_program(source, program, directory);
  ASSERT_EQ(std::system((program + " > " + program + ".txt").c_str()), 0);

  std::istringstream lines(read_file(program + ".txt"));
  std::string name;
  Count count;
  std::size_t functions = 0;
  while (lines >> name >> count.multiplications >> count.additions >> count.divisions) {
    EXPECT_EQ(count, stated.at(name)) << name;
    ++functions;
  }
  EXPECT_EQ(functions, stated.size());
  EXPECT_GT(expect_one_division(stated), 0);
  compare_with_page(stated);
  EXPECT_GT(functions, 100U);
}

}  // namespace
}  // namespace assur::test::emit_scene_counts_test
