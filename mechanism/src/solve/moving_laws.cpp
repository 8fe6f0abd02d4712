#include "moving_laws.hpp"

#include <algorithm>
#include <assur/directions.hpp>

#include "models/series_functions.hpp"
#include "plan/plan_data.hpp"
#include "values/rates.hpp"

namespace assur::mechanism::solve {

namespace {

models::Series moving_number(const Values& values, NumberIndex index,
                             const std::function<models::Series(JointIndex)>& coordinate_of) {
  const auto in_time = [&](ParameterIndex parameter) {
    const Dual& number = values.in_time(parameter);
    models::Series moving(number.value());
    moving.c[1] = values::rate_of(number);
    moving.c[2] = values::second_rate_of(number) / 2;
    return moving;
  };
  return values.plan().mechanism.numbers()[index].formula.evaluate<models::Series>(in_time,
                                                                                   coordinate_of);
}

}  // namespace

models::Series moving_angle(const Table<LinkIndex, Pose<models::Series>>& links,
                            const Configuration& configuration, JointIndex index) {
  const Mechanism& mechanism = configuration.plan->mechanism;
  const Joint& joint = mechanism.joints()[index];
  const auto direction = [&](std::size_t place) {
    return links[mechanism.features()[joint.between[place]].link].direction;
  };
  const Direction<models::Series> between = turned(direction(1), reversed(direction(0)));
  models::Series angle = atan2(between.sin, between.cos);
  const std::vector<CountedAngle>& counted = configuration.counted;
  if (const auto known = std::ranges::find(counted, index, &CountedAngle::joint);
      known != counted.end()) {
    angle.c[0] = known->angle;
  }
  return angle;
}

LinkFeature<models::Series> moving_feature(const Values& values, FeatureIndex index, bool is_line) {
  const Frame& frame = values.frame(index);
  const auto& [cosine, sine] = frame.pose.direction;
  LinkFeature<models::Series> result{is_line, frame.pose.x, frame.pose.y, {cosine, sine}};
  if (!index.exists()) {  // a joint of a block
    return result;
  }
  const Feature& feature = values.plan().mechanism.features()[index];
  const auto move = [](const models::Series& by, models::Series& number) {
    std::copy(by.c.begin() + 1, by.c.end(), number.c.begin() + 1);
  };
  move(moving_number(values, feature.x, nullptr), result.x);
  move(moving_number(values, feature.y, nullptr), result.y);
  if (feature.is_line) {
    const Direction<models::Series> along =
        unit_direction(moving_number(values, feature.along_x, nullptr),
                       moving_number(values, feature.along_y, nullptr));
    move(along.cos, result.along.cos);
    move(along.sin, result.along.sin);
  }
  return result;
}

models::Series moving_law(const Values& values, DriverIndex index,
                          const std::function<models::Series(JointIndex)>& coordinate_of) {
  const Driver& driver = values.plan().mechanism.drivers()[index];
  models::Series law = moving_number(values, driver.position, coordinate_of);
  if (driver.velocity.exists() || driver.acceleration.exists()) {
    law.c[1] = driver.velocity.exists() ? values.number(driver.velocity).value() : law.c[1];
    law.c[2] =
        driver.acceleration.exists() ? values.number(driver.acceleration).value() / 2 : law.c[2];
    law.c[3] = law.c[4] = 0;
  }
  return law;
}

}  // namespace assur::mechanism::solve
