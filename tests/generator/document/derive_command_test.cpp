// Law: `assur derive` prints the same in every process, its LaTeX fits the page, and unknown
// arguments are refused in one line.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>

#include "command/command.hpp"
#include "generator/all_models.hpp"
#include "whole_campaign.hpp"

namespace assur::test::derive_command_test {
namespace {

using Json = nlohmann::ordered_json;

class DeriveProcess : public testing::TestWithParam<const generator::structure::Model*> {
 protected:
  [[nodiscard]] static std::string said(const std::string& format) {
    return run_assur("derive " + std::to_string(GetParam()->number) + " --group " +
                     GetParam()->group->name() + " --format " + format)
        .output;
  }
};

TEST_P(DeriveProcess, GivesTheSameBytesTwice) {
  // All formats lay out the same derivation; each model tries one of them.
  const auto number = static_cast<std::size_t>(GetParam()->number);
  const char* const format = std::array{"text", "latex", "json"}[number / 6 % 3];
  const std::string once = said(format);
  EXPECT_FALSE(once.empty());
  EXPECT_EQ(once, said(format));
}

INSTANTIATE_TEST_SUITE_P(Models, DeriveProcess, testing::ValuesIn(share_of(all_models(), 6)),
                         name_of_model);

#ifdef ASSUR_PDFLATEX
class DeriveLatex : public DeriveProcess {};

TEST_P(DeriveLatex, CompilesAndFitsThePage) {
  const TemporaryDirectory directory;
  directory.write("model.tex", said("latex"));
  const std::string line = "cd " + directory.path().string() +
                           " && " ASSUR_PDFLATEX
                           " -interaction=nonstopmode -halt-on-error model.tex > out 2>&1";
  EXPECT_EQ(std::system(line.c_str()), 0) << read_file(directory.path() / "out");
  const std::string log = read_file(directory.path() / "model.log");
  EXPECT_EQ(log.find("Overfull \\hbox"), std::string::npos)
      << log.substr(std::min(log.size(), log.find("Overfull")), 200);
}

INSTANTIATE_TEST_SUITE_P(Models, DeriveLatex, testing::ValuesIn(share_of(all_models(), 6)),
                         name_of_model);
#endif

TEST(DeriveCommand, ReadsAKindAsItsModelByARelabelling) {
  const Json asked = Json::parse(run_assur("derive RRR-RRP --format json").output);
  EXPECT_EQ(asked["group"], "tetrad");
  EXPECT_EQ(asked["asked"], "RRR-RRP");
  const std::string kind = asked["kind"];
  EXPECT_NE(kind, "RRR-RRP");
  // The prismatic joint of the kind plays the prismatic joint of the model.
  const std::string spelled = "BCG-EDF";
  EXPECT_EQ(kind[spelled.find(asked["plays"]["F"].get<std::string>())], 'P');
  const std::string text = run_assur("derive RRR-RRP").output;
  EXPECT_NE(text.find("joint of RRR-RRP  plays joint"), std::string::npos);
  EXPECT_NE(text.find("\nmodel " + kind + "\n"), std::string::npos);
}

TEST(DeriveCommand, FindsTheGroupOfAKindByItsSpelling) {
  for (const auto& [kind, group] : std::map<std::string, std::string>{
           {"RRP", "dyad"}, {"RR-RR-RP", "triad"}, {"RRP-RRR", "tetrad"}}) {
    EXPECT_EQ(Json::parse(run_assur("derive " + kind + " --format json").output)["group"], group);
  }
}

TEST(DeriveCommand, RefusesWhatItDoesNotKnow) {
  const std::map<std::string, std::string> faults = {
      {"RRX-RRR", "no kind 'RRX-RRR' (did you mean 'RRR-RRR'?)"},
      {"rrp", "no kind 'rrp' (did you mean 'RRP'?)"},
      {"25", "no tetrad model 25; the models are 1 to 24"},
      {"0 --group dyad", "no dyad model 0; the models are 1 to 6"},
      {"RRP --group triad", "no triad kind 'RRP'"},
      {"1 --group pentad", "pentad"},
      {"", "KIND_OR_MODEL"},
      {"1 --format pdf", "pdf"}};
  for (const auto& [line, expected] : faults) {
    const CommandResult result = run_assur("derive " + line);
    EXPECT_EQ(result.status, 2) << line;
    EXPECT_EQ(result.output, "") << line;
    EXPECT_EQ(std::count(result.messages.begin(), result.messages.end(), '\n'), 1) << line;
    EXPECT_NE(result.messages.find(expected), std::string::npos) << result.messages;
  }
}

}  // namespace
}  // namespace assur::test::derive_command_test
