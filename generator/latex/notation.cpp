#include "latex/notation.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace assur::generator::latex {

namespace {

constexpr std::size_t longest_formula = 10'000;

constexpr std::array<std::string_view, 38> symbol_names = {
    "alpha",    "beta",  "gamma",   "delta",  "epsilon", "varepsilon", "zeta",  "eta",
    "theta",    "iota",  "kappa",   "lambda", "mu",      "nu",         "xi",    "rho",
    "sigma",    "tau",   "upsilon", "phi",    "varphi",  "chi",        "psi",   "omega",
    "vartheta", "Gamma", "Delta",   "Theta",  "Lambda",  "Xi",         "Sigma", "Upsilon",
    "Phi",      "Psi",   "Omega",   "ell",    "varrho",  "varsigma"};
/// Commands that change the shape of letters, but not their meaning.
constexpr std::array<std::string_view, 8> shapes = {"\\mathrm", "\\mathit", "\\text",
                                                    "\\textrm", "\\mathsf", "\\mathnormal",
                                                    "\\textit", "\\mathtt"};
/// Commands that turn a letter into another symbol.
constexpr std::array<std::string_view, 15> accents = {
    "\\mathbf",   "\\boldsymbol", "\\bm",        "\\vec",     "\\bar",
    "\\overline", "\\hat",        "\\tilde",     "\\widehat", "\\mathcal",
    "\\check",    "\\widetilde",  "\\underline", "\\mathbb",  "\\overrightarrow"};

bool is_symbol(const Token& token) {
  return token.is_command() && contains(symbol_names, token.text.substr(1));
}

constexpr int most_dots = 4;

/// The number of dots that a command puts above a symbol.
int dots_of(const Token& token) {
  constexpr std::array<std::string_view, most_dots> commands = {"\\dot", "\\ddot", "\\dddot",
                                                                "\\ddddot"};
  const auto found = std::find(commands.begin(), commands.end(), token.text);
  return found == commands.end() ? 0 : static_cast<int>(found - commands.begin()) + 1;
}

bool is_skipped(const Token& token) {
  return is_layout(token) || is_thin_space(token) || token.is("\\mathstrut");
}

/// Tokens as one text without braces and shapes.
std::string flat(const Tokens& tokens) {
  std::string text;
  bool word = false;  // the last token was the name of a symbol
  for (const Token& token : tokens) {
    if (token.is("{") || token.is("}") || is_skipped(token) || contains(shapes, token.text)) {
      continue;
    }
    const bool accent = contains(accents, token.text);
    text += word && token.is_letter() ? " " : "";
    text += token.is_command() ? token.text.substr(1) : token.text;
    text += accent ? "." : "";
    word = token.is_command() && !accent;
  }
  return text;
}

bool could_be_power(const Tokens& tokens) {
  return !tokens.empty() && std::none_of(tokens.begin(), tokens.end(), [](const Token& token) {
    return token.is("\\prime") || token.is("?");
  });
}

/// Whether the pattern matches the whole text; if so, the matches of its `?` are added to
/// `captured`. Each `?` matches as few characters as possible, but at least one and no superscript,
/// which may be a power. Only the first occurrence of a piece between them need be tried: a later
/// one leaves less to the next `?`, and no superscript can lie between the two.
bool glob(const std::string& pattern, const std::string& text, std::vector<std::string>& captured) {
  std::size_t next = std::min(pattern.find('?'), pattern.size());
  if (text.compare(0, next, pattern, 0, next) != 0) {
    return false;
  }
  std::vector<std::string> parts;
  std::size_t at = next;  // in the text
  while (next < pattern.size()) {
    const std::size_t begin = next + 1;
    next = std::min(pattern.find('?', begin), pattern.size());
    const std::string piece = pattern.substr(begin, next - begin);
    const std::size_t place = next < pattern.size()   ? text.find(piece, at + 1)
                              : text.ends_with(piece) ? text.size() - piece.size()
                                                      : std::string::npos;
    if (place == std::string::npos || place <= at) {
      return false;
    }
    parts.push_back(text.substr(at, place - at));
    if (parts.back().find('^') != std::string::npos) {
      return false;
    }
    at = place + piece.size();
  }
  if (at != text.size()) {
    return false;
  }
  captured.insert(captured.end(), parts.begin(), parts.end());
  return true;
}

std::string dotted(int dots, const std::string& name) {
  return (dots == 0 ? "" : std::string(static_cast<std::size_t>(dots), 'd') + "ot.") + name;
}

std::string whole_name(const Atom& atom) {
  return atom.name + (atom.superscript.empty() ? "" : "^" + atom.superscript);
}

class AtomReader {
 public:
  AtomReader(const Tokens& tokens, std::size_t at) : tokens_(tokens), at_(at) {}

  std::optional<Atom> run() {
    if (!nucleus()) {
      return std::nullopt;
    }
    scripts();
    atom_.end = at_;
    return atom_;
  }

 private:
  bool nucleus() {
    if (at_ >= tokens_.size()) {
      return false;
    }
    const Token& token = tokens_[at_];
    if (token.is_letter() || is_symbol(token)) {
      atom_.name = flat({token});
      ++at_;
      return true;
    }
    if (dots_of(token) > 0 || token.is("{")) {
      return inside(token);
    }
    const bool accent = contains(accents, token.text);
    if (!accent && !contains(shapes, token.text)) {
      return false;
    }
    ++at_;
    const std::string text = flat(take_argument(tokens_, at_));
    if (text.empty()) {
      throw FormulaError(token.text + " has an argument without a symbol", token.place);
    }
    atom_.name = accent ? token.text.substr(1) + "." + text : text;
    return true;
  }

  /// One symbol in a group, or under dots.
  bool inside(const Token& token) {
    std::size_t behind = at_ + (token.is("{") ? 0 : 1);
    const Tokens group = take_argument(tokens_, behind);
    const std::optional<Atom> inner = read_atom(group, 0);
    if (!inner || inner->end != group.size()) {
      if (token.is("{")) {
        return false;
      }
      throw FormulaError("dots stand above a single symbol", token.place);
    }
    atom_ = *inner;
    atom_.dots += dots_of(token);
    if (atom_.dots > most_dots) {
      throw FormulaError("more than four dots are not read", token.place);
    }
    if (!atom_.superscript.empty() && token.is("{")) {
      return false;  // a power in braces is a formula
    }
    at_ = behind;
    return true;
  }

  void scripts() {
    bool index = false;
    while (at_ < tokens_.size()) {
      const Token& token = tokens_[at_];
      if (token.is("'")) {
        atom_.name += "'";
        ++at_;
      } else if (token.is("_")) {
        if (index) {
          throw FormulaError("this has two indices; write them as one", token.place);
        }
        index = true;
        atom_.name += "_" + flat(take_argument(tokens_, ++at_));
      } else if (token.is("^")) {
        if (!atom_.superscript.empty()) {
          throw FormulaError("this has two superscripts; write brackets", token.place);
        }
        const Tokens script = take_argument(tokens_, ++at_);
        atom_.superscript = flat(script);
        atom_.power = could_be_power(script) ? script : Tokens{};
        if (atom_.superscript.empty()) {
          throw FormulaError("this superscript is empty", token.place);
        }
      } else {
        return;
      }
    }
  }

  const Tokens& tokens_;
  std::size_t at_;
  Atom atom_;
};

std::size_t skip(const Tokens& tokens, std::size_t at) {
  while (at < tokens.size() && is_skipped(tokens[at])) {
    ++at;
  }
  return at;
}

}  // namespace

std::optional<Atom> read_atom(const Tokens& tokens, std::size_t at) {
  return AtomReader(tokens, at).run();
}

std::vector<std::string> symbols_of(const Tokens& tokens) {
  std::vector<std::string> list;
  for (std::size_t at = skip(tokens, 0); at < tokens.size(); at = skip(tokens, at)) {
    if (const std::optional<Atom> atom = read_atom(tokens, at)) {
      list.push_back(dotted(atom->dots, whole_name(*atom)));
      at = atom->end;
      continue;
    }
    const Token& token = tokens[at++];
    if (!token.is("{") && !token.is("}")) {
      list.push_back(token.text);
    }
  }
  return list;
}

std::optional<std::vector<std::string>> matched(const std::vector<std::string>& pattern,
                                                const std::vector<std::string>& symbols) {
  std::vector<std::string> captured;
  if (pattern.size() != symbols.size()) {
    return std::nullopt;
  }
  for (std::size_t place = 0; place < pattern.size(); ++place) {
    if (!glob(pattern[place], symbols[place], captured)) {
      return std::nullopt;
    }
  }
  return captured;
}

std::string filled(const std::string& formula, const std::vector<std::string>& captured,
                   Place place) {
  std::string text;
  std::size_t next = 0;
  for (const char letter : formula) {
    if (text.size() > longest_formula) {
      throw FormulaError("the map's formula for this has more than " +
                             std::to_string(longest_formula) + " characters",
                         place);
    }
    if (letter != '?' || captured.empty()) {
      text += letter;
      continue;
    }
    std::string part = captured[std::min(next++, captured.size() - 1)];
    std::replace(part.begin(), part.end(), ',', '_');
    text += part;
  }
  return text;
}

void Notations::add(const Tokens& notation, const std::string& formula) {
  Notation added{symbols_of(notation), formula};
  const auto is_general = [](const Notation& each) {
    return std::any_of(each.pattern.begin(), each.pattern.end(),
                       [](const std::string& part) { return part.find('?') != std::string::npos; });
  };
  const auto place = std::find_if(notations_.begin(), notations_.end(), [&](const Notation& each) {
    return each.pattern.size() < added.pattern.size() ||
           (each.pattern.size() == added.pattern.size() && is_general(each) && !is_general(added));
  });
  notations_.insert(place, std::move(added));
}

bool Notations::contains(const Tokens& notation) const {
  const std::vector<std::string> pattern = symbols_of(notation);
  return std::any_of(notations_.begin(), notations_.end(),
                     [&](const Notation& each) { return each.pattern == pattern; });
}

std::optional<Meaning> Notations::match(const Notation& notation, const Tokens& tokens,
                                        std::size_t at) {
  std::vector<std::string> captured;
  Meaning meaning;
  const std::size_t first = at;
  std::size_t open = 0;  // braces
  for (std::size_t place = 0; place < notation.pattern.size(); ++place) {
    const std::string& pattern = notation.pattern[place];
    const bool last = place + 1 == notation.pattern.size();
    std::optional<Atom> atom;
    for (at = skip(tokens, at); at < tokens.size(); at = skip(tokens, at + 1)) {
      atom = read_atom(tokens, at);
      const bool opens = tokens[at].is("{");
      if (atom || (!opens && (!tokens[at].is("}") || open == 0))) {
        break;
      }
      open += opens ? 1 : 0;
      open -= opens ? 0 : 1;
    }
    if (at >= tokens.size()) {
      return std::nullopt;
    }
    const std::string whole = atom ? dotted(atom->dots, whole_name(*atom)) : tokens[at].text;
    meaning.name += (meaning.name.empty() ? "" : " ") + whole;
    if (glob(pattern, whole, captured)) {
      at = atom ? atom->end : at + 1;
      continue;
    }
    if (!atom || !last) {
      return std::nullopt;
    }
    // Its superscript is a power, or its dots are time derivatives of the notation's quantity.
    const std::string name = dotted(atom->dots, atom->name);
    const bool derived = atom->dots > 0 && place == 0;
    if (!atom->superscript.empty() && !atom->power.empty() && glob(pattern, name, captured)) {
      meaning.power = atom->power;
    } else if (derived && glob(pattern, whole_name(*atom), captured)) {
      meaning.dots = atom->dots;
    } else if (derived && !atom->power.empty() && glob(pattern, atom->name, captured)) {
      meaning.dots = atom->dots;
      meaning.power = atom->power;
    } else {
      return std::nullopt;
    }
    meaning.name.resize(meaning.name.size() - whole.size());
    meaning.name +=
        meaning.dots > 0 ? (meaning.power.empty() ? whole_name(*atom) : atom->name) : name;
    at = atom->end;
  }
  for (; open > 0 && at < tokens.size() && tokens[at].is("}"); --open) {
    ++at;
  }
  if (open > 0) {
    return std::nullopt;
  }
  meaning.formula = filled(notation.formula, captured, tokens[first].place);
  meaning.end = at;
  return meaning;
}

std::optional<Meaning> Notations::by_spelling(const Tokens& tokens, std::size_t at) const {
  const std::optional<Atom> atom = read_atom(tokens, at);
  if (!atom || (!atom->superscript.empty() && atom->power.empty())) {
    return std::nullopt;
  }
  std::string spelled = atom->name;
  std::replace(spelled.begin(), spelled.end(), ',', '_');
  std::string without = spelled;
  if (const std::size_t mark = spelled.rfind('_');
      mark != std::string::npos && spelled.find('_') == mark &&
      spelled.find_first_not_of("0123456789", mark + 1) == std::string::npos) {
    without.erase(mark, 1);
  }
  const bool one = declared_(spelled);
  const bool other = without != spelled && declared_(without);
  if (one && other) {
    throw FormulaError("'" + spelled + "' and '" + without +
                           "' are both quantities; say in the map which of them this is",
                       tokens[at].place);
  }
  if (!one && !other) {
    return std::nullopt;
  }
  return Meaning{one ? spelled : without, atom->name, atom->power, atom->dots, atom->end};
}

/// Throws if `ab` may be a times b or a quantity of that name.
void Notations::refuse_words(const Tokens& tokens, std::size_t at) const {
  if (!tokens[at].is_letter() || (at > 0 && tokens[at - 1].is_letter())) {
    return;
  }
  std::string word;
  for (std::size_t next = at; next < tokens.size() && tokens[next].is_letter(); ++next) {
    const std::optional<Atom> last = read_atom(tokens, next);
    if (next > at && declared_(word + last->name)) {
      throw FormulaError("'" + word + last->name +
                             "' is a quantity, and may be a product here; set it as \\mathit{...} "
                             "or say in the map what it is",
                         tokens[at].place);
    }
    word += tokens[next].text;
  }
}

std::optional<Meaning> Notations::at(const Tokens& tokens, std::size_t at) const {
  for (const Notation& notation : notations_) {
    if (std::optional<Meaning> found = match(notation, tokens, at)) {
      return found;
    }
  }
  refuse_words(tokens, at);
  return by_spelling(tokens, at);
}

}  // namespace assur::generator::latex
