#include "models/tied_closures.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace assur::mechanism::models {

namespace {

using Vector2 = Eigen::Vector2d;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A longer displacement counts as infinite, as in rigid groups.
constexpr double farthest_displacement = 0x1p24;
/// Along a direction that slides reach by less than this, closing a gap may need a displacement
/// that long.
constexpr double weak = 0x1p-20;

/// The parts of the closures along some directions that slides do not reach: turning e + fixed.
struct UnreachedParts {
  SmallMatrix turning;
  SmallVector fixed;

  [[nodiscard]] SmallVector at(const Vector2& e) const { return turning * e + fixed; }
};

[[nodiscard]] Vector2 turned_by(double angle, const Vector2& e) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * e.x() - s * e.y(), s * e.x() + c * e.y()};
}

/// Turns a direction by Gauss-Newton steps to a nearby minimum of the parts.
[[nodiscard]] Vector2 settled(const UnreachedParts& parts, Vector2 e) {
  constexpr int most_steps = 60;
  constexpr int most_halvings = 6;
  SmallVector unreached = parts.at(e);
  for (int step = 0; step < most_steps; ++step) {
    const SmallVector slope = parts.turning * Vector2(-e.y(), e.x());
    const double square = slope.squaredNorm();
    double by = square > 0 ? -slope.dot(unreached) / square : 0;
    bool gains = false;
    for (int halving = 0; halving < most_halvings && by != 0 && !gains; ++halving, by /= 2) {
      const Vector2 next = turned_by(std::clamp(by, -1.0, 1.0), e).normalized();
      const SmallVector there = parts.at(next);
      gains = there.norm() < unreached.norm();
      if (gains) {
        e = next;
        unreached = there;
      }
    }
    if (!gains) {
      break;
    }
  }
  return e;
}

/// The directions at which the parts may vanish, or are least. If they have a double zero, steps
/// would end beside it, so that the directions by formula come first.
[[nodiscard]] std::vector<Vector2> likely_directions(const UnreachedParts& parts) {
  std::vector<Vector2> result;
  const Eigen::JacobiSVD<SmallMatrix> factors(parts.turning,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  const auto add = [&](double x, double y) {
    const Vector2 e(factors.matrixV().col(0) * x + factors.matrixV().col(1) * y);
    result.push_back(settled(parts, e.normalized()));
  };
  const SmallVector seen = factors.matrixU().transpose() * parts.fixed;
  Vector2 wanted = Vector2::Zero();
  for (Eigen::Index place = 0; place < factors.singularValues().size(); ++place) {
    const double value = factors.singularValues()(place);
    wanted(place) = value > 0 ? -seen(place) / value : 0;
    const double part = std::clamp(wanted(place), -1.0, 1.0);
    const double other = std::sqrt((1 - part) * (1 + part));
    for (const double side : {other, -other}) {
      place == 0 ? add(part, side) : add(side, part);
    }
  }
  if (wanted.allFinite() && wanted.norm() > 0) {
    add(wanted.normalized().x(), wanted.normalized().y());
  }
  constexpr int samples = 16;
  for (int sample = 0; sample < samples; ++sample) {
    const double angle = 2 * std::numbers::pi * (sample + 0.3) / samples;
    add(std::cos(angle), std::sin(angle));
  }
  return result;
}

class TiedSearch {
 public:
  explicit TiedSearch(const TiedClosures& closures)
      : closures_(closures),
        factors_(closures.slides, Eigen::ComputeFullU | Eigen::ComputeFullV),
        rank_(rank_above(8 * (4 * epsilon + closures.turned))),
        unreached_(parts_beyond(rank_)) {}

  [[nodiscard]] TiedVerdict run() const {
    TiedVerdict result;
    // Directions that slides reach weakly count as unreached at first: only tiny gaps can be closed
    // along them.
    const UnreachedParts unreached = parts_beyond(rank_above(weak));
    result.miss = std::numeric_limits<double>::infinity();
    for (const UnreachedParts& parts : {unreached, unreached_}) {
      for (const Vector2& e : directions(parts)) {
        result.miss = std::min(result.miss, unreached.at(e).norm());
        result.closes = result.closes || closes(e);
      }
    }
    if (result.closes) {
      result.mobility = static_cast<int>(closures_.slides.cols()) - rank_ + (is_free() ? 1 : 0);
    }
    return result;
  }

 private:
  [[nodiscard]] int rank_above(double threshold) const {
    return static_cast<int>((factors_.singularValues().array() > threshold).count());
  }

  [[nodiscard]] UnreachedParts parts_beyond(int rank) const {
    const SmallMatrix across = factors_.matrixU().rightCols(closures_.slides.rows() - rank);
    return {across.transpose() * closures_.turning, across.transpose() * closures_.fixed};
  }

  [[nodiscard]] std::vector<Vector2> directions(const UnreachedParts& parts) const {
    return closures_.turns && parts.fixed.size() > 0 ? likely_directions(parts)
                                                     : std::vector<Vector2>{Vector2(1, 0)};
  }

  /// The norm of the least displacements that close the directions that slides reach.
  [[nodiscard]] double displacements(const Vector2& e) const {
    const SmallVector open = closures_.turning * e + closures_.fixed;
    const SmallVector reached = factors_.matrixU().leftCols(rank_).transpose() * open;
    return reached.cwiseQuotient(factors_.singularValues().head(rank_)).norm();
  }

  /// The rounding error of the closures for slides of this length.
  [[nodiscard]] double rounding(double displacement) const {
    return 32 * epsilon * (1 + closures_.farthest + displacement) + 4 * closures_.displaced +
           4 * closures_.turned * (1 + displacement);
  }

  [[nodiscard]] bool closes(const Vector2& e) const {
    const double displacement = displacements(e);
    return displacement < farthest_displacement &&
           unreached_.at(e).norm() <= rounding(displacement);
  }

  /// Whether the closures hold at any angle.
  [[nodiscard]] bool is_free() const {
    return closures_.turns && unreached_.turning.norm() + unreached_.fixed.norm() <= rounding(1);
  }

  const TiedClosures& closures_;
  Eigen::JacobiSVD<SmallMatrix> factors_;
  int rank_;
  UnreachedParts unreached_;
};

}  // namespace

TiedVerdict verdict_on(const TiedClosures& closures) { return TiedSearch(closures).run(); }

}  // namespace assur::mechanism::models
