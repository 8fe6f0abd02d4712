// Lays out the statements of a straight-line function; related ones share lines.
#pragma once

#include <string>
#include <vector>

#include "program/program.hpp"

namespace assur::generator::emission::cpp {

/// The width of a line of emitted text, and the indentation of a member function's body.
constexpr std::size_t line_width = 100;
constexpr std::size_t body_indentation = 4;

/// `J(0, 1)`, `poses[2].x`
[[nodiscard]] std::string spelled(const program::Place& place);

/// Consecutive declarations become one statement, and assignments to entries of one row of a matrix
/// share a line as long as there is room.
class FilledLines {
 public:
  /// Lines with the indentation of a member function's body, or more.
  explicit FilledLines(std::size_t indentation = body_indentation) : indentation_(indentation) {}

  /// A line by itself.
  void add(const std::string& line);
  /// The next text begins a line.
  void begin_line() { last_ = Last::other; }
  /// `const Scalar name = value`
  void declare(const std::string& name, const std::string& value);
  /// `target = value`
  void assign(const program::Place& target, const std::string& value);

  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }

 private:
  enum class Last : unsigned char { other, declaration, assignment };
  /// Whether a line has room for more text.
  [[nodiscard]] bool has_room(const std::string& more) const;

  std::size_t indentation_;
  std::vector<std::string> lines_;
  Last last_ = Last::other;
  program::Place row_;  ///< of the last assignment
};

}  // namespace assur::generator::emission::cpp
