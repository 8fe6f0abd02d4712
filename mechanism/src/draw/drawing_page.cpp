// Turns a mechanism and its sweep into one HTML page that needs no other file.
#include <array>
#include <assur/mechanism/drawing.hpp>
#include <bit>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>

#include "draw/drawing_text.hpp"
#include "draw/film.hpp"
#include "draw/palette.hpp"
#include "draw/templates.hpp"

namespace assur::mechanism::draw {

namespace {

using Json = nlohmann::ordered_json;

/// What the frames of a page may take, so that the whole is below a megabyte.
constexpr std::size_t most_film_bytes = 750'000;

constexpr std::array symbol_names = {"bar",  "plate", "slot", "guide", "block",
                                     "tube", "rod",   "pin",  "tracer"};

/// Numbers of 32 bits, the low byte first, in base 64.
std::string base_64(const std::vector<float>& numbers) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  std::uint32_t held = 0;
  unsigned bits = 0;
  for (const float number : numbers) {
    const auto word = std::bit_cast<std::uint32_t>(number);
    for (unsigned shift = 0; shift < 32; shift += 8) {
      held = held << 8U | (word >> shift & 0xFFU);
      for (bits += 8; bits >= 6; bits -= 6) {
        text += digits[held >> (bits - 6) & 0x3FU];
      }
    }
  }
  if (bits > 0) {
    text += digits[held << (6 - bits) & 0x3FU];
  }
  text.append((4 - text.size() % 4) % 4, '=');
  return text;
}

Json json_of(const Mechanism& mechanism, const Request& request, const Film& film) {
  Json shapes = Json::array();
  for (const Shape& shape : film.shapes) {
    shapes.push_back({{"symbol", symbol_names[static_cast<std::size_t>(shape.symbol)]},
                      {"link", shape.link},
                      {"name", shape.name},
                      {"fixed", shape.fixed},
                      {"points", shape.points}});
  }
  Json branches = Json::array();
  for (const FilmedBranch& branch : film.branches) {
    branches.push_back({{"number", branch.number},
                        {"points", base_64(branch.points)},
                        {"outputs", base_64(branch.outputs)}});
  }
  Json events = Json::array();
  for (const FilmedEvent& event : film.events) {
    events.push_back(
        {{"event", event.event}, {"branches", event.branches}, {"parameter", event.parameter}});
  }
  Json outputs = Json::array();
  for (const Output& output : mechanism.outputs()) {
    outputs.push_back(output.name);
  }
  return {{"title", mechanism.name()},
          {"unit", mechanism.unit()},
          {"parameter",
           request.sweep ? mechanism.parameters()[request.sweep->parameter].name : std::string()},
          {"from", film.from},
          {"to", film.to},
          {"count", film.count},
          {"chosen", film.chosen},
          {"left_out", film.left_out},
          {"points", film.points},
          {"shapes", std::move(shapes)},
          {"outputs", std::move(outputs)},
          {"branches", std::move(branches)},
          {"events", std::move(events)}};
}

/// JSON inside an element of HTML: no text of it may end the element.
std::string inside_html(const Json& json) {
  std::string text;
  for (const char letter : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    text += letter == '<' ? std::string("\\u003c") : std::string(1, letter);
  }
  return text;
}

std::string file_of_page(std::string_view name) {
  for (const auto& [known, content] : templates::all) {
    if (known == name) {
      return content;
    }
  }
  return "";
}

/// The colours of branches and of all else as variables of the style.
std::string colours_of_page(const char* Colour::*shade) {
  std::string text = ":root{--ink:" + std::string(ink.*shade) + ";--muted:" + muted.*shade +
                     ";--paper:" + paper.*shade;
  for (std::size_t place = 0; place < colours.size(); ++place) {
    text += ";--c" + std::to_string(place) + ":" + colours[place].*shade;
  }
  return text + "}";
}

/// The page with texts where it has their names between braces; what these texts hold is not read.
std::string filled(const std::string& page, const std::map<std::string, std::string>& texts) {
  std::string result;
  std::size_t done = 0;
  for (std::size_t at = page.find("{{"); at != std::string::npos; at = page.find("{{", done)) {
    const std::size_t end = page.find("}}", at);
    result += page.substr(done, at - done) + texts.at(page.substr(at + 2, end - at - 2));
    done = end + 2;
  }
  return result + page.substr(done);
}

}  // namespace

}  // namespace assur::mechanism::draw

namespace assur::mechanism {

std::string drawing_page(const Mechanism& mechanism, const Request& request) {
  using namespace draw;
  const Film film = film_of(mechanism, request, most_film_bytes);
  return filled(
      file_of_page("page.html"),
      {{"title", escaped(mechanism.name().empty() ? "A mechanism" : mechanism.name())},
       {"style", colours_of_page(&Colour::light) + "\n@media (prefers-color-scheme:dark){" +
                     colours_of_page(&Colour::dark) + "}\n" + file_of_page("page.css")},
       {"script", file_of_page("film.js") + file_of_page("stage.js") + file_of_page("plot.js") +
                      file_of_page("page.js")},
       {"film", inside_html(json_of(mechanism, request, film))}});
}

}  // namespace assur::mechanism
