// Tracking by SolveSpace's constraint solver: points C, G, D, F at given distances, as a sketch.
// slvs.h needs memset and does not include it.
// clang-format off
#include <cstring>
#include <slvs.h>
// clang-format on

#include "tracking/tracking_methods.hpp"

namespace assur::speed {

namespace {

constexpr Slvs_hGroup fixed_group = 1;
constexpr Slvs_hGroup free_group = 2;
constexpr Slvs_hEntity origin = 101;
constexpr Slvs_hEntity normal = 102;
constexpr Slvs_hEntity plane = 200;

/// A sketch of the points B, E (fixed), C, G, D and F.
class Sketch {
 public:
  Sketch() {
    for (int parameter = 0; parameter < 3; ++parameter) {
      add_parameter(fixed_group, 0);
    }
    double w = 1;
    double x = 0;
    double y = 0;
    double z = 0;
    Slvs_MakeQuaternion(1, 0, 0, 0, 1, 0, &w, &x, &y, &z);
    for (const double value : {w, x, y, z}) {
      add_parameter(fixed_group, value);
    }
    entities_[entity_count_++] = Slvs_MakePoint3d(origin, fixed_group, 1, 2, 3);
    entities_[entity_count_++] = Slvs_MakeNormal3d(normal, fixed_group, 4, 5, 6, 7);
    entities_[entity_count_++] = Slvs_MakeWorkplane(plane, fixed_group, origin, normal);
  }

  Slvs_hEntity add_point(Slvs_hGroup group, const Eigen::Vector2d& at) {
    add_parameter(group, at.x());
    add_parameter(group, at.y());
    const Slvs_hEntity point = 300 + static_cast<Slvs_hEntity>(entity_count_);
    const auto last = static_cast<Slvs_hParam>(parameter_count_);
    entities_[entity_count_++] = Slvs_MakePoint2d(point, group, plane, last - 1, last);
    return point;
  }
  void add_distance(Slvs_hEntity a, Slvs_hEntity b, double distance) {
    const auto number = static_cast<Slvs_hConstraint>(constraint_count_ + 1);
    constraints_[constraint_count_++] = Slvs_MakeConstraint(
        number, free_group, SLVS_C_PT_PT_DISTANCE, plane, std::abs(distance), a, b, 0, 0);
  }
  [[nodiscard]] bool solve() {
    Slvs_System system{};
    system.param = parameters_.data();
    system.params = static_cast<int>(parameter_count_);
    system.entity = entities_.data();
    system.entities = static_cast<int>(entity_count_);
    system.constraint = constraints_.data();
    system.constraints = static_cast<int>(constraint_count_);
    Slvs_Solve(&system, free_group);
    return system.result == SLVS_RESULT_OKAY;
  }
  /// The position of the n-th point, in the order in which the points were added.
  [[nodiscard]] Eigen::Vector2d place(std::size_t number) const {
    return {parameters_[7 + 2 * number].val, parameters_[8 + 2 * number].val};
  }

 private:
  void add_parameter(Slvs_hGroup group, double value) {
    const auto number = static_cast<Slvs_hParam>(parameter_count_ + 1);
    parameters_[parameter_count_++] = Slvs_MakeParam(number, group, value);
  }

  std::array<Slvs_Param, 32> parameters_{};
  std::array<Slvs_Entity, 16> entities_{};
  std::array<Slvs_Constraint, 16> constraints_{};
  std::size_t parameter_count_ = 0;
  std::size_t entity_count_ = 0;
  std::size_t constraint_count_ = 0;
};

Direction<double> along(const Eigen::Vector2d& vector, double length) {
  return {vector.x() / length, vector.y() / length};
}

}  // namespace

TrackingAnswer track_by_solvespace(const TrackingSample& sample) {
  const auto& d = sample.d;
  const auto u = sample.at(sample.to).u;
  const auto& q = sample.start.q;
  const auto turned_by = [](const Direction<double>& direction, double x, double y) {
    return Eigen::Vector2d(direction.cos * x - direction.sin * y,
                           direction.sin * x + direction.cos * y);
  };
  const Eigen::Vector2d B(u.x_B, u.y_B);
  const Eigen::Vector2d E(u.x_E, u.y_E);
  Sketch sketch;
  const Slvs_hEntity b = sketch.add_point(fixed_group, B);
  const Slvs_hEntity e = sketch.add_point(fixed_group, E);
  const Slvs_hEntity c = sketch.add_point(free_group, B + turned_by(q.theta_BCG, d.BC, 0));
  const Slvs_hEntity g =
      sketch.add_point(free_group, B + turned_by(q.theta_BCG, d.x_G_BCG, d.y_G_BCG));
  const Slvs_hEntity at_d = sketch.add_point(free_group, E + turned_by(q.theta_EDF, d.ED, 0));
  const Slvs_hEntity f =
      sketch.add_point(free_group, E + turned_by(q.theta_EDF, d.x_F_EDF, d.y_F_EDF));
  sketch.add_distance(b, c, d.BC);
  sketch.add_distance(b, g, std::hypot(d.x_G_BCG, d.y_G_BCG));
  sketch.add_distance(c, g, std::hypot(d.x_G_BCG - d.BC, d.y_G_BCG));
  sketch.add_distance(e, at_d, d.ED);
  sketch.add_distance(e, f, std::hypot(d.x_F_EDF, d.y_F_EDF));
  sketch.add_distance(at_d, f, std::hypot(d.x_F_EDF - d.ED, d.y_F_EDF));
  sketch.add_distance(c, at_d, d.CD);
  sketch.add_distance(g, f, d.GF);
  if (!sketch.solve()) {
    return {true, {}};
  }
  const Eigen::Vector2d C = sketch.place(2);
  const Eigen::Vector2d G = sketch.place(3);
  const Eigen::Vector2d D = sketch.place(4);
  const Eigen::Vector2d F = sketch.place(5);
  return {false, {along(C - B, d.BC), along(D - E, d.ED), along(D - C, d.CD), along(F - G, d.GF)}};
}

}  // namespace assur::speed
