#include "emission/cpp/filled_lines.hpp"

namespace assur::generator::emission::cpp {

namespace {

/// What the places in one line have in common: the row of a matrix, or the argument.
program::Place row_of(const program::Place& target) {
  return {target.argument, "", target.column < 0 ? -1 : target.row, -1};
}

}  // namespace

std::string spelled(const program::Place& place) {
  if (!place.is_entry()) {
    return place.argument + place.member;
  }
  return place.argument + "(" + std::to_string(place.row) +
         (place.column < 0 ? "" : ", " + std::to_string(place.column)) + ")";
}

void FilledLines::add(const std::string& line) {
  lines_.push_back(line);
  last_ = Last::other;
}

void FilledLines::declare(const std::string& name, const std::string& value) {
  const std::string declarator = name + " = " + value + ";";
  if (last_ == Last::declaration && has_room(" " + declarator)) {
    lines_.back().back() = ',';
    lines_.back() += " " + declarator;
  } else {
    lines_.push_back("const Scalar " + declarator);
  }
  last_ = Last::declaration;
}

void FilledLines::assign(const program::Place& target, const std::string& value) {
  const std::string statement = spelled(target) + " = " + value + ";";
  if (last_ == Last::assignment && row_ == row_of(target) && has_room("  " + statement)) {
    lines_.back() += "  " + statement;
  } else {
    lines_.push_back(statement);
  }
  last_ = Last::assignment;
  row_ = row_of(target);
}

bool FilledLines::has_room(const std::string& more) const {
  return indentation_ + lines_.back().size() + more.size() <= line_width;
}

}  // namespace assur::generator::emission::cpp
