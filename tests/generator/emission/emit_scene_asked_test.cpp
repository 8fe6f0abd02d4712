// Law: an emitted solver contains nothing that is never called or read, whichever results and
// outputs of a scene are wanted.
#include <gtest/gtest.h>

#include <assur/mechanism/scene_file.hpp>
#include <cstdlib>
#include <iterator>

#include "emission/scene/emit_scene.hpp"
#include "generator/emitted_code.hpp"
#include "generator/scene_files.hpp"
#include "generator/solver_comparison.hpp"
#include "whole_campaign.hpp"

namespace assur::test::emit_scene_asked_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// An emitted solver, and the sorts of its groups: the runtime calls two of one sort alike.
struct Emitted {
  std::string name;  ///< of the struct, different for every solver
  std::string text;
  std::string code;
  std::set<std::string> sorts;
};

/// The members of a list whose bits are set.
template <typename List>
List chosen(const List& list, std::size_t bits) {
  List some;
  for (std::size_t index = 0; index < list.size(); ++index) {
    if ((bits >> index & 1U) != 0) {
      some.push_back(list[index]);
    }
  }
  return some;
}

/// The scene with every subset of its outputs: without outputs it reports links and slides, with
/// some it reports nothing else.
std::vector<Json> with_subsets_of_outputs(const Json& scene) {
  Json outputs = scene["outputs"];
  if (outputs.is_array()) {  // of a drawing: each point under its own name
    outputs = Json::object();
    for (const std::string point : scene["outputs"]) {
      outputs[point] = point;
    }
  }
  std::vector<std::string> names;
  for (const auto& [name, feature] : outputs.items()) {
    names.push_back(name);
  }
  std::vector<Json> scenes;
  for (std::size_t bits = 0; bits < std::size_t{1} << names.size(); ++bits) {
    Json& part = scenes.emplace_back(scene);
    part["outputs"] = Json::object();
    for (const std::string& name : chosen(names, bits)) {
      part["outputs"][name] = outputs[name];
    }
    if (bits != 0) {
      part["report"] = {{"links", Json::array()}, {"joints", Json::array()}};
    }
  }
  return scenes;
}

/// What decides which of a group's functions the runtime calls: which there are, the order of the
/// rates, and whether there are derivatives.
std::string sort_of(const EmittedStruct& group, const EmittedStruct& solver) {
  std::string sort = matches_of(solver.code, " order = (.*);").at(0);
  sort += matches_of(solver.code, " parameter_count = (.*);").at(0) == "0" ? "" : " derivatives";
  for (const std::string& function : functions_of(group.code)) {
    sort += " " + function;
  }
  return sort;
}

/// Every solver, or one in 29 of them, among which all sets of results occur.
std::vector<Emitted> emitted_solvers(bool all_of_them) {
  const std::size_t stride = all_of_them ? 1 : 29;
  std::size_t number = 0;
  const std::vector<std::string> results = {"position", "velocity", "acceleration", "sensitivity"};
  std::vector<Emitted> all;
  for (const fs::path& example : scene_files({ASSUR_EXAMPLES})) {
    for (Json& scene : with_subsets_of_outputs(scene_json(example))) {
      for (std::size_t bits = 1; bits < std::size_t{1} << results.size(); ++bits) {
        if (number++ % stride != 0) {
          continue;
        }
        scene["want"] = chosen(results, bits);
        Emitted& one = all.emplace_back();
        one.name = "Solver" + std::to_string(all.size());
        one.text = generator::emission::scene::emit_scene(
                       mechanism::parse_scene(scene.dump(), one.name + ".json"))
                       .front()
                       .text;
        one.code = code_of(one.text);
        const std::vector<EmittedStruct> structs = structs_of(one.code);
        EXPECT_EQ(structs.back().name, one.name);
        for (auto group = structs.begin(); group != std::prev(structs.end()); ++group) {
          one.sorts.insert(sort_of(*group, structs.back()));
        }
      }
    }
  }
  return all;
}

/// The words of the runtime's code.
std::map<std::string, int> runtime_words() {
  std::string code;
  for (const auto& entry : fs::recursive_directory_iterator(ASSUR_RUNTIME)) {
    if (entry.is_regular_file()) {
      code += code_of(read_file(entry.path()));
    }
  }
  return words_of(code);
}

/// Expects that every struct, name of a type, constant and function that is declared is mentioned
/// again, in the header or by the runtime, or is for users.
void expect_mentioned(const EmittedStruct& solver, const std::map<std::string, int>& runtime) {
  const std::set<std::string> for_users = {"solve", "branch", "track", "parameters"};
  const std::map<std::string, int> words = words_of(solver.code);
  for (const std::string& name : matches_of(
           solver.code, R"((?:struct|using|constexpr [\w:<>, *]+|static [\w<>]+) (\w+)[ (])")) {
    EXPECT_TRUE(words.at(name) > 1 || runtime.count(name) == 1 || for_users.count(name) == 1)
        << name;
  }
  EXPECT_FALSE(std::regex_search(solver.code, std::regex(R"(struct \w+ \{\n +\};)")));
}

/// Expects that a group's functions read all inputs, unknowns and constants, and their own names.
void expect_read(const EmittedStruct& group, const std::map<std::string, int>& runtime) {
  const std::map<std::string, int> words = words_of(group.code);
  for (const std::string& constant : matches_of(group.code, R"(static constexpr [\w:]+ (\w+) =)")) {
    EXPECT_TRUE(words.at(constant) > 1 || runtime.count(constant) == 1) << constant;
  }
  for (const auto& [object, type] : {std::pair("u", "Inputs"), std::pair("q", "Configuration")}) {
    const std::string members = block_of(group.code, std::string("struct ") + type + " {");
    for (const std::string& member : matches_of(members, R"((?:>|Scalar) (\w+)\{\};)")) {
      EXPECT_TRUE(std::regex_search(
          group.code, std::regex(std::string("\\b") + object + "\\." + member + "\\b")))
          << object << "." << member;
    }
  }
  std::string function;
  std::istringstream in(group.code + "\n");
  for (std::string line; std::getline(in, line);) {
    function += line + "\n";
    if (line == "  }" || line == "  };") {
      const std::map<std::string, int> own = words_of(function);
      for (const std::string& local : matches_of(function, R"(const Scalar (\w+) =)")) {
        EXPECT_GT(own.at(local), 1) << local << " of " << function;
      }
      const std::size_t body = function.find(") {\n");
      for (const std::string& parameter : matches_of(function.substr(0, body), R"(& (\w+)[,)]?)")) {
        EXPECT_GT(own.at(parameter), 1) << parameter << " of " << function;
      }
      function.clear();
    }
  }
}

/// Expects that every member of `Placed` is read, and not only set.
void expect_placed_is_read(const EmittedStruct& solver) {
  const std::string members = block_of(solver.code, "struct Placed {");
  for (const std::string& member : matches_of(members, R"( (\w+)(?: =.*)?;\n)")) {
    EXPECT_TRUE(std::regex_search(solver.code,
                                  std::regex("\\bplaced\\." + member + R"(\b(?!(\.\w+)? = ))")))
        << member;
  }
}

/// Expects that the solver sets every member of a state's parts and reads every member of a driver.
void expect_filled(const EmittedStruct& solver) {
  for (const std::string part : {"Links", "Slides", "Outputs"}) {
    const std::string members = block_of(solver.code, "struct " + part + " {");
    std::string list = part;
    list[0] = static_cast<char>(std::tolower(list[0]));
    for (const std::string& member : matches_of(members, R"(> (\w+);)")) {
      EXPECT_NE(solver.code.find("state." + list + "." + member + " = {"), std::string::npos)
          << part << "::" << member;
    }
  }
  for (const std::string& member :
       matches_of(block_of(solver.code, "struct DriverState {"), R"(Scalar (\w+)\{\};)")) {
    EXPECT_TRUE(std::regex_search(solver.code, std::regex("drivers\\.\\w+\\." + member + "\\b")))
        << member;
  }
}

/// At most `most` solvers, the shortest first, each of which has a sort of group not seen before.
std::vector<const Emitted*> sample_of(const std::vector<Emitted>& all, std::size_t most) {
  std::vector<const Emitted*> by_size;
  for (const Emitted& one : all) {
    by_size.push_back(&one);
  }
  std::stable_sort(by_size.begin(), by_size.end(), [](const Emitted* one, const Emitted* other) {
    return one->text.size() < other->text.size();
  });
  std::vector<const Emitted*> sample;
  std::set<std::string> covered;
  for (const Emitted* one : by_size) {
    const std::size_t before = covered.size();
    covered.insert(one->sorts.begin(), one->sorts.end());
    if (covered.size() > before && sample.size() < most) {
      sample.push_back(one);
    }
  }
  return sample;
}

/// The functions that a compiler put into an object file: `Solver1Group1::Inputs::members const`.
/// It leaves out a member function that nobody calls.
std::multiset<std::string> compiled_functions(const fs::path& object,
                                              const TemporaryDirectory& directory) {
  const fs::path names = directory.path() / "names";
  EXPECT_EQ(std::system((ASSUR_NM " -C " + object.string() + " > " + names.string()).c_str()), 0);
  const std::regex function(
      R"(\w+ \w (?:void |auto |unsigned \w+ |assur::support::[\w:<>, ]+ )?assur::scenes::((?:\w+(?:<double>)?::)+\w+)(?:<.*>)?\(.*\)( const)?)");
  std::multiset<std::string> functions;
  std::istringstream in(read_file(names));
  for (std::string line; std::getline(in, line);) {
    std::smatch match;
    if (std::regex_match(line, match, function)) {
      functions.insert(std::regex_replace(match[1].str(), std::regex("<double>"), "") +
                       match[2].str());
    }
  }
  return functions;
}

void expect_everything_is_read(const std::vector<Emitted>& all) {
  const std::map<std::string, int> runtime = runtime_words();
  std::set<std::string> seen;
  for (const Emitted& solver : all) {
    SCOPED_TRACE(solver.name);
    const std::vector<EmittedStruct> structs = structs_of(solver.code);
    for (auto group = structs.begin(); group != std::prev(structs.end()); ++group) {
      if (seen.insert(group->code).second) {
        expect_read(*group, runtime);
      }
    }
    expect_mentioned(structs.back(), runtime);
    expect_placed_is_read(structs.back());
    expect_filled(structs.back());
  }
  std::printf("%zu solvers, %zu different groups\n", all.size(), seen.size());
}

void expect_everything_is_called(const std::vector<Emitted>& all, std::size_t most) {
  const std::vector<const Emitted*> sample = sample_of(all, most);
  const TemporaryDirectory directory;
  std::string includes;
  std::string calls;
  const bool has_batches = is_whole_campaign();  // they take as long to compile as all else
  for (const Emitted* solver : sample) {
    const std::string header = solver->name + ".hpp";
    directory.write(header, solver->text);
    includes += "#include \"" + header + "\"\n";
    calls += "  use<assur::scenes::" + solver->name + ">();\n";
    if (has_batches) {
      calls += "  use_batch<assur::scenes::" + solver->name + ">();\n";
    }
    if (solver->text.find("static Nearest nearest(") != std::string::npos) {
      calls += "  use_nearest<assur::scenes::" + solver->name + ">();\n";
    }
  }
  const std::string use = R"(template <typename Solver> void use() {
  const typename Solver::template Drivers<double> drivers;
  std::array<typename Solver::template State<double>, Solver::max_configurations> states;
  typename Solver::Branch branch = Solver::branch(drivers, Solver::solve(drivers, states).count);
  static_cast<void>(Solver::track(drivers, branch, states[0]));
}
template <typename Solver> void use_batch() {
  Solver::solve_batch(0, {}, {});
}
template <typename Solver> void use_nearest() {
  const typename Solver::template Drivers<double> drivers;
  std::array<typename Solver::template State<double>, Solver::max_configurations> states;
  static_cast<void>(Solver::nearest(Solver::solve(drivers, states), states));
}
)";
  const fs::path source =
      directory.write("use.cpp", includes + use + "int main() {\n" + calls + "}\n");
  const fs::path object = directory.path() / "use.o";
  compile(quick_compiler().command, "-O0 -c -o " + object.string(), source, directory);
  const std::multiset<std::string> compiled = compiled_functions(object, directory);
  std::size_t functions = 0;
  for (const Emitted* solver : sample) {
    for (const EmittedStruct& part : structs_of(solver->code)) {
      const std::multiset<std::string> declared = functions_of(part.code);
      const bool has_inputs = part.code.find("input_count = 0") == std::string::npos;
      for (const std::string& function : std::set<std::string>(declared.begin(), declared.end())) {
        // The types alone can tell the runtime what a configuration holds, and that there are no
        // inputs, so that these need not be called.
        if (function == "Configuration::members const" ||
            (!has_inputs && function.starts_with("Inputs::members"))) {
          continue;
        }
        const bool is_of_solver = part.name == solver->name;
        if (!has_batches && is_of_solver &&
            (function == "solve_batch" || function.ends_with("::members"))) {
          continue;
        }
        EXPECT_GE(compiled.count(part.name + "::" + function), declared.count(function))
            << part.name << "::" << function << "\n"
            << solver->text.substr(0, 300);
        ++functions;
      }
    }
  }
  std::printf("%zu functions of %zu solvers of %zu\n", functions, sample.size(), all.size());
  EXPECT_GT(functions, most < all.size() ? 100U : 200U);
}

// One solver in 29 by default, all by `ctest -L long`.
TEST(EmitSceneAsked, IsAllThatAnEmittedSolverHolds) {
  const bool whole = is_whole_campaign();
  const std::vector<Emitted> all = emitted_solvers(whole);
  EXPECT_GE(all.size(), whole ? 900U : 30U);
  expect_everything_is_read(all);
  expect_everything_is_called(all, whole ? all.size() : 6);
}

}  // namespace
}  // namespace assur::test::emit_scene_asked_test
