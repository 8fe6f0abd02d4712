#include "latex/macros.hpp"

#include <algorithm>
#include <map>
#include <memory>

namespace assur::generator::latex {

namespace {

/// No call in a paper needs this many replacements, but definitions that use each other never end.
constexpr std::size_t most_replacements = 20000;
/// No paper has this many tokens after its commands are replaced, nor produces as many on the way.
constexpr std::size_t most_tokens = 2000000;
constexpr std::size_t most_made = 20000000;

struct Macro {
  std::size_t arguments = 0;
  Tokens body;
  bool readable = true;  ///< its definition has a supported form
};
/// The meaning of a command; null if it is not defined.
using SharedMacro = std::shared_ptr<const Macro>;

class Expander {
 public:
  Expander(const Tokens& tokens, const std::set<std::string>& kept) : kept_(kept) {
    rest_.assign(tokens.rbegin(), tokens.rend());
  }

  Tokens run() {
    while (!rest_.empty()) {
      const Token token = next();
      if (token.is("\\newcommand") || token.is("\\renewcommand") || token.is("\\providecommand")) {
        define_command();
      } else if (token.is("\\def") || token.is("\\edef") || token.is("\\gdef") ||
                 token.is("\\xdef")) {
        global_ = token.is("\\gdef") || token.is("\\xdef");
        define_plainly();
        global_ = false;
      } else if (token.is("\\let")) {
        define_alike();
      } else if (token.is("\\mathcode") || token.is("\\catcode")) {
        throw FormulaError(token.text + " changes what letters mean, which is not followed",
                           token.place);
      } else if (token.is("\\DeclareMathOperator")) {
        define_operator();
      } else if (const auto macro = macros_.find(token.text); macro != macros_.end()) {
        replace(token, *macro->second);
      } else {
        follow_group(token);
        result_.push_back(token);
      }
    }
    return std::move(result_);
  }

 private:
  Token next() {
    Token token = std::move(rest_.back());
    rest_.pop_back();
    last_ = token.place;
    return token;
  }

  bool take(const char* text) {
    if (rest_.empty() || !rest_.back().is(text)) {
      return false;
    }
    static_cast<void>(next());
    return true;
  }

  Tokens argument() {
    Tokens found;
    std::size_t depth = 0;
    do {
      if (rest_.empty()) {
        throw FormulaError("the file ends within an argument", last_);
      }
      found.push_back(next());
      depth += found.back().is("{") ? 1 : 0;
      if (found.back().is("}")) {
        if (depth == 0) {
          throw FormulaError("an argument is missing", last_);
        }
        --depth;
      }
    } while (depth > 0);
    if (found[0].is("{")) {
      found.erase(found.begin());
      found.pop_back();
    }
    return found;
  }

  /// The text between brackets, if one opens here.
  std::string optional_argument() {
    std::string text;
    if (take("[")) {
      while (!take("]")) {
        if (rest_.empty()) {
          throw FormulaError("a bracket is not closed", last_);
        }
        text += next().text;
      }
    }
    return text;
  }

  void define(const Tokens& name, Macro macro) {
    define(name, std::make_shared<const Macro>(std::move(macro)));
  }

  void define(const Tokens& name, SharedMacro macro) {
    if (name.size() == 1 && name[0].is_command() && !kept_.contains(name[0].text)) {
      const auto before = macros_.find(name[0].text);
      if (!groups_.empty() && !global_) {
        groups_.back().emplace_back(name[0].text,
                                    before == macros_.end() ? nullptr : before->second);
      }
      macros_[name[0].text] = std::move(macro);
    }
  }

  /// Definitions in a group end with it.
  void follow_group(const Token& token) {
    if (token.is("{") || token.is("\\begin")) {
      groups_.emplace_back();
    } else if ((token.is("}") || token.is("\\end")) && !groups_.empty()) {
      std::vector<Definition> ended = std::move(groups_.back());
      groups_.pop_back();
      for (auto each = ended.rbegin(); each != ended.rend(); ++each) {
        if (each->second) {
          macros_[each->first] = each->second;
        } else {
          macros_.erase(each->first);
        }
      }
    }
  }

  void define_command() {
    take("*");
    const Tokens name = argument();
    const std::string count = optional_argument();
    const bool defaults = !optional_argument().empty();
    const bool digit = count.size() == 1 && count[0] >= '0' && count[0] <= '9';
    define(name, Macro{digit ? static_cast<std::size_t>(count[0] - '0') : 0, argument(),
                       !defaults && (digit || count.empty())});
  }

  void define_plainly() {
    const Tokens name = argument();
    Macro macro;
    while (take("#")) {
      macro.readable = macro.readable && !rest_.empty() && next().is_digit();
      ++macro.arguments;
    }
    while (!rest_.empty() && !rest_.back().is("{")) {
      macro.readable = false;
      static_cast<void>(next());
    }
    macro.body = argument();
    define(name, std::move(macro));
  }

  /// `\let\NAME=\OTHER`: the current meaning of the other command.
  void define_alike() {
    const Tokens name = argument();
    take("=");
    const Tokens other = argument();
    if (other.size() != 1 || (name.size() == 1 && name[0].is(other[0].text.c_str()))) {
      return;
    }
    const auto known = macros_.find(other[0].text);
    define(name,
           known == macros_.end() ? std::make_shared<const Macro>(Macro{0, other}) : known->second);
  }

  void define_operator() {
    take("*");
    const Tokens name = argument();
    Tokens body = argument();
    if (body.empty()) {
      return;
    }
    Token token = body[0];
    const auto made = [&](const char* text) {
      token.text = text;
      return token;
    };
    body.insert(body.begin(), {made("\\operatorname"), made("{")});
    body.push_back(made("}"));
    define(name, Macro{0, body});
  }

  void replace(const Token& call, const Macro& macro) {
    if (!macro.readable) {
      throw FormulaError("the definition of " + call.text + " cannot be followed; write it out",
                         call.place);
    }
    if (++replacements_[call.from] > most_replacements) {
      throw FormulaError("expanding " + call.text + " takes more than " +
                             std::to_string(most_replacements) + " replacements; write it out",
                         call.place);
    }
    std::vector<Tokens> arguments;
    while (arguments.size() < macro.arguments) {
      arguments.push_back(argument());
    }
    Tokens made;
    for (std::size_t at = 0; at < macro.body.size(); ++at) {
      expect_room(call, made.size());
      const bool place = macro.body[at].is("#") && at + 1 < macro.body.size();
      const std::size_t number = place && macro.body[at + 1].is_digit()
                                     ? static_cast<std::size_t>(macro.body[at + 1].text[0] - '0')
                                     : 0;
      if (number >= 1 && number <= arguments.size()) {
        made.insert(made.end(), arguments[number - 1].begin(), arguments[number - 1].end());
        ++at;
        continue;
      }
      made.push_back(macro.body[at]);
      made.back().place = call.place;
      made.back().from = call.from;
      made.back().to = call.to;
    }
    expect_room(call, made.size());
    made_ += made.size() + 1;
    rest_.insert(rest_.end(), made.rbegin(), made.rend());
  }

  void expect_room(const Token& call, std::size_t made) const {
    const bool many = result_.size() + rest_.size() + made > most_tokens;
    if (many || made_ + made > most_made) {
      throw FormulaError("expanding the commands up to " + call.text + " makes more than " +
                             std::to_string(many ? most_tokens : most_made) +
                             " tokens; write it out",
                         call.place);
    }
  }

  const std::set<std::string>& kept_;
  Tokens rest_;  ///< in reverse
  Tokens result_;
  std::map<std::string, SharedMacro> macros_;
  using Definition = std::pair<std::string, SharedMacro>;
  std::vector<std::vector<Definition>> groups_;  ///< former definitions, by open group
  bool global_ = false;                          ///< the definition outlives its group
  /// The number of replacements of each call in the file, by its place. Calls within a replacement
  /// have the same place and count with it.
  std::map<std::size_t, std::size_t> replacements_;
  std::size_t made_ = 0;  ///< tokens by all replacements so far, plus one for each
  Place last_{1, 1};
};

}  // namespace

Tokens expanded(const Tokens& tokens, const std::set<std::string>& kept) {
  return Expander(tokens, kept).run();
}

}  // namespace assur::generator::latex
