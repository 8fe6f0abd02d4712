// Turns points with names into texts beside them that do not overlap.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace assur::mechanism::draw {

/// An upright rectangle of a picture.
struct Box {
  Eigen::Vector2d lowest, highest;
};

/// What labels keep away from.
struct Obstacles {
  Box inside;              ///< labels stay within it
  std::vector<Box> boxes;  ///< no label touches one
  struct Line {
    Eigen::Vector2d from, to;
    double weight;  ///< how bad it is to lie across it
  };
  std::vector<Line> lines;
};

/// A text beside a point.
struct Label {
  std::string text;
  Eigen::Vector2d at;  ///< the middle of its base line
};

constexpr double text_height = 10;
/// About how wide a text is in a plain font of that height.
[[nodiscard]] double text_width(const std::string& text);

/// Places texts beside their points where they are least in the way; a text without a free place is
/// left out.
class LabelPlacer {
 public:
  explicit LabelPlacer(Obstacles obstacles) : obstacles_(std::move(obstacles)) {}
  void place(const std::string& text, const Eigen::Vector2d& point);
  [[nodiscard]] const std::vector<Label>& labels() const { return labels_; }

 private:
  /// The cost of a place; infinite where it is not free.
  [[nodiscard]] double cost(const Box& box) const;

  Obstacles obstacles_;
  std::vector<Label> labels_;
};

}  // namespace assur::mechanism::draw
