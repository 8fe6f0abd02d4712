// Chains of rigid links drawn with pins and slides at given positions, as scenes and as bodies for
// Newton's method: the independent truth for larger groups.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <assur/mechanism/solution.hpp>
#include <cmath>
#include <complex>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "mechanism/larger_groups.hpp"

namespace assur::test {

/// Where the joints of a chain are drawn.
using Places = std::vector<std::complex<double>>;

inline Places any_places(const Chain& chain, std::mt19937& engine) {
  std::uniform_real_distribution<double> place(-4, 4);
  Places result(chain.size());
  for (std::complex<double>& one : result) {
    const double x = place(engine);
    one = {x, place(engine)};
  }
  return result;
}

/// The directions of the slides among the joints of a chain, of length one; those of pins are zero.
using Lines = std::vector<std::complex<double>>;

inline Lines any_lines(const std::vector<bool>& slides, std::mt19937& engine) {
  std::uniform_real_distribution<double> angle(-3.2, 3.2);
  Lines result;
  for (const bool is_slide : slides) {
    result.push_back(is_slide ? std::polar(1.0, angle(engine)) : 0.0);
  }
  return result;
}

inline bool have_slides(const Lines& lines) {
  return std::ranges::any_of(lines, [](const std::complex<double>& one) { return one != 0.0; });
}

/// Bars between points: joint k of a chain at point Pk.
inline nlohmann::ordered_json drawn_chain(const Chain& chain, const Places& places, int links,
                                          int ground) {
  nlohmann::ordered_json scene;
  for (std::size_t joint = 0; joint < chain.size(); ++joint) {
    scene["points"]["P" + std::to_string(joint)] = {places[joint].real(), places[joint].imag()};
  }
  for (int link = 0; link < links; ++link) {
    nlohmann::ordered_json& points =
        scene["links"][link == ground ? "ground" : "L" + std::to_string(link)];
    for (std::size_t joint = 0; joint < chain.size(); ++joint) {
      if (chain[joint].first == link || chain[joint].second == link) {
        points.push_back("P" + std::to_string(joint));
      }
    }
  }
  return scene;
}

/// The same with slides along lines through their places. Each link begins with two points of its
/// own, so that its frame is that of the drawing.
inline nlohmann::ordered_json drawn_chain(const Chain& chain, const Places& places,
                                          const Lines& lines, int links, int ground) {
  nlohmann::ordered_json scene = drawn_chain(chain, places, links, ground);
  if (!have_slides(lines)) {
    return scene;
  }
  const auto name_of = [&](int link) {
    return link == ground ? "ground" : "L" + std::to_string(link);
  };
  for (int link = 0; link < links; ++link) {
    const std::string name = name_of(link);
    scene["points"][name + " origin"] = {0, 0};
    scene["points"][name + " axis"] = {1, 0};
    nlohmann::ordered_json points = {name + " origin", name + " axis"};
    for (std::size_t joint = 0; joint < chain.size(); ++joint) {
      const bool is_here = chain[joint].first == link || chain[joint].second == link;
      if (is_here && lines[joint] == 0.0) {
        points.push_back("P" + std::to_string(joint));
      }
    }
    scene["links"][name] = std::move(points);
  }
  for (std::size_t joint = 0; joint < chain.size(); ++joint) {
    if (lines[joint] != 0.0) {
      scene["joints"]["S" + std::to_string(joint)] = {
          {"type", "prismatic"},
          {"links", {name_of(chain[joint].first), name_of(chain[joint].second)}},
          {"at", "P" + std::to_string(joint)},
          {"direction", {lines[joint].real(), lines[joint].imag()}}};
    }
  }
  return scene;
}

/// The links of a chain as rigid bodies that turn about the origin and move from their drawn poses:
/// coordinates x, y and angle of every link but the ground. It uses no groups and no loops.
class PinnedBodies {
 public:
  PinnedBodies(const Chain& chain, const Places& places, int links, int ground)
      : PinnedBodies(chain, places, Lines(chain.size(), 0), links, ground) {}
  PinnedBodies(const Chain& chain, const Places& places, Lines lines, int links, int ground)
      : chain_(chain),
        places_(places),
        lines_(std::move(lines)),
        ground_(ground),
        size_(3L * (links - 1)) {}

  [[nodiscard]] Eigen::Index size() const { return size_; }

  /// Newton's method with rotations of at most one radian a step; returns whether it converged.
  [[nodiscard]] bool assemble(Eigen::VectorXd& q) const {
    constexpr int most_steps = 60;
    Eigen::MatrixXd jacobian(size_, size_);
    for (int step = 0; step < most_steps; ++step) {
      const Eigen::VectorXd f = gaps(q, &jacobian);
      const Eigen::VectorXd by = jacobian.partialPivLu().solve(-f);
      if (!by.allFinite()) {
        return false;
      }
      const double length = by.cwiseAbs().maxCoeff();
      q += by / std::max(1.0, length);
      if (length < 1e-11) {
        return true;
      }
    }
    return false;
  }

  /// The largest gap at a joint.
  [[nodiscard]] double gap(const Eigen::VectorXd& q) const {
    return gaps(q, nullptr).cwiseAbs().maxCoeff();
  }

  /// The gaps at the joints, and on request their derivatives: x and y of a pin; for a slide the
  /// distance of its point on the second link from the line on the first one, and twice the sine of
  /// half the angle between the links.
  [[nodiscard]] Eigen::VectorXd gaps(const Eigen::VectorXd& q, Eigen::MatrixXd* jacobian) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(size_);
    if (jacobian != nullptr) {
      jacobian->setZero();
    }
    for (std::size_t joint = 0; joint < chain_.size(); ++joint) {
      const auto row = 2 * static_cast<Eigen::Index>(joint);
      if (lines_[joint] != 0.0) {
        put_slide(joint, q, result, jacobian);
        continue;
      }
      for (const auto& [link, sign] :
           {std::pair{chain_[joint].first, 1.0}, {chain_[joint].second, -1.0}}) {
        if (link == ground_) {
          result(row) += sign * places_[joint].real();
          result(row + 1) += sign * places_[joint].imag();
          continue;
        }
        const Eigen::Index first = first_of(link);
        const Complex arm = std::polar(1.0, q(first + 2)) * places_[joint];
        result(row) += sign * (q(first) + arm.real());
        result(row + 1) += sign * (q(first + 1) + arm.imag());
        if (jacobian != nullptr) {
          (*jacobian)(row, first) = (*jacobian)(row + 1, first + 1) = sign;
          (*jacobian)(row, first + 2) = -sign * arm.imag();
          (*jacobian)(row + 1, first + 2) = sign * arm.real();
        }
      }
    }
    return result;
  }

  /// The coordinates in a configuration: the frame of a link that is given by points has its origin
  /// at the first one, and its x-axis leads to the second one.
  [[nodiscard]] Eigen::VectorXd coordinates(const mechanism::Configuration& configuration) const {
    Eigen::VectorXd q(size_);
    const bool has_slides = have_slides(lines_);
    for (int link = 0; link < static_cast<int>(size_ / 3) + 1; ++link) {
      if (link == ground_) {
        continue;
      }
      const Pose<double>& pose = configuration.link("L" + std::to_string(link)).pose;
      if (has_slides) {
        q.segment<3>(first_of(link)) << pose.x, pose.y,
            std::atan2(pose.direction.sin, pose.direction.cos);
        continue;
      }
      std::vector<Complex> points;
      for (std::size_t joint = 0; joint < chain_.size(); ++joint) {
        if (chain_[joint].first == link || chain_[joint].second == link) {
          points.push_back(places_[joint]);
        }
      }
      const Complex axis = (points[1] - points[0]) / std::abs(points[1] - points[0]);
      const Complex turn = Complex(pose.direction.cos, pose.direction.sin) / axis;
      const Complex at = Complex(pose.x, pose.y) - turn * points[0];
      q.segment<3>(first_of(link)) << at.real(), at.imag(), std::arg(turn);
    }
    return q;
  }

 private:
  using Complex = std::complex<double>;

  [[nodiscard]] Eigen::Index first_of(int link) const {
    return 3L * (link - (link > ground_ ? 1 : 0));
  }

  void put_slide(std::size_t joint, const Eigen::VectorXd& q, Eigen::VectorXd& result,
                 Eigen::MatrixXd* jacobian) const {
    const Complex i(0, 1);
    const auto row = 2 * static_cast<Eigen::Index>(joint);
    const auto [first, second] = chain_[joint];
    const auto angle_of = [&](int link) { return link == ground_ ? 0 : q(first_of(link) + 2); };
    const auto arm_of = [&](int link) { return std::polar(1.0, angle_of(link)) * places_[joint]; };
    const auto place_of = [&](int link) {
      return link == ground_ ? arm_of(link)
                             : Complex(q(first_of(link)), q(first_of(link) + 1)) + arm_of(link);
    };
    const Complex along = std::polar(1.0, angle_of(first)) * lines_[joint];
    const Complex by = place_of(second) - place_of(first);
    const double half = (angle_of(first) - angle_of(second)) / 2;
    const auto across = [&](const Complex& of) { return (std::conj(along) * of).imag(); };
    result(row) = across(by);
    result(row + 1) = 2 * std::sin(half);
    for (const auto& [link, sign] : {std::pair{first, -1.0}, {second, 1.0}}) {
      if (jacobian != nullptr && link != ground_) {
        const Eigen::Index column = first_of(link);
        (*jacobian)(row, column) = sign * across(1);
        (*jacobian)(row, column + 1) = sign * across(i);
        (*jacobian)(row, column + 2) =
            sign * across(i * arm_of(link)) - (link == first ? across(i * by) : 0);
        (*jacobian)(row + 1, column + 2) = -sign * std::cos(half);
      }
    }
  }

  const Chain& chain_;
  const Places& places_;
  Lines lines_;
  int ground_;
  Eigen::Index size_;
};

/// The largest difference of coordinates, of angles modulo a turn.
inline double distance_of(const Eigen::VectorXd& one, const Eigen::VectorXd& other) {
  double result = 0;
  for (Eigen::Index place = 0; place < one.size(); ++place) {
    const double difference = one(place) - other(place);
    result =
        std::max(result, place % 3 == 2 ? std::abs(std::remainder(difference, 2 * std::acos(-1)))
                                        : std::abs(difference));
  }
  return result;
}

}  // namespace assur::test
