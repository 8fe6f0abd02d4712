#include "foreign/pmks_payload.hpp"

#include <algorithm>
#include <array>
#include <assur/text/quoted.hpp>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace assur::mechanism::foreign {

namespace {

constexpr std::string_view digits =
    "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-";
constexpr std::size_t check_letters = 62;  ///< of these digits the last two are no check letters
constexpr std::size_t longest_number = 10;
constexpr double thousandths = 1000;
constexpr std::size_t sections_of_settings = 4;

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char letter : text) {
    if (letter == separator) {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

/// A whole number in base 64; a leading zero is its minus sign.
double whole_number(const std::string& text, const std::string& part, bool has_sign = true) {
  const bool is_negative = has_sign && text.starts_with('0');
  double number = 0;
  for (const char letter : text) {
    const std::size_t digit = digits.find(letter);
    if (digit == std::string_view::npos || text.size() > longest_number) {
      throw MechanismError(part, "expected a number to the base 64, found " +
                                     text::in_quotes(text) + "; copy the whole link again");
    }
    number = number * static_cast<double>(digits.size()) + static_cast<double>(digit);
  }
  return is_negative ? -number : number;
}

double decimal_number(const std::string& text, const std::string& part) {
  return whole_number(text, part) / thousandths;
}

/// The comma-separated fields of one record, the first of which begins with a digit of flags.
class Record {
 public:
  Record(const std::string& text, std::string part)
      : fields_(split(text, ',')), part_(std::move(part)) {}

  [[nodiscard]] std::size_t size() const { return fields_.size(); }
  [[nodiscard]] const std::string& part() const { return part_; }
  [[nodiscard]] std::string text(std::size_t at) const {
    return at < fields_.size() ? fields_[at] : "";
  }
  [[nodiscard]] double number(std::size_t at) const { return decimal_number(text(at), part_); }
  void expect_fields(std::size_t least) const {
    if (fields_.size() < least || fields_.front().size() < 2) {
      throw MechanismError(part_, "it has " + std::to_string(fields_.size()) + " fields of " +
                                      std::to_string(least) + "; copy the whole link again");
    }
  }

 private:
  std::vector<std::string> fields_;
  std::string part_;
};

PmksJoint joint_of(const Record& record) {
  record.expect_fields(5);
  const auto flags =
      static_cast<unsigned>(whole_number(record.text(0).substr(0, 1), record.part(), false));
  PmksJoint joint;
  joint.slides = (flags & 1U) != 0;
  joint.is_input = (flags & 2U) != 0;
  joint.is_grounded = (flags & 4U) != 0;
  joint.is_welded = (flags & 8U) != 0;
  joint.is_traced = (flags & 16U) != 0;
  joint.id = record.text(0).substr(1);
  joint.name = record.text(1);
  joint.x = record.number(2);
  joint.y = record.number(3);
  joint.angle = record.number(4);
  joint.carrier = record.text(5);
  joint.slot_a = record.text(6);
  joint.slot_b = record.text(7);
  joint.speed = record.number(8);
  joint.mass = record.number(9);
  return joint;
}

PmksLink link_of(const Record& record) {
  record.expect_fields(8);
  const std::string head = record.text(0);
  constexpr std::string_view roots = "YAMG0123";
  constexpr std::string_view parts = "Namg4567";
  PmksLink link;
  link.is_root = roots.find(head[0]) != std::string_view::npos;
  if (!link.is_root && parts.find(head[0]) == std::string_view::npos) {
    throw MechanismError(record.part(),
                         "expected one of the letters Y, A, M, G, N, a, m, g or a "
                         "digit up to 7 in front, found " +
                             text::in_quotes(head.substr(0, 1)));
  }
  link.is_block = head[1] == 'P';
  link.id = head.substr(2);
  link.name = record.text(1);
  link.mass = record.number(2);
  link.inertia = record.number(3);
  link.x = record.number(4);
  link.y = record.number(5);
  std::size_t at = 7;
  for (; at < record.size() && !record.text(at).empty(); ++at) {
    link.joints.push_back(record.text(at));
  }
  for (++at; at < record.size(); ++at) {
    if (!record.text(at).empty()) {
      link.parts.push_back(record.text(at));
    }
  }
  return link;
}

PmksForce force_of(const Record& record) {
  record.expect_fields(8);
  const auto flags =
      static_cast<unsigned>(whole_number(record.text(0).substr(0, 1), record.part(), false));
  return {(flags & 1U) != 0, (flags & 2U) != 0, record.text(0).substr(1), record.text(1),
          record.text(2),    record.number(3),  record.number(4),         record.number(5),
          record.number(6),  record.number(7)};
}

/// The payload without its checks: its length as one letter, and, in newer links, a digest after an
/// asterisk.
std::string checked(std::string payload) {
  constexpr std::size_t digest_length = 6;
  const std::string damaged = "the link is damaged or not whole; copy it again";
  const std::size_t mark = payload.rfind('*');
  if (mark != std::string::npos) {
    std::uint32_t hash = 0x811C9DC5U;  // FNV-1a
    for (const char letter : payload.substr(0, mark)) {
      hash = (hash ^ static_cast<unsigned char>(letter)) * 0x01000193U;
    }
    std::string digest(digest_length, '0');
    for (std::size_t at = digest_length; at-- > 0; hash /= check_letters) {
      digest[at] = digits[hash % check_letters];
    }
    if (payload.substr(mark + 1) != digest) {
      throw MechanismError("", damaged);
    }
    payload.resize(mark);
  }
  const char letter = payload.empty() ? ' ' : payload.back();
  if (!payload.empty()) {
    payload.pop_back();
  }
  if (digits[payload.size() % check_letters] != letter) {
    throw MechanismError("", damaged);
  }
  return payload;
}

/// Replaces a number that is not a multiple of a thousandth: `PJA~0~1.23456` is x of the joint A.
void restore(const std::string& entry, PmksPayload& payload) {
  const std::vector<std::string> fields = split(entry, '~');
  const auto invalid = [&] {
    return MechanismError("", "the exact number " + text::in_quotes(entry) +
                                  " belongs to nothing in the link; copy the whole link again");
  };
  double value = 0;
  if (fields.size() != 3 || fields[0].size() < 2 || fields[1].size() != 1) {
    throw invalid();
  }
  const auto [end, error] =
      std::from_chars(fields[2].data(), fields[2].data() + fields[2].size(), value);
  if (error != std::errc() || end != fields[2].data() + fields[2].size() || !std::isfinite(value)) {
    throw invalid();
  }
  const auto field = static_cast<std::size_t>(fields[1][0] - '0');
  const std::string id = fields[0].substr(2);
  const auto put = [&](auto& parts, const auto& numbers) {
    const auto found = std::ranges::find_if(parts, [&](const auto& part) { return part.id == id; });
    if (found == parts.end() || field >= numbers.size()) {
      throw invalid();
    }
    (*found).*numbers[field] = value;
  };
  switch (fields[0][1]) {
    case 'J':
      put(payload.joints, std::array{&PmksJoint::x, &PmksJoint::y, &PmksJoint::angle,
                                     &PmksJoint::speed, &PmksJoint::mass});
      return;
    case 'L':
      put(payload.links,
          std::array{&PmksLink::mass, &PmksLink::inertia, &PmksLink::x, &PmksLink::y});
      return;
    case 'F':
      put(payload.forces, std::array{&PmksForce::start_x, &PmksForce::start_y, &PmksForce::end_x,
                                     &PmksForce::end_y, &PmksForce::magnitude});
      return;
    case 'D':  // the others belong to the view
      if (field == 1) {
        payload.slide_speed = value;
      }
      return;
    case 'I':
      if (field == 0) {
        payload.turns_per_minute = value;
      }
      return;
    default:
      throw invalid();
  }
}

/// The entries after all sections, each beginning with a letter for its kind.
void read_tail(const std::string& tail, PmksPayload& payload, ForeignMechanism& mechanism) {
  for (const std::string& entry : split(tail, ',')) {
    if (entry.empty()) {
      continue;
    }
    switch (entry.front()) {
      case 'P':
        restore(entry, payload);
        break;
      case 'J':
      case 'L':
      case 'F':
        mechanism.forget_look("locks");
        break;
      case 'C':
        mechanism.forget_look("what centres of mass keep to");
        break;
      case 'K':
        mechanism.forget_look("colours");
        break;
      case 'S':
        mechanism.remark("the design by given positions is left out; its links are in the scene");
        break;
      case 'G':
        mechanism.miss("the gears of the link are left out; write them as drivers with joint(...)");
        break;
      default:
        mechanism.miss("the entry " + text::in_quotes(entry) + " is not known here, and left out");
    }
  }
}

void read_settings(const std::vector<std::string>& sections, PmksPayload& payload) {
  const auto flags =
      static_cast<unsigned>(std::min(whole_number(sections[0], "settings", false), 4294967295.0));
  payload.is_clockwise = (flags & 1U) != 0;
  payload.wants_forces = (flags & 128U) != 0;
  payload.has_gravity = (flags & 256U) == 0;
  const std::vector<std::string> decimals = split(sections[1], ',');
  for (std::size_t at = 0; at < decimals.size(); ++at) {
    const double value = decimal_number(decimals[at], "settings");
    payload.slide_speed = at == 1 ? value : payload.slide_speed;
  }
  payload.turns_per_minute = whole_number(split(sections[2], ',').front(), "settings");
  if (!sections[3].empty()) {
    payload.length_unit =
        static_cast<int>(whole_number(sections[3].substr(0, 1), "settings", false));
  }
}

int hex_digit(char letter) {
  const std::string_view hex = "0123456789abcdef";
  return static_cast<int>(
      hex.find(static_cast<char>(std::tolower(static_cast<unsigned char>(letter)))));
}

}  // namespace

PmksPayload read_pmks(const std::string& text, ForeignMechanism& mechanism) {
  const std::vector<std::string> sections = split(checked(text), '.');
  if (sections.size() < sections_of_settings + 2) {
    throw MechanismError("", "the link is not whole; copy it again");
  }
  PmksPayload payload;
  read_settings(sections, payload);
  std::size_t at = sections_of_settings;
  // An empty section ends the joints, the links and the forces.
  const auto records = [&](const std::string& kind, auto& parts, const auto& read) {
    for (; at < sections.size() && !sections[at].empty(); ++at) {
      parts.push_back(read(Record(sections[at], kind + " " + std::to_string(parts.size() + 1))));
    }
    ++at;
  };
  records("joint", payload.joints, joint_of);
  records("link", payload.links, link_of);
  if (payload.links.size() > Mechanism::most_links) {
    throw MechanismError("", "there are more than " + std::to_string(Mechanism::most_links) +
                                 " links, the limit of scenes; divide the mechanism");
  }
  records("force", payload.forces, force_of);
  mechanism.forget_look("the view");
  if (!payload.links.empty()) {
    mechanism.forget_look("colours");
  }
  // The selection comes next, and then the tail, in which exact numbers have decimal points.
  std::string tail;
  while (++at < sections.size()) {
    tail += (tail.empty() ? "" : ".") + sections[at];
  }
  read_tail(tail, payload, mechanism);
  return payload;
}

std::string pmks_payload_of(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  if (begin == std::string::npos) {
    return "";
  }
  std::string trimmed = text.substr(begin, end + 1 - begin);
  if (const std::size_t mark = trimmed.find('?');
      mark != std::string::npos && trimmed.find("://") < mark) {
    trimmed.erase(0, mark + 1);
  }
  std::string payload;
  for (std::size_t at = 0; at < trimmed.size(); ++at) {
    const bool is_escape = trimmed[at] == '%' && at + 2 < trimmed.size() &&
                           hex_digit(trimmed[at + 1]) >= 0 && hex_digit(trimmed[at + 2]) >= 0;
    payload += is_escape
                   ? static_cast<char>(16 * hex_digit(trimmed[at + 1]) + hex_digit(trimmed[at + 2]))
                   : trimmed[at];
    at += is_escape ? 2 : 0;
  }
  // Flags, decimals, integers and units come first, in digits and commas.
  std::size_t dots = 0;
  for (const char letter : payload) {
    dots += letter == '.' ? 1 : 0;
    if (dots == sections_of_settings) {
      return payload;
    }
    if (letter != '.' && letter != ',' && digits.find(letter) == std::string_view::npos) {
      return "";
    }
  }
  return "";
}

}  // namespace assur::mechanism::foreign
