// Drawing of a mechanism and its configurations, in SVG, DXF or as an animated page.
#pragma once

#include <Eigen/Core>
#include <assur/mechanism/mechanism.hpp>
#include <assur/mechanism/request.hpp>
#include <optional>
#include <string>
#include <vector>

namespace assur::mechanism {

/// The meaning of a shape; its points are listed in this order.
enum class Symbol : unsigned char {
  bar,     ///< a link, from end to end
  plate,   ///< a link, its corners counter-clockwise
  slot,    ///< the line in which a pin slides, from end to end
  guide,   ///< the line along which a block slides, from end to end
  block,   ///< its centre, and a point ahead of it along the guide
  tube,    ///< of a cylinder: its eye and its mouth
  rod,     ///< of a cylinder: the tube's mouth and the rod's own eye
  pin,     ///< a revolute joint
  tracer,  ///< an output's point
};

/// A part of the drawing, the same in every stance.
struct Shape {
  Symbol symbol;
  std::string link;                 ///< its link; empty for a pin, which links share
  std::string name;                 ///< of the joint, or of the output; empty for a link itself
  bool fixed = false;               ///< whether it belongs to the ground
  std::vector<std::size_t> points;  ///< places in the points of a stance
};

/// One configuration: the points of the shapes, in the frame of the ground.
struct Stance {
  int configuration;  ///< its number among the solution's, from 1
  std::vector<Eigen::Vector2d> points;
};

/// The path of an output along one branch of the sweep.
struct Trace {
  int configuration;  ///< a configuration on the branch; 0 if it is unknown
  std::string output;
  std::vector<Eigen::Vector2d> points;
};

/// A singular configuration on a branch of the sweep.
struct Mark {
  std::string event;                    ///< `fold`, `crossing`: see docs/guide/sweeps.md
  double parameter;                     ///< the swept parameter's value
  std::vector<int> configurations;      ///< of the branches that meet there
  std::vector<Eigen::Vector2d> points;  ///< of the outputs
};

/// The force that a joint transmits to one of its links.
struct ForceArrow {
  std::string joint, link;
  Eigen::Vector2d at;
  Eigen::Vector2d force;
};

/// A mechanism as plain data. Lengths are in the scene's unit.
struct Drawing {
  std::string title;      ///< the mechanism's name
  std::string unit;       ///< of length, as in the scene; may be empty
  std::string parameter;  ///< the swept parameter; empty without a sweep
  std::vector<Shape> shapes;
  std::vector<Stance> stances;
  std::size_t emphasised = 0;  ///< the stance drawn at full strength
  std::size_t left_out = 0;    ///< number of configurations that are not drawn
  std::vector<Trace> traces;
  std::vector<Mark> marks;
  /// The forces in the joints of the only stance; empty if several are drawn or none are requested.
  std::vector<ForceArrow> forces;
  double length_of_force = 0;  ///< the length of the arrow of a unit force
  /// The emphasised stance at successive moments of a repeated motion; empty without motion.
  std::vector<Stance> motion;
  double seconds = 0;  ///< duration of one period
};

/// The configurations to draw.
struct DrawingChoice {
  int configuration = 0;  ///< the number of the only one to draw; 0 for all
  bool nearest = false;   ///< only the one nearest to the request's reference
};

/// The largest number of configurations that are drawn.
inline constexpr std::size_t most_drawn = 24;

/// Solves the mechanism at its own values and draws its configurations, with the paths of the
/// outputs over the request's sweep. If all are drawn, the one nearest to the request's reference
/// is emphasised, or else the first. If one is drawn and forces are requested, the forces in its
/// joints are drawn. Throws MechanismError if there is no configuration, or none of that number,
/// and as `Plan` and `sweep` do.
[[nodiscard]] Drawing drawing_of(const Mechanism& mechanism, const Request& request,
                                 const DrawingChoice& choice = {});

/// One branch of the request's sweep in motion: the branch with a number, or for 0 the one nearest
/// to the reference, or else the first. The motion is periodic if the branch ends as it begins, and
/// otherwise runs back and forth. Throws MechanismError as `drawing_of` does, and if the request
/// has no sweep.
[[nodiscard]] Drawing moving_drawing_of(const Mechanism& mechanism, const Request& request,
                                        int branch = 0);

/// A picture 80 mm wide, in one self-contained file, light or dark as the reader's viewer prefers.
/// Its coordinates (u, v) follow from the scene's (x, y) by the root's attributes `data-x`,
/// `data-y` and `data-scale`: u = data-scale (x - data-x), v = data-scale (data-y - y).
[[nodiscard]] std::string drawing_svg(const Drawing& drawing);

/// A drawing for CAD in the ASCII form of DXF R12, in the scene's unit, with a layer for each link
/// of each configuration, for its pins, for each output's path, and for dead centres.
[[nodiscard]] std::string drawing_dxf(const Drawing& drawing);

/// The text of a scene file, which a page can solve anew.
struct SceneText {
  std::string text;
  std::vector<std::string> settings;  ///< of parameters, as `parse_scene` takes them
};

/// The most bytes of a page: a size that mail accepts, and a browser opens at once.
inline constexpr std::size_t most_page_bytes = 1'500'000;

/// One self-contained HTML page of `most_page_bytes` at most, which needs no network. It animates
/// all branches of the request's sweep, or shows all configurations if there is none. It opens on
/// the branch with the number `chosen`, or for 0 on the one nearest to the reference, or else on
/// the first. With the text of the scene from which the mechanism and the request were read, the
/// page can solve that scene for other values of its parameters and another drawing, unless that
/// would make it too large. Throws MechanismError as `drawing_of` does and if no step of the sweep
/// has a configuration, and NoSuchConfiguration if no branch has the number.
[[nodiscard]] std::string drawing_page(const Mechanism& mechanism, const Request& request,
                                       const std::optional<SceneText>& scene = std::nullopt,
                                       int chosen = 0);

}  // namespace assur::mechanism
