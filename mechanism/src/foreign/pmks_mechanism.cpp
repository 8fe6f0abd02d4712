// Mechanisms from links that PMKS+ shares, with masses and forces.
#include <algorithm>
#include <assur/text/quoted.hpp>
#include <cmath>
#include <map>

#include "foreign/drive_period.hpp"
#include "foreign/pmks_payload.hpp"
#include "foreign/scene_text.hpp"

namespace assur::mechanism::foreign {

namespace {

/// The program's units for one unit of length, as factors that make forces newtons, or pounds of
/// force for lengths in inches. Masses are pounds, grams and kilograms, inertias lb in^2, kg cm^2
/// and kg m^2.
struct Units {
  const char* length;
  const char* mass_factor;
  const char* inertia_factor;
  const char* gravity;
  const char* told;  ///< the factors in the remark
};
constexpr std::array pmks_units = {
    Units{"in", "*0.0254/9.80665", "*0.0254/9.80665", "-9.81/0.0254",
          "lbf s^2/in, so that forces are pounds of force, and couples lbf in"},
    Units{"cm", "/100000", "/100", "-981", "100 kg, so that forces are newtons, and couples N cm"},
    Units{"m", "", "", "-9.81", ""}};

/// Builds the mechanism of a payload.
class PmksBuilder {
 public:
  explicit PmksBuilder(const std::string& text) : payload_(read_pmks(text, mechanism_)) {}

  ForeignMechanism build() {
    if (payload_.length_unit >= 0 && payload_.length_unit < static_cast<int>(pmks_units.size())) {
      unit_ = &pmks_units[static_cast<std::size_t>(payload_.length_unit)];
      mechanism_.unit = unit_->length;
    } else {
      mechanism_.remark("the link names no unit of length");
    }
    number_parts();
    fold_blocks();
    for (const PmksJoint& joint : payload_.joints) {
      mechanism_.points.add({joint.id, joint.name, joint.x, joint.y});
    }
    add_links();
    for (std::size_t place = 0; place < payload_.joints.size(); ++place) {
      const PmksJoint& joint = payload_.joints[place];
      if (is_folded_[place]) {
        continue;
      }
      const ForeignPointIndex point(place);
      if (joint.slides) {
        add_slide(joint, point);
      } else {
        add_pin(joint, point);
      }
      if (joint.is_traced && mechanism_.is_moved(point)) {
        mechanism_.outputs.push_back(point);
      }
    }
    add_masses();
    add_forces();
    mechanism_.finish();
    mechanism_.sweep = period_.sweep(mechanism_);
    if (!mechanism_.sweep && slide_speed_ != 0) {
      mechanism_.sweep = slide_sweep();
    }
    return std::move(mechanism_);
  }

 private:
  void number_parts() {
    for (std::size_t place = 0; place < payload_.joints.size(); ++place) {
      if (!joint_of_id_.emplace(payload_.joints[place].id, place).second) {
        throw MechanismError("joint " + text::shortened(payload_.joints[place].id),
                             "the link has two of them; copy the whole link again");
      }
    }
    for (std::size_t place = 0; place < payload_.links.size(); ++place) {
      const PmksLink& link = payload_.links[place];
      const std::string part = "link " + text::shortened(link.id);
      if (!link_of_id_.emplace(link.id, place).second) {
        throw MechanismError(part, "the link has two of them; copy the whole link again");
      }
      for (const std::string& id : link.joints) {
        if (!joint_of_id_.contains(id)) {
          throw MechanismError(
              part, "there is no joint " + text::in_quotes(id) + "; copy the whole link again");
        }
      }
    }
    is_folded_.resize(payload_.joints.size());
  }

  /// Older links store a slider as a separate joint, which a block joins to a pin at the same
  /// place: the pin takes over the slider's data, and the slider is removed.
  void fold_blocks() {
    for (const PmksLink& block : payload_.links) {
      if (!block.is_block || block.joints.size() != 2) {
        continue;
      }
      std::size_t slider = joint_of_id_.at(block.joints[0]);
      std::size_t pin = joint_of_id_.at(block.joints[1]);
      if (!payload_.joints[slider].slides) {
        std::swap(slider, pin);
      }
      PmksJoint& one = payload_.joints[slider];
      PmksJoint& other = payload_.joints[pin];
      if (!one.slides || other.slides) {
        mechanism_.miss("link " + text::in_quotes(block.id) +
                        ": the block joins no slider to a pin, and is left out");
        continue;
      }
      other.slides = true;
      other.is_input = one.is_input || other.is_input;
      other.is_traced = one.is_traced || other.is_traced;
      other.angle = one.angle;
      other.carrier = one.carrier;
      other.slot_a = one.slot_a;
      other.slot_b = one.slot_b;
      other.speed = other.speed == 0 ? one.speed : other.speed;
      other.mass = block.mass;
      is_folded_[slider] = true;
    }
  }

  void add_links() {
    for (const PmksLink& link : payload_.links) {
      if (!link.is_root || link.is_block) {
        continue;
      }
      const auto grounded = std::ranges::count_if(link.joints, [&](const std::string& id) {
        const PmksJoint& joint = payload_.joints[joint_of_id_.at(id)];
        return joint.is_grounded && !joint.slides;
      });
      const ForeignLinkIndex body =
          grounded > 1 ? mechanism_.ground() : mechanism_.links.add({link.id, link.name});
      body_of_id_[link.id] = body;
      for (const std::string& id : link.joints) {
        mechanism_.list(body, ForeignPointIndex(joint_of_id_.at(id)));
      }
    }
    // A point that is fixed in a part is fixed in the whole.
    for (const PmksLink& link : payload_.links) {
      for (const std::string& part : link.parts) {
        if (const auto whole = body_of_id_.find(link.id); whole != body_of_id_.end()) {
          body_of_id_.emplace(part, whole->second);
        }
      }
    }
  }

  [[nodiscard]] ForeignLinkIndex body(const std::string& id) const {
    const auto found = body_of_id_.find(id);
    return found == body_of_id_.end() ? ForeignLinkIndex() : found->second;
  }
  /// The links other than the slot's that have a joint, in the order of the file.
  [[nodiscard]] std::vector<ForeignLinkIndex> riders(ForeignPointIndex point,
                                                     ForeignLinkIndex slotted) const {
    std::vector<ForeignLinkIndex> found;
    for (const ForeignLinkIndex link : mechanism_.links.keys()) {
      if (link != slotted && link != mechanism_.ground() && mechanism_.lists(link, point)) {
        found.push_back(link);
      }
    }
    return found;
  }

  void add_pin(const PmksJoint& joint, ForeignPointIndex point) {
    const std::string what = "joint " + text::in_quotes(joint.id);
    if (joint.is_grounded) {
      mechanism_.list(mechanism_.ground(), point);
    }
    if (!joint.is_input) {
      return;
    }
    std::vector<ForeignLinkIndex> pinned = mechanism_.pinned_at(point);
    if (pinned.size() < 2) {
      mechanism_.miss(what +
                      ": it is an input, but joins no two links that move against each other");
      return;
    }
    if (pinned.size() > 2) {
      mechanism_.remark(what + ": of the links at the input, the first is driven");
    }
    mechanism_.drives.push_back({mechanism_.pin(pinned[0], pinned[1], point), turning(joint)});
  }

  /// Speeds of joints count counter-clockwise; the file stores the sense separately.
  std::string turning(const PmksJoint& joint) {
    const double speed =
        joint.speed != 0 ? joint.speed
                         : std::abs(payload_.turns_per_minute) * (payload_.is_clockwise ? -1 : 1);
    if (speed == 0) {
      mechanism_.remark("joint " + text::in_quotes(joint.id) +
                        ": the input stands still, since its speed is 0");
      return "";
    }
    period_.add(std::abs(speed));
    return term_text(speed) + "*2*pi/60*t";
  }

  void add_slide(const PmksJoint& joint, ForeignPointIndex point) {
    const std::string what = "joint " + text::in_quotes(joint.id);
    const bool is_in_link = !joint.carrier.empty();
    const ForeignLinkIndex slotted = is_in_link ? body(joint.carrier) : mechanism_.ground();
    if (!slotted.exists()) {
      throw MechanismError("joint " + text::shortened(joint.id),
                           "there is no link " + text::in_quotes(joint.carrier) +
                               " for its slot; copy the whole link again");
    }
    const std::vector<ForeignLinkIndex> riding = riders(point, slotted);
    if (riding.empty()) {
      mechanism_.miss(what + ": it slides in its own link, or in none, and holds nothing");
      return;
    }
    ForeignJoint slide{joint.is_welded ? JointType::prismatic : JointType::pin_in_slot,
                       joint.is_welded ? slotted : riding.front(),
                       joint.is_welded ? riding.front() : slotted, point};
    if (is_in_link) {
      for (const std::string& id : {joint.slot_a, joint.slot_b}) {
        if (!joint_of_id_.contains(id)) {
          throw MechanismError("joint " + text::shortened(joint.id),
                               "there is no joint " + text::in_quotes(id) +
                                   " for its slot; copy the whole link again");
        }
      }
      slide.along = {ForeignPointIndex(joint_of_id_.at(joint.slot_a)),
                     ForeignPointIndex(joint_of_id_.at(joint.slot_b))};
      if (mechanism_.distance((*slide.along)[0], (*slide.along)[1]) == 0) {
        mechanism_.miss(what + ": the ends of its slot coincide");
        return;
      }
    } else {
      slide.direction = {std::cos(joint.angle), std::sin(joint.angle)};
    }
    if (joint.is_welded && mechanism_.lists(slotted, point)) {
      mechanism_.miss(what + ": the link of its slot is pinned there, too");
      return;
    }
    const ForeignJointIndex added = mechanism_.joints.add(slide);
    block_masses_.push_back({riding.front(), joint.mass, 0, joint.x, joint.y});
    if (joint.is_input) {
      mechanism_.drives.push_back({added, sliding(joint)});
    }
  }

  std::string sliding(const PmksJoint& joint) {
    const double speed =
        joint.speed != 0 ? joint.speed : payload_.slide_speed * (payload_.is_clockwise ? -1 : 1);
    if (speed == 0) {
      mechanism_.miss("joint " + text::in_quotes(joint.id) +
                      ": the link gives no speed for a driven slide; it stands as it is drawn");
      return "";
    }
    slide_speed_ = slide_speed_ == 0 ? std::abs(speed) : std::min(slide_speed_, std::abs(speed));
    return term_text(speed) + "*t";
  }

  /// A slide is swept over half the width of the drawing, to either side.
  [[nodiscard]] ForeignSweep slide_sweep() const {
    double size = 0;
    for (const ForeignPointIndex point : mechanism_.points.keys()) {
      size = std::max(size, mechanism_.distance(ForeignPointIndex(0), point));
    }
    const double half = size / 2 / slide_speed_;
    constexpr int steps = 360;
    return {"t", -half, half, steps + 1};
  }

  /// The masses of links, including the blocks that slide with them.
  void add_masses() {
    for (const PmksLink& link : payload_.links) {
      if (link.is_root && !link.is_block && (link.mass != 0 || link.inertia != 0)) {
        add_mass({body(link.id), link.mass, link.inertia, link.x, link.y});
      }
    }
    for (const ForeignMass& mass : block_masses_) {
      if (mass.mass != 0) {
        add_mass(mass);
      }
    }
    if (mechanism_.masses.empty()) {
      return;
    }
    if (unit_ != nullptr) {
      mechanism_.mass_factor = unit_->mass_factor;
      mechanism_.inertia_factor = unit_->inertia_factor;
      mechanism_.gravity = payload_.has_gravity ? unit_->gravity : "";
      if (unit_->told[0] != '\0') {
        mechanism_.remark(std::string("masses are written in ") + unit_->told);
      }
    } else {
      mechanism_.remark("masses and gravity need a unit of length; they are left out");
      mechanism_.masses.clear();
    }
  }

  void add_mass(const ForeignMass& added) {
    if (added.link == mechanism_.ground() || !added.link.exists()) {
      return;  // links at rest need no mass
    }
    if (added.mass < 0 || added.inertia < 0) {
      mechanism_.remark("a negative mass of the link " +
                        text::in_quotes(mechanism_.links[added.link].id) + " is left out");
      return;
    }
    const auto found = std::ranges::find(mechanism_.masses, added.link, &ForeignMass::link);
    if (found == mechanism_.masses.end()) {
      mechanism_.masses.push_back(added);
      return;
    }
    // Two bodies as one: the inertia is about the common centre. A mass in grams with lengths in
    // centimetres gives kilograms times square centimetres.
    const double mass = found->mass + added.mass;
    if (mass == 0) {
      return;
    }
    const double part = added.mass / mass;
    const double across = std::hypot(added.x - found->x, added.y - found->y);
    const double in_inertia_unit = payload_.length_unit == 1 ? 0.001 : 1;
    found->inertia += added.inertia + in_inertia_unit * found->mass * part * across * across;
    found->x += part * (added.x - found->x);
    found->y += part * (added.y - found->y);
    found->mass = mass;
  }

  void add_forces() {
    mechanism_.wants_forces = payload_.wants_forces || !payload_.forces.empty();
    for (const PmksForce& force : payload_.forces) {
      const std::string what = "force " + text::in_quotes(force.id);
      const ForeignLinkIndex link = body(force.link);
      if (!link.exists()) {
        throw MechanismError(
            "force " + text::shortened(force.id),
            "there is no link " + text::in_quotes(force.link) + "; copy the whole link again");
      }
      const double x = force.end_x - force.start_x;
      const double y = force.end_y - force.start_y;
      const double length = std::hypot(x, y);
      if (length == 0 || link == mechanism_.ground()) {
        mechanism_.remark(what + (length == 0 ? ": it has no direction, and is left out"
                                              : ": it acts on the ground, and is left out"));
        continue;
      }
      if (!force.points_out) {
        mechanism_.remark(what +
                          ": its arrow is drawn inward; the force acts from its start to its end");
      }
      mechanism_.forces.push_back({force.id,
                                   force.name,
                                   link,
                                   force.start_x,
                                   force.start_y,
                                   {force.magnitude * x / length, force.magnitude * y / length},
                                   force.is_local});
    }
  }

  ForeignMechanism mechanism_;
  PmksPayload payload_;
  const Units* unit_ = nullptr;
  std::map<std::string, std::size_t> joint_of_id_, link_of_id_;
  std::map<std::string, ForeignLinkIndex> body_of_id_;
  std::vector<bool> is_folded_;
  std::vector<ForeignMass> block_masses_;
  DrivePeriod period_;
  double slide_speed_ = 0;
};

}  // namespace

ForeignMechanism pmks_mechanism(const std::string& payload) { return PmksBuilder(payload).build(); }

}  // namespace assur::mechanism::foreign
