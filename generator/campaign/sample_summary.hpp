// Statistics of a sample's outputs, beside the predictions by derivatives.
#pragma once

#include <array>
#include <assur/mechanism/campaign.hpp>
#include <assur/mechanism/sample_statistics.hpp>
#include <string>
#include <vector>

#include "campaign/description.hpp"

namespace assur::generator::campaign {

/// Predictions for one coordinate from derivatives at the nominal values; NaN if unknown.
struct FirstOrder {
  double nominal, worst_case, rss;
  double variance, mean_shift;  ///< of first and second order
};

/// The two coordinates of an output, or the one number of a force.
struct SampledOutput {
  std::string name;
  bool is_point;
  std::array<FirstOrder, 2> predicted;
  double covariance;  ///< of the two coordinates, of first order
  mechanism::PointStatistics statistics;

  [[nodiscard]] std::size_t axes() const { return is_point ? 2 : 1; }
  [[nodiscard]] std::string name_of(std::size_t axis) const {
    return name + (!is_point ? "" : axis == 0 ? ".x" : ".y");
  }
};

class SampleSummary {
 public:
  /// Throws InputError, prefixed by `where`, if the description is not that of a sample.
  SampleSummary(Description description, const std::string& where);
  void add(const std::vector<double>& rows);

  [[nodiscard]] const Description& description() const { return description_; }
  [[nodiscard]] const std::vector<SampledOutput>& outputs() const { return outputs_; }
  /// The number of samples with an outcome.
  [[nodiscard]] std::uint64_t count_of(mechanism::Outcome outcome) const {
    return counts_[static_cast<std::size_t>(outcome)];
  }
  [[nodiscard]] std::uint64_t count() const;
  /// The first sample with an outcome that occurs.
  [[nodiscard]] std::uint64_t first_of(mechanism::Outcome outcome) const {
    return first_[static_cast<std::size_t>(outcome)];
  }

 private:
  Description description_;
  std::vector<SampledOutput> outputs_;
  std::array<std::uint64_t, mechanism::outcome_words.size()> counts_{}, first_{};
};

/// Adds nominal values and predictions to a sample's description; see docs/guide/campaigns.md.
void describe_nominal(const mechanism::Sampling& sampling, Description& description);

/// The summary as text and as JSON.
[[nodiscard]] std::string sample_text(const SampleSummary& summary);
[[nodiscard]] std::string sample_json(const SampleSummary& summary);
/// A histogram of each coordinate as SVG, with the predictions by derivatives.
[[nodiscard]] std::string histogram_picture(const SampleSummary& summary);

}  // namespace assur::generator::campaign
