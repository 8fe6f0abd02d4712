#include <algorithm>
#include <assur/text/json.hpp>
#include <assur/text/utf8.hpp>
#include <string_view>

namespace assur::text {

namespace {

/// The text with a replacement character for each byte that is not UTF-8.
std::string as_utf8(std::string text) {
  for (std::size_t at = first_byte_outside_utf8(text); at < text.size();
       at = first_byte_outside_utf8(text)) {
    text.replace(at, 1, "\xEF\xBF\xBD");
  }
  return text;
}

std::string quoted(const std::string& given) {
  const std::string text = as_utf8(given);
  constexpr std::string_view hexadecimal = "0123456789abcdef";
  constexpr std::string_view escaped = "\"\\\b\f\n\r\t";
  constexpr std::string_view spelled = "\"\\bfnrt";
  std::string result = "\"";
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    const std::size_t place = escaped.find(letter);
    if (place != std::string_view::npos) {
      result += {'\\', spelled[place]};
    } else if (code < 0x20) {
      result += {'\\', 'u', '0', '0', hexadecimal[code / 16U], hexadecimal[code % 16U]};
    } else {
      result += letter;
    }
  }
  return result + '"';
}

}  // namespace

Json::Json(const std::string& text) : scalar_(quoted(text)) {}

Json::Json(std::initializer_list<Member> members) : Json(object()) {
  for (const auto& [name, value] : members) {
    (*this)[name] = value;
  }
}

Json Json::array() {
  Json result;
  result.kind_ = Kind::array;
  return result;
}

Json Json::object() {
  Json result;
  result.kind_ = Kind::object;
  return result;
}

void Json::push_back(Json item) { values_.push_back(std::move(item)); }

Json& Json::operator[](const std::string& name) {
  const auto known = std::find(names_.begin(), names_.end(), name);
  if (known != names_.end()) {
    return values_[static_cast<std::size_t>(known - names_.begin())];
  }
  kind_ = Kind::object;
  names_.push_back(name);
  return values_.emplace_back();
}

std::string Json::dump() const {
  std::string text;
  append_to(text, 0);
  return text;
}

void Json::append_to(std::string& text, std::size_t indent) const {
  if (kind_ == Kind::scalar) {
    text += scalar_;
    return;
  }
  const bool named = kind_ == Kind::object;
  const std::size_t inner = indent + 2;
  text += named ? '{' : '[';
  for (std::size_t place = 0; place < values_.size(); ++place) {
    text += (place == 0 ? "\n" : ",\n") + std::string(inner, ' ');
    text += named ? quoted(names_[place]) + ": " : "";
    values_[place].append_to(text, inner);
  }
  text += values_.empty() ? "" : "\n" + std::string(indent, ' ');
  text += named ? '}' : ']';
}

}  // namespace assur::text
