#include "audit/code/local_values.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace assur::generator::audit::code {

namespace {

constexpr long largest_whole = std::numeric_limits<std::int32_t>::max();

/// `q[2][1]` as `q` and two indices.
struct Element {
  std::string of;
  std::ptrdiff_t indices;
};

Element element_of(const CodeName& name) {
  const std::size_t dot = name.spelled.rfind('.');
  const std::size_t open = name.spelled.find('[', dot == std::string::npos ? 0 : dot);
  return {name.spelled.substr(0, open),
          std::count(name.spelled.begin() +
                         static_cast<std::ptrdiff_t>(std::min(open, name.spelled.size())),
                     name.spelled.end(), '[')};
}

}  // namespace

void LocalValues::expect_one_spelling(const CodeName& name) const {
  const Element element = element_of(name);
  for (const Assigned& other : assigned_) {
    const Element set = element_of(other.name);
    if (set.of == element.of && set.indices > 0 && element.indices > 0 &&
        set.indices != element.indices) {
      throw CodeError(
          "'" + name.spelled + "' and '" + other.name.spelled + "' may be one value" + by_running,
          name.place);
    }
  }
}

void LocalValues::expect_own_storage(const CodeName& name) const {
  const std::size_t dot = name.spelled.find('.');
  if (name.called && dot != std::string::npos && name.spelled.find('[', dot) != std::string::npos) {
    throw CodeError("'" + name.spelled + "' may be another name of a value" + by_running,
                    name.place);
  }
  const Element element = element_of(name);
  const auto is_whole = [&](const Assigned& other) {
    return element.indices > 0 && other.name.spelled == element.of && !other.taken &&
           names_.meanings.contains(other.name.name);
  };
  const bool is_symbol = element.indices > 0 && system_.is_known(element.of);
  if (is_symbol || std::ranges::any_of(assigned_, is_whole)) {
    throw CodeError("'" + name.spelled + "' may be '" + element.of + "' itself" + by_running,
                    name.place);
  }
  expect_one_spelling(name);
}

void LocalValues::refuse_calls(const CodeFormula& formula) const {
  std::vector<CodeName> calls = formula.unknown_calls;
  for (const CodeName& name : formula.names) {
    const std::string base = name.spelled.substr(0, name.spelled.find_first_of(".["));
    const bool set = std::any_of(assigned_.begin(), assigned_.end(), [&](const Assigned& each) {
      return name.is_part_of(each.name) && !functions_.contains(each.name.name);
    });
    const bool element = set || (system_.is_known(name.name) && !functions_.contains(base));
    if (name.called && !element) {
      calls.push_back({base, base, name.place, true});
    }
  }
  if (!calls.empty()) {
    throw CodeError("what '" + calls[0].name + "' does cannot be followed" + by_running,
                    calls[0].place);
  }
}

void LocalValues::refuse_calls(Tokens expression) const {
  if (!expression.empty()) {
    refuse_calls(code_formula(expression, dialect_));
  }
}

void LocalValues::expect_readable(const CodeName& name) const {
  const std::size_t dot = name.spelled.rfind('.');
  const std::string member =
      dot == std::string::npos
          ? ""
          : name.spelled.substr(dot + 1, name.spelled.find('[', dot) - dot - 1);
  if (const auto found = members_.find(member); found != members_.end()) {
    throw CodeError("'" + name.spelled + "' cannot be read: " + found->second, name.place);
  }
  expect_one_spelling(name);
  for (auto at = assigned_.rbegin(); at != assigned_.rend(); ++at) {
    if (at->name.name == name.name && at->name.spelled != name.spelled) {
      throw CodeError("'" + name.spelled + "' and '" + at->name.spelled +
                          "' would be read as one; give one of them another name",
                      name.place);
    }
    if (name.is_part_of(at->name)) {
      if (at->taken && (at->reason.empty() || name.spelled != at->name.spelled)) {
        return;
      }
      if (name.spelled != at->name.spelled && !at->refused) {
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
  expect_own_storage(name);
  const bool whole = std::any_of(whole_.begin(), whole_.end(),
                                 [&](const CodeName& each) { return name.is_part_of(each); });
  std::string reason;
  closures::Place place = name.place;
  std::optional<GiNaC::ex> meaning;
  try {
    refuse_calls(expression);
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
    if (whole && GiNaC::is_a<GiNaC::numeric>(*meaning) &&
        GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(*meaning)) > largest_whole) {
      throw CodeError("its value is beyond 2147483647, which a whole number may not hold",
                      read.text.place);
    }
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
  expect_own_storage(name);
  names_.meanings.erase(name.name);
  assigned_.push_back({name, reason, name.place});
}

void LocalValues::take(const CodeName& name, const std::string& reason) {
  names_.meanings.erase(name.name);
  assigned_.push_back({name, reason, name.place, true});
}

void LocalValues::refuse(const CodeName& name, const std::string& reason) {
  names_.meanings.erase(name.name);
  assigned_.push_back({name, reason, name.place, false, true});
}

void LocalValues::hold(Tokens expression) {
  for (const CodeName& name : code_formula(expression, dialect_).names) {
    held_.push_back(name);
  }
}

}  // namespace assur::generator::audit::code
