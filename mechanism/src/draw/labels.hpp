// Placement of texts beside points without overlap.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace assur::mechanism::draw {

/// An upright rectangle of a picture.
struct Box {
  Eigen::Vector2d lowest, highest;
};

/// The shapes that labels avoid.
struct Obstacles {
  Box inside;              ///< labels stay within it
  std::vector<Box> boxes;  ///< labels touch none of them
  struct Line {
    Eigen::Vector2d from, to;
    double weight;  ///< the cost of a label across it
  };
  std::vector<Line> lines;
};

/// A text beside a point.
struct Label {
  std::string text;
  Eigen::Vector2d at;  ///< the middle of its base line
};

constexpr double text_height = 10;
/// The approximate width of a text in a plain font of that height.
[[nodiscard]] double text_width(const std::string& text);

/// Places texts beside their points where they obstruct least; a text without a free place is
/// omitted.
class LabelPlacer {
 public:
  explicit LabelPlacer(Obstacles obstacles) : obstacles_(std::move(obstacles)) {}
  void place(const std::string& text, const Eigen::Vector2d& point);
  [[nodiscard]] const std::vector<Label>& labels() const { return labels_; }

 private:
  /// The cost of a place; infinite if it is occupied.
  [[nodiscard]] double cost(const Box& box) const;

  Obstacles obstacles_;
  std::vector<Label> labels_;
};

}  // namespace assur::mechanism::draw
