// Searches source files for lines that break the rules of the house.
#pragma once

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace assur::test {

/// Texts by their paths from the project's root, with `/` between folders.
using Files = std::map<std::string, std::string>;

/// A folder, the folders on which it may depend, and the one namespace of its files.
struct Folder {
  std::string path;                    ///< with its subfolders, except those in the table
  std::string name_space;              ///< `assur::text`
  std::vector<std::string> below;      ///< folders whose headers it may include
  std::vector<std::string> libraries;  ///< from outside: `Eigen`, `ginac`
  /// Whether a folder inside appends its name to the namespace; otherwise it shares it.
  bool nested = false;
  /// The folder through which this one is called, if any: what its headers declare, in their
  /// namespace, is defined here.
  std::string door{};
};

/// The house as a table.
struct House {
  std::vector<Folder> folders;
  std::vector<std::string> include_directories;
  /// No file outside `private_to.second` includes a path that begins with `private_to.first`.
  std::vector<std::pair<std::string, std::string>> private_to;

  [[nodiscard]] const Folder* folder_of(const std::string& file) const {
    const Folder* best = nullptr;
    for (const Folder& folder : folders) {
      if (file.starts_with(folder.path + "/") &&
          (best == nullptr || folder.path.size() > best->path.size())) {
        best = &folder;
      }
    }
    return best;
  }
};

/// One line of a file that begins an include or a namespace.
struct SourceLine {
  std::size_t number;
  std::string text;  ///< the path between quotes or brackets, or the namespace
  bool quoted = false;
};

inline std::vector<SourceLine> lines_that_begin(const std::string& text, const std::string& word) {
  std::vector<SourceLine> lines;
  std::istringstream in(text);
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    if (line.starts_with(word)) {
      lines.push_back({number, line.substr(word.size()), false});
    }
  }
  return lines;
}

/// The paths that a file includes, whatever spaces its lines contain.
inline std::vector<SourceLine> includes_of(const std::string& text) {
  std::vector<SourceLine> includes;
  std::istringstream in(text);
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    const std::size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line[hash] != '#') {
      continue;
    }
    const std::size_t word = line.find_first_not_of(" \t", hash + 1);
    const std::size_t open = line.find_first_of("\"<", hash);
    if (word == std::string::npos || line.compare(word, 7, "include") != 0 ||
        open == std::string::npos) {
      continue;
    }
    const std::size_t close = line.find_first_of("\">", open + 1);
    includes.push_back({number, line.substr(open + 1, close - open - 1), line[open] == '"'});
  }
  return includes;
}

/// The namespaces of the project that a file opens.
inline std::vector<SourceLine> namespaces_of(const std::string& text) {
  std::vector<SourceLine> names = lines_that_begin(text, "namespace ");
  for (SourceLine& name : names) {
    name.text = name.text.substr(0, name.text.find_first_of(" {"));
  }
  std::erase_if(names, [](const SourceLine& name) { return !name.text.starts_with("assur"); });
  return names;
}

/// Checks files against a house.
class HouseCheck {
 public:
  HouseCheck(const House& house, const Files& files) : house_(house), files_(files) {
    check_table();
    for (const auto& [path, text] : files_) {
      if (const Folder* folder = house_.folder_of(path)) {
        check_includes(path, text, *folder);
        check_namespaces(path, text, *folder);
      } else {
        complain(path, 1, "belongs to no folder of the house");
      }
    }
  }

  /// `generator/audit/a.cpp:3: ...`, one for each line that breaks a rule.
  [[nodiscard]] const std::vector<std::string>& complaints() const { return complaints_; }

 private:
  void complain(const std::string& path, std::size_t line, const std::string& what) {
    complaints_.push_back(path + ":" + std::to_string(line) + ": " + what);
  }

  [[nodiscard]] const Folder* named(const std::string& path) const {
    const auto found = std::find_if(house_.folders.begin(), house_.folders.end(),
                                    [&](const Folder& folder) { return folder.path == path; });
    return found == house_.folders.end() ? nullptr : &*found;
  }

  /// Every arrow of the table leads to one of its folders, and no arrows form a circle.
  void check_table() {
    for (const Folder& folder : house_.folders) {
      std::set<std::string> seen;
      std::vector<std::string> open = folder.below;
      while (!open.empty()) {
        const std::string at = open.back();
        open.pop_back();
        const Folder* below = named(at);
        if (below == nullptr) {
          complain("the table", 0, "no folder " + at + ", which " + folder.path + " may include");
        } else if (at == folder.path) {
          complain("the table", 0, "arrows lead from " + at + " back to it");
          return;
        } else if (seen.insert(at).second) {
          open.insert(open.end(), below->below.begin(), below->below.end());
        }
      }
    }
  }

  /// The file that an include names; empty if the house has no such file.
  [[nodiscard]] std::string resolved(const std::string& path, const SourceLine& include) const {
    std::vector<std::string> directories = house_.include_directories;
    if (include.quoted) {
      directories.insert(directories.begin(), path.substr(0, path.rfind('/')));
    }
    for (const std::string& directory : directories) {
      std::string file = directory + "/" + include.text;
      if (files_.contains(file)) {
        return file;
      }
    }
    return "";
  }

  void check_includes(const std::string& path, const std::string& text, const Folder& folder) {
    for (const SourceLine& include : includes_of(text)) {
      for (const auto& [prefix, owner] : house_.private_to) {
        if (include.text.starts_with(prefix) && !path.starts_with(owner + "/")) {
          complain(path, include.number, "<" + include.text + "> is private to " + owner);
        }
      }
      const std::string file = resolved(path, include);
      if (file.empty()) {
        check_library(path, include, folder);
        continue;
      }
      const Folder* target = house_.folder_of(file);
      const bool allowed = target == &folder ||
                           (target != nullptr && std::find(folder.below.begin(), folder.below.end(),
                                                           target->path) != folder.below.end());
      if (!allowed) {
        complain(path, include.number,
                 folder.path + " may not include " + file + ": no arrow leads there");
      }
    }
  }

  /// Every folder may include the standard headers, which have no folder and no ending.
  void check_library(const std::string& path, const SourceLine& include, const Folder& folder) {
    const std::size_t slash = include.text.find('/');
    if (slash == std::string::npos) {
      const bool standard = !include.quoted && include.text.find('.') == std::string::npos;
      if (!standard && std::find(folder.libraries.begin(), folder.libraries.end(), include.text) ==
                           folder.libraries.end()) {
        complain(path, include.number, include.text + " is no header of the house or the standard");
      }
      return;
    }
    const std::string library = include.text.substr(0, slash);
    if (std::find(folder.libraries.begin(), folder.libraries.end(), library) ==
        folder.libraries.end()) {
      complain(path, include.number, folder.path + " may not include " + include.text);
    }
  }

  void check_namespaces(const std::string& path, const std::string& text, const Folder& folder) {
    std::string expected = folder.name_space;
    if (folder.nested) {
      std::istringstream inside(path.substr(folder.path.size() + 1));
      std::string part;
      while (std::getline(inside, part, '/') && !inside.eof()) {
        expected += "::" + part;
      }
    }
    const Folder* door = folder.door.empty() ? nullptr : named(folder.door);
    for (const SourceLine& name : namespaces_of(text)) {
      if (door != nullptr && name.text == door->name_space) {
        check_definitions(path, text, name, *door);
      } else if (name.text != expected) {
        complain(path, name.number, "namespace " + name.text + " in a folder of " + expected);
      }
    }
  }

  /// Between a door's namespace and its end, whatever begins at the margin must be declared by the
  /// door. After `template`, the next line says what is defined.
  void check_definitions(const std::string& path, const std::string& text, const SourceLine& opened,
                         const Folder& door) {
    static const std::regex begins(R"(^(?!template )\w)");
    std::istringstream in(text);
    std::string line;
    for (std::size_t number = 1; std::getline(in, line); ++number) {
      if (number <= opened.number) {
        continue;
      }
      if (line.starts_with("}  // namespace assur")) {
        break;
      }
      if (std::regex_search(line, begins) && !declares(door, line)) {
        complain(path, number, "no header of " + door.path + " declares: " + line);
      }
    }
  }

  /// Whether a door's headers declare the class or the function that a line defines, or the class
  /// of which it defines a member.
  [[nodiscard]] bool declares(const Folder& door, const std::string& line) const {
    static const std::regex definition(
        R"(^(?:struct|class) (\w+)|(\w+)(?:<[^<>]*>)?::[\w:~]+(?:\(| = )|(\w+)\()");
    std::smatch found;
    if (!std::regex_search(line, found, definition)) {
      return false;
    }
    const bool is_function = found[3].matched;
    const std::string name = is_function ? found[3] : found[1].matched ? found[1] : found[2];
    const std::regex declaration(is_function ? R"((^|\n)[^/\n]*\b)" + name + R"(\()"
                                             : R"(\n(struct|class) )" + name + R"(\b)");
    return std::any_of(files_.begin(), files_.end(), [&](const auto& file) {
      return house_.folder_of(file.first) == &door && std::regex_search(file.second, declaration);
    });
  }

  const House& house_;
  const Files& files_;
  std::vector<std::string> complaints_;
};

}  // namespace assur::test
