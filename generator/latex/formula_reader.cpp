#include "latex/formula_reader.hpp"

namespace assur::generator::latex {

namespace {

constexpr int most_nested = 60;
/// The work of one second of reading.
constexpr std::size_t most_work = 2'000'000;

}  // namespace

bool is_fraction(const Token& token) {
  return token.is("\\frac") || token.is("\\dfrac") || token.is("\\tfrac") || token.is("\\cfrac");
}

FormulaReader::FormulaReader(Tokens tokens, const Reading& reading, Progress& progress, Place place,
                             int depth)
    : tokens_(std::move(tokens)),
      reading_(reading),
      progress_(progress),
      place_(place),
      depth_(depth) {
  for (std::size_t at = 0; at + 1 < tokens_.size(); ++at) {
    tokens_[at + 1].spaced =
        tokens_[at + 1].spaced || (is_layout(tokens_[at]) && tokens_[at].spaced);
  }
  std::erase_if(tokens_, [](const Token& token) { return is_layout(token); });
  if (!tokens_.empty()) {
    place_ = tokens_[0].place;
  }
  if (depth_ > most_nested) {
    throw FormulaError("this is nested too deeply", place_);
  }
  spend(tokens_.size(), 0);
}

void FormulaReader::fail(const std::string& what, std::size_t at) const {
  const bool inside = at < tokens_.size();
  throw FormulaError(what, inside || tokens_.empty() ? (inside ? tokens_[at].place : place_)
                                                     : tokens_.back().place);
}

void FormulaReader::skip_spaces() {
  while (at_ < tokens_.size() && is_thin_space(tokens_[at_])) {
    ++at_;
  }
}

Expression FormulaReader::read(Tokens tokens, std::size_t at) {
  return FormulaReader(std::move(tokens), reading_, progress_, place_of(at), depth_ + 1).whole();
}

Place FormulaReader::place_of(std::size_t at) const {
  return at < tokens_.size() ? tokens_[at].place : tokens_.empty() ? place_ : tokens_.back().place;
}

std::size_t FormulaReader::column(std::size_t at) {
  progress_.places.push_back(place_of(at));
  return progress_.places.size();
}

void FormulaReader::spend(std::size_t work, std::size_t at) {
  progress_.work += work;
  if (progress_.work > most_work) {
    fail("written out, this has more than " + std::to_string(most_work) +
             " tokens; let the map skip this equation",
         at);
  }
}

Expression FormulaReader::call(const std::string& name, Operation operation,
                               std::vector<Expression> arguments, std::size_t at) {
  return {Expression::Kind::call, 0, name, std::move(arguments), operation, column(at)};
}

Expression FormulaReader::binary(const std::string& name, Operation operation, Expression left,
                                 Expression right, std::size_t at) {
  std::vector<Expression> both;
  both.push_back(std::move(left));
  both.push_back(std::move(right));
  return call(name, operation, std::move(both), at);
}

Expression FormulaReader::number_tree(const std::string& digits, std::size_t at) {
  return {Expression::Kind::number, std::stod(digits), digits, {}, Operation::other, column(at)};
}

}  // namespace assur::generator::latex
