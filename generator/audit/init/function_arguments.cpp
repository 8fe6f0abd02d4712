#include "audit/init/function_arguments.hpp"

#include <algorithm>
#include <regex>

namespace assur::generator::audit::init {

namespace {

void name_elements(Argument& list, Language language) {
  list.parts.clear();
  for (std::size_t at = 0; at < list.size; ++at) {
    list.parts.push_back(list.name + "_" + std::to_string(at + first_index(language)));
  }
}

std::optional<Argument> declared_argument(Words words, Language language) {
  words = words.subspan(0, find_mark(words, "="));  // a default value
  Argument argument;
  if (is_c_or_cpp(language)) {
    std::size_t name = words.size();
    for (std::size_t at = 0; at < words.size(); ++at) {
      if (words[at].is("[")) {
        argument.is_array = true;
        if (at + 1 < words.size() && is_whole(words[at + 1])) {
          argument.size = number_of(words[at + 1]);
        }
        break;
      }
      argument.is_array = argument.is_array || words[at].is("*");
      name = words[at].is_name() ? at : name;
    }
    if (name == words.size() || (words.size() == 1 && words[0].is("void"))) {
      return std::nullopt;
    }
    static const std::set<std::string> numbers = {"double", "float", "int"};
    const bool has_name = !numbers.contains(words[name].text);
    argument.name = has_name ? words[name].text : "";
    std::vector<Word> type;
    for (const Word& word : words.subspan(0, name)) {
      if (!is_one_of(word, {"const", "&", "*", "restrict", "struct"})) {
        type.push_back(word);
      }
    }
    argument.type = spelled(type);
    static const std::regex of_reference("(?:Eigen::)?Ref<(.*)>");
    if (argument.type.size() <= longest_type) {
      argument.type = std::regex_replace(argument.type, of_reference, "$1");
    }
  } else {
    if (!words.empty() && words[0].is("{")) {  // an object of JavaScript, by its members
      for (const Words& member : parts(inside(words, 0), ",")) {
        argument.parts.push_back(member.empty() ? "" : member[0].text);
      }
      argument.kind = Argument::Kind::object;
      argument.members = argument.parts;
      return argument;
    }
    words = words.subspan(0, find_mark(words, ":"));
    if (words.empty() || !words[0].is_name()) {
      return std::nullopt;
    }
    argument.name = words[0].text;
  }
  return argument;
}

}  // namespace

std::vector<Argument> declared_arguments(Words parameters, Language language) {
  std::vector<Argument> arguments;
  for (const Words& parameter : parts(parameters, ",")) {
    if (std::optional<Argument> argument = declared_argument(parameter, language)) {
      arguments.push_back(std::move(*argument));
    }
  }
  return arguments;
}

const Argument* find_argument(const std::vector<Argument>& arguments, const std::string& name) {
  const auto found = std::find_if(arguments.begin(), arguments.end(),
                                  [&](const Argument& each) { return each.name == name; });
  return found == arguments.end() ? nullptr : &*found;
}

void name_parts(std::vector<Argument>& arguments, const Source& source, Language language,
                const Assignments& assignments,
                const std::map<std::string, std::vector<std::string>>& records) {
  for (Argument& each : arguments) {
    if (each.kind == Argument::Kind::output || each.name.empty()) {
      continue;
    }
    std::set<std::size_t> indices;
    std::vector<std::string> members;
    for (const Words& statement : source.statements) {
      for (std::size_t at = 0; at + 2 < statement.size(); ++at) {
        if (!statement[at].is(each.name.c_str()) ||
            (at > 0 && is_one_of(statement[at - 1], {".", "->"}))) {
          continue;
        }
        const Words rest = statement.subspan(at + 1);
        if (rest.size() >= 3 && is_one_of(rest[0], {"[", "("}) && is_whole(rest[1]) &&
            is_one_of(rest[2], {"]", ")"})) {
          indices.insert(number_of(rest[1]));
        } else if (is_one_of(rest[0], {".", "->"}) && rest[1].is_name() &&
                   (rest.size() < 3 || !rest[2].is("(")) &&
                   std::find(members.begin(), members.end(), rest[1].text) == members.end()) {
          members.push_back(rest[1].text);
        }
      }
    }
    if (const auto record = records.find(each.type); record != records.end()) {
      members = record->second;
    }
    const auto unpacked = assignments.unpacked.find(each.name);
    const bool by_name = assignments.unpacked_by_name.contains(each.name);
    if (unpacked != assignments.unpacked.end()) {
      for (std::size_t at = 0; at < unpacked->second.size(); ++at) {
        indices.insert(at);
      }
    }
    if (by_name) {
      members = unpacked->second;
    }
    if (each.kind == Argument::Kind::number && is_c_or_cpp(language)) {
      const std::optional<MatrixSize> size = size_of_type(each.type);
      each.size = size ? size->rows * size->columns : each.size;
    }
    if ((!indices.empty() || each.size > 0) && !by_name) {
      each.kind = Argument::Kind::list;
      const std::size_t used = indices.empty() ? 0 : *indices.rbegin() + 1 - first_index(language);
      each.size = std::min(std::max(each.size, used), most_entries);
      name_elements(each, language);
    } else if (!members.empty()) {
      each.kind = Argument::Kind::object;
      each.members = members;
      for (const std::string& member : members) {
        each.parts.push_back(each.name + "_" + member);
      }
    } else {
      each.parts = {each.name};
    }
  }
}

void unite_arguments(const std::vector<std::span<Argument>>& functions, Language language) {
  std::map<std::string, Argument> largest;
  for (const std::span<Argument>& function : functions) {
    for (const Argument& each : function) {
      Argument& found = largest[each.name];
      if (each.kind == Argument::Kind::list || each.kind == Argument::Kind::object) {
        found = each.parts.size() > found.parts.size() ? each : found;
      }
    }
  }
  for (const std::span<Argument>& function : functions) {
    for (Argument& each : function) {
      const Argument& found = largest.at(each.name);
      const bool is_one_number = each.kind == Argument::Kind::number &&
                                 (each.type == "double" || each.type == "float") && !each.is_array;
      if (each.name.empty() || found.parts.empty() || is_one_number ||
          each.kind == Argument::Kind::output) {
        continue;
      }
      each.kind = found.kind;
      each.members = found.members;
      each.size = found.size;
      each.parts = found.parts;
      if (each.kind == Argument::Kind::list) {
        name_elements(each, language);
      }
    }
  }
}

}  // namespace assur::generator::audit::init
