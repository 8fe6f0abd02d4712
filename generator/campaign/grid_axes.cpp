#include "campaign/grid_axes.hpp"

#include <sstream>

namespace assur::generator::campaign {

std::string axis_text(const NamedAxis& axis) {
  return axis.name + " " + number_text(axis.from) + " " + number_text(axis.to) + " " +
         std::to_string(axis.count);
}

std::vector<NamedAxis> axes_of(const Description& description) {
  std::vector<NamedAxis> axes;
  for (const std::string& text : description.texts_of("axis")) {
    NamedAxis axis{};
    std::istringstream(text) >> axis.name >> axis.from >> axis.to >> axis.count;
    axes.push_back(axis);
  }
  return axes;
}

}  // namespace assur::generator::campaign
