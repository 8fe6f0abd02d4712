#include "emission/cpp/filled_lines.hpp"

namespace assur::generator::emission::cpp {

namespace {

/// The common part of entries of one row: `J(0` of `J(0, 1)`, `rhs` of `rhs(0)`.
std::string row_of(const std::string& target) {
  const std::size_t comma = target.find(',');
  return target.substr(0, comma == std::string::npos ? target.find_first_of("([.") : comma);
}

}  // namespace

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

void FilledLines::assign(const std::string& target, const std::string& value) {
  const std::string statement = target + " = " + value + ";";
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
