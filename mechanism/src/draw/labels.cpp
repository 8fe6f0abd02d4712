#include "draw/labels.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace assur::mechanism::draw {

namespace {

/// The height of capital letters, on which a text is centred.
constexpr double letter_height = 0.72 * text_height;
constexpr double gap = 1;

bool overlap(const Box& one, const Box& other) {
  return (one.lowest.array() < other.highest.array()).all() &&
         (other.lowest.array() < one.highest.array()).all();
}

/// Whether a part of the line is inside the box, found by clipping at its four sides.
bool crosses(const Obstacles::Line& line, const Box& box) {
  double first = 0;
  double last = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const double from = line.from(axis);
    const double along = line.to(axis) - from;
    if (along == 0) {
      if (from < box.lowest(axis) || from > box.highest(axis)) {
        return false;
      }
      continue;
    }
    const double one = (box.lowest(axis) - from) / along;
    const double other = (box.highest(axis) - from) / along;
    first = std::max(first, std::min(one, other));
    last = std::min(last, std::max(one, other));
  }
  return first <= last;
}

}  // namespace

double text_width(const std::string& text) {
  const auto letters = std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;  // first byte of a letter in UTF-8
  });
  return 0.62 * text_height * static_cast<double>(letters);
}

double LabelPlacer::cost(const Box& box) const {
  const Box& inside = obstacles_.inside;
  if ((box.lowest.array() < inside.lowest.array()).any() ||
      (box.highest.array() > inside.highest.array()).any() ||
      std::any_of(obstacles_.boxes.begin(), obstacles_.boxes.end(),
                  [&](const Box& other) { return overlap(box, other); })) {
    return INFINITY;
  }
  double sum = 0;
  for (const Obstacles::Line& line : obstacles_.lines) {
    sum += crosses(line, box) ? line.weight : 0;
  }
  return sum;
}

void LabelPlacer::place(const std::string& text, const Eigen::Vector2d& point) {
  constexpr int directions = 16;
  const Eigen::Vector2d half(text_width(text) / 2, letter_height / 2);
  double least = INFINITY;
  Box best{};
  Eigen::Vector2d centre_of_best = point;
  for (const double distance : {4.5, 8.0, 12.0, 17.0}) {
    for (int direction = 0; direction < directions; ++direction) {
      // Begins to the upper right, where most people look first.
      const double angle = 2 * std::numbers::pi * (direction + 14) / directions;
      const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
      const Eigen::Vector2d centre = point + distance * along + along.cwiseProduct(half);
      const Box box{centre - half - Eigen::Vector2d::Constant(gap),
                    centre + half + Eigen::Vector2d::Constant(gap)};
      const double here = cost(box) + 0.1 * distance + 0.01 * direction;
      if (here < least) {
        least = here;
        best = box;
        centre_of_best = centre;
      }
    }
  }
  if (std::isfinite(least)) {
    obstacles_.boxes.push_back(best);
    labels_.push_back({text, centre_of_best + Eigen::Vector2d(0, letter_height / 2)});
  }
}

}  // namespace assur::mechanism::draw
