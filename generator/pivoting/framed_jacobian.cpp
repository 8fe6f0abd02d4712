#include "pivoting/framed_jacobian.hpp"

#include <algorithm>

namespace assur::generator::pivoting {

namespace {

/// `BCG_minus_CD` for theta_BCG - theta_CD.
std::string name_of(const equations::AngleSum& angle) {
  std::string name;
  for (const bool positive : {true, false}) {
    for (const auto& [variable, factor] : angle.terms()) {
      for (int count = 0; count < std::abs(factor) && (factor > 0) == positive; ++count) {
        const std::string prefix = "theta_";
        const std::string letters = variable->name.starts_with(prefix)
                                        ? variable->name.substr(prefix.size())
                                        : variable->name;
        name += positive ? (name.empty() ? "" : "_plus_") : (name.empty() ? "minus_" : "_minus_");
        name += letters;
      }
    }
  }
  return name;
}

equations::Vector2 normal_of(const equations::Vector2& vector) { return {-vector.y, vector.x}; }

equations::Vector2 operator*(const GiNaC::ex& factor, const equations::Vector2& vector) {
  return {factor * vector.x, factor * vector.y};
}

void add(equations::Vector2& sum, const equations::Vector2& vector) {
  sum = {sum.x + vector.x, sum.y + vector.y};
}

void put(std::vector<GiNaC::ex>& rows, std::size_t loop, const equations::Vector2& vector) {
  rows[2 * loop] = vector.x.expand();
  rows[2 * loop + 1] = vector.y.expand();
}

}  // namespace

FramedClosures::FramedClosures(const equations::ClosureEquations& equations)
    : equations_(&equations), vocabulary_(equations.vocabulary), loops_(polar_loops(equations)) {
  name_directions();
  name_turning_vectors();
}

std::string FramedClosures::row_name(std::size_t row) const {
  const PolarLoop& loop = loops_[row / 2];
  return (row % 2 == 0 ? "along_" : "across_") + loop.frame_name;
}

equations::Vector2 named_direction(const equations::AngleSum& angle,
                                   equations::Vocabulary& vocabulary) {
  const auto terms = angle.terms();
  int count = 0;
  for (const auto& [variable, factor] : terms) {
    count += std::abs(factor);
  }
  if (count < 2) {
    return angle.direction();
  }
  equations::AngleSum head;
  equations::AngleSum tail;
  for (const auto& [variable, factor] : terms) {
    (factor > 0 ? head : tail).add(*variable, factor);
  }
  if (head.terms().empty() || tail.terms().empty()) {
    const auto& [last, factor] = terms.back();
    head = angle - (factor > 0 ? equations::AngleSum(*last)
                               : equations::AngleSum() - equations::AngleSum(*last));
    tail = angle - head;
  }
  const equations::Vector2 first = named_direction(head, vocabulary);
  const equations::Vector2 second = named_direction(tail, vocabulary);
  const std::string name = name_of(angle);
  return {vocabulary.name("cos_" + name, first.x * second.x - first.y * second.y,
                          "cosine of " + angle.text()),
          vocabulary.name("sin_" + name, first.y * second.x + first.x * second.y,
                          "sine of " + angle.text())};
}

void FramedClosures::name_directions() {
  for (const PolarLoop& loop : loops_) {
    frame_directions_.push_back(named_direction(loop.frame, vocabulary_));
    std::vector<equations::Vector2>& directions = directions_.emplace_back();
    for (const PolarTerm& term : loop.terms) {
      equations::Vector2 direction = named_direction(term.angle - loop.frame, vocabulary_);
      for (int turn = 0; turn < term.quarter_turns; ++turn) {
        direction = normal_of(direction);
      }
      directions.push_back(direction);
    }
  }
}

equations::AngleSum FramedClosures::moving_part(const equations::AngleSum& angle) const {
  equations::AngleSum moving;
  for (const auto* variables : {&equations_->unknowns, &equations_->inputs}) {
    for (const equations::Variable& variable : *variables) {
      if (variable.is_angle()) {
        moving.add(variable, angle.factor(variable));
      }
    }
  }
  return moving;
}

void FramedClosures::name_turning_vectors() {
  for (std::size_t index = 0; index < loops_.size(); ++index) {
    const PolarLoop& loop = loops_[index];
    std::vector<Turning>& turnings = turnings_.emplace_back();
    for (std::size_t place = 0; place < loop.terms.size(); ++place) {
      const PolarTerm& term = loop.terms[place];
      const equations::AngleSum moving = moving_part(term.angle);
      if (moving.terms().empty()) {
        continue;
      }
      auto turning = std::find_if(turnings.begin(), turnings.end(), [&](const Turning& known) {
        return known.moving.text() == moving.text();
      });
      if (turning == turnings.end()) {
        turning = turnings.insert(turnings.end(), {moving, {}});
      }
      add(turning->vector, term.length->value * directions_[index][place]);
    }
    for (Turning& turning : turnings) {
      const std::string name = name_of(turning.moving);
      const std::string meaning = "of the sum of the vectors of loop " +
                                  equations_->loops[index].name + " that turn with " +
                                  turning.moving.text();
      turning.vector = {
          vocabulary_.name(name + "_along_" + loop.frame_name, turning.vector.x.expand(),
                           "component along " + loop.frame_name + " " + meaning),
          vocabulary_.name(name + "_across_" + loop.frame_name, turning.vector.y.expand(),
                           "component across " + loop.frame_name + " " + meaning)};
    }
  }
}

std::vector<GiNaC::ex> FramedClosures::derivative(const equations::Variable& variable) const {
  std::vector<GiNaC::ex> rows(row_count());
  const bool moves = !moving_part(equations::AngleSum(variable)).terms().empty();
  for (std::size_t index = 0; index < loops_.size(); ++index) {
    equations::Vector2 sum;
    if (variable.is_angle() && moves) {
      for (const Turning& turning : turnings_[index]) {
        add(sum, turning.moving.factor(variable) * normal_of(turning.vector));
      }
    } else {
      for (std::size_t place = 0; place < loops_[index].terms.size(); ++place) {
        const PolarTerm& term = loops_[index].terms[place];
        const equations::Vector2& direction = directions_[index][place];
        add(sum, variable.is_angle()
                     ? term.angle.factor(variable) * term.length->value * normal_of(direction)
                     : GiNaC::ex(term.length == &variable ? 1 : 0) * direction);
      }
    }
    put(rows, index, sum);
  }
  return rows;
}

std::vector<GiNaC::ex> FramedClosures::quadratic_rates() const {
  std::vector<GiNaC::ex> rows(row_count());
  const auto rate_of = [](const equations::AngleSum& moving) {
    GiNaC::ex rate;
    for (const auto& [angle, factor] : moving.terms()) {
      rate += factor * angle->rate;
    }
    return rate;
  };
  for (std::size_t index = 0; index < loops_.size(); ++index) {
    equations::Vector2 sum;
    for (const Turning& turning : turnings_[index]) {
      const GiNaC::ex rate = rate_of(turning.moving);
      add(sum, -rate * rate * turning.vector);
    }
    for (std::size_t place = 0; place < loops_[index].terms.size(); ++place) {
      const PolarTerm& term = loops_[index].terms[place];
      const auto is_length = [&](const equations::Variable& variable) {
        return &variable == term.length;
      };
      const bool changes = std::ranges::any_of(equations_->unknowns, is_length) ||
                           std::ranges::any_of(equations_->inputs, is_length);
      if (changes) {
        add(sum, 2 * term.length->rate * rate_of(moving_part(term.angle)) *
                     normal_of(directions_[index][place]));
      }
    }
    put(rows, index, sum);
  }
  return rows;
}

std::vector<GiNaC::ex> FramedClosures::derivative_bound(const equations::Variable& variable) const {
  std::vector<GiNaC::ex> rows(row_count());
  for (std::size_t index = 0; index < loops_.size(); ++index) {
    GiNaC::ex size;
    for (const PolarTerm& term : loops_[index].terms) {
      const int factor = variable.is_angle() ? std::abs(term.angle.factor(variable)) : 0;
      size += factor * term.length->size + (term.length == &variable ? 1 : 0);
    }
    rows[2 * index] = rows[2 * index + 1] = size;
  }
  return rows;
}

std::vector<GiNaC::ex> FramedClosures::row_size() const {
  std::vector<GiNaC::ex> rows;
  for (const PolarLoop& loop : loops_) {
    GiNaC::ex size;
    for (const PolarTerm& term : loop.terms) {
      const bool moves = !term.angle.terms().empty();
      size += moves ? GiNaC::ex(term.length->size) : GiNaC::ex(0);
    }
    rows.push_back(size);
    rows.push_back(size);
  }
  return rows;
}

}  // namespace assur::generator::pivoting
