#include "audit/code/cpp_filled_matrix.hpp"

#include <algorithm>

#include "audit/code/cpp_file.hpp"

namespace assur::generator::audit::code {

namespace {

/// Whether all tokens are zeros, commas or braces.
bool is_nothing(Tokens tokens) {
  return std::all_of(tokens.begin(), tokens.end(), [](const Token& token) {
    return token.is("{") || token.is("}") || token.is(",") || token.is("0") || token.is("0.0") ||
           token.is("0.");
  });
}

}  // namespace

void CppFilledMatrix::take_parameter(const Declarator& declared) {
  declare_variable(declared).zero = true;
  own_ = !declared.type.is_shared() && !declared.type.plain;
}

/// Throws CodeError unless the type is a matrix of real numbers of the audited size.
Variable& CppFilledMatrix::declare_variable(const Declarator& declared) {
  const Type& type = declared.type;
  if (type.kind != Type::Kind::other && (type.sort == Sort::whole || type.sort == Sort::rounded)) {
    throw CodeError(scope_.array() +
                        (type.sort == Sort::whole
                             ? " holds whole numbers"
                             : " holds numbers that do not keep every value as it is" + by_running),
                    declared.name->place);
  }
  if (type.kind != Type::Kind::grid && !(type.kind == Type::Kind::other && type.undeclared)) {
    throw CodeError("the type of " + scope_.array() + " is not known" + by_running,
                    declared.name->place);
  }
  expect_shape(type.rows, type.columns, *declared.name);
  declared_at_ = declared.name->place;
  std::optional<Type> known = type;
  known->rows.reset();
  known->columns.reset();
  known->constant = false;
  round_ = type.kind == Type::Kind::other || type.round;
  square_ = type.kind == Type::Kind::other || type.square;
  return scope_.variables().declare(*declared.name, Variable::Origin::own,
                                    type.kind == Type::Kind::other ? std::nullopt : known);
}

void CppFilledMatrix::expect_shape(std::optional<std::size_t> rows,
                                   std::optional<std::size_t> columns, const Token& at) const {
  if (rows.value_or(scope_.audited().rows) != scope_.audited().rows ||
      columns.value_or(scope_.audited().columns) != scope_.audited().columns) {
    throw CodeError(scope_.array() + " has another size here, and is audited as " +
                        scope_.audited().size_text(),
                    at.place);
  }
}

void CppFilledMatrix::declare(const Declarator& declared) {
  Variable& matrix = declare_variable(declared);
  own_ = true;
  Tokens rest = declared.rest;
  const bool class_of_known_size = !declared.type.round && declared.type.rows;
  const bool assigned = !rest.empty() && rest[0].is("=");
  if (are(rest, {"(", "#", ",", "#", ")"})) {
    if (!round_) {
      scope_.refuse(*declared.name);
    }
    expect_shape(whole_number(rest[1]), whole_number(rest[3]), *declared.name);
  } else if (assigned && is_zero(rest.subspan(1))) {
    matrix.zero = true;
  } else if (!rest.empty()) {
    // `{}` and `{0}` set an array to zero, but not the entries of Eigen's classes.
    const Tokens braces = rest.subspan(assigned ? 1 : 0);
    const bool nothing = is_enclosed(braces, "{") && is_nothing(braces);
    matrix.zero = nothing && class_of_known_size;
    if (!nothing || (!class_of_known_size && braces.size() != 2)) {
      scope_.refuse(*declared.name);
    }
  }
  if (matrix.zero) {
    scope_.note_filled(declared.name->place);
  }
}

bool CppFilledMatrix::is_zero(Tokens value) const {
  const auto word =
      std::find_if(value.begin(), value.end(), [](const Token& token) { return token.is("Zero"); });
  const auto at = static_cast<std::size_t>(word - value.begin());
  if (at < 2 || at + 1 >= value.size() || !value[at - 1].is("::")) {
    return false;
  }
  Tokens type = value.first(at - 1);
  const std::optional<Type> of = scope_.types().take(type);
  const Tokens size = value.subspan(at + 1);
  const bool sized = are(size, {"(", "#", ",", "#", ")"});
  if (!of || !type.empty() || (!sized && !are(size, {"(", ")"}))) {
    return false;
  }
  if (of->kind != Type::Kind::grid || !of->round || of->sort != Sort::real) {
    return false;
  }
  if (!sized && !(of->rows && of->columns)) {
    return false;
  }
  expect_shape(of->rows, of->columns, *word);
  if (sized) {
    expect_shape(whole_number(size[1]), whole_number(size[3]), *word);
  }
  return true;
}

void CppFilledMatrix::fill(Tokens statement) {
  const Token& first = statement[0];
  const std::size_t entry = scope_.entry_length(statement);
  const Tokens rest = statement.subspan(entry > 0 ? entry : 1);
  if (entry > 0 && !rest.empty() && rest[0].is("=")) {
    const Tokens value = rest.subspan(1);
    if (comma_parts(value).size() > 1) {
      scope_.refuse(first);
    }
    if (value.empty()) {
      throw CodeError("a value is missing", first.place);
    }
    if (entry == 6 ? !round_ : !square_) {
      scope_.refuse(first);
    }
    scope_.check_reading(value);
    static_cast<void>(scope_.variables().found(first));
    const Spelled target = scope_.variables().spelled(statement);
    scope_.set_entry(target.indices[0], target.indices[1], target, scope_.cell_of(value));
  } else if (entry == 0 && !rest.empty() && rest[0].is("<<") && round_) {
    set_all(comma_parts(rest.subspan(1)), first);
  } else if (entry == 0 && round_ && clears(rest)) {
    Variable& matrix = scope_.variables().found(first);
    scope_.variables().expect_free(matrix, "", scope_.array(), first.place);
    matrix.cells.clear();
    matrix.zero = true;
  } else {
    scope_.refuse(first);
  }
}

/// `J << a, b, c, d`; no value may read the matrix, since some entries are set before.
void CppFilledMatrix::set_all(const std::vector<Tokens>& values, const Token& first) {
  if (values.size() != scope_.audited().rows * scope_.audited().columns) {
    throw CodeError(scope_.array() + " is audited as " + scope_.audited().size_text() +
                        ", and this lists " + std::to_string(values.size()) + " entries",
                    first.place);
  }
  Variable& matrix = scope_.variables().found(first);
  scope_.variables().expect_free(matrix, "", scope_.array(), first.place);
  for (std::size_t at = 0; at < values.size(); ++at) {
    if (values[at].empty()) {
      throw CodeError("a value is missing", first.place);
    }
    if (const Token* mention = mention_of(values[at], scope_.array())) {
      scope_.refuse(*mention);
    }
    const std::size_t row = at / scope_.audited().columns;
    const std::size_t column = at % scope_.audited().columns;
    Spelled entry{&matrix,
                  scope_.array(),
                  "[" + std::to_string(row) + "][" + std::to_string(column) + "]",
                  "",
                  {},
                  Sort::real,
                  first.place,
                  0,
                  true};
    scope_.set_entry(row, column, entry, scope_.cell_of(values[at]));
  }
}

/// Whether the tokens after the matrix's name set all its entries to zero.
bool CppFilledMatrix::clears(Tokens rest) const {
  if (are(rest, {".", "setZero", "(", "#", ",", "#", ")"})) {
    expect_shape(whole_number(rest[3]), whole_number(rest[5]), rest[1]);
    return true;
  }
  return are(rest, {".", "setZero", "(", ")"}) || are(rest, {".", "fill", "(", "0", ")"}) ||
         are(rest, {".", "fill", "(", "0.0", ")"}) ||
         are(rest, {".", "setConstant", "(", "0", ")"}) ||
         (rest.size() > 1 && rest[0].is("=") && is_zero(rest.subspan(1)));
}

}  // namespace assur::generator::audit::code
