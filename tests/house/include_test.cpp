// Law: every include of the project follows an arrow of the table below, and every folder has one
// namespace.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include "house.hpp"

namespace assur::test {
namespace {

const std::string runtime = "runtime/include/assur";
const std::string models = "generated/assur";
const std::string words = "runtime/text/include/assur/text";
const std::string mechanism = "mechanism/include/assur/mechanism";

/// A folder of the generator: its path is its namespace, and besides the folders below it may
/// include the generator's root and `words`.
Folder stage(const std::string& path, const std::vector<std::string>& below,
             std::vector<std::string> libraries = {"ginac"}, std::vector<std::string> more = {}) {
  std::string name_space = "assur::generator::" + path;
  for (std::size_t at = name_space.find('/'); at != std::string::npos; at = name_space.find('/')) {
    name_space.replace(at, 1, "::");
  }
  more.emplace_back("generator");
  more.push_back(words);
  for (const std::string& folder : below) {
    more.push_back("generator/" + folder);
  }
  return {"generator/" + path, name_space, std::move(more), std::move(libraries)};
}

/// A folder of the library: its name is its namespace, and what users call is in the library's
/// namespace.
Folder part(const std::string& name, const std::vector<std::string>& below,
            std::vector<std::string> libraries = {"Eigen"}) {
  std::vector<std::string> all = {mechanism, runtime, models, words};
  for (const std::string& folder : below) {
    all.push_back("mechanism/src/" + folder);
  }
  return {"mechanism/src/" + name,
          "assur::mechanism::" + name,
          std::move(all),
          std::move(libraries),
          false,
          mechanism};
}

House house() {
  return {
      {
          {runtime, "assur", {}, {"Eigen"}, true},
          {models, "assur", {runtime}, {"Eigen"}, true},
          {words, "assur::text", {}, {}},
          {"runtime/text/src", "assur::text", {words}, {}},

          {mechanism, "assur::mechanism", {runtime, words}, {"Eigen"}},
          part("description", {}, {}),
          part("drawn", {"description"}, {}),
          part("file", {"description", "drawn"}, {"nlohmann"}),
          part("foreign", {"description"}, {"boost", "nlohmann"}),
          part("models", {}),
          part("groups", {"models"}, {"Eigen", "unsupported"}),
          part("plan", {"description", "models", "groups"}, {}),
          part("values", {"description", "models", "plan"}),
          part("solve", {"description", "models", "groups", "plan", "values"}),
          part("choose", {"description", "plan", "values", "solve"}, {}),
          part("follow", {"description", "models", "plan", "values", "solve"}),
          part("forces", {"description", "plan", "values", "solve"}),
          part("campaign", {"description", "plan", "values", "solve", "forces"}),
          part("report", {"description", "models", "plan", "values", "solve", "forces"},
               {"Eigen", "nlohmann"}),
          part("draw", {"description", "models", "plan", "values", "solve", "follow"},
               {"Eigen", "nlohmann"}),
          part("page", {"draw"}, {"nlohmann"}),

          {"python/src", "assur::python", {mechanism, runtime, words}, {"Eigen", "pybind11"}},

          {"generator", "assur::generator", {}, {}},
          stage("structure", {}, {}),
          stage("equations", {"structure"}),
          stage("derivatives", {"structure", "equations"}),
          stage("elimination", {"structure", "equations", "derivatives"}),
          stage("special_points", {"structure", "equations", "derivatives", "elimination"}),
          stage("pivoting", {"structure", "equations"}),
          stage("forces", {"structure", "equations", "derivatives", "pivoting"}),
          stage("program", {"equations"}),
          stage("closures", {"structure", "equations"}),
          stage("emission/cpp", {"equations", "program"}, {"ginac", "kainjow", "unistd.h"}),
          stage("emission/model",
                {"structure", "equations", "derivatives", "elimination", "special_points",
                 "pivoting", "forces", "program", "emission/cpp"},
                {"ginac", "Eigen"}, {runtime}),
          stage("emission/closures", {"equations", "derivatives", "program", "closures",
                                      "emission/cpp", "emission/model"}),
          stage("emission/scene",
                {"structure", "equations", "derivatives", "elimination", "pivoting", "program",
                 "emission/cpp", "emission/model"},
                {"ginac", "Eigen"}, {mechanism, runtime, models}),
          stage("document",
                {"structure", "equations", "derivatives", "elimination", "pivoting", "forces",
                 "program"},
                {"ginac"}, {runtime}),
          stage("audit/code", {"equations", "closures"}),
          stage("audit/running", {}, {"fcntl.h", "poll.h", "sys", "unistd.h"}),
          stage(
              "audit",
              {"structure", "equations", "derivatives", "closures", "audit/code", "audit/running"},
              {"ginac"}),
          stage("audit/scene", {}, {}, {mechanism, runtime}),
          stage("latex", {"closures"}),
          stage("audit/latex", {"closures", "latex", "audit"}),
          stage("audit/init", {"closures", "latex"}),
          stage("campaign", {},
                {"Eigen", "dlfcn.h", "fcntl.h", "hdf5.h", "nlohmann", "sys", "unistd.h"},
                {mechanism}),
          stage("command",
                {"structure", "equations", "derivatives", "elimination", "pivoting", "closures",
                 "document", "audit", "audit/scene", "audit/latex", "audit/init", "emission/cpp",
                 "emission/model", "emission/closures", "emission/scene", "campaign"},
                {"CLI", "mpi.h", "unistd.h"}, {mechanism}),
      },
      {"runtime/include", "runtime/text/include", "generated", "mechanism/include", "mechanism/src",
       "generator"},
      {{"assur/detail/", runtime}}};
}

Files files_of_the_project() {
  const std::filesystem::path root = ASSUR_SOURCE;
  Files files;
  for (const std::string top : {"runtime", "mechanism", "python", "generator", "generated"}) {
    if (!std::filesystem::exists(root / top)) {
      continue;
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / top)) {
      const std::string ending = entry.path().extension().string();
      if (ending == ".hpp" || ending == ".cpp") {
        std::ifstream in(entry.path(), std::ios::binary);
        files[entry.path().lexically_relative(root).generic_string()] = {
            std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
      }
    }
  }
  // These headers are written while the project is built.
  files["generator/emission/cpp/templates.hpp"] = "";
  files["generator/audit/running/templates.hpp"] = "";
  files["mechanism/src/draw/templates.hpp"] = "";
  return files;
}

TEST(House, EveryIncludeFollowsAnArrow) {
  const Files files = files_of_the_project();
  ASSERT_GT(files.size(), 100U);
  const House table = house();
  const HouseCheck check(table, files);
  for (const std::string& complaint : check.complaints()) {
    ADD_FAILURE() << complaint;
  }
}

TEST(House, MechanismAndGeneratorMeetAboveBothAlone) {
  for (const Folder& folder : house().folders) {
    for (const std::string& below : folder.below) {
      if (folder.path.starts_with("mechanism")) {
        EXPECT_FALSE(below.starts_with("generator")) << folder.path;
      }
      if (folder.path.starts_with("generator") && below.starts_with("mechanism")) {
        EXPECT_TRUE(folder.path == "generator/emission/scene" ||
                    folder.path == "generator/audit/scene" || folder.path == "generator/campaign" ||
                    folder.path == "generator/command")
            << folder.path;
      }
    }
    for (const std::string& library : folder.libraries) {
      EXPECT_TRUE((library != "ginac" && library != "cln") || folder.path.starts_with("generator"))
          << folder.path;
    }
  }
}

/// The headers of the runtime in storeys, the lowest first: patterns of their paths below `assur/`.
const std::vector<std::pair<const char*, std::regex>>& storeys_of_the_runtime() {
  static const std::vector<std::pair<const char*, std::regex>> storeys = {
      {"what models are made of",
       std::regex("(version|model_tables|status|assemblies|model|"
                  "directions|variables|columns|detail/(index|members|numbers|refused_options))")},
      {"numbers and roots", std::regex("numeric/.*")},
      {"the geometry of groups and links",
       std::regex(
           "local/(body_constraints|close|crossing|elimination|singular_point|system)|loops/.*|"
           "detail/"
           "(batch/(pack_arcs|pack_columns|pack_roots|pack_verdicts|scaled_block)|"
           "closed_form|closure_geometry|completion|first_values|limit_turns|"
           "multiple_assembly|neighbourhood|pivots|products|second_look|small_step|"
           "special_search)|"
           "support/"
           "(all_constraints|batch_limits|batch_order|configuration_order|derivative_digits|"
           "discriminant|displaced_frame|flat_variables|limits|nearest|placed_link|"
           "position_polynomial|power_derivative|"
           "redundant|rigid_motion|scale|second_rates|solved_by_lu)")},
      {"answers at a configuration",
       std::regex("batch_kinematics|branch_point|kinematics|normal_form|second_order|"
                  "singularity|special_points")},
      {"the searches",
       std::regex("detail/(assembly_order|batch/(closed_pack|general_block|pack_order)|"
                  "branch_step|closed_search|general_search|"
                  "polish|special_group|wider)")},
      {"all configurations, and branches", std::regex("assembly|batch|tracking")},
      {"whole mechanisms",
       std::regex(
           "assur|detail/batch/placed_pack|support/"
           "(batch_search|closures_on_way|coordinate_motions|displacement|equations_of_motion|"
           "equilibrium|"
           "flat_branch|held_group|link_forces|loop_group|placed_group|scene_batch|"
           "scene_access|scene_branch|scene_columns|scene_crossing|scene_search|scene_solve|"
           "scene_track|shared_search|"
           "specialised|track_batch)")},
  };
  return storeys;
}

/// The storey of a header, or -1 where it has none.
int storey_of(const std::string& header) {
  const auto& storeys = storeys_of_the_runtime();
  const auto at = std::find_if(storeys.begin(), storeys.end(), [&](const auto& storey) {
    return std::regex_match(header, storey.second);
  });
  return at == storeys.end() ? -1 : static_cast<int>(at - storeys.begin());
}

TEST(House, TheRuntimeStandsInStoreys) {
  const std::regex include(R"(^#include <assur/([^>]+)\.hpp>)");
  const std::string root = runtime + "/";
  int read = 0;
  for (const auto& [path, text] : files_of_the_project()) {
    if (!path.starts_with(root)) {
      continue;
    }
    ++read;
    const std::string header = path.substr(root.size(), path.rfind('.') - root.size());
    const int storey = storey_of(header);
    EXPECT_GE(storey, 0) << header << " has no storey";
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
      std::smatch match;
      if (std::regex_search(line, match, include)) {
        EXPECT_LE(storey_of(match[1]), storey) << path << " looks upwards: " << line;
      }
    }
  }
  EXPECT_GT(read, 40);
}

TEST(House, NobodyOutsideNamesTheDetailsOfTheRuntime) {
  const std::filesystem::path root = ASSUR_SOURCE;
  const std::filesystem::path own_tests = root / "tests/runtime/detail";
  const std::regex details(R"(assur/detail/|(^|[^:\w])(assur::)?detail::)");
  int read = 0;
  for (const std::string top :
       {"mechanism", "python", "generator", "generated", "templates", "examples", "bench",
        "tests/mechanism", "tests/python", "tests/generator", "tests/generated", "tests/runtime",
        "tests/command", "tests/support"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / top)) {
      if (!entry.is_regular_file() || entry.path().parent_path() == own_tests) {
        continue;
      }
      ++read;
      std::ifstream in(entry.path(), std::ios::binary);
      std::string line;
      for (int number = 1; std::getline(in, line); ++number) {
        EXPECT_FALSE(line.find("detail") != std::string::npos && std::regex_search(line, details))
            << entry.path().lexically_relative(root).string() << ":" << number << ": " << line;
      }
    }
  }
  EXPECT_GT(read, 300);
}

/// A house of two storeys with a private room; the upper storey is called through the lower one.
House small_house() {
  return {{{"low", "assur::low", {}, {"Eigen"}, true},
           {"high", "assur::high", {"low"}, {}, false, "low"}},
          {"low", "high"},
          {{"detail/", "low"}}};
}

std::vector<std::string> complaints(const House& house, const Files& files) {
  return HouseCheck(house, files).complaints();
}

TEST(HouseCheck, AcceptsWhatFollowsTheTable) {
  EXPECT_EQ(
      complaints(
          small_house(),
          {{"low/a.hpp", "#include <vector>\n#include <Eigen/Core>\nnamespace assur::low {"},
           {"low/detail/b.hpp", "# include \"a.hpp\"\nnamespace assur::low::detail {\n"},
           {"high/c.cpp", "#include <a.hpp>\nnamespace assur::high {\nnamespace {\n"},
           {"low/e.hpp", "namespace assur::low {\nclass Solver;\n[[nodiscard]] int solve(int);"},
           {"high/e.cpp",
            "namespace assur::low {\nint solve(int a) {\n  helper(a);\n}\n"
            "Solver::Solver(int a) {\n}\nclass Solver {\n};\n"
            "template <>\nconst bool Solver<2>::exists = true;\n"
            "}  // namespace assur::low\nnamespace assur::high {\nint more() {\n"}}),
      std::vector<std::string>{});
}

TEST(HouseCheck, NamesTheLineThatBreaksARule) {
  const std::vector<std::pair<Files, std::string>> cases = {
      {{{"high/c.hpp", ""}, {"low/a.cpp", "\n#include \"c.hpp\"\n"}},
       "low/a.cpp:2: low may not include high/c.hpp: no arrow leads there"},
      {{{"low/detail/b.hpp", ""}, {"high/c.cpp", "#include \"detail/b.hpp\"\n"}},
       "high/c.cpp:1: <detail/b.hpp> is private to low"},
      {{{"high/c.cpp", "\n\n  #  include <ginac/ginac.h>\n"}},
       "high/c.cpp:3: high may not include ginac/ginac.h"},
      {{{"high/c.cpp", "#include \"gone.hpp\"\n"}},
       "high/c.cpp:1: gone.hpp is no header of the house or the standard"},
      {{{"high/c.cpp", "namespace assur::mid {\n"}},
       "high/c.cpp:1: namespace assur::mid in a folder of assur::high"},
      {{{"low/e.hpp", "namespace assur::low {\n// solve(int)\nint resolve(int);\n"},
        {"high/e.cpp", "namespace assur::low {\nint solve(int a) {\n"}},
       "high/e.cpp:2: no header of low declares: int solve(int a) {"},
      {{{"low/e.hpp", "namespace assur::low {\nint solve(int);\n"},
        {"high/e.cpp", "namespace assur::low {\nnamespace {\nint solve(int) {\n"}},
       "high/e.cpp:2: no header of low declares: namespace {"},
      {{{"high/e.cpp",
         "namespace assur::high {\n}  // namespace assur::high\n"
         "namespace assur::low {\n\nclass Solver {\n"}},
       "high/e.cpp:5: no header of low declares: class Solver {"},
      {{{"high/e.cpp", "namespace assur::low {\ntemplate <>\nint Solver<2>::count = 1;\n"}},
       "high/e.cpp:3: no header of low declares: int Solver<2>::count = 1;"},
      {{{"low/detail/b.hpp", "namespace assur::low {\n"}},
       "low/detail/b.hpp:1: namespace assur::low in a folder of assur::low::detail"},
      {{{"attic/d.cpp", ""}}, "attic/d.cpp:1: belongs to no folder of the house"}};
  for (const auto& [files, complaint] : cases) {
    EXPECT_EQ(complaints(small_house(), files), std::vector<std::string>{complaint});
  }
}

TEST(HouseCheck, RefusesATableWithACircle) {
  House circle = small_house();
  circle.folders[0].below = {"high"};
  EXPECT_FALSE(complaints(circle, {}).empty());
  House gone = small_house();
  gone.folders[0].below = {"cellar"};
  EXPECT_EQ(complaints(gone, {}).size(), 2U);
}

}  // namespace
}  // namespace assur::test
