// Solver of a page's scene inside the page: films for other values of its parameters.
#include <assur/mechanism/scene_file.hpp>

#include "draw/film_json.hpp"

namespace assur::mechanism::page {

namespace {

/// The most numbers of a film; more exceed the memory of a small computer.
constexpr std::size_t most_numbers = 8'000'000;

/// The page writes its query here.
std::string question;
/// The answer to the last query; the page reads it before the next one.
std::string answer;
draw::Film film;

/// The address and count of numbers.
draw::Json in_memory(const std::vector<double>& numbers) {
  return {reinterpret_cast<std::uintptr_t>(numbers.data()), numbers.size()};
}

/// The points of the scene's drawing, at the film's values of the parameters.
draw::Json drawn_places(const Scene& scene) {
  const auto value_of = [](ParameterIndex parameter) { return film.parameters[parameter.place()]; };
  draw::Json places = draw::Json::array();
  for (const DrawnPoint& point : scene.points) {
    places.push_back({{"name", point.name},
                      {"x", point.x.evaluate<double>(value_of)},
                      {"y", point.y.evaluate<double>(value_of)}});
  }
  return places;
}

draw::Json solved(const draw::Json& asked) {
  const Scene scene = parse_scene(asked.at("text"), "scene", asked.at("settings"));
  draw::Filming filming{most_numbers, 0, true, std::nullopt};
  if (asked.contains("seen")) {
    filming.seen = draw::SeenPose{asked["seen"].at("part"), asked["seen"].at("points")};
  }
  film = draw::film_of(scene.mechanism, scene.request, filming);
  draw::Json told = draw::film_json(scene.mechanism, scene.request, film, in_memory);
  told["drawing"] = drawn_places(scene);
  return told;
}

}  // namespace

extern "C" {

/// Allocates a query of `bytes` bytes: JSON in UTF-8 with the `text` of a scene file and `settings`
/// as `parse_scene` takes them, and with the last `seen` pose, if its branch is to be followed.
[[clang::export_name("question")]] char* question_of(std::size_t bytes) {
  question.resize(bytes);
  return question.data();
}

/// Answers the query with a film as JSON, whose numbers are `[address, count]`, and returns true;
/// or with a line that gives the reason for failure.
[[clang::export_name("solve")]] bool solve() {
  try {
    const draw::Json told = solved(draw::Json::parse(question));
    answer = told.dump(-1, ' ', false, draw::Json::error_handler_t::replace);
    return true;
  } catch (const std::exception& error) {
    answer = error.what();
    return false;
  }
}

[[clang::export_name("answer")]] const char* text_of_answer() { return answer.data(); }
[[clang::export_name("answer_bytes")]] std::size_t bytes_of_answer() { return answer.size(); }
}

}  // namespace assur::mechanism::page
