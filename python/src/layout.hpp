// The layout of a row: the numbers of one configuration and their offsets, from a plan.
#pragma once

#include <array>
#include <assur/mechanism/force_columns.hpp>
#include <assur/mechanism/reported_parts.hpp>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace assur::python {

/// Stands for an extent equal to the number of the mechanism's parameters.
inline constexpr std::ptrdiff_t parameters = -1;

/// The request in a scene that puts a field in the row.
enum class Need : unsigned char {
  position,
  velocity,
  acceleration,
  both_rates,
  sensitivity,
  spread
};

/// Numbers of a link, a slide or an output, in a row-major array.
template <typename Part>
struct Field {
  const char* name;
  std::vector<std::ptrdiff_t> shape;
  Need need;
  void (*write)(const Part& part, const mechanism::Spread& spread, double* numbers);
  const char* meaning;  ///< for the docstring
};

/// All fields of a part: mechanism::Frame, mechanism::SlideState or mechanism::Point.
template <typename Part>
[[nodiscard]] const std::vector<Field<Part>>& fields();

/// The section of a row with the parts of one kind, consecutive and of equal layout.
struct Section {
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  std::vector<std::string> names;    ///< of the parts
  std::size_t first = 0, width = 0;  ///< offset of the first part; size of each part
  std::vector<std::size_t> offsets;  ///< of each field in a part; `none` if it is not requested

  [[nodiscard]] std::size_t end() const { return first + names.size() * width; }
};

/// The section of a row with forces: the numbers of the columns, then, if sensitivities are
/// requested, their derivatives with respect to each parameter, their worst case and their rss.
struct ForceSection {
  std::vector<mechanism::ForceColumn> columns;  ///< empty if no forces are requested
  std::vector<std::string> parameters;          ///< of the derivatives; empty if not requested
  std::size_t first = 0;

  /// The offset of the numbers (block 0), of the derivatives with respect to parameter number
  /// `block`, from 1, or, after these, of worst case and rss.
  [[nodiscard]] std::size_t block(std::size_t block) const {
    return first + block * columns.size();
  }
  [[nodiscard]] std::size_t end() const {
    return block(parameters.empty() ? 1 : parameters.size() + 3);
  }
};

/// A row: the residual, then links, slides, outputs and forces.
struct Layout {
  Layout(const mechanism::Plan& plan, const mechanism::Want& want);

  [[nodiscard]] std::size_t width() const { return forces.end(); }
  template <typename Part>
  [[nodiscard]] const Section& section() const;
  /// Writes the numbers of a configuration except its forces; unknown ones are NaN.
  void write(const mechanism::Plan& plan, const mechanism::Configuration& configuration,
             const mechanism::Spread& spread, double* row) const;
  /// The numbers of the section of forces, and the reason if some are NaN. Throws MechanismError
  /// for a load that has no value.
  [[nodiscard]] std::pair<std::vector<double>, std::string> forces_of(
      const mechanism::Plan& plan, const mechanism::Values& values,
      const mechanism::Configuration& configuration) const;

  std::vector<mechanism::LinkIndex> link_of;    ///< in the order of the section
  std::vector<mechanism::JointIndex> slide_of;  ///< in the order of its section
  Section links, slides, outputs;
  ForceSection forces;
  std::ptrdiff_t parameter_count;
};

template <>
inline const Section& Layout::section<mechanism::Frame>() const {
  return links;
}
template <>
inline const Section& Layout::section<mechanism::SlideState>() const {
  return slides;
}
template <>
inline const Section& Layout::section<mechanism::Point>() const {
  return outputs;
}

}  // namespace assur::python
