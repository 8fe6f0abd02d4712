#include "layout.hpp"

#include <algorithm>
#include <assur/mechanism/point_values.hpp>
#include <assur/variables.hpp>
#include <iterator>

namespace assur::python {

namespace {

using mechanism::Frame;
using mechanism::Point;
using mechanism::SlideState;
using mechanism::Spread;

template <typename Numbers>
void put(const Numbers& numbers, double* to) {
  for (Eigen::Index row = 0; row < numbers.rows(); ++row) {
    for (Eigen::Index column = 0; column < numbers.cols(); ++column) {
      *to++ = numbers(row, column);
    }
  }
}

std::size_t size_of(const std::vector<std::ptrdiff_t>& shape, std::ptrdiff_t parameter_count) {
  std::size_t size = 1;
  for (const std::ptrdiff_t extent : shape) {
    size *= static_cast<std::size_t>(extent == parameters ? parameter_count : extent);
  }
  return size;
}

bool is_wanted(Need need, const mechanism::Want& want, bool has_covariance) {
  switch (need) {
    case Need::position:
      return want.position;
    case Need::velocity:
      return want.velocity;
    case Need::acceleration:
      return want.acceleration;
    case Need::both_rates:
      return want.velocity && want.acceleration;
    case Need::sensitivity:
      return want.sensitivity;
    case Need::spread:
      return want.sensitivity && has_covariance;
  }
  return false;
}

template <typename Part>
Section section_of(std::vector<std::string> names, std::size_t first, const mechanism::Want& want,
                   const mechanism::Plan& plan) {
  Section section{std::move(names), first, 0, {}};
  for (const Field<Part>& field : fields<Part>()) {
    const bool wanted = is_wanted(field.need, want, plan.request().covariance.has_value());
    section.offsets.push_back(wanted ? section.width : Section::none);
    section.width +=
        wanted ? size_of(field.shape,
                         static_cast<std::ptrdiff_t>(plan.mechanism().parameters().size()))
               : 0;
  }
  return section;
}

/// Writes the part at index `place` of its section.
template <typename Part>
void write_part(const Section& section, std::size_t place, const Part& part, const Spread& spread,
                double* row) {
  double* const start = row + section.first + place * section.width;
  static const std::vector<Field<Part>>& all = fields<Part>();
  for (std::size_t field = 0; field < section.offsets.size(); ++field) {
    if (section.offsets[field] != Section::none) {
      all[field].write(part, spread, start + section.offsets[field]);
    }
  }
}

template <typename Index, typename Item>
std::vector<std::string> names_at(const text::Table<Index, Item>& table,
                                  const std::vector<Index>& places) {
  std::vector<std::string> names;
  for (const Index place : places) {
    names.push_back(table[place].name);
  }
  return names;
}

}  // namespace

// Tables of fields are never destroyed: a daemon thread may still be solving when the process ends.
template <>
const std::vector<Field<Frame>>& fields<Frame>() {
  static const auto& all = *new std::vector<Field<Frame>>{
      {"pose",
       {3},
       Need::position,
       [](const Frame& link, const Spread&, double* to) {
         put(Eigen::Vector3d(link.pose.x, link.pose.y, angle_of(link.pose.direction)), to);
       },
       "x, y of the link's origin in the scene's unit, theta in (-pi, pi]"},
      {"velocity",
       {3},
       Need::velocity,
       [](const Frame& link, const Spread&, double* to) { put(link.velocity, to); },
       "vx, vy of the link's origin, omega, per unit of time"},
      {"acceleration",
       {3},
       Need::acceleration,
       [](const Frame& link, const Spread&, double* to) { put(link.acceleration, to); },
       "ax, ay of the link's origin, alpha, per unit of time squared"},
      {"sensitivity",
       {3, parameters},
       Need::sensitivity,
       [](const Frame& link, const Spread&, double* to) { put(link.follows.first, to); },
       "derivatives of x, y, theta with respect to the parameters,\nwhile the drivers follow their "
       "laws"}};
  return all;
}

template <>
const std::vector<Field<SlideState>>& fields<SlideState>() {
  static const auto& all = *new std::vector<Field<SlideState>>{
      {"displacement",
       {},
       Need::position,
       [](const SlideState& slide, const Spread&, double* to) { *to = slide.displacement; },
       "from the first feature to the second, in the scene's unit"},
      {"velocity",
       {},
       Need::velocity,
       [](const SlideState& slide, const Spread&, double* to) { *to = slide.velocity; },
       "rate of the displacement, per unit of time"},
      {"acceleration",
       {},
       Need::acceleration,
       [](const SlideState& slide, const Spread&, double* to) { *to = slide.acceleration; },
       "second rate of the displacement, per unit of time squared"},
      {"sensitivity",
       {parameters},
       Need::sensitivity,
       [](const SlideState& slide, const Spread&, double* to) { put(slide.follows.first, to); },
       "derivatives of the displacement with respect to the parameters,\nwhile the drivers follow "
       "their laws"}};
  return all;
}

template <>
const std::vector<Field<Point>>& fields<Point>() {
  static const auto& all = *new std::vector<Field<Point>>{
      {"position",
       {2},
       Need::position,
       [](const Point& point, const Spread&, double* to) { put(point.position, to); },
       "x, y in the scene's unit"},
      {"velocity",
       {2},
       Need::velocity,
       [](const Point& point, const Spread&, double* to) { put(point.velocity, to); },
       "vx, vy, per unit of time"},
      {"acceleration",
       {2},
       Need::acceleration,
       [](const Point& point, const Spread&, double* to) { put(point.acceleration, to); },
       "ax, ay, per unit of time squared"},
      {"tangential",
       {},
       Need::both_rates,
       [](const Point& point, const Spread&, double* to) {
         *to = mechanism::path_acceleration(point).tangential;
       },
       "acceleration along the path; NaN where the point is at rest"},
      {"normal",
       {},
       Need::both_rates,
       [](const Point& point, const Spread&, double* to) {
         *to = mechanism::path_acceleration(point).normal;
       },
       "acceleration across the path, positive to its left; NaN where the point is at rest"},
      {"sensitivity",
       {2, parameters},
       Need::sensitivity,
       [](const Point& point, const Spread&, double* to) { put(point.follows.first, to); },
       "derivatives of x, y with respect to the parameters,\nwhile the drivers follow their laws"},
      {"worst_case",
       {2},
       Need::sensitivity,
       [](const Point& point, const Spread& spread, double* to) {
         put(mechanism::worst_case(point, spread), to);
       },
       "largest deviation of x and y to first order,\nthe sum of |derivative| times tolerance"},
      {"rss",
       {2},
       Need::sensitivity,
       [](const Point& point, const Spread& spread, double* to) {
         put(mechanism::root_sum_square(point, spread), to);
       },
       "root sum square for x and y, of derivative times tolerance"},
      {"covariance",
       {2, 2},
       Need::spread,
       [](const Point& point, const Spread& spread, double* to) {
         put(mechanism::spread_of(point, spread).covariance, to);
       },
       "covariance of x and y by first derivatives, in the square of the scene's unit"},
      {"mean_shift",
       {2},
       Need::spread,
       [](const Point& point, const Spread& spread, double* to) {
         put(mechanism::spread_of(point, spread).mean_shift, to);
       },
       "shift of the mean of x and y by second derivatives, in the scene's unit"},
      {"hessian",
       {2, parameters, parameters},
       Need::spread,
       [](const Point& point, const Spread&, double* to) {
         for (const Eigen::MatrixXd& second : point.follows.second) {
           put(second, to);
           to += second.size();
         }
       },
       "second derivatives of x and y with respect to the parameters,\nwhile the drivers follow "
       "their laws"}};
  return all;
}

Layout::Layout(const mechanism::Plan& plan, const mechanism::Want& want)
    : link_of(mechanism::reported_links(plan, true)),
      slide_of(mechanism::reported_slides(plan)),
      parameter_count(static_cast<std::ptrdiff_t>(plan.mechanism().parameters().size())) {
  const mechanism::Mechanism& of = plan.mechanism();
  links = section_of<Frame>(names_at(of.links(), link_of), 1, want, plan);
  slides = section_of<SlideState>(names_at(of.joints(), slide_of), links.end(), want, plan);
  outputs = section_of<Point>(text::names_of(of.outputs()), slides.end(), want, plan);
  forces.first = outputs.end();
  if (want.forces) {
    forces.columns = mechanism::force_columns(plan);
    if (mechanism::wants_force_sensitivities(plan)) {
      forces.parameters = text::names_of(of.parameters());
    }
  }
}

void Layout::write(const mechanism::Plan& plan, const mechanism::Configuration& configuration,
                   const mechanism::Spread& spread, double* row) const {
  if (!configuration.derivatives_known) {
    write(plan, mechanism::without_derivatives(plan, configuration), spread, row);
    return;
  }
  *row = configuration.residual;
  for (std::size_t place = 0; place < link_of.size(); ++place) {
    write_part(links, place, configuration.links[link_of[place]], spread, row);
  }
  for (std::size_t place = 0; place < slide_of.size(); ++place) {
    const auto slide = std::ranges::find(configuration.slides, slide_of[place], &SlideState::joint);
    if (slide != configuration.slides.end()) {
      write_part(slides, place, *slide, spread, row);
    }
  }
  std::size_t place = 0;
  for (const Point& point : configuration.outputs) {
    write_part(outputs, place++, point, spread, row);
  }
}

std::pair<std::vector<double>, std::string> Layout::forces_of(
    const mechanism::Plan& plan, const mechanism::Values& values,
    const mechanism::Configuration& configuration) const {
  const mechanism::Forces of = mechanism::forces_of(values, configuration);
  std::vector<double> numbers = mechanism::force_numbers(plan, of);
  numbers.reserve(forces.end() - forces.first);
  const auto add = [&](const mechanism::Forces& more) {
    std::ranges::copy(mechanism::force_numbers(plan, more), std::back_inserter(numbers));
  };
  if (!forces.parameters.empty()) {
    const std::vector<mechanism::Forces> all = force_sensitivities(values, configuration);
    std::ranges::for_each(all, add);
    add(mechanism::worst_case(all, values.spread()));
    add(mechanism::root_sum_square(all, values.spread()));
  }
  return {std::move(numbers), of.reason};
}

}  // namespace assur::python
