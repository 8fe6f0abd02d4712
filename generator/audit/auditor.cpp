#include "audit/auditor.hpp"

#include <algorithm>
#include <assur/text/suggestion.hpp>
#include <charconv>
#include <map>

#include "audit/kind_audit.hpp"

namespace assur::generator::audit {

std::set<std::string> Auditor::turned() const {
  std::set<std::string> names;
  for (const auto& [name, turned] : printed_closures_) {
    if (turned) {
      names.insert(name);
    }
  }
  return names;
}

AuditReport Auditor::report() const { return {reader_.file(), reader_.source(), statements_}; }

void Auditor::expect_no_rows(const closures::Statement& statement) const {
  if (!statement.rows.empty()) {
    reader_.fail(statement.rows[0].place, "this statement has no rows");
  }
}

bool Auditor::read_declaration(const closures::Statement& statement) {
  if (reader_.read(statement)) {
    closures::ClosureSystem& system = reader_.system();
    std::erase_if(turned_, [&](const std::string& name) {
      const bool declared = system.closure_named(name) != nullptr;
      if (declared) {
        system.negate_closure(name);
      }
      return declared;
    });
    return true;
  }
  return false;
}

void Auditor::read_signs(const closures::Statement& statement) {
  const std::vector<closures::PlacedText> words = closures::words(statement.head);
  const bool closure = words.size() > 1 && words[0].text == "printed" && words[1].text == "closure";
  if (!read_declaration(statement) && closure) {
    read(statement);
  }
}

void Auditor::read(const closures::Statement& statement) {
  if (read_declaration(statement)) {
    return;
  }
  try {
    read_own(statement);
  } catch (const closures::FormulaError& error) {
    reader_.fail(error.place, error.what());
  }
}

void Auditor::read_own(const closures::Statement& statement) {
  using Reader = void (Auditor::*)(const closures::PlacedText&);
  static const std::map<std::string, Reader> readers = {{"scene", &Auditor::read_scene},
                                                        {"group", &Auditor::read_group},
                                                        {"given", &Auditor::read_given},
                                                        {"value", &Auditor::read_value}};
  closures::PlacedText rest = statement.head;
  const closures::PlacedText keyword = closures::take_word(rest);
  if (keyword.text == "printed") {
    read_printed(statement, rest);
  } else if (const auto reader = readers.find(keyword.text); reader != readers.end()) {
    (this->*reader->second)(closures::after_words(closures::joined(statement), 1));
  } else {
    std::vector<std::string> known = closures::ClosureReader::keywords();
    known.emplace_back("printed");
    for (const auto& [name, function] : readers) {
      known.push_back(name);
    }
    reader_.fail(keyword.place, "no statement '" + keyword.text + "'" +
                                    text::suggestion_or_choice(keyword.text, known));
  }
}

void Auditor::define(const std::string& name, double value) {
  numbers_.define(name, value);
  reader_.reserve(name);
}

void Auditor::read_scene(const closures::PlacedText& rest) {
  closures::PlacedText after = rest;
  const closures::PlacedText file = closures::take_file(after);
  int configuration = 1;
  if (closures::take_keyword(after, "branch")) {
    const closures::PlacedText number = closures::take_word(after);
    const char* const last = number.text.data() + number.text.size();
    const auto [end, error] = std::from_chars(number.text.data(), last, configuration);
    if (error != std::errc() || end != last) {
      reader_.fail(number.place, "expected the number of a configuration");
    }
  }
  if (file.empty() || !after.empty()) {
    reader_.fail(rest.place, "expected 'scene FILE [branch N]'");
  }
  const std::string path = (directory_ / file.text).string();
  if (!scenes_) {
    reader_.fail(file.place, "scenes cannot be read here");
  }
  try {
    for (const auto& [name, value] : scenes_(path, configuration, settings_)) {
      define(name, value);
    }
  } catch (const text::InputError& error) {
    reader_.fail(file.place, error.what());
  }
}

void Auditor::read_group(const closures::PlacedText& rest) {
  for (const auto& [name, value] : group_numbers(group_by_name(rest))) {
    define(name, value);
  }
}

const structure::Group& Auditor::group_by_name(const closures::PlacedText& name) const {
  if (name.empty()) {
    reader_.fail(name.place, "the name of a group is missing");
  }
  for (const structure::Group& group : structure::known_groups()) {
    if (group.name() == name.text) {
      return group;
    }
  }
  reader_.fail(name.place,
               "no group named '" + name.text + "'; the groups are dyad, triad and tetrad");
}

void Auditor::read_given(const closures::PlacedText& rest) {
  for (const closures::PlacedText& each : closures::split(rest, ',')) {
    const auto [name, number] = closures::cut(each, '=');
    reader_.expect_new(name);
    closures::PlacedText value = number;
    const closures::PlacedText first = closures::take_word(value);
    numbers_.give(name.text, first);
    reader_.reserve(name.text);
    settings_.push_back(name.text + "=" + first.text);
  }
}

void Auditor::read_value(const closures::PlacedText& rest) {
  const auto [name, definition] = closures::cut(rest, '=');
  reader_.expect_new(name);
  numbers_.define(name.text, definition);
  reader_.reserve(name.text);
}

}  // namespace assur::generator::audit
