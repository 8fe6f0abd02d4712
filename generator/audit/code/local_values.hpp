// Turns the assignments of straight-line code, one after the other, into what its variables mean.
#pragma once

#include <map>
#include <optional>
#include <set>

#include "audit/code/formula.hpp"
#include "closures/read_formula.hpp"

namespace assur::generator::audit::code {

/// Variables that the code never sets stand for the symbols of the system; all others for what was
/// assigned last.
class LocalValues {
 public:
  LocalValues(closures::ClosureSystem& system, const Dialect& dialect)
      : system_(system), dialect_(dialect) {}

  /// The formula of an expression, all of whose variables can be read. Throws CodeError.
  [[nodiscard]] CodeFormula formula(Tokens expression) const;
  /// The variable has that value from now on; one that cannot be read is refused where it is used.
  void set(const CodeName& name, Tokens expression);
  /// Whatever the variable stood for, it can no longer be read, for that reason.
  void forget(const CodeName& name, const std::string& reason);
  /// A parameter of the function is the symbol of its name, whatever is declared outside, and so
  /// are its parts; with a reason, the parts alone can be read.
  void take(const CodeName& name, const std::string& reason = "");
  /// Neither the parameter nor its parts can be read, for that reason.
  void refuse(const CodeName& name, const std::string& reason);
  /// The variables of an expression may not be set any more, since something refers to them.
  void hold(Tokens expression);
  /// Its values, and those of its parts, are whole numbers.
  void declare_whole(const CodeName& name) { whole_.push_back(name); }
  /// Its values are real numbers, whatever was declared of an earlier variable of that name.
  void declare_real(const std::string& name) {
    std::erase_if(whole_, [&](const CodeName& each) { return each.name == name; });
  }
  /// Whatever is spelled `NAME(...)` is a call of a function of the file.
  void declare_function(const std::string& name) { functions_.insert(name); }
  /// Whatever is spelled `.NAME` cannot be read, for that reason.
  void declare_member(const std::string& name, const std::string& reason) {
    members_[name] = reason;
  }
  /// Throws CodeError where an expression may do more than give a value.
  void refuse_calls(Tokens expression) const;

  [[nodiscard]] bool is_whole(const CodeFormula& value) const {
    return code::is_whole(value, whole_);
  }
  [[nodiscard]] const closures::LocalNames& names() const { return names_; }

 private:
  struct Assigned {
    CodeName name;
    std::string reason;  ///< why it cannot be read; empty where it can
    closures::Place place;
    bool taken = false;    ///< a parameter: its parts are symbols too
    bool refused = false;  ///< the reason is that of its parts, too
  };

  void expect_free(const CodeName& name) const;
  /// Throws CodeError for an element that is spelled with another number of indices elsewhere.
  void expect_one_spelling(const CodeName& name) const;
  /// Throws CodeError where what is set may be another spelling of something else.
  void expect_own_storage(const CodeName& name) const;
  void expect_readable(const CodeName& name) const;
  void refuse_calls(const CodeFormula& formula) const;

  closures::ClosureSystem& system_;
  Dialect dialect_;
  closures::LocalNames names_;
  std::vector<Assigned> assigned_;
  std::vector<CodeName> held_;
  std::vector<CodeName> whole_;
  std::set<std::string> functions_;
  std::map<std::string, std::string> members_;
};

}  // namespace assur::generator::audit::code
