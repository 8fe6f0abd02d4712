// Turns a mechanism and its configurations into a drawing, in SVG, DXF or an animated page.
#pragma once

#include <Eigen/Core>
#include <assur/mechanism/mechanism.hpp>
#include <assur/mechanism/request.hpp>
#include <optional>
#include <string>
#include <vector>

namespace assur::mechanism {

/// What a shape stands for; its points are listed in this order.
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
  std::string link;    ///< the link that it is or belongs to; empty for a pin, which links share
  std::string name;    ///< of the joint, or of the output; empty for a link itself
  bool fixed = false;  ///< whether it is on the ground
  std::vector<std::size_t> points;  ///< places in the points of a stance
};

/// One configuration: where the points of the shapes are, in the frame of the ground.
struct Stance {
  int configuration;  ///< its number among the solution's, from 1
  std::vector<Eigen::Vector2d> points;
};

/// The path of an output along one branch of the sweep.
struct Trace {
  int configuration;  ///< through which the branch passes; 0 where that is not known
  std::string output;
  std::vector<Eigen::Vector2d> points;
};

/// A singular configuration on a branch of the sweep.
struct Mark {
  std::string event;                    ///< `fold`, `crossing`: see docs/guide/sweeps.md
  double parameter;                     ///< the swept parameter's value
  std::vector<int> configurations;      ///< whose branches meet there
  std::vector<Eigen::Vector2d> points;  ///< where the outputs are
};

/// What a joint transmits to one of its links.
struct ForceArrow {
  std::string joint, link;
  Eigen::Vector2d at;
  Eigen::Vector2d force;
};

/// A mechanism as plain data. Lengths are in the scene's unit.
struct Drawing {
  std::string title;      ///< the mechanism's name
  std::string unit;       ///< of length, as the scene has it; may be empty
  std::string parameter;  ///< that is swept; empty without a sweep
  std::vector<Shape> shapes;
  std::vector<Stance> stances;
  std::size_t emphasised = 0;  ///< the stance that is drawn at full strength
  std::size_t left_out = 0;    ///< configurations that are not drawn
  std::vector<Trace> traces;
  std::vector<Mark> marks;
  /// The forces in the joints of the only stance; empty where several are drawn or none are wanted.
  std::vector<ForceArrow> forces;
  double length_of_force = 0;  ///< the length of the arrow of the force 1
  /// The emphasised stance from moment to moment, round and round; empty where it stands still.
  std::vector<Stance> motion;
  double seconds = 0;  ///< for one round
};

/// Which configurations are drawn.
struct DrawingChoice {
  int configuration = 0;  ///< only this one, by its number; 0 for all
  bool nearest = false;   ///< only the one nearest to the request's reference
};

/// The largest number of configurations that are drawn.
inline constexpr std::size_t most_drawn = 24;

/// Solves the mechanism at its own values and draws its configurations, with the paths of the
/// outputs over the request's sweep. Where all are drawn, the one nearest to the request's
/// reference is emphasised, or else the first. Where one is drawn and forces are wanted, it has
/// those of its joints. Throws MechanismError where there is no configuration, or none of that
/// number, and as `Plan` and `sweep` do.
[[nodiscard]] Drawing drawing_of(const Mechanism& mechanism, const Request& request,
                                 const DrawingChoice& choice = {});

/// One branch of the request's sweep in motion, by its number in the sweep, or for 0 the one
/// nearest to the reference, or else the first. The motion is closed if the branch ends as it
/// begins, and otherwise goes to and fro. Throws MechanismError as `drawing_of` does, and where the
/// request has no sweep.
[[nodiscard]] Drawing moving_drawing_of(const Mechanism& mechanism, const Request& request,
                                        int branch = 0);

/// A picture 80 mm wide, in one file that needs no other. It is light or dark as the reader's
/// viewer prefers. The root's `data-x`, `data-y` and `data-scale` say how its coordinates (u, v)
/// come from the scene's: u = data-scale (x - data-x), v = data-scale (data-y - y).
[[nodiscard]] std::string drawing_svg(const Drawing& drawing);

/// A drawing for CAD in the ASCII form of DXF R12, in the scene's unit: a layer for each link of
/// each configuration, for its pins, for each output's path, and for dead centres.
[[nodiscard]] std::string drawing_dxf(const Drawing& drawing);

/// A scene file that a page can solve anew.
struct SceneText {
  std::string text;
  std::vector<std::string> settings;  ///< of parameters, as `parse_scene` takes them
};

/// The most bytes of a page: what a reader can send by mail, and a browser opens at once.
inline constexpr std::size_t most_page_bytes = 1'500'000;

/// One HTML page of `most_page_bytes` at most that needs no other file and no network: it animates
/// all branches of the request's sweep, or shows all configurations where it has none. It opens on
/// the branch with the number `chosen`, or for 0 on the one nearest to the reference, or else on
/// the first. With the text of the scene that the mechanism and the request were read from, the
/// page can solve that scene for other values of its parameters and another drawing, unless that
/// would make it too large. Throws MechanismError as `drawing_of` does, where no step of the sweep
/// has a configuration, and NoSuchConfiguration where no branch has the number.
[[nodiscard]] std::string drawing_page(const Mechanism& mechanism, const Request& request,
                                       const std::optional<SceneText>& scene = std::nullopt,
                                       int chosen = 0);

}  // namespace assur::mechanism
