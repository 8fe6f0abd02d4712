#include <assur/text/utf8.hpp>
#include <assur/text/xml.hpp>

namespace assur::text {

std::string escaped_for_xml(const std::string& text) {
  std::string result;
  for (const char letter : text.substr(0, first_byte_outside_utf8(text))) {
    switch (letter) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += static_cast<unsigned char>(letter) < 0x20 ? '?' : letter;
    }
  }
  return result;
}

}  // namespace assur::text
