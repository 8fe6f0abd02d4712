#include <assur/text/quoted.hpp>

namespace assur::text {

namespace {

/// Whether a byte continues a UTF-8 character, so that a text cannot be cut before it.
bool continues_letter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

bool is_white(char letter) { return letter >= '\t' && letter <= '\r'; }

/// The number of bytes of the control character at an offset, white space except the space
/// included; zero for any other character.
std::size_t bytes_of_control_character(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t ahead) {
    return at + ahead < text.size() ? static_cast<unsigned char>(text[at + ahead]) : 0U;
  };
  if (byte(0) < 0x20 || byte(0) == 0x7F) {
    return 1;  // C0 and DEL
  }
  const bool is_c1 = byte(0) == 0xC2 && byte(1) >= 0x80 && byte(1) < 0xA0;
  const bool is_arabic_mark = byte(0) == 0xD8 && byte(1) == 0x9C;  // U+061C
  if (is_c1 || is_arabic_mark) {
    return 2;
  }
  const unsigned last = byte(2);
  const bool is_mark_or_embedding =  // U+200E, U+200F, and U+2028, which ends a line, to U+202E
      byte(1) == 0x80 && (last == 0x8E || last == 0x8F || (last >= 0xA8 && last <= 0xAE));
  const bool is_isolate = byte(1) == 0x81 && last >= 0xA6 && last <= 0xA9;  // U+2066 to U+2069
  return byte(0) == 0xE2 && (is_mark_or_embedding || is_isolate) ? 3 : 0;
}

}  // namespace

std::size_t first_control_character(const std::string& text) {
  std::size_t at = 0;
  while (at < text.size() && (is_white(text[at]) || bytes_of_control_character(text, at) == 0)) {
    ++at;
  }
  return at;
}

std::string on_one_line(const std::string& text) {
  std::string shown;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t bytes = bytes_of_control_character(text, at);
    shown += bytes > 0 ? '?' : text[at];
    at += bytes > 0 ? bytes : 1;
  }
  return shown;
}

std::string shortened(const std::string& text) {
  constexpr std::size_t longest = 40;
  if (text.size() <= longest) {
    return on_one_line(text);
  }
  std::size_t end = longest;
  while (end > 0 && continues_letter(text[end])) {
    --end;
  }
  return on_one_line(text.substr(0, end)) + "...";
}

std::string in_quotes(const std::string& text) { return "'" + shortened(text) + "'"; }

}  // namespace assur::text
