// Law: documents are written as another library writes them.
#include <gtest/gtest.h>

#include <array>
#include <assur/text/json.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace assur::text {
namespace {

/// The same document, by the type that it is given.
template <typename Document>
Document everything() {
  std::string bytes;
  for (int code = 1; code < 128; ++code) {
    bytes += static_cast<char>(code);
  }
  Document root;
  root["bytes"] = bytes + "\u00e9\u2212";
  root["empty"] = "";
  root["nothing"] = Document();
  root["truths"] = {{"yes", true}, {"no", false}};
  root["numbers"] = std::vector<int>{0, -7, 2147483647};
  root["count"] = std::vector<int>().size();
  root["none"] = Document::array();
  root["no names"] = Document::object();
  root["nested"] = std::vector<std::array<std::string, 2>>{{"a", "b"}, {"c", "\"d\\"}};
  root["later"] = Document::array();
  root["later"].push_back({{"z", 1}, {"a", Document::array()}});
  root["later"].push_back("text");
  root["empty"] = "no more";
  return root;
}

TEST(Json, IsWrittenAsAnotherLibraryWritesIt) {
  EXPECT_EQ(everything<Json>().dump(), everything<nlohmann::ordered_json>().dump(2));
}

TEST(Json, WritesWhatStandsAlone) {
  EXPECT_EQ(Json().dump(), nlohmann::ordered_json().dump(2));
  EXPECT_EQ(Json(-3).dump(), nlohmann::ordered_json(-3).dump(2));
  EXPECT_EQ(Json("a\nb").dump(), nlohmann::ordered_json("a\nb").dump(2));
  EXPECT_EQ(Json::object().dump(), nlohmann::ordered_json::object().dump(2));
}

}  // namespace
}  // namespace assur::text
