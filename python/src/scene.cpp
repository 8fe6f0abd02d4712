// Scenes from files, text, dictionaries and other programs' formats, and their pictures.
#include <pybind11/stl.h>

#include <assur/mechanism/imported_scene.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <assur/text/input_file.hpp>
#include <filesystem>

#include "bindings.hpp"
#include "drawing.hpp"
#include "given.hpp"
#include "long_call.hpp"
#include "names.hpp"
#include "plan.hpp"

namespace assur::python {

using Scene = ReadScene;

SharedScene scene_of(const std::string& text, const std::string& file,
                     const std::vector<std::string>& settings) {
  return std::make_shared<Scene>(
      Scene{mechanism::parse_scene(text, file, settings), {text, settings}});
}

namespace {

/// A file name of any type that `open` accepts, with the same errors.
std::filesystem::path path_given(const py::object& path) {
  PyObject* bytes = nullptr;
  if (PyUnicode_FSConverter(path.ptr(), &bytes) == 0) {
    throw py::error_already_set();
  }
  return {std::string(py::reinterpret_steal<py::bytes>(bytes))};
}

SharedScene read(const py::object& path, const py::object& values, const py::kwargs& keywords) {
  const std::filesystem::path file = path_given(path);
  const std::vector<std::string> settings = settings_of(given(values, keywords));
  const OthersRun others_run;
  return scene_of(text::read_input_file(file), file.string(), settings);
}

/// The JSON text of a dictionary, which may contain NumPy numbers and arrays.
std::string json_text_of(const py::object& scene) {
  if (PyUnicode_Check(scene.ptr()) != 0) {
    return utf8_of(scene, "scene: what is parsed");
  }
  const py::cpp_function plain([](const py::object& value) -> py::object {
    if (!py::hasattr(value, "tolist")) {
      throw ShapeError("scene: expected numbers, texts, lists and dictionaries, not " +
                       py::cast<std::string>(py::type::of(value).attr("__name__")));
    }
    return value.attr("tolist")();
  });
  try {
    return py::cast<std::string>(
        py::module_::import("json").attr("dumps")(scene, py::arg("default") = plain));
  } catch (const py::error_already_set& error) {
    if (!error.matches(PyExc_ValueError) && !error.matches(PyExc_TypeError) &&
        !error.matches(PyExc_RecursionError)) {
      throw;
    }
    throw ShapeError("scene: " + py::cast<std::string>(py::str(error.value())));
  }
}

SharedScene parse(const py::object& scene, const py::object& values, const py::kwargs& keywords) {
  const std::vector<std::string> settings = settings_of(given(values, keywords));
  const std::string text = json_text_of(scene);
  const OthersRun others_run;
  return scene_of(text, "scene", settings);
}

std::string svg_of_scene(const Scene& scene, const py::object& configuration,
                         const py::object& nearest) {
  const int number = place_number(configuration, "configuration");
  const bool is_nearest = truth(nearest, "nearest");
  const OthersRun others_run;
  return svg_of(scene, {}, {number, is_nearest});
}

std::string moving_svg(const Scene& scene, const py::object& branch) {
  const int number = place_number(branch, "branch");
  const OthersRun others_run;
  return in_scene(scene.file, [&] {
    return mechanism::drawing_svg(
        mechanism::moving_drawing_of(scene.mechanism, scene.request, number));
  });
}

std::string dxf(const Scene& scene, const py::object& configuration, const py::object& nearest) {
  const int number = place_number(configuration, "configuration");
  const bool is_nearest = truth(nearest, "nearest");
  const OthersRun others_run;
  return in_scene(scene.file, [&] {
    return mechanism::drawing_dxf(
        mechanism::drawing_of(scene.mechanism, scene.request, {number, is_nearest}));
  });
}

std::string page(const Scene& scene, const py::object& branch) {
  const int number = place_number(branch, "branch");
  const OthersRun others_run;
  return in_scene(scene.file, [&] {
    return mechanism::drawing_page(scene.mechanism, scene.request, scene.source, number);
  });
}

/// The scene in another program's file, or in a text that the program shares.
mechanism::ImportedScene import_scene(const py::object& source, const std::string& driver) {
  if (PyUnicode_Check(source.ptr()) != 0) {
    const std::string text = utf8_of(source, "source: what is imported");
    if (mechanism::is_shared_mechanism(text)) {
      const OthersRun others_run;
      return mechanism::import_scene(text, "the link", driver);
    }
  }
  const std::filesystem::path file = path_given(source);
  const OthersRun others_run;
  return mechanism::import_scene(text::read_input_file(file), file.string(), driver);
}

/// None if there is no picture: a notebook then shows the text.
py::object picture_of_scene(const Scene& scene) {
  try {
    return py::str(svg_of_scene(scene, py::int_(0), py::bool_(false)));
  } catch (const text::InputError&) {
    return py::none();
  }
}

std::vector<std::string> driven_joints(const Scene& scene) {
  std::vector<std::string> names;
  for (const mechanism::Driver& driver : scene.mechanism.drivers()) {
    names.push_back(scene.mechanism.joints()[driver.joint].name);
  }
  return names;
}

}  // namespace

void bind_scene(py::module_& module) {
  py::class_<Scene, SharedScene>(
      module, "Scene",
      "A mechanism and what is wanted of it, which read_scene or parse_scene returns. It is\n"
      "immutable.")
      .def_property_readonly(
          "file", [](const Scene& scene) { return scene.file; },
          "str: the name of its file, with which errors begin.")
      .def_property_readonly(
          "name", [](const Scene& scene) { return scene.mechanism.name(); }, "str: its name.")
      .def_property_readonly(
          "unit", [](const Scene& scene) { return scene.mechanism.unit(); },
          "str: the name of its unit of length; empty if the scene does not give one.")
      .def_property_readonly(
          "parameters",
          [](const Scene& scene) { return tuple_of(text::names_of(scene.mechanism.parameters())); },
          "tuple of str: the names of its parameters, in the order of sensitivities.")
      .def_property_readonly(
          "links",
          [](const Scene& scene) { return tuple_of(text::names_of(scene.mechanism.links())); },
          "tuple of str: the names of its links.")
      .def_property_readonly(
          "joints",
          [](const Scene& scene) { return tuple_of(text::names_of(scene.mechanism.joints())); },
          "tuple of str: the names of its joints.")
      .def_property_readonly(
          "drivers", [](const Scene& scene) { return tuple_of(driven_joints(scene)); },
          "tuple of str: the names of the joints that have drivers.")
      .def_property_readonly(
          "outputs",
          [](const Scene& scene) { return tuple_of(text::names_of(scene.mechanism.outputs())); },
          "tuple of str: the names of its outputs.")
      .def("svg", svg_of_scene, py::arg("configuration") = 0, py::arg("nearest") = false,
           "svg(self, configuration=0, nearest=False)\n--\n\n"
           "Returns a picture, 80 mm wide, as the text of an SVG file: of all configurations, of "
           "the\n"
           "one with a number, or of the one nearest to the scene's reference.\n\n"
           "Raises SceneError where there is no such configuration.")
      .def(
          "moving_svg", moving_svg, py::arg("branch") = 0,
          "moving_svg(self, branch=0)\n--\n\n"
          "Returns a moving picture, as the text of an SVG file, of one branch of the scene's "
          "sweep:\n"
          "the one with a number, or for 0 the one nearest to the reference, or else the first.\n\n"
          "Raises SceneError where the scene has no sweep or no such branch.")
      .def("dxf", dxf, py::arg("configuration") = 0, py::arg("nearest") = false,
           "dxf(self, configuration=0, nearest=False)\n--\n\n"
           "Returns a drawing for CAD as the text of a DXF file, in the scene's unit. Arguments "
           "and\n"
           "errors are those of svg.")
      .def("page", page, py::arg("branch") = 0,
           "page(self, branch=0)\n--\n\n"
           "Returns the text of an HTML page that needs no other file and animates the scene's "
           "sweep.\n"
           "It opens on the branch, or without a sweep the configuration, with a number; for 0 on "
           "the one\n"
           "nearest to the reference, or else on the first.\n\n"
           "Raises SceneError where no step of the sweep has a configuration, or there is no such "
           "branch.")
      .def("_repr_svg_", picture_of_scene)
      .def(py::pickle(
          [](const Scene& scene) {
            return py::make_tuple(scene.source.text, scene.file, scene.source.settings);
          },
          [](const py::tuple& state) {
            return scene_of(state[0].cast<std::string>(), state[1].cast<std::string>(),
                            state[2].cast<std::vector<std::string>>());
          }))
      .def("__repr__", [](const Scene& scene) {
        return "<assur.Scene " + scene.file +
               (scene.mechanism.name().empty() ? "" : ": " + scene.mechanism.name()) + ">";
      });
  module.def(
      "read_scene", read, ByPlace("file "), ByPlace("values ") = py::none(), py::pos_only(),
      "read_scene(file, values=None, /, **parameters)\n--\n\n"
      "Returns the Scene in a JSON file.\n\n"
      "values, and keywords: numbers or texts of expressions for parameters, by their names, in\n"
      "place of those in the file. A keyword overrides the mapping.\n\n"
      "Raises SceneError with the file, the place in it, what is wrong, and the remedy.");
  module.def(
      "parse_scene", parse, ByPlace("scene "), ByPlace("values ") = py::none(), py::pos_only(),
      "parse_scene(scene, values=None, /, **parameters)\n--\n\n"
      "Returns the Scene in a JSON text, or in a dictionary of the same form, which may contain\n"
      "numbers and arrays of NumPy. values, keywords and errors: see read_scene.");
  py::class_<mechanism::ImportedScene>(module, "ImportedScene",
                                       "A scene made of another program's file, by import_scene.")
      .def_readonly("text", &mechanism::ImportedScene::text,
                    "str: what a scene file holds, for parse_scene.")
      .def_property_readonly(
          "remarks", [](const mechanism::ImportedScene& scene) { return tuple_of(scene.remarks); },
          "tuple of str: a line for each thing that the scene does not say.")
      .def_readonly("complete", &mechanism::ImportedScene::complete,
                    "bool: whether all that holds or drives the mechanism is in the scene.");
  module.def("import_scene", import_scene, ByPlace("source "), py::arg("driver") = "",
             "import_scene(source, /, driver='')\n--\n\n"
             "Returns the ImportedScene of a .linkage2 file of Linkage, a link that PMKS+ shares, "
             "or an\n"
             "expression of Pyslvs: in a file, or in a text in place of its name. driver: for an\n"
             "expression, the point of the driven joint, such as 'P0'.\n\n"
             "Raises SceneError with one line where it cannot be read.");
  module.def("scene_schema", mechanism::scene_schema,
             "scene_schema()\n--\n\nReturns the JSON Schema of scenes, as text.");
}

}  // namespace assur::python
