#include "drawing.hpp"

#include "errors.hpp"

namespace assur::python {

std::string svg_of(const mechanism::Scene& scene,
                   const std::vector<std::pair<std::string, double>>& replaced,
                   const mechanism::DrawingChoice& choice) {
  return in_scene(scene.file, [&] {
    mechanism::Mechanism mechanism = scene.mechanism;
    for (const auto& [name, value] : replaced) {
      mechanism.set_parameter(name, value);
    }
    return mechanism::drawing_svg(mechanism::drawing_of(mechanism, scene.request, choice));
  });
}

}  // namespace assur::python
