#include <assur/text/quoted.hpp>

namespace assur::text {

namespace {

/// Whether a byte continues a letter of UTF-8, so that a text cannot be cut before it.
bool continues_letter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

}  // namespace

bool is_control_character(char letter) {
  constexpr unsigned char deletion = 0x7F;
  constexpr unsigned char space = 0x20;
  const auto byte = static_cast<unsigned char>(letter);
  const bool is_white = letter >= '\t' && letter <= '\r';
  return (byte < space && !is_white) || byte == deletion;
}

std::string on_one_line(const std::string& text) {
  constexpr unsigned char deletion = 0x7F;
  std::string shown;
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    shown += byte < 0x20 || byte == deletion ? '?' : letter;
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
