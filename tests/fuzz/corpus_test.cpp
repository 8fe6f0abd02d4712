// Law: every text of the corpora is answered or refused in one line. They are the seeds of fuzzing
// and what it has found.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "readers.hpp"

namespace assur::test::corpus_test {
namespace {

struct Parser {
  const char* name;  ///< and the folder of its corpus
  void (*read)(const std::string&);
};

class Corpus : public testing::TestWithParam<Parser> {};

TEST_P(Corpus, IsAnsweredOrRefusedInOneLine) {
  int texts = 0;
  const std::filesystem::path folder = std::filesystem::path(ASSUR_CORPUS) / GetParam().name;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path().string());
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NO_THROW(GetParam().read(text));
    ++texts;
  }
  EXPECT_GT(texts, 0);
}

constexpr std::array parsers = {
    Parser{"scene", fuzz::read_scene_text},           Parser{"import", fuzz::read_import_text},
    Parser{"expression", fuzz::read_expression_text}, Parser{"closures", fuzz::read_closures_text},
    Parser{"audit", fuzz::read_audit_text},           Parser{"code", fuzz::read_code_text},
    Parser{"paper", fuzz::read_paper_text},
};

INSTANTIATE_TEST_SUITE_P(Parsers, Corpus, testing::ValuesIn(parsers),
                         [](const auto& parser) { return std::string(parser.param.name); });

}  // namespace
}  // namespace assur::test::corpus_test
