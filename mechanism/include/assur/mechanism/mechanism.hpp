// Planar mechanism of links, joints, drivers and outputs, built part by part by name.
#pragma once

#include <array>
#include <assur/mechanism/error.hpp>
#include <assur/mechanism/formula.hpp>
#include <assur/mechanism/loads.hpp>
#include <assur/mechanism/part_indices.hpp>
#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

namespace assur::mechanism {

/// A number of a mechanism, and its part of the mechanism, for messages.
struct Number {
  Formula formula;
  std::string part;  ///< `links.crank.B[0]`
};

/// A number with a name.
struct Parameter {
  std::string name;
  NumberIndex value;
  NumberIndex tolerance;  ///< a half-width; does not exist if the parameter has no tolerance
  /// Rates in time. If they do not exist, they follow from the rates of the parameters in its
  /// formula.
  NumberIndex velocity, acceleration;
};

/// A named place on a link, in the link's local frame: a point, or a line through it.
struct Feature {
  std::string name;
  LinkIndex link;
  bool is_line = false;
  NumberIndex x, y;              ///< of the point, or of the line's `through`
  NumberIndex along_x, along_y;  ///< of a line; of any length, but its sense matters
};

/// A rigid body with named features.
struct Link {
  std::string name;
  std::vector<FeatureIndex> features;
  bool is_drawn = false;  ///< whether points of a drawing define its frame and its features
  bool is_idle = false;   ///< whether it would turn freely on its only pin, and is held at rest
};

/// The constraint that a joint puts on its features.
enum class JointType : unsigned char {
  revolute,    ///< the points coincide; k links at one pin are k - 1 joints
  prismatic,   ///< the two lines coincide and point the same way
  pin_in_slot  ///< the point lies on the line
};

/// A connection of features of links.
struct Joint {
  std::string name;
  JointType type = JointType::revolute;
  std::vector<FeatureIndex> between;
  NumberIndex lowest, highest;  ///< of its coordinate; do not exist where it has no limits
  /// Whether the order of its links, and so the sense of its coordinate, is given. If not, neither
  /// drivers nor formulas may name the joint.
  bool is_measured = true;
};

/// The law of a joint of two links: the angle theta_second - theta_first, or the displacement. It
/// may read the coordinates of other joints.
struct Driver {
  JointIndex joint;
  NumberIndex position;
  NumberIndex velocity, acceleration;  ///< if they do not exist, they follow from the law
};

/// A point to report.
struct Output {
  std::string name;
  FeatureIndex point;
};

/// One planar mechanism: its parts, without a request for results. Every function that adds a part
/// throws MechanismError if the part does not fit the others, and then leaves the mechanism
/// unchanged.
///
///     Mechanism four_bar("a four-bar");
///     four_bar.add_parameter("phi", "60*deg");
///     four_bar.add_link("ground");
///     four_bar.add_point("ground.A", 0, 0);
///     ...
///     four_bar.add_joint("A", JointType::revolute, {"ground.A", "crank.A"});
///     four_bar.add_driver("A", "phi", 1);
///     four_bar.add_output("P", "coupler.P");
///
/// Lengths share one unit; angles are radians. The link named `ground`, if there is one, is the
/// fixed frame. A number may be given as a number or as an expression in declared parameters
/// (docs/guide/scenes.md).
class Mechanism {
 public:
  /// The limit: planning a chain of a thousand cranks takes two seconds, and the time grows as the
  /// cube.
  static constexpr std::size_t most_links = 1000;

  /// A number as a caller gives it: a number, the text of an expression, or a formula.
  class Given {
   public:
    Given(double number) : formula_(number) {}
    Given(int number) : formula_(number) {}
    Given(const char* expression) : text_(expression) {}
    Given(std::string expression) : text_(std::move(expression)) {}
    /// A formula in the parameters of the mechanism that it is given to.
    Given(Formula formula) : formula_(std::move(formula)) {}

   private:
    friend class Mechanism;
    Formula formula_;
    std::optional<std::string> text_;
  };

  explicit Mechanism(std::string name = "") : name_(std::move(name)) {}

  /// Declares a name for use in expressions. The parameter must get a value before the mechanism is
  /// used.
  ParameterIndex declare_parameter(const std::string& name);
  /// Sets the value of a declared parameter; `part` is its name in messages.
  void set_parameter(const std::string& name, const Given& value, const std::string& part = "");
  void set_tolerance(const std::string& name, const Given& half_width);
  /// Sets a rate in time. Quantities that depend on the parameter get their rates by the chain
  /// rule.
  void set_velocity(const std::string& name, const Given& velocity);
  void set_acceleration(const std::string& name, const Given& acceleration);
  /// Declares a parameter and sets its value.
  ParameterIndex add_parameter(const std::string& name, const Given& value);

  LinkIndex add_link(const std::string& name);
  /// A link whose frame and features are defined by points of a drawing.
  LinkIndex add_drawn_link(const std::string& name);
  /// Adds a feature; `name` is `link.feature`.
  FeatureIndex add_point(const std::string& name, const Given& x, const Given& y);
  /// A line through a point; `along` is its direction, of any length except zero.
  FeatureIndex add_line(const std::string& name, const Given& x, const Given& y,
                        const Given& along_x, const Given& along_y);
  /// A line from one point of the link to another, both given by their names without the link's.
  FeatureIndex add_line(const std::string& name, const std::string& from, const std::string& to);
  JointIndex add_joint(const std::string& name, JointType type,
                       const std::vector<std::string>& between);
  /// A revolute joint whose coordinate has no sense, since the order of its links is not given.
  JointIndex add_unmeasured_joint(const std::string& name, const std::vector<std::string>& between);
  /// Sets the range, ends included, of the coordinate of a joint of two links. An angle is within
  /// the range if whole turns bring it there.
  void set_limits(const std::string& joint, const Given& lowest, const Given& highest);
  /// Adds a driver. The position may contain `joint(K)`, the coordinate of another joint of two
  /// links. Omitted rates follow from the position.
  DriverIndex add_driver(const std::string& joint, const Given& position,
                         const std::optional<Given>& velocity = std::nullopt,
                         const std::optional<Given>& acceleration = std::nullopt);
  OutputIndex add_output(const std::string& name, const std::string& point);

  /// A place of a mass: a point's name without its link, coordinates, or the link's origin.
  using GivenPlace = std::variant<std::monostate, std::string, std::array<Given, 2>>;
  /// Gives a link a mass, and a moment of inertia about the centre of mass.
  void add_mass(const std::string& link, const Given& mass, const GivenPlace& at = {},
                const Given& inertia = 0);
  /// Sets the acceleration of free fall, in the frame of the ground.
  void set_gravity(const Given& x, const Given& y);
  /// Adds a force at `link.point`, in the frame of a link (the ground's if the name is empty). The
  /// force and a moment may contain `joint(K)`.
  void add_force(const std::string& name, const std::string& at, const std::array<Given, 2>& force,
                 const std::string& frame = "");
  /// Adds a couple on a link.
  void add_moment(const std::string& name, const std::string& link, const Given& moment);
  /// Adds a spring with a damper between `link.point` and `link.point`.
  void add_spring(const std::string& name, const std::array<std::string, 2>& between,
                  const Given& stiffness, const Given& length, const Given& damping);
  /// Adds a spring with a damper along the coordinate of a joint of two links.
  void add_joint_spring(const std::string& name, const std::string& joint, const Given& stiffness,
                        const Given& rest, const Given& damping);
  [[nodiscard]] const Loading& loading() const { return loading_; }

  [[nodiscard]] const std::string& name() const { return name_; }
  void set_name(const std::string& name);
  /// The name of the unit of length; may be empty.
  [[nodiscard]] const std::string& unit() const { return unit_; }
  void set_unit(const std::string& unit);
  [[nodiscard]] const Table<ParameterIndex, Parameter>& parameters() const { return parameters_; }
  [[nodiscard]] const Table<NumberIndex, Number>& numbers() const { return numbers_; }
  [[nodiscard]] const Table<FeatureIndex, Feature>& features() const { return features_; }
  [[nodiscard]] const Table<LinkIndex, Link>& links() const { return links_; }
  [[nodiscard]] const Table<JointIndex, Joint>& joints() const { return joints_; }
  [[nodiscard]] const Table<DriverIndex, Driver>& drivers() const { return drivers_; }
  [[nodiscard]] const Table<OutputIndex, Output>& outputs() const { return outputs_; }
  /// The driver of a joint; does not exist if the joint has none.
  [[nodiscard]] DriverIndex driver_of(JointIndex joint) const;
  /// Whether a driver was not described, but holds an idle link at rest.
  [[nodiscard]] bool holds_idle(DriverIndex driver) const;
  /// The fixed frame; does not exist if no link is named `ground`.
  [[nodiscard]] LinkIndex ground() const { return index_of(links_, std::string("ground")); }

  /// Holds at rest, by a driver each, the links that only one pin holds, if no driver, limit,
  /// formula or load is at that pin and nothing loads the link; `angle_of` gives the angle of a
  /// link. Two links pinned only to each other are held by one driver. Does nothing if other links
  /// can move as well.
  void hold_idle_links(const std::function<Formula(LinkIndex)>& angle_of);

  /// The mechanism without the links that are not kept: without their features and outputs, and
  /// without the joints that fewer than two of the kept links share. Parameters and numbers are
  /// unchanged.
  [[nodiscard]] Mechanism only(const Table<LinkIndex, bool>& kept) const;

  /// The mechanism with all its drivers advanced: angles by `by`, displacements by `by * length`.
  [[nodiscard]] Mechanism driven_on(double by, double length) const;
  /// The mechanism in which a joint no longer holds one of its links, the owner of this feature.
  [[nodiscard]] Mechanism without(JointIndex joint, FeatureIndex feature) const;
  /// The mechanism in which a pin replaces one of the lines of a prismatic joint, at the line's
  /// `through`. The pin slides in the other line, so that the joint has one constraint less; its
  /// displacement is unchanged.
  [[nodiscard]] Mechanism with_pin(JointIndex slide, FeatureIndex line) const;
  /// The mechanism with a slot on one of the links of a revolute joint, along the line from another
  /// point of that link, so that the joint has one constraint less.
  [[nodiscard]] Mechanism with_slot(JointIndex pin, FeatureIndex feature,
                                    FeatureIndex along_from) const;

  /// The formula of a number that names parameters only.
  [[nodiscard]] Formula formula_of(const Given& given, const std::string& part) const;
  /// The parameter with a name; `part` is the place of the name, for messages.
  [[nodiscard]] ParameterIndex parameter_named(const std::string& name,
                                               const std::string& part = "") const;
  /// A number that a request adds; it counts as one of the mechanism's.
  NumberIndex add_number(const Given& given, const std::string& part);

 private:
  [[nodiscard]] JointIndex pin_of_idle(LinkIndex link) const;
  void hold(JointIndex joint, const std::function<Formula(LinkIndex)>& angle_of);
  /// Updates drivers to other indices of joints, and removes the drivers of joints that are gone.
  void renumber_drivers(const Table<JointIndex, JointIndex>& joint_of);
  /// The names allowed in an expression beside parameters.
  enum class Reads : unsigned char { parameters, joints };
  [[nodiscard]] Formula formula(const std::string& text, const std::string& part,
                                Reads reads) const;
  [[nodiscard]] Number number(const Given& given, const std::string& part,
                              Reads reads = Reads::parameters) const;
  [[nodiscard]] JointIndex joint_named(const std::string& name, const std::string& part) const;
  /// Replaces the number at `place` if there is one, else adds it.
  void put_number(const Given& given, const std::string& part, NumberIndex& place);
  void expect_new_parameter(const std::string& name) const;
  ParameterIndex add(Parameter parameter);
  /// The feature `link.feature` of an existing link; the link need not have the feature yet.
  [[nodiscard]] Feature on_link(const std::string& name, const std::string& part) const;
  [[nodiscard]] Feature new_feature(const std::string& name, const std::string& part) const;
  FeatureIndex add_feature(Feature feature);
  [[nodiscard]] FeatureIndex feature_named(const std::string& name, const std::string& part) const;
  void expect_fitting(const Joint& joint, const std::string& part) const;
  /// Throws MechanismError, with the remedy, for a joint whose coordinate has no sense.
  void expect_measured(const Joint& joint, const std::string& part) const;
  [[nodiscard]] LinkIndex link_named(const std::string& name, const std::string& part) const;
  [[nodiscard]] FeatureIndex point_named(const std::string& name, const std::string& part) const;
  [[nodiscard]] NumberIndex number_not_negative(const Given& given, const std::string& part);
  void expect_new_load(const std::string& name, const std::string& part) const;
  void expect_new_spring(const std::string& name, const std::string& part) const;
  /// Removes the loads of links and features without new indices, and renumbers the others.
  void renumber_loading(const Table<LinkIndex, LinkIndex>& link_of,
                        const Table<FeatureIndex, FeatureIndex>& feature_of);
  /// Updates the formulas of loads to other indices of joints.
  void renumber_loads(const Table<JointIndex, JointIndex>& joint_of);

  std::string name_;
  std::string unit_;
  Table<ParameterIndex, Parameter> parameters_;
  std::unordered_map<std::string, ParameterIndex> parameter_of_name_;
  Table<NumberIndex, Number> numbers_;
  Table<FeatureIndex, Feature> features_;
  Table<LinkIndex, Link> links_;
  Table<JointIndex, Joint> joints_;
  Table<DriverIndex, Driver> drivers_;
  Table<OutputIndex, Output> outputs_;
  Loading loading_;
};

}  // namespace assur::mechanism
