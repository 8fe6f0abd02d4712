#include "foreign/linkage_file.hpp"

#include <algorithm>
#include <assur/text/names.hpp>
#include <assur/text/quoted.hpp>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace assur::mechanism::foreign {

namespace {

using boost::property_tree::ptree;

/// Files of the program have three levels; deeper nesting would serve only to exhaust the stack.
constexpr int deepest = 32;
/// A bound far above real files, whose links have a handful of connectors each.
constexpr std::size_t most_connectors = 20000;
/// The bits of layers whose elements move; lower bits are drawings and measurements.
constexpr unsigned moving_layers = 0xFFFFFFF0U;

/// Attributes of the display of an element, and their names in the remark.
const std::map<std::string, std::string> looks = {
    {"color", "colours"},
    {"usercolor", "colours"},
    {"linesize", "widths of lines"},
    {"selected", "selections"},
    {"locked", "locks"},
    {"drawcircle", "circles"},
    {"showaspoint", "signs of points"},
    {"solid", "fillings"},
    {"polyline", "outlines"},
    {"shapetype", "outlines"},
    {"showangles", "angles that are shown"},
    {"zoom", "the view"},
    {"xoffset", "the view"},
    {"yoffset", "the view"},
    {"viewlayers", "the view"},
    {"editlayers", "the view"},
    {"xgrid", "the grid"},
    {"ygrid", "the grid"},
};

/// Throws MechanismError for deeper nesting than any such file has: the parser calls itself for
/// each level.
void expect_shallow(const std::string& text) {
  int depth = 0;
  const auto behind = [&](const char* end, std::size_t at) {
    const std::size_t found = text.find(end, at);
    return found == std::string::npos ? text.size() : found;
  };
  for (std::size_t at = text.find('<'); at < text.size(); at = text.find('<', at)) {
    if (text.compare(at, 4, "<!--") == 0) {
      at = behind("-->", at);
    } else if (text.compare(at, 9, "<![CDATA[") == 0) {
      at = behind("]]>", at);
    } else if (text.compare(at, 2, "<?") == 0) {
      at = behind("?>", at);
    } else if (text.compare(at, 2, "<!") == 0) {
      throw MechanismError("",
                           "a document type is declared; a file of Linkage has none, save it "
                           "from Linkage again");
    } else if (text.compare(at, 2, "</") == 0) {
      --depth;
      at += 2;
    } else {
      char quote = '\0';
      while (at < text.size() && (quote != '\0' || text[at] != '>')) {
        if (quote == '\0' && (text[at] == '"' || text[at] == '\'')) {
          quote = text[at];
        } else if (text[at] == quote) {
          quote = '\0';
        }
        ++at;
      }
      depth += text[at - 1] == '/' ? 0 : 1;
      if (depth > deepest) {
        throw MechanismError("", "elements are nested more than " + std::to_string(deepest) +
                                     " deep; a file of Linkage has three levels");
      }
    }
  }
}

/// The attributes of one element, each read once.
class Attributes {
 public:
  Attributes(const ptree& element, std::string part) : part_(std::move(part)) {
    if (const auto attributes = element.get_child_optional("<xmlattr>")) {
      for (const auto& [name, value] : *attributes) {
        values_.emplace(name, value.data());
      }
    }
  }

  [[nodiscard]] const std::string& part() const { return part_; }
  std::string text(const std::string& name) {
    const auto found = values_.find(name);
    if (found == values_.end()) {
      return "";
    }
    std::string value = found->second;
    values_.erase(found);
    return value;
  }
  bool truth(const std::string& name) { return text(name) == "true"; }
  /// A number; `absent` if there is none.
  double number(const std::string& name, std::optional<double> absent = 0) {
    const std::string value = text(name);
    if (value.empty() && absent) {
      return *absent;
    }
    double number = 0;
    const char* const end = value.data() + value.size();
    const auto [at, error] = std::from_chars(value.data(), end, number);
    if (at != end || error != std::errc() || !std::isfinite(number)) {
      throw MechanismError(part_ + "." + name,
                           value.empty() ? "the number is missing; save the file again"
                                         : "expected a number, found " + text::in_quotes(value));
    }
    return number;
  }
  std::optional<int> identifier(const std::string& name) {
    const std::string value = text(name);
    if (value.empty()) {
      return std::nullopt;
    }
    int number = 0;
    const char* const end = value.data() + value.size();
    const auto [at, error] = std::from_chars(value.data(), end, number);
    if (at != end || error != std::errc()) {
      throw MechanismError(part_ + "." + name,
                           "expected a whole number, found " + text::in_quotes(value));
    }
    return number;
  }
  /// Whether the element moves, and is not part of a drawing or a measurement.
  bool moves() {
    const std::optional<int> layer = identifier("layer");
    return !layer || *layer == 0 || (static_cast<unsigned>(*layer) & moving_layers) != 0;
  }
  /// Notes the display attributes as omitted, and returns the names of all remaining ones.
  std::vector<std::string> rest(ForeignMechanism& mechanism) {
    std::vector<std::string> unknown;
    for (const auto& [name, value] : values_) {
      const auto look = looks.find(name);
      if (look == looks.end()) {
        unknown.push_back(name);
      } else if (!value.empty() && value != "false") {
        mechanism.forget_look(look->second);
      }
    }
    return unknown;
  }

 private:
  std::string part_;
  std::map<std::string, std::string> values_;
};

/// Reads the elements of a file, one after another.
class ElementReader {
 public:
  explicit ElementReader(ForeignMechanism& mechanism) : mechanism_(mechanism) {}

  LinkageFile read(const ptree& root) {
    for (const auto& [kind, element] : root) {
      if (kind == "program") {
        read_program(element);
      } else if (kind == "connector") {
        read_connector(element);
      } else if (kind == "Link" || kind == "element") {
        read_link(element);
      } else if (kind == "ratios") {
        read_ratios(element);
      } else if (kind == "selected") {
        mechanism_.forget_look("selections");
      } else if (kind == "background") {
        if (!element.data().empty()) {
          mechanism_.remark("the picture in the background is left out");
        }
      } else if (kind != "<xmlattr>" && kind != "<xmlcomment>" && kind != "<xmltext>") {
        unknown_elements_.insert(kind);
      }
    }
    tell_what_is_left_out();
    return std::move(file_);
  }

 private:
  void finish(Attributes& attributes, const std::string& kind) {
    for (const std::string& name : attributes.rest(mechanism_)) {
      unknown_attributes_.insert(kind + "." + name);
    }
  }

  void read_program(const ptree& element) {
    Attributes program(element, "program");
    std::string unit = program.text("units");
    std::ranges::transform(unit, unit.begin(), [](unsigned char letter) {
      return static_cast<char>(std::tolower(letter));
    });
    file_.unit = unit == "inches" ? "in" : "mm";
    if (const double scale = program.number("scalefactor", 1); scale != 1 && scale != 0) {
      mechanism_.remark("the scale " + number_text(scale) +
                        " of the drawing is left out: the scene has the coordinates of the file");
    }
    (void)program.text("backgroundtransparency");
    finish(program, "program");
  }

  void read_connector(const ptree& element) {
    LinkageConnector connector;
    connector.id = identified(element, "connector");
    if (!connector_ids_.insert(connector.id).second) {
      throw MechanismError("connector " + std::to_string(connector.id),
                           "the file has two of them; save it from Linkage again");
    }
    if (connector_ids_.size() > most_connectors) {
      throw MechanismError("", "there are more than " + std::to_string(most_connectors) +
                                   " connectors; divide the file");
    }
    Attributes attributes(element, "connector " + std::to_string(connector.id));
    (void)attributes.text("id");
    connector.name = attributes.text("name");
    connector.x = attributes.number("x", std::nullopt);
    connector.y = attributes.number("y", std::nullopt);
    connector.is_input = attributes.truth("input");
    connector.is_anchor = attributes.truth("anchor") || connector.is_input;
    connector.is_drawing = attributes.truth("draw");
    connector.is_moved_by_hand = attributes.truth("alwaysmanual");
    connector.turns_per_minute = attributes.number("rpm");
    connector.limit_angle = attributes.number("limitangle");
    connector.start_offset = attributes.number("startoffset");
    connector.slide_radius = attributes.number("slideradius");
    connector.link = attributes.identifier("fasten");
    if (const auto link = attributes.identifier("fastenlink"); link && !connector.link) {
      connector.link = link;
    }
    connector.connector = attributes.identifier("fastenconnector");
    const bool is_slider = attributes.truth("slider");
    for (const auto& [kind, child] : element) {
      if (kind == "slidelimit" && is_slider && connector.slide_limits.size() < 2) {
        connector.slide_limits.push_back(
            Attributes(child, attributes.part() + ".slidelimit").identifier("id").value_or(-1));
      } else if (kind != "<xmlattr>" && kind != "<xmlcomment>" && kind != "<xmltext>" &&
                 kind != "slidelimit") {
        unknown_elements_.insert("connector." + kind);
      }
    }
    if (is_slider && connector.slide_limits.size() < 2) {
      mechanism_.miss(attributes.part() +
                      ": it slides, but the file names no two ends of the slot");
      connector.slide_limits.clear();
    }
    const bool is_measurement = attributes.truth("measurementelement");
    (void)attributes.text("measurementuseoffset");
    const bool moves = attributes.moves();
    finish(attributes, "connector");
    count(is_measurement, !moves, "connector");
    connector.moves = moves && !is_measurement;
    file_.connectors.push_back(connector);
  }

  void read_link(const ptree& element) {
    LinkageLink link;
    link.id = identified(element, "Link");
    if (++links_read_ > Mechanism::most_links) {
      throw MechanismError("", "there are more than " + std::to_string(Mechanism::most_links) +
                                   " links, the limit of scenes; divide the file");
    }
    Attributes attributes(element, "Link " + std::to_string(link.id));
    (void)attributes.text("id");
    link.name = attributes.text("name");
    link.is_actuator = attributes.truth("actuator");
    link.is_gear = attributes.truth("gear");
    link.is_moved_by_hand = attributes.truth("alwaysmanual");
    link.stroke = attributes.number("throw");
    link.cycles_per_minute = attributes.number("cpm");
    link.start_offset = attributes.number("startoffset");
    link.link = attributes.identifier("fastenlink");
    link.connector = attributes.identifier("fastenconnector");
    for (const auto& [kind, child] : element) {
      if (kind == "connector" || kind == "fastenconnector") {
        const auto id = Attributes(child, attributes.part() + "." + kind).identifier("id");
        if (id) {
          (kind == "connector" ? link.connectors : link.fastened).push_back(*id);
        }
      } else if (kind != "<xmlattr>" && kind != "<xmlcomment>" && kind != "<xmltext>") {
        unknown_elements_.insert("Link." + kind);
      }
    }
    const bool is_measurement = attributes.truth("measurementelement");
    (void)attributes.text("measurementuseoffset");
    const bool moves = attributes.moves();
    finish(attributes, "Link");
    count(is_measurement, !moves, "link");
    if (moves && !is_measurement) {
      file_.links.push_back(link);
    }
  }

  void read_ratios(const ptree& element) {
    for (const auto& [kind, child] : element) {
      if (kind != "ratio") {
        continue;
      }
      Attributes attributes(child, "ratio");
      LinkageRatio ratio;
      ratio.is_chain = attributes.text("type") != "gears";
      (void)attributes.text("sizeassize");  // the ratio is that of the sizes in either case
      for (const auto& [part, wheel] : child) {
        if (part == "link") {
          Attributes link(wheel, "ratio.link");
          ratio.links.push_back(link.identifier("id").value_or(-1));
          ratio.sizes.push_back(link.number("size"));
        }
      }
      finish(attributes, "ratio");
      file_.ratios.push_back(ratio);
    }
  }

  static int identified(const ptree& element, const std::string& kind) {
    const std::optional<int> id = Attributes(element, kind).identifier("id");
    if (!id) {
      throw MechanismError(kind, "an element has no 'id'; save the file from Linkage again");
    }
    return *id;
  }

  void count(bool is_measurement, bool is_drawn, const std::string& kind) {
    if (is_measurement || is_drawn) {
      ++left_out_[{is_measurement ? "measurement" : "the drawing layer", kind}];
    }
  }

  void tell_what_is_left_out() {
    for (const std::string layer : {"measurement", "the drawing layer"}) {
      std::vector<std::string> counts;
      for (const auto& [key, number] : left_out_) {
        if (key.first == layer) {
          counts.push_back(std::to_string(number) + " " + key.second + (number == 1 ? "" : "s"));
        }
      }
      if (!counts.empty()) {
        mechanism_.remark("elements of " + layer + " are left out: " + text::listed(counts));
      }
    }
    for (const std::string& name : unknown_attributes_) {
      mechanism_.remark("the attribute " + text::in_quotes(name) +
                        " is not known here, and left out");
    }
    for (const std::string& name : unknown_elements_) {
      mechanism_.miss("the element " + text::in_quotes(name) + " is not known here, and left out");
    }
  }

  ForeignMechanism& mechanism_;
  LinkageFile file_;
  std::set<int> connector_ids_;
  std::size_t links_read_ = 0;
  std::map<std::pair<std::string, std::string>, int> left_out_;  ///< by layer and kind
  std::set<std::string> unknown_attributes_, unknown_elements_;
};

}  // namespace

LinkageFile read_linkage(const std::string& text, ForeignMechanism& mechanism) {
  expect_shallow(text);
  ptree document;
  try {
    std::istringstream stream(text);
    boost::property_tree::read_xml(stream, document);
  } catch (const boost::property_tree::xml_parser_error& error) {
    throw MechanismError("line " + std::to_string(error.line()),
                         "no XML (" + error.message() + "); save the file from Linkage again");
  }
  const auto root = document.get_child_optional("linkage2");
  if (!root) {
    throw MechanismError("", "expected the element <linkage2>; save the file from Linkage again");
  }
  return ElementReader(mechanism).read(*root);
}

}  // namespace assur::mechanism::foreign
