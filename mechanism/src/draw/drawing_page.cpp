// Self-contained HTML page of a mechanism and its sweep.
#include <algorithm>
#include <array>
#include <assur/mechanism/drawing.hpp>
#include <assur/mechanism/plan.hpp>
#include <assur/text/xml.hpp>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>

#include "draw/drawing_text.hpp"
#include "draw/film_json.hpp"
#include "draw/palette.hpp"
#include "draw/templates.hpp"

namespace assur::mechanism::draw {

namespace {

/// The bytes of the page itself, its scripts and its shapes.
constexpr std::size_t bytes_beside_numbers = 160'000;
/// The most bytes of numbers; more do not improve a page.
constexpr std::size_t most_number_bytes = 750'000;
/// The bytes of one number in base 64.
constexpr double bytes_of_number = sizeof(float) * 4 / 3.0;

/// Numbers as 32 bits, the low byte first, in base 64.
std::string base_64(const std::vector<double>& numbers) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  std::uint32_t held = 0;
  unsigned bits = 0;
  for (const double number : numbers) {
    const auto word = std::bit_cast<std::uint32_t>(static_cast<float>(number));
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

/// Subtracts a point of the film from all coordinates and returns it, so that the precision of 32
/// bits is relative to the mechanism's size, however far it is from the scene's origin.
std::array<double, 2> brought_near(Film& film) {
  std::array<double, 2> origin = {0, 0};
  for (const FilmedBranch& branch : film.branches) {
    const auto x = std::find_if(branch.points.begin(), branch.points.end(),
                                [](double number) { return std::isfinite(number); });
    if (x != branch.points.end()) {
      origin = {*x, *std::next(x)};
      break;
    }
  }
  const auto move = [&](std::vector<double>& rows, std::size_t width) {
    for (std::size_t at = 0; at < rows.size(); at += width) {
      rows[at] -= origin[0];
      rows[at + 1] -= origin[1];
    }
  };
  for (FilmedBranch& branch : film.branches) {
    move(branch.points, 2);
    move(branch.outputs, 6);
  }
  return origin;
}

/// JSON inside an element of HTML: none of its texts may end the element.
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

/// The page's scripts: while it loads, each one uses only earlier ones.
std::string script_of_page() {
  std::string script;
  for (const char* name :
       {"lzma",    "library", "solver", "quantities", "film",     "view",   "stage",
        "arrows",  "plot",    "table",  "scene",      "sliders",  "motion", "hand",
        "editing", "marks",   "files",  "panels",     "controls", "page"}) {
    script += file_of_page(name + std::string(".js"));
  }
  return script;
}

/// The colours of branches and of all other parts as variables of the style.
std::string colours_of_page(const char* Colour::*shade) {
  std::string text = ":root{--ink:" + std::string(ink.*shade) + ";--muted:" + muted.*shade +
                     ";--paper:" + paper.*shade;
  for (std::size_t place = 0; place < colours.size(); ++place) {
    text += ";--c" + std::to_string(place) + ":" + colours[place].*shade;
  }
  return text + "}";
}

/// The page with texts inserted for their names in braces; braces within the texts are unchanged.
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

/// The scene that the page solves for other values, and the module that solves it.
Json solved_anew(const SceneText& scene) {
  return {{"text", scene.text},
          {"settings", scene.settings},
          {"module", file_of_page("mechanism.wasm.lzma.base64")}};
}

/// Angles and forces are left to the module if there is one, since they need as much room as the
/// rest.
std::string page_of(const Mechanism& mechanism, const Request& request, const Json& scene,
                    int chosen) {
  const std::size_t taken = bytes_beside_numbers + inside_html(scene).size();
  const std::size_t room = taken < most_page_bytes ? most_page_bytes - taken : 0;
  const auto most_numbers = static_cast<std::size_t>(
      static_cast<double>(std::min(room, most_number_bytes)) / bytes_of_number);
  Film film = film_of(mechanism, request, {most_numbers, chosen, scene.is_null(), std::nullopt});
  if (film.shapes.empty()) {
    throw MechanismError("",
                         "there is nothing to draw: the mechanism has no joints and no outputs");
  }
  const std::array<double, 2> origin = brought_near(film);
  Json data = film_json(mechanism, request, film, base_64);
  data["origin"] = origin;
  data["scene"] = scene;
  return filled(
      file_of_page("page.html"),
      {{"title",
        text::escaped_for_xml(mechanism.name().empty() ? "A mechanism" : mechanism.name())},
       {"style", colours_of_page(&Colour::light) + "\n@media (prefers-color-scheme:dark){" +
                     colours_of_page(&Colour::dark) + "}\n" + file_of_page("page.css")},
       {"script", script_of_page()},
       {"film", inside_html(data)}});
}

}  // namespace

}  // namespace assur::mechanism::draw

namespace assur::mechanism {

std::string drawing_page(const Mechanism& mechanism, const Request& request,
                         const std::optional<SceneText>& scene, int chosen) {
  using namespace draw;
  if (scene) {
    std::string page = page_of(mechanism, request, solved_anew(*scene), chosen);
    if (page.size() <= most_page_bytes) {
      return page;
    }
  }
  return page_of(mechanism, request, nullptr, chosen);
}

}  // namespace assur::mechanism
