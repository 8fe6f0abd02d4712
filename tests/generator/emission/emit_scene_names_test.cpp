// Law: a solver compiles even where the scene's parts or file are named like words of the solver.
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "generator/solver_comparison.hpp"

namespace assur::test::emit_scene_names_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

void check_syntax(const fs::path& source, const TemporaryDirectory& directory) {
  compile(ASSUR_COMPILER, "-fsyntax-only", source, directory);
  check_by_clang(source, directory);
}

/// The identifiers in the code of a solver that has groups, slides, tolerances and variable
/// parameters.
std::set<std::string> words_of_a_solver() {
  const TemporaryDirectory directory;
  const EmittedScene scene{
      fs::path(ASSUR_EXAMPLES) / "quintero_2011_rrp_rrr.json", "quintero_2011_rrp_rrr", "", {}};
  emit_solver(scene, directory, "--variable all");
  const std::string text =
      std::regex_replace(read_file(directory.path() / "assur/scenes/quintero_2011_rrp_rrr.hpp"),
                         std::regex("//[^\n]*|\"[^\"\n]*\""), "");
  const std::regex word("[A-Za-z_][A-Za-z_0-9]*");
  return {std::sregex_token_iterator(text.begin(), text.end(), word), {}};
}

/// Links driven one by one against the ground, each named as its joint and output; every other one
/// slides.
Json driven_links(const std::set<std::string>& names) {
  Json scene;
  scene["parameters"]["p"] = {{"value", 0.3}, {"tolerance", 0.01}};
  const Json line = {{"through", {0, 0}}, {"along", {"p", 1}}};
  scene["links"]["ground"] = {{"o", {0, 0}}, {"l", line}};
  scene["joints"] = scene["drivers"] = scene["outputs"] = Json::object();
  bool slides = false;
  for (const std::string& name : names) {
    const char* feature = slides ? ".l" : ".o";
    scene["links"][name] = {{"o", {"p", 0}}, {"l", line}};
    scene["joints"][name] = {{"type", slides ? "prismatic" : "revolute"},
                             {"between", {std::string("ground") + feature, name + feature}}};
    scene["drivers"][name]["position"] = "p";
    scene["outputs"][name] = name + ".o";
    slides = !slides;
  }
  return scene;
}

TEST(EmitSceneNames, MayBeEveryWordOfASolver) {
  const TemporaryDirectory directory;
  std::set<std::string> words = words_of_a_solver();
  EXPECT_GT(words.size(), 200U);
  for (const char* word :
       {"NULL", "errno", "static_cast", "xor", "_x", "__x", "x__", "_X", "slide_order"}) {
    words.insert(word);
  }
  emit_solver({directory.write("words.json", driven_links(words).dump()), "", "", {}}, directory);
  check_syntax(directory.write("words.cpp", "#include <assur/scenes/words.hpp>\n"), directory);
}

/// The solver of the worked mechanism comes last, where all other structs could hide its words.
TEST(EmitSceneNames, OfFilesMayBeEveryWordOfASolver) {
  const TemporaryDirectory directory;
  const std::regex type("[A-Z]+[a-z][A-Za-z]*");
  std::string includes;
  int files = 0;
  for (const std::string& word : words_of_a_solver()) {
    // Only names of types; those that begin with Quintero are defined by the worked mechanism.
    if (std::regex_match(word, type) && !word.starts_with("Quintero")) {
      const auto file = directory.write(word + ".json", driven_links({"a", "b"}).dump());
      emit_solver({file, "", "", {}}, directory);
      includes += "#include <assur/scenes/" + word + ".hpp>\n";
      ++files;
    }
  }
  EXPECT_GT(files, 30);
  for (const char* stem : {"shaper_quick_return", "quintero_2011_rrp_rrr"}) {
    emit_solver({fs::path(ASSUR_EXAMPLES) / (std::string(stem) + ".json"), "", "", {}}, directory);
    includes += "#include <assur/scenes/" + std::string(stem) + ".hpp>\n";
  }
  check_syntax(directory.write("files.cpp", includes), directory);
}

}  // namespace
}  // namespace assur::test::emit_scene_names_test
