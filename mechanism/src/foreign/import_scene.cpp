// Import of a text as a scene, with recognition of the program that wrote it.
#include <assur/mechanism/imported_scene.hpp>
#include <assur/text/quoted.hpp>
#include <assur/text/utf8.hpp>

#include "foreign/pmks_payload.hpp"
#include "foreign/scene_text.hpp"

namespace assur::mechanism::foreign {

namespace {

/// The offset of the first character after white space, comments of Pyslvs and a byte order mark.
std::size_t first_word(const std::string& text) {
  std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  while (at < text.size()) {
    at = text.find_first_not_of(" \t\r\n", at);
    if (at == std::string::npos || text[at] != '#') {
      break;
    }
    const std::size_t end = text.compare(at, 2, "#[") == 0 ? text.find("#]", at) : at;
    at = end == std::string::npos ? end : text.find('\n', end);
  }
  return std::min(at, text.size());
}

bool is_pyslvs(const std::string& text) { return text.compare(first_word(text), 2, "M[") == 0; }

ForeignMechanism mechanism_of(const std::string& text, const std::string& driver) {
  const std::size_t begin = first_word(text);
  const bool is_linkage = begin < text.size() && text[begin] == '<' &&
                          text.find("<linkage2", begin) != std::string::npos;
  if (!driver.empty() && !is_pyslvs(text)) {
    throw MechanismError("--driver", "only expressions of Pyslvs name no input; leave it out");
  }
  if (is_linkage) {
    return linkage_mechanism(text.substr(begin));
  }
  if (is_pyslvs(text)) {
    return pyslvs_mechanism(text, driver);
  }
  if (const std::string payload = pmks_payload_of(text); !payload.empty()) {
    return pmks_mechanism(payload);
  }
  throw MechanismError(
      "",
      "expected a file of Linkage (<linkage2>), a link of PMKS+ or an expression of Pyslvs "
      "(M[...]), found " +
          (begin == text.size() ? "nothing" : text::in_quotes(text.substr(begin))));
}

}  // namespace

}  // namespace assur::mechanism::foreign

namespace assur::mechanism {

ImportedScene import_scene(const std::string& text, const std::string& file,
                           const std::string& driver) {
  text::expect_no_nul(text, file);
  try {
    foreign::ForeignMechanism mechanism = foreign::mechanism_of(text, driver);
    ImportedScene scene;
    scene.text = foreign::scene_text(mechanism);
    scene.remarks = mechanism.remarks();
    scene.complete = mechanism.is_complete();
    return scene;
  } catch (const MechanismError& error) {
    throw text::InputError(file + ": " + error.what());
  }
}

bool is_shared_mechanism(const std::string& text) {
  return foreign::is_pyslvs(text) || !foreign::pmks_payload_of(text).empty();
}

}  // namespace assur::mechanism
