// Draws histograms of a sample's outputs as SVG.
#include <algorithm>
#include <assur/text/counts.hpp>
#include <assur/text/numbers.hpp>
#include <cmath>
#include <numbers>

#include "campaign/sample_summary.hpp"
#include "campaign/svg_text.hpp"

namespace assur::generator::campaign {

namespace {

constexpr double panel_width = 420;
constexpr double panel_height = 230;
constexpr double margin = 40;
constexpr double head = 34;
constexpr std::size_t most_bars = 64;
/// Height above the panel at which the names of lines are printed.
constexpr double upper_row = 15;
constexpr double lower_row = 3;
constexpr double name_width = 66;
constexpr const char* worst_colour = "#d62728";
constexpr const char* rss_colour = "#2ca02c";
constexpr const char* normal_colour = "#08519c";

/// One coordinate: the bars, the worst case and the deviation predicted by first derivatives, and
/// the normal density with the sample's mean and deviation.
class Panel {
 public:
  Panel(const SampledOutput& output, std::size_t axis, double left, double top)
      : predicted_(output.predicted[axis]),
        statistics_(output.statistics),
        axis_(static_cast<Eigen::Index>(axis)),
        bars_(statistics_.histogram(axis).bars(most_bars)),
        left_(left + margin),
        top_(top + margin / 2),
        width_(panel_width - 2 * margin),
        height_(panel_height - 2 * margin) {
    const double worst = std::isfinite(predicted_.worst_case) ? predicted_.worst_case : 0;
    from_ = std::min(bars_.front().from - predicted_.nominal, -worst);
    to_ = std::max(bars_.back().to - predicted_.nominal, worst);
    constexpr double rounding = 1e-12;
    const double size =
        std::abs(output.predicted[0].nominal) + std::abs(output.predicted[1].nominal);
    const double farthest = std::max(statistics_.greatest()(axis_) - predicted_.nominal,
                                     predicted_.nominal - statistics_.least()(axis_));
    is_constant_ = std::max(farthest, worst) <= rounding * size;
    for (const auto& bar : bars_) {
      highest_ = std::max(highest_, density(bar));
    }
    deviation_ = std::sqrt(statistics_.covariance()(axis_, axis_));
    has_curve_ = deviation_ > (to_ - from_) * 1e-3;
    highest_ = std::max(highest_, has_curve_ ? normal_density(0) : 0);
  }

  [[nodiscard]] std::string svg(const std::string& coordinate) const {
    const double middle = left_ + width_ / 2;
    if (is_constant_) {
      return words(
          middle, top_ + height_ / 2, "middle",
          coordinate + " is " + text::short_number(predicted_.nominal, 4) + " in all samples");
    }
    std::string body;
    for (const auto& bar : bars_) {
      const double x = x_of(bar.from - predicted_.nominal);
      const double y = y_of(density(bar));
      body += rectangle(x, y, std::max(0.5, x_of(bar.to - predicted_.nominal) - x),
                        top_ + height_ - y, "#9ecae1");
    }
    body += normal_curve();
    body += line(left_, top_ + height_, left_ + width_, top_ + height_, "stroke=\"black\"");
    // Where the names of three lines would overlap, one of them serves all.
    const bool are_apart = x_of(predicted_.worst_case) - x_of(0) > name_width;
    body += mark(0, "black", "");
    const double inside = std::clamp(x_of(0), left_ + margin, left_ + width_ - margin);
    body += are_apart ? name(0, upper_row, "nominal", "black")
                      : words(inside, top_ - upper_row, "middle", "nominal, worst case");
    for (const double sign : {-1.0, 1.0}) {
      const double worst = sign * predicted_.worst_case;
      body += mark(worst, worst_colour, " stroke-width=\"1.5\"");
      if (are_apart) {
        body += name(worst, upper_row, "worst case", worst_colour);
      }
      const double rss = sign * predicted_.rss / std::numbers::sqrt3;
      body += mark(rss, rss_colour, " stroke-dasharray=\"5 3\"");
    }
    body += name(predicted_.rss / std::numbers::sqrt3, lower_row, "rss/√3", rss_colour);
    const double below = top_ + height_ + 15;
    body += words(left_, below, "middle", text::short_number(from_, 4));
    body += words(left_ + width_, below, "middle", text::short_number(to_, 4));
    return body +
           words(middle, below + 3, "middle",
                 coordinate + ", deviation from " + text::short_number(predicted_.nominal, 4));
  }

 private:
  [[nodiscard]] double x_of(double away) const {
    return left_ + width_ * (away - from_) / (to_ - from_);
  }
  [[nodiscard]] double y_of(double density) const {
    return top_ + height_ * (1 - density / (1.1 * highest_));
  }
  [[nodiscard]] double density(const mechanism::Histogram::Bar& bar) const {
    return static_cast<double>(bar.count) / static_cast<double>(statistics_.count()) /
           (bar.to - bar.from);
  }

  /// The normal density at a distance from the mean in standard deviations.
  [[nodiscard]] double normal_density(double deviations) const {
    return std::exp(-deviations * deviations / 2) / (deviation_ * std::sqrt(2 * std::numbers::pi));
  }

  [[nodiscard]] std::string mark(double away, const std::string& colour,
                                 const std::string& style) const {
    return std::isfinite(away) ? line(x_of(away), top_, x_of(away), top_ + height_,
                                      "stroke=\"" + colour + "\"" + style)
                               : "";
  }

  /// The name of a line, above its upper end.
  [[nodiscard]] std::string name(double away, double row, const std::string& text,
                                 const std::string& colour) const {
    return std::isfinite(away) ? words(x_of(away), top_ - row, "middle", text, colour) : "";
  }

  [[nodiscard]] std::string normal_curve() const {
    if (!has_curve_) {
      return "";
    }
    const double mean = statistics_.mean_shift()(axis_);
    std::string points;
    constexpr int steps = 120;
    for (int step = 0; step <= steps; ++step) {
      const double away = from_ + (to_ - from_) * step / steps;
      const double height = normal_density((away - mean) / deviation_);
      points += at(x_of(away)) + "," + at(y_of(height)) + " ";
    }
    // The name is at the right of the curve, or above it where it would leave the panel.
    constexpr double beside = 1.3;
    constexpr double distance = 12;
    const double right = x_of(mean + beside * deviation_) + distance;
    const double start = std::min(right, left_ + width_ - distance / 2 - name_width);
    const double away = from_ + (to_ - from_) * (start - left_) / width_;
    const double above_curve = y_of(normal_density((away - mean) / deviation_)) - distance / 2;
    return "<polyline fill=\"none\" stroke=\"" + std::string(normal_colour) + "\" points=\"" +
           points + "\"/>\n" + words(start, above_curve, "start", "normal law", normal_colour);
  }

  const FirstOrder& predicted_;
  const mechanism::PointStatistics& statistics_;
  Eigen::Index axis_;
  std::vector<mechanism::Histogram::Bar> bars_;
  double left_, top_, width_, height_;
  double from_ = 0, to_ = 0, highest_ = 0, deviation_ = 0;
  bool has_curve_ = false;
  bool is_constant_ = false;  ///< except for rounding
};

}  // namespace

std::string histogram_picture(const SampleSummary& summary) {
  std::string body = words(
      margin, 20, "start",
      summary.description().text_of("name") + ": " + text::with_noun(summary.count(), "sample"));
  double top = head;
  for (const SampledOutput& output : summary.outputs()) {
    for (std::size_t axis = 0; axis < output.axes(); ++axis) {
      if (output.statistics.count() > 0) {
        body += Panel(output, axis, static_cast<double>(axis) * panel_width, top)
                    .svg(output.name_of(axis));
      }
    }
    top += panel_height;
  }
  return document(2 * panel_width, top, body);
}

}  // namespace assur::generator::campaign
