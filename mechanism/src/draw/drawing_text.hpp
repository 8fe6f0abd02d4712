// Text of numbers and names in a drawing.
#pragma once

#include <Eigen/Core>
#include <array>
#include <charconv>
#include <string>

namespace assur::mechanism::draw {

/// A coordinate of the picture: two decimals are a four-hundredth of a millimetre.
[[nodiscard]] inline std::string coordinate(double value) {
  std::array<char, 64> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 2);
  std::string number(text.data(), end.ptr);
  number.erase(number.find_last_not_of('0') + 1);
  if (number.back() == '.') {
    number.pop_back();
  }
  return number == "-0" ? "0" : number;
}

[[nodiscard]] inline std::string pair(const Eigen::Vector2d& place) {
  return coordinate(place.x()) + "," + coordinate(place.y());
}

/// `name="value"`, preceded by a blank.
[[nodiscard]] inline std::string attribute(const std::string& name, double value) {
  return " " + name + "=\"" + coordinate(value) + "\"";
}

/// The shortest text that parses to this number.
[[nodiscard]] inline std::string exact(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

}  // namespace assur::mechanism::draw
