// Reads the elements of an XML document, or its first fault.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace assur::test {

struct XmlElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;  ///< directly inside
  std::vector<XmlElement> children;

  [[nodiscard]] std::string attribute(const std::string& key) const {
    const auto found = attributes.find(key);
    return found == attributes.end() ? "" : found->second;
  }
  /// This element and all inside it, in the order of the document.
  void collect(std::vector<const XmlElement*>& all) const {
    all.push_back(this);
    for (const XmlElement& child : children) {
      child.collect(all);
    }
  }
};

/// Reads as much of XML as a picture has: elements, attributes, text and the four entities. Throws
/// std::runtime_error for whatever is not well-formed.
class XmlReader {
 public:
  explicit XmlReader(const std::string& text) : text_(text) {}

  XmlElement document() {
    expect("<");
    XmlElement root = element();
    while (at_ < text_.size() && text_[at_] == '\n') {
      ++at_;
    }
    require(at_ == text_.size(), "text behind the root");
    return root;
  }

 private:
  void require(bool holds, const std::string& what) const {
    if (!holds) {
      throw std::runtime_error(what + " at " + std::to_string(at_) + ": " + text_.substr(at_, 40));
    }
  }
  void expect(const std::string& token) {
    require(text_.compare(at_, token.size(), token) == 0, "expected " + token);
    at_ += token.size();
  }
  bool take(const std::string& token) {
    const bool there = text_.compare(at_, token.size(), token) == 0;
    at_ += there ? token.size() : 0;
    return there;
  }
  std::string name() {
    std::string result;
    while (at_ < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '-')) {
      result += text_[at_++];
    }
    require(!result.empty(), "expected a name");
    return result;
  }
  std::string letters_until(char end) {
    std::string result;
    while (at_ < text_.size() && text_[at_] != end) {
      const auto letter = static_cast<unsigned char>(text_[at_]);
      require(letter >= 0x20 || letter == '\n', "a control character");
      require(letter != '<' || end == '<', "a bare <");
      if (letter == '&') {
        const bool known = take("&amp;") || take("&lt;") || take("&gt;") || take("&quot;");
        require(known, "a bare &");
        const std::size_t begin = text_.rfind('&', at_ - 1);
        const std::string entity = text_.substr(begin, at_ - begin);
        result += entity == "&amp;" ? '&' : entity == "&lt;" ? '<' : entity == "&gt;" ? '>' : '"';
      } else {
        result += text_[at_++];
      }
    }
    require(at_ < text_.size(), "the document ends");
    return result;
  }

  /// Behind its `<`.
  XmlElement element() {
    XmlElement result;
    result.name = name();
    while (take(" ")) {
      const std::string key = name();
      expect("=\"");
      require(!result.attributes.contains(key), "an attribute stands twice");
      result.attributes[key] = letters_until('"');
      expect("\"");
    }
    if (take("/>")) {
      return result;
    }
    expect(">");
    while (true) {
      result.text += letters_until('<');
      expect("<");
      if (take("/")) {
        expect(result.name + ">");
        return result;
      }
      result.children.push_back(element());
    }
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

}  // namespace assur::test
