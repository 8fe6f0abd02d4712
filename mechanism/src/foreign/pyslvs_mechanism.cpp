// Mechanisms from expressions of Pyslvs.
#include <algorithm>
#include <assur/text/quoted.hpp>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>

#include "foreign/drive_period.hpp"
#include "foreign/scene_text.hpp"

namespace assur::mechanism::foreign {

namespace {

constexpr std::size_t most_joints = 1000;
constexpr double cycles_of_one_radian_per_second = 30 / M_PI;

/// A joint as written in the expression.
struct PyslvsJoint {
  std::string type;  ///< R, P or RP
  double angle = 0;  ///< of the slot of P and RP, in degrees
  double x = 0, y = 0;
  std::vector<std::string> links;
};

/// Reads the grammar: joints `J[type, A[angle], color[...], P[x, y], L[name, ...]]` in `M[...]`,
/// with blanks anywhere, and comments `# ...` and `#[ ... #]`.
class ExpressionReader {
 public:
  explicit ExpressionReader(const std::string& text) : text_(text) {}

  std::vector<PyslvsJoint> read() {
    expect("M[");
    std::vector<PyslvsJoint> joints;
    while (!take("]")) {
      if (joints.size() >= most_joints) {
        fail("there are more than " + std::to_string(most_joints) +
             " joints; divide the mechanism");
      }
      joints.push_back(joint());
      if (!take(",")) {
        expect("]");
        break;
      }
    }
    skip();
    if (at_ < text_.size()) {
      fail("expected the end of the expression");
    }
    return joints;
  }

  bool has_colors() const { return has_colors_; }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    const auto lines =
        std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
    const std::size_t line_begin = at_ == 0 ? std::string::npos : text_.rfind('\n', at_ - 1);
    const std::size_t column = at_ - (line_begin == std::string::npos ? 0 : line_begin + 1) + 1;
    const std::string found =
        at_ < text_.size() ? ", found " + text::in_quotes(text_.substr(at_, 20)) : "";
    throw MechanismError("line " + std::to_string(lines + 1) + ", column " + std::to_string(column),
                         what + found);
  }

  void skip() {
    while (at_ < text_.size()) {
      if (std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
        ++at_;
      } else if (text_[at_] == '#') {
        const bool is_long = text_.compare(at_, 2, "#[") == 0;
        const std::size_t end = is_long ? text_.find("#]", at_ + 2) : at_;
        at_ = std::min(text_.find('\n', std::min(end, text_.size())), text_.size());
      } else {
        return;
      }
    }
  }
  bool take(const std::string& word) {
    skip();
    if (text_.compare(at_, word.size(), word) != 0) {
      return false;
    }
    at_ += word.size();
    return true;
  }
  void expect(const std::string& word) {
    if (!take(word)) {
      fail("expected '" + word + "'");
    }
  }
  double number() {
    skip();
    const std::size_t sign = at_ < text_.size() && text_[at_] == '+' ? 1 : 0;
    double value = 0;
    const char* const begin = text_.data() + at_ + sign;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error != std::errc() || !std::isfinite(value)) {
      fail("expected a number");
    }
    at_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }
  std::string name() {
    skip();
    const std::size_t begin = at_;
    while (at_ < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '_')) {
      ++at_;
    }
    if (begin == at_ || std::isdigit(static_cast<unsigned char>(text_[begin])) != 0) {
      at_ = begin;
      fail("expected the name of a link");
    }
    return text_.substr(begin, at_ - begin);
  }

  PyslvsJoint joint() {
    PyslvsJoint joint;
    expect("J[");
    for (const std::string type : {"RP", "R", "P"}) {
      if (joint.type.empty() && take(type)) {
        joint.type = type;
      }
    }
    if (joint.type.empty()) {
      fail("expected the type R, P or RP of a joint");
    }
    expect(",");
    bool has_angle = false;
    if (take("A[")) {
      joint.angle = number();
      has_angle = true;
      expect("]");
      expect(",");
    }
    if (joint.type != "R" && !has_angle) {
      fail("a joint " + joint.type + " needs the angle of its slot, as A[30]");
    }
    if (take("color[")) {
      has_colors_ = true;
      const std::size_t end = text_.find(']', at_);
      if (end == std::string::npos) {
        fail("expected ']'");
      }
      at_ = end + 1;
      expect(",");
    }
    expect("P[");
    joint.x = number();
    expect(",");
    joint.y = number();
    expect("]");
    expect(",");
    expect("L[");
    while (!take("]")) {
      const std::string link = name();
      if (std::ranges::find(joint.links, link) == joint.links.end()) {
        joint.links.push_back(link);
      }
      if (!take(",")) {
        expect("]");
        break;
      }
    }
    expect("]");
    return joint;
  }

  const std::string& text_;
  std::size_t at_ = 0;
  bool has_colors_ = false;
};

/// Builds the mechanism of an expression.
class PyslvsBuilder {
 public:
  explicit PyslvsBuilder(const std::string& text) {
    ExpressionReader reader(text);
    written_ = reader.read();
    if (reader.has_colors()) {
      mechanism_.forget_look("colours");
    }
  }

  ForeignMechanism build(const std::string& driver) {
    const std::size_t joints = written_.size();
    for (std::size_t place = 0; place < joints; ++place) {
      const std::string id = "P" + std::to_string(place);
      mechanism_.points.add({id, id, written_[place].x, written_[place].y});
      for (const std::string& name : written_[place].links) {
        if (name != "ground" && !link_of_name_.contains(name)) {
          link_of_name_.emplace(name, mechanism_.links.add({name, name}));
        }
      }
    }
    for (std::size_t place = 0; place < written_.size(); ++place) {
      add_joint(place);
    }
    give_points_to_guides();
    choose_driver(driver);
    for (std::size_t place = 0; place < joints; ++place) {
      const std::vector<ForeignLinkIndex> pinned = mechanism_.pinned_at(ForeignPointIndex(place));
      if (pinned.size() == 1 && pinned.front() != mechanism_.ground()) {
        mechanism_.outputs.emplace_back(place);
      }
    }
    mechanism_.finish();
    DrivePeriod period;
    period.add(cycles_of_one_radian_per_second);
    mechanism_.sweep = period.sweep(mechanism_);
    return std::move(mechanism_);
  }

 private:
  [[nodiscard]] ForeignLinkIndex link(const std::string& name) const {
    return name == "ground" ? mechanism_.ground() : link_of_name_.at(name);
  }

  /// The first link of a slider has the slot. The part that slides in it turns there for RP, and
  /// does not for P.
  void add_joint(std::size_t place) {
    const PyslvsJoint& joint = written_[place];
    const ForeignPointIndex point(place);
    const bool slides = joint.type != "R";
    for (std::size_t at = slides ? 1 : 0; at < joint.links.size(); ++at) {
      mechanism_.list(link(joint.links[at]), point);
    }
    const std::string what = "P" + std::to_string(place);
    if (!slides) {
      return;
    }
    if (joint.links.size() < 2) {
      mechanism_.miss(what + ": a slider joins two links; it is left out");
      return;
    }
    const double angle = joint.angle * M_PI / 180;
    const ForeignLinkIndex slotted = link(joint.links[0]);
    const ForeignLinkIndex sliding = link(joint.links[1]);
    ForeignJoint slide{JointType::pin_in_slot, sliding, slotted, point};
    if (joint.type == "P") {
      slide = {JointType::prismatic, slotted, sliding, point};
      if (joint.links.size() > 2) {
        mechanism_.miss(what +
                        ": of the links in the slot, only the first is kept from turning; "
                        "the others are pinned to it");
      }
    }
    slide.direction = {std::cos(angle), std::sin(angle)};
    mechanism_.joints.add(slide);
  }

  /// Adds a point at the first slot of each link that has slots only.
  void give_points_to_guides() {
    for (const ForeignLinkIndex link : mechanism_.links.keys()) {
      if (link == mechanism_.ground() || !mechanism_.links[link].points.empty()) {
        continue;
      }
      for (const ForeignJoint& joint : mechanism_.joints) {
        if (mechanism_.links[link].points.empty() &&
            (joint.first == link || joint.second == link)) {
          const ForeignPoint at = mechanism_.points[joint.at];
          added_points_.push_back({link, at});
          break;
        }
      }
    }
    for (const auto& [link, at] : added_points_) {
      mechanism_.list(link,
                      mechanism_.points.add({mechanism_.links[link].id + "_slot", "", at.x, at.y}));
      written_.push_back({"P", 0, at.x, at.y, {}});
    }
  }

  void choose_driver(const std::string& driver) {
    ForeignPointIndex point;
    for (std::size_t place = 0; place < written_.size() && !point.exists(); ++place) {
      const std::vector<ForeignLinkIndex> pinned = mechanism_.pinned_at(ForeignPointIndex(place));
      const bool is_crank = driver.empty() && written_[place].type == "R" && pinned.size() == 2 &&
                            pinned.front() == mechanism_.ground();
      if (is_crank ||
          (!driver.empty() && driver == mechanism_.points[ForeignPointIndex(place)].id)) {
        point = ForeignPointIndex(place);
      }
    }
    if (!point.exists()) {
      if (!driver.empty()) {
        throw MechanismError(
            "--driver", "there is no point " + text::in_quotes(driver) +
                            "; the points are P0 to P" +
                            std::to_string(std::max<std::size_t>(mechanism_.points.size(), 1) - 1));
      }
      return;
    }
    const std::string name = mechanism_.points[point].id;
    if (driver.empty()) {
      mechanism_.remark("an expression names no input: " + name +
                        ", the first pin of one link on the ground, is driven; --driver POINT "
                        "drives another one");
    }
    mechanism_.remark(
        "an expression has no speed: the drive turns by a radian in a second, or "
        "slides by one length");
    for (const ForeignJointIndex joint : mechanism_.joints.keys()) {
      if (mechanism_.joints[joint].at == point) {
        mechanism_.drives.push_back({joint, " + 1*t"});
        return;
      }
    }
    std::vector<ForeignLinkIndex> pinned = mechanism_.pinned_at(point);
    if (pinned.size() < 2) {
      throw MechanismError("--driver", "the point " + text::in_quotes(name) +
                                           " is no joint of two links; name another one");
    }
    // If the ground is among the links at a driven pin, all others are driven; otherwise the second
    // relative to the first.
    pinned.resize(pinned.front() == mechanism_.ground() ? pinned.size() : 2);
    for (auto link = pinned.begin() + 1; link != pinned.end(); ++link) {
      mechanism_.drives.push_back({mechanism_.pin(pinned.front(), *link, point), " + 1*t"});
    }
  }

  ForeignMechanism mechanism_;
  std::vector<PyslvsJoint> written_;
  std::map<std::string, ForeignLinkIndex> link_of_name_;
  std::vector<std::pair<ForeignLinkIndex, ForeignPoint>> added_points_;
};

}  // namespace

ForeignMechanism pyslvs_mechanism(const std::string& text, const std::string& driver) {
  return PyslvsBuilder(text).build(driver);
}

}  // namespace assur::mechanism::foreign
