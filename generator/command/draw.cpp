// The command `assur draw`: pictures of scenes.
#include <algorithm>
#include <array>
#include <assur/mechanism/drawing.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <assur/text/input_file.hpp>
#include <assur/text/names.hpp>
#include <assur/text/quoted.hpp>
#include <assur/text/suggestion.hpp>
#include <filesystem>

#include "campaign/partial_file.hpp"
#include "command/commands.hpp"
#include "command/scene_warnings.hpp"
#include "emission/cpp/files.hpp"

namespace assur::generator::command {

namespace {

using mechanism::Scene;

/// A scene and the text that it was read from.
struct Source {
  std::string text;
  Scene scene;
};

mechanism::Drawing standing(const Scene& scene, const DrawOptions& options) {
  return drawing_of(scene.mechanism, scene.request, {options.configuration, options.nearest});
}

void expect_standing(const DrawOptions& options) {
  if (options.moving) {
    throw text::InputError(
        "--moving: only an .svg can be drawn in motion; an .html page moves by itself, a .dxf "
        "never");
  }
}

std::string svg(const Source& source, const DrawOptions& options) {
  const Scene& scene = source.scene;
  return drawing_svg(options.moving
                         ? moving_drawing_of(scene.mechanism, scene.request, options.configuration)
                         : standing(scene, options));
}

std::string dxf(const Source& source, const DrawOptions& options) {
  expect_standing(options);
  return drawing_dxf(standing(source.scene, options));
}

std::string page(const Source& source, const DrawOptions& options) {
  expect_standing(options);
  if (options.nearest) {
    throw text::InputError(
        "--nearest: a page opens on the branch nearest to the reference without it; leave it out");
  }
  return drawing_page(source.scene.mechanism, source.scene.request,
                      mechanism::SceneText{source.text, options.settings}, options.configuration);
}

/// A format of drawings, by the extension of its files.
struct Form {
  const char* extension;
  std::string (*text)(const Source&, const DrawOptions&);
};

constexpr std::array forms = {Form{".svg", svg}, Form{".html", page}, Form{".dxf", dxf}};

const Form& form_of(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  const auto* const found = std::find_if(
      forms.begin(), forms.end(), [&](const Form& form) { return form.extension == extension; });
  if (found == forms.end()) {
    std::vector<std::string> known;
    for (const Form& form : forms) {
      known.emplace_back(form.extension);
    }
    throw text::InputError(
        "--output: " + file.string() + ": " +
        (extension.empty() ? "the name has no extension"
                           : "no drawing has the extension " + text::in_quotes(extension)) +
        "; the extensions are " + text::listed(known) + text::suggestion(extension, known));
  }
  return *found;
}

}  // namespace

void draw_scene(const DrawOptions& options) {
  const std::filesystem::path file = options.output;
  const Form& form = form_of(file);
  campaign::expect_writable(file);
  campaign::expect_other(file, {options.scene});
  const std::string read = text::read_input_file(options.scene);
  const Source source = {read,
                         mechanism::parse_scene(read, options.scene, options.settings, "--set")};
  try {
    const std::string text = form.text(source, options);
    warn_of_idle_links(source.scene);
    warn_of_idle_sweep(source.scene);
    emission::cpp::write_files({{file.filename(), text}},
                               file.has_parent_path() ? file.parent_path() : ".");
  } catch (const mechanism::NoSuchConfiguration& error) {
    throw text::InputError(source.scene.file + ": --configuration: " + error.what());
  } catch (const mechanism::MechanismError& error) {
    throw text::InputError(source.scene.file + ": " + error.what());
  }
}

}  // namespace assur::generator::command
