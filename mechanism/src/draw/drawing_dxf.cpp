// Drawings as DXF files for CAD, in the ASCII form of R12, which needs neither handles nor objects.
#include <algorithm>
#include <array>
#include <assur/mechanism/drawing.hpp>
#include <assur/text/numbers.hpp>
#include <assur/text/utf8.hpp>
#include <cstdint>
#include <cstdio>
#include <map>
#include <set>

#include "draw/drawing_text.hpp"
#include "draw/palette.hpp"

namespace assur::mechanism::draw {

namespace {

using Eigen::Vector2d;

// Lengths relative to the drawing's size.
constexpr double pin_part = 0.008;
constexpr double text_part = 0.016;
constexpr double block_part = 0.02;

/// The code of a unit in `$INSUNITS`; R12 has no such variable, and programs that do not support it
/// skip it.
struct DxfUnit {
  const char* name;
  int code;
};
constexpr std::array dxf_units = {DxfUnit{"in", 1},  DxfUnit{"ft", 2}, DxfUnit{"mm", 4},
                                  DxfUnit{"cm", 5},  DxfUnit{"m", 6},  DxfUnit{"km", 7},
                                  DxfUnit{"um", 13}, DxfUnit{"dm", 14}};

/// Colours of AutoCAD's index that resemble those of the palette, in the same order.
constexpr std::array dxf_colours = {5, 30, 94, 211, 40, 151};
constexpr int dxf_ink = 7;

/// A layer, identified by its content, and its preferred name.
struct Layer {
  enum class Holds : unsigned char { ground, link, pins, outputs, path, events } holds;
  std::string name;
};

/// Names as R12 allows them: capital letters, digits, `_` and `-`, 31 at most; a number
/// distinguishes two that would become equal.
class LayerNames {
 public:
  const std::string& of(const Layer& layer) {
    const std::string& wanted = layer.name;
    std::string& name = names_[{layer.holds, layer.name}];
    for (int copy = 1; name.empty(); ++copy) {
      const std::string tail = copy == 1 ? "" : "_" + std::to_string(copy);
      std::string cut = plain(wanted).substr(0, 31 - tail.size()) + tail;
      if (taken_.insert(cut).second) {
        name = std::move(cut);
      }
    }
    return name;
  }

 private:
  static std::string plain(const std::string& text) {
    std::string result;
    for (const char letter : text) {
      const bool lower = letter >= 'a' && letter <= 'z';
      const bool fits =
          (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9') || letter == '-';
      result += lower ? static_cast<char>(letter - 'a' + 'A') : fits ? letter : '_';
    }
    return result;
  }

  std::map<std::pair<Layer::Holds, std::string>, std::string> names_;
  std::set<std::string> taken_;
};

/// The text in ASCII, the only letters of R12: others are written as in `\\U+00B5`.
std::string in_ascii(const std::string& text) {
  std::string result;
  std::uint32_t letter = 0;
  int more = 0;  // remaining bytes of the letter
  for (const char byte : text.substr(0, text::first_byte_outside_utf8(text))) {
    const auto bits = static_cast<unsigned char>(byte);
    if (bits < 0x80U) {
      result += bits < 0x20U ? '?' : byte;
      continue;
    }
    const bool begins = bits >= 0xC0U;
    more = begins ? (bits >= 0xF0U ? 3 : bits >= 0xE0U ? 2 : 1) : more - 1;
    letter = begins ? bits & (0x3FU >> static_cast<unsigned>(more)) : letter << 6U | (bits & 0x3FU);
    if (more == 0) {
      std::array<char, 16> code{};
      (void)std::snprintf(code.data(), code.size(), "\\U+%04X", letter);
      result += code.data();
    }
  }
  return result;
}

class DxfWriter {
 public:
  explicit DxfWriter(const Drawing& drawing) : drawing_(drawing), size_(size_of_drawing()) {}

  std::string written() {
    add_ground();
    for (const Stance& stance : drawing_.stances) {
      for (const Shape& shape : drawing_.shapes) {
        if (!shape.fixed) {
          add_shape(shape, stance, layer_of(shape, stance));
        }
      }
    }
    for (const Trace& trace : drawing_.traces) {
      layer({Layer::Holds::path, prefix(trace.configuration) + "path " + trace.output},
            colour(trace.configuration));
      polyline(trace.points, false);
    }
    for (const Mark& mark : drawing_.marks) {
      layer({Layer::Holds::events, "singular"}, dxf_ink);
      for (const Vector2d& point : mark.points) {
        group("POINT", point);
        text(point, mark.event + " at " + drawing_.parameter + " = " +
                        text::short_number(mark.parameter, 6));
      }
    }
    return header() + tables() + "0\nSECTION\n2\nENTITIES\n" + entities_ + "0\nENDSEC\n0\nEOF\n";
  }

 private:
  [[nodiscard]] double size_of_drawing() const {
    const std::vector<Vector2d>& points = drawing_.stances[drawing_.emphasised].points;
    Vector2d lowest = points[0];
    Vector2d highest = points[0];
    for (const Vector2d& point : points) {
      lowest = lowest.cwiseMin(point);
      highest = highest.cwiseMax(point);
    }
    const double size = (highest - lowest).norm();
    return size > 0 ? size : 1;
  }

  static std::string prefix(int configuration) { return "c" + std::to_string(configuration) + " "; }
  static int colour(int configuration) {
    return configuration < 1 ? dxf_ink : dxf_colours[colour_of(configuration)];
  }
  static Layer layer_of(const Shape& shape, const Stance& stance) {
    const std::string before = prefix(stance.configuration);
    return shape.symbol == Symbol::tracer ? Layer{Layer::Holds::outputs, before + "outputs"}
           : shape.link.empty()           ? Layer{Layer::Holds::pins, before + "pins"}
                                          : Layer{Layer::Holds::link, before + shape.link};
  }

  /// Puts the following entities on a layer.
  void layer(const Layer& wanted, int colour) {
    layer_ = names_.of(wanted);
    layers_.emplace(layer_, colour);
  }
  void group(const char* entity) {
    entities_ += std::string("0\n") + entity + "\n8\n" + layer_ + "\n";
  }
  void group(const char* entity, const Vector2d& at) {
    group(entity);
    place(0, at);
  }
  void place(int number, const Vector2d& at) {
    entities_ += "1" + std::to_string(number) + "\n" + exact(at.x()) + "\n2" +
                 std::to_string(number) + "\n" + exact(at.y()) + "\n3" + std::to_string(number) +
                 "\n0\n";
  }
  void line(const Vector2d& from, const Vector2d& to) {
    group("LINE", from);
    place(1, to);
  }
  void polyline(const std::vector<Vector2d>& points, bool closed) {
    group("POLYLINE");
    entities_ += std::string("66\n1\n70\n") + (closed ? "1" : "0") + "\n";
    place(0, {0, 0});
    for (const Vector2d& point : points) {
      group("VERTEX", point);
    }
    group("SEQEND");
  }
  void text(const Vector2d& beside, const std::string& words) {
    group("TEXT", beside + Vector2d::Constant(1.3 * pin_part * size_));
    entities_ += "40\n" + exact(text_part * size_) + "\n1\n" + in_ascii(words) + "\n";
  }

  void add_shape(const Shape& shape, const Stance& stance, const Layer& on_layer) {
    layer(on_layer, shape.fixed ? dxf_ink : colour(stance.configuration));
    std::vector<Vector2d> at;
    for (const std::size_t point : shape.points) {
      at.push_back(stance.points[point]);
    }
    switch (shape.symbol) {
      case Symbol::plate:
        polyline(at, true);
        return;
      case Symbol::block:
        rectangle(at[0] - block_part * size_ * (at[1] - at[0]).normalized(),
                  at[0] + block_part * size_ * (at[1] - at[0]).normalized());
        return;
      case Symbol::tube:
        rectangle(at[0], at[1]);
        return;
      case Symbol::pin:
        group("CIRCLE", at[0]);
        entities_ += "40\n" + exact(pin_part * size_) + "\n";
        text(at[0], shape.name);
        return;
      case Symbol::tracer:
        group("POINT", at[0]);
        text(at[0], shape.name);
        return;
      case Symbol::bar:
      case Symbol::rod:
      case Symbol::slot:
      case Symbol::guide:
        line(at[0], at[1]);
        return;
    }
  }

  void rectangle(const Vector2d& from, const Vector2d& to) {
    const Vector2d along = (to - from).normalized();
    const Vector2d aside = 0.6 * block_part * size_ * Vector2d(-along.y(), along.x());
    polyline({from + aside, to + aside, to - aside, from - aside}, true);
  }

  /// Adds the fixed shapes, which are the same in all stances, except for the range of parts that
  /// slide along them.
  void add_ground() {
    for (const Shape& shape : drawing_.shapes) {
      if (shape.fixed) {
        add_shape(shape, drawing_.stances[drawing_.emphasised], {Layer::Holds::ground, "ground"});
      }
    }
  }

  [[nodiscard]] std::string header() const {
    const auto* const unit =
        std::find_if(dxf_units.begin(), dxf_units.end(),
                     [&](const DxfUnit& known) { return drawing_.unit == known.name; });
    return "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n9\n$INSUNITS\n70\n" +
           std::to_string(unit == dxf_units.end() ? 0 : unit->code) + "\n0\nENDSEC\n";
  }
  [[nodiscard]] std::string tables() const {
    std::string text =
        "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLTYPE\n70\n1\n0\nLTYPE\n2\nCONTINUOUS\n70\n0\n3\n"
        "Solid line\n72\n65\n73\n0\n40\n0\n0\nENDTAB\n0\nTABLE\n2\nLAYER\n70\n" +
        std::to_string(layers_.size()) + "\n";
    for (const auto& [name, colour] : layers_) {
      text +=
          "0\nLAYER\n2\n" + name + "\n70\n0\n62\n" + std::to_string(colour) + "\n6\nCONTINUOUS\n";
    }
    return text + "0\nENDTAB\n0\nENDSEC\n";
  }

  const Drawing& drawing_;
  double size_;
  LayerNames names_;
  std::map<std::string, int> layers_;  ///< with their colours
  std::string layer_;
  std::string entities_;
};

}  // namespace

}  // namespace assur::mechanism::draw

namespace assur::mechanism {

std::string drawing_dxf(const Drawing& drawing) { return draw::DxfWriter(drawing).written(); }

}  // namespace assur::mechanism
