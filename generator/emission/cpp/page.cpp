#include "emission/cpp/page.hpp"

#include <algorithm>
#include <assur/text/quoted.hpp>
#include <kainjow/mustache.hpp>
#include <sstream>
#include <string_view>

#include "emission/cpp/cpp_text.hpp"
#include "emission/cpp/templates.hpp"
#include "error.hpp"

namespace assur::generator::emission::cpp {

namespace {

namespace mustache = kainjow::mustache;

/// Marks blank lines until a template is filled in: otherwise a tag whose line end is removed,
/// followed by a blank line, would again be a line with only a tag.
const std::string blank_line = "\x01";

/// A template without the line ends of lines that contain only a tag. The Mustache library keeps
/// these line ends where a section is hidden, which leaves a blank line.
std::string without_tag_lines(const std::string& text) {
  std::istringstream in(text);
  std::string page;
  std::string line;
  while (std::getline(in, line)) {
    const bool tag = line.starts_with("{{") && line.find("}}") == line.size() - 2 &&
                     std::string("#^/>").find(line[2]) != std::string::npos;
    page += tag ? line : (line.empty() ? blank_line : line) + "\n";
  }
  return page;
}

mustache::data shown(const View& view) {
  mustache::data data;
  for (const auto& [name, value] : view.values()) {
    if (const auto* text = std::get_if<std::string>(&value)) {
      data.set(name, *text);
    } else if (const auto* stands = std::get_if<bool>(&value)) {
      data.set(name, *stands);
    } else {
      mustache::data list{mustache::data::type::list};
      for (const View& entry : std::get<View::List>(value)) {
        list << shown(entry);
      }
      data.set(name, list);
    }
  }
  return data;
}

}  // namespace

View::List line_list(const std::vector<std::string>& lines, const std::string& indentation) {
  View::List list;
  for (const std::string& line : lines) {
    list.emplace_back("line", indentation + line);
  }
  return list;
}

std::string boolean(bool value) { return value ? "true" : "false"; }

std::string comment_text(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  text = text::on_one_line(text);
  std::replace(text.begin(), text.end(), '\\', '/');
  // Before C++17 and in C99 these three characters are a backslash that continues the comment.
  for (std::size_t at = text.find("?\?/"); at != std::string::npos; at = text.find("?\?/", at)) {
    text.erase(at, 1);
  }
  return text;
}

std::string page(const std::string& name, const View& view) {
  mustache::data data = shown(view);
  std::string page_text;
  for (const auto& [file, text] : templates::all) {
    const std::string part(file.substr(0, file.find('.')));
    if (!view.values().contains(part)) {
      data.set(part, mustache::partial([text = text] { return without_tag_lines(text); }));
    }
    if (file == name) {
      page_text = without_tag_lines(text);
    }
  }
  mustache::mustache page{page_text};
  page.set_custom_escape([](const std::string& raw) { return raw; });
  if (page_text.empty() || !page.is_valid()) {
    throw GeneratorError("emission", "template " + name, page.error_message());
  }
  std::string result = page.render(data);
  std::erase(result, blank_line.front());
  return fitted_to_width(result);
}

}  // namespace assur::generator::emission::cpp
