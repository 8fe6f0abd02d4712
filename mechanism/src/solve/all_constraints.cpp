#include "all_constraints.hpp"

#include <algorithm>
#include <assur/directions.hpp>
#include <assur/support/redundant.hpp>
#include <assur/support/rigid_motion.hpp>
#include <cmath>

#include "plan/plan_data.hpp"
#include "relative_frames.hpp"

namespace assur::mechanism::solve {

Table<LinkIndex, Pose<double>> poses_of(const Table<LinkIndex, Frame>& links) {
  Table<LinkIndex, Pose<double>> poses;
  for (const Frame& link : links) {
    poses.add(link.pose);
  }
  return poses;
}

namespace {

/// Replaces the pairs of a pin of several links by pairs with the link that is placed first, so
/// that the rows of a group hold its unknowns and those of earlier groups only.
void pair_with_first_placed(const Mechanism& mechanism,
                            const Table<LinkIndex, std::size_t>& groups_before,
                            std::vector<HeldPair>& pairs) {
  const auto place_of = [&](FeatureIndex feature) {
    return groups_before[mechanism.features()[feature].link];
  };
  const auto is_pin = [](const HeldPair& pair) {
    return pair.holds == std::array{true, true, false} && !pair.driver.exists();
  };
  for (auto pair = pairs.begin(); pair != pairs.end();) {
    const auto end = std::find_if(pair, pairs.end(), [&](const HeldPair& other) {
      return other.first != pair->first || !is_pin(other);
    });
    if (end == pair) {
      ++pair;
      continue;
    }
    const auto earliest =
        std::min_element(pair, end, [&](const HeldPair& one, const HeldPair& other) {
          return place_of(one.second) < place_of(other.second);
        });
    if (place_of(earliest->second) < place_of(earliest->first)) {
      const FeatureIndex centre = earliest->second;
      earliest->second = earliest->first;
      std::for_each(pair, end, [&](HeldPair& own) { own.first = centre; });
    }
    pair = end;
  }
}

}  // namespace

AllConstraints::AllConstraints(const Values& values)
    : AllConstraints(values, values.plan().redundant) {}

AllConstraints::AllConstraints(const Values& values, const std::vector<RedundantJoint>& left_out)
    : values_(values),
      mechanism_(values.plan().mechanism),
      pairs_(held_pairs(mechanism_, left_out)),
      column_of_(mechanism_.links().size(), -1),
      body_({}, 0) {
  pair_with_first_placed(mechanism_, values.plan().structure.groups_before(), pairs_);
  for (const HeldPair& pair : pairs_) {
    for (const FeatureIndex feature : {pair.first, pair.second}) {
      const LinkIndex link = mechanism_.features()[feature].link;
      if (link != mechanism_.ground() && column_of_[link] < 0) {
        column_of_[link] = unknowns();
        moving_.push_back(link);
      }
    }
  }
}

AllConstraints::Body::Pairs AllConstraints::held() const {
  const auto place_of_link = [this](FeatureIndex feature) {
    const Eigen::Index column = column_of_[mechanism_.features()[feature].link];
    return column < 0 ? -1 : static_cast<int>(column / 3);
  };
  Body::Pairs held;
  for (const HeldPair& pair : pairs_) {
    held.push_back({place_of_link(pair.first), place_of_link(pair.second),
                    values_.frame(pair.first).pose, values_.frame(pair.second).pose, pair.holds});
    if (pair.driver.exists()) {
      held.back().driven = pair.driven;
      held.back().wanted = values_.motion(pair.driver).position.value();
    }
  }
  return held;
}

AllConstraints::Body AllConstraints::of_loose(const Table<LinkIndex, bool>& is_placed,
                                              const Poses& links) const {
  std::vector<int> places;  // of the moving links; -1 for placed ones
  int loose = 0;
  for (const LinkIndex link : moving_) {
    places.push_back(is_placed[link] ? -1 : loose++);
  }
  Body::Pairs pairs = held();
  const auto loosen = [&](int& place, Pose<double>& feature) {
    if (place >= 0) {
      const auto link = static_cast<std::size_t>(place);
      place = places[link];
      feature = place < 0 ? support::pose_in(links[moving_[link]], feature) : feature;
    }
  };
  for (Body::Pair& pair : pairs) {
    loosen(pair.first, pair.one);
    loosen(pair.second, pair.other);
  }
  std::erase_if(pairs, [](const Body::Pair& pair) { return pair.first < 0 && pair.second < 0; });
  return {std::move(pairs), loose};
}

Table<LinkIndex, bool> AllConstraints::without_joined(const Table<LinkIndex, bool>& is_placed,
                                                      const std::vector<LinkIndex>& links) const {
  Table<LinkIndex, bool> is_apart(is_placed.size(), true);
  std::ranges::for_each(links, [&](LinkIndex link) { is_apart[link] = false; });
  const Body::Pairs pairs = held();
  for (bool grows = true; grows;) {
    grows = false;
    for (const Body::Pair& pair : pairs) {
      if (pair.first >= 0 && pair.second >= 0) {
        const LinkIndex one = moving_[static_cast<std::size_t>(pair.first)];
        const LinkIndex other = moving_[static_cast<std::size_t>(pair.second)];
        if (is_apart[one] != is_apart[other] && !is_placed[one] && !is_placed[other]) {
          is_apart[one] = is_apart[other] = false;
          grows = true;
        }
      }
    }
  }
  return is_apart;
}

AllConstraints::Body::Poses AllConstraints::moving_poses(const Poses& links) const {
  Body::Poses poses;
  for (const LinkIndex link : moving_) {
    poses.push_back(links[link]);
  }
  return poses;
}

void AllConstraints::place(const Body::Poses& moved, Poses& links) const {
  for (std::size_t place = 0; place < moving_.size(); ++place) {
    links[moving_[place]] = moved[place];
  }
}

void AllConstraints::measure(const Poses& links) {
  body_ = Body(held(), static_cast<int>(moving_.size()));
  body_.measure(moving_poses(links));
}

Eigen::VectorXd AllConstraints::misses(const Poses& links) const {
  return body_.misses(moving_poses(links));
}

Eigen::MatrixXd AllConstraints::jacobian(const Poses& links) const {
  return body_.jacobian(moving_poses(links));
}

AllConstraints::Blocks AllConstraints::blocks() const {
  const Table<LinkIndex, std::size_t> groups_before = values_.plan().structure.groups_before();
  Blocks result;
  for (const LinkIndex link : moving_) {
    result.of_unknowns.insert(result.of_unknowns.end(), 3, groups_before[link]);
  }
  body_.for_each_row([&](int /*row*/, int /*coordinate*/, std::size_t index) {
    const HeldPair& pair = pairs_[index];
    result.of_rows.push_back(std::max(groups_before[mechanism_.features()[pair.first].link],
                                      groups_before[mechanism_.features()[pair.second].link]));
  });
  return result;
}

Eigen::VectorXd AllConstraints::along_laws(Eigen::Index parameter) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(body_.rows());
  body_.for_each_row([&](int row, int coordinate, std::size_t index) {
    const HeldPair& pair = pairs_[index];
    if (pair.driver.exists() && pair.driven == coordinate) {
      const Eigen::VectorXd& follows = values_.motion(pair.driver).position.derivatives();
      result(row) = follows.size() > 0 ? -follows(parameter) / unit(coordinate) : 0;
    }
  });
  return result;
}

void AllConstraints::move(const Eigen::VectorXd& step, Poses& links) const {
  Body::Poses poses = moving_poses(links);
  body_.move(step, poses);
  place(poses, links);
}

Eigen::VectorXd AllConstraints::step(const Poses& from, const Poses& to) const {
  return body_.step(moving_poses(from), moving_poses(to));
}

Frame AllConstraints::relative(const HeldPair& pair, const Links& links) const {
  const auto placed = [&](FeatureIndex feature) {
    return composed(links[mechanism_.features()[feature].link], values_.frame(feature));
  };
  return seen_from(placed(pair.first), placed(pair.second));
}

Eigen::MatrixXd AllConstraints::first_rates(const Links& links) const {
  const Eigen::Index parameters = std::ssize(values_.columns());
  Eigen::MatrixXd result(body_.rows(), 1 + parameters);
  body_.for_each_row([&](int row, int coordinate, std::size_t index) {
    const HeldPair& pair = pairs_[index];
    const Frame at = relative(pair, links);
    result(row, 0) = at.velocity(coordinate);
    result.row(row).tail(parameters) = at.follows.first.row(coordinate);
    if (pair.driver.exists() && pair.driven == coordinate) {
      const JointMotion& law = values_.motion(pair.driver);
      result(row, 0) -= law.velocity;
      if (law.position.derivatives().size() > 0) {
        result.row(row).tail(parameters) -= law.position.derivatives().transpose();
      }
    }
    result.row(row) /= unit(coordinate);
  });
  return result;
}

Eigen::MatrixXd AllConstraints::second_rates(const Links& links) const {
  const Eigen::Index parameters = values_.second_order() ? std::ssize(values_.columns()) : 0;
  Eigen::MatrixXd result(body_.rows(), 1 + parameters * parameters);
  body_.for_each_row([&](int row, int coordinate, std::size_t index) {
    const HeldPair& pair = pairs_[index];
    const Frame at = relative(pair, links);
    const bool is_driven = pair.driver.exists() && pair.driven == coordinate;
    result(row, 0) =
        at.acceleration(coordinate) - (is_driven ? values_.motion(pair.driver).acceleration : 0);
    for (Eigen::Index one = 0; one < parameters; ++one) {
      for (Eigen::Index other = 0; other < parameters; ++other) {
        double& second = result(row, 1 + one * parameters + other);
        second = at.follows.second[static_cast<std::size_t>(coordinate)](one, other);
        if (is_driven && values_.motion(pair.driver).position.has_hessian()) {
          second -= values_.motion(pair.driver).position.hessian()(one, other);
        }
      }
    }
    result.row(row) /= unit(coordinate);
  });
  return result;
}

Eigen::VectorXd AllConstraints::unknown_rates(const Links& links, Eigen::Index parameter) const {
  const Body::Poses poses = moving_poses(poses_of(links));
  Eigen::VectorXd result(unknowns());
  for (std::size_t place = 0; place < moving_.size(); ++place) {
    result.segment<3>(3 * static_cast<Eigen::Index>(place)) = body_.unknown_rates_of(
        static_cast<int>(place), links[moving_[place]].follows.first.col(parameter), poses);
  }
  return result;
}

void AllConstraints::add_first(const Eigen::MatrixXd& rates, Links& links) const {
  const Body::Poses poses = moving_poses(poses_of(links));
  for (std::size_t place = 0; place < moving_.size(); ++place) {
    Frame& frame = links[moving_[place]];
    const auto moved = [&](Eigen::Index column) {
      return body_.rates_of(static_cast<int>(place), rates.col(column), poses);
    };
    frame.velocity += moved(0);
    for (Eigen::Index column = 1; column < rates.cols(); ++column) {
      frame.follows.first.col(column - 1) += moved(column);
    }
  }
}

void AllConstraints::add_second(const Eigen::MatrixXd& rates, Links& links) const {
  const Eigen::Index parameters = std::ssize(values_.columns());
  const Body::Poses poses = moving_poses(poses_of(links));
  for (std::size_t place = 0; place < moving_.size(); ++place) {
    Frame& frame = links[moving_[place]];
    const auto moved = [&](Eigen::Index column) {
      return body_.rates_of(static_cast<int>(place), rates.col(column), poses);
    };
    frame.acceleration += moved(0);
    for (Eigen::Index column = 1; column < rates.cols(); ++column) {
      const Eigen::Vector3d second = moved(column);
      for (std::size_t row = 0; row < 3; ++row) {
        frame.follows.second[row]((column - 1) / parameters, (column - 1) % parameters) +=
            second(static_cast<Eigen::Index>(row));
      }
    }
  }
}

}  // namespace assur::mechanism::solve
