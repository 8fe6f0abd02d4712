#include "audit/code/local_values.hpp"

namespace assur::generator::audit::code {

namespace {

void refuse_calls(const CodeFormula& formula) {
  if (!formula.unknown_calls.empty()) {
    const CodeName& call = formula.unknown_calls.front();
    throw CodeError("what '" + call.name + "' does cannot be followed" + by_running, call.place);
  }
}

}  // namespace

void LocalValues::expect_readable(const CodeName& name) const {
  for (auto at = assigned_.rbegin(); at != assigned_.rend(); ++at) {
    if (at->name.name == name.name && at->name.spelled != name.spelled) {
      throw CodeError("'" + name.spelled + "' and '" + at->name.spelled +
                          "' would be read as one; give one of them another name",
                      name.place);
    }
    if (name.is_part_of(at->name)) {
      if (at->taken) {
        return;
      }
      if (name.spelled != at->name.spelled) {
        throw CodeError("'" + name.spelled + "' is part of '" + at->name.spelled +
                            "', which is set here and cannot be followed" + by_running,
                        name.place);
      }
      if (!at->reason.empty()) {
        throw CodeError("'" + name.spelled + "' cannot be read: " + at->reason, at->place);
      }
      return;
    }
  }
}

CodeFormula LocalValues::formula(Tokens expression) const {
  CodeFormula formula = code_formula(expression, dialect_);
  refuse_calls(formula);
  for (const CodeName& name : formula.names) {
    expect_readable(name);
  }
  if (dialect_.whole_quotients_round) {
    static_cast<void>(is_whole(formula));
  }
  return formula;
}

void LocalValues::expect_free(const CodeName& name) const {
  for (const CodeName& held : held_) {
    if (held.is_part_of(name) || name.is_part_of(held)) {
      throw CodeError("'" + name.spelled + "' is set while a reference to it is held" + by_running,
                      name.place);
    }
  }
}

void LocalValues::set(const CodeName& name, Tokens expression) {
  expect_free(name);
  const bool whole = whole_.contains(name.name);
  std::string reason;
  closures::Place place = name.place;
  std::optional<GiNaC::ex> meaning;
  try {
    refuse_calls(code_formula(expression, dialect_));
  } catch (const CodeError& error) {
    if (std::string(error.what()).ends_with(by_running)) {
      throw;  // it may do more than give a value
    }
  }
  try {
    const CodeFormula read = formula(expression);
    if (whole && !is_whole(read)) {
      throw CodeError("its value is rounded to a whole number", read.text.place);
    }
    meaning = closures::read_formula(read.text, system_, names_);
  } catch (const closures::FormulaError& error) {
    reason = error.what();
    place = error.place;
  } catch (const CodeError& error) {
    reason = error.what();
    place = error.place;
  }
  names_.meanings.erase(name.name);
  if (meaning) {
    names_.meanings[name.name] = *meaning;
  }
  assigned_.push_back({name, reason, place});
}

void LocalValues::forget(const CodeName& name, const std::string& reason) {
  expect_free(name);
  names_.meanings.erase(name.name);
  assigned_.push_back({name, reason, name.place});
}

void LocalValues::take(const CodeName& name) {
  names_.meanings.erase(name.name);
  assigned_.push_back({name, "", name.place, true});
}

void LocalValues::hold(Tokens expression) {
  for (const CodeName& name : code_formula(expression, dialect_).names) {
    held_.push_back(name);
  }
}

}  // namespace assur::generator::audit::code
