#include "equations/variable.hpp"

#include <utility>

namespace assur::generator::equations {

namespace {

/// `_BCG` of `theta_BCG`, `_turn` of `turn`.
std::string angle_suffix(const std::string& name) {
  const std::size_t at = name.find('_');
  return at == std::string::npos ? "_" + name : name.substr(at);
}

}  // namespace

Variable::Variable(std::string name_in, Quantity quantity_in, std::string meaning_in)
    : name(std::move(name_in)),
      quantity(quantity_in),
      meaning(std::move(meaning_in)),
      value(name),
      size("size_" + name),
      cosine("cos_" + name),
      sine("sin_" + name),
      rate(is_angle() ? "omega" + angle_suffix(name) : "v_" + name),
      second_rate(is_angle() ? "alpha" + angle_suffix(name) : "a_" + name),
      third_rate(is_angle() ? "jerk" + angle_suffix(name) : "j_" + name) {}

GiNaC::ex partial(const GiNaC::ex& expression, const Variable& variable) {
  if (variable.is_angle()) {
    return expression.diff(variable.sine) * variable.cosine -
           expression.diff(variable.cosine) * variable.sine;
  }
  return expression.diff(variable.value);
}

AngleSum& AngleSum::add(const Variable& angle, int factor) {
  const auto [entry, fresh] = terms_.try_emplace(angle.name, Entry{&angle, 0});
  entry->second.factor += factor;
  if (entry->second.factor == 0) {
    terms_.erase(entry);
  }
  return *this;
}

AngleSum operator+(AngleSum left, const AngleSum& right) {
  for (const auto& [name, entry] : right.terms_) {
    left.add(*entry.angle, entry.factor);
  }
  return left;
}

AngleSum operator-(AngleSum left, const AngleSum& right) {
  for (const auto& [name, entry] : right.terms_) {
    left.add(*entry.angle, -entry.factor);
  }
  return left;
}

Vector2 AngleSum::direction() const {
  Vector2 sum{1, 0};
  for (const auto& [name, entry] : terms_) {
    const int sense = entry.factor < 0 ? -1 : 1;
    for (int count = 0; count != entry.factor; count += sense) {
      const Vector2 step{entry.angle->cosine, sense * entry.angle->sine};
      sum = {(sum.x * step.x - sum.y * step.y).expand(),
             (sum.x * step.y + sum.y * step.x).expand()};
    }
  }
  return sum;
}

int AngleSum::factor(const Variable& angle) const {
  const auto entry = terms_.find(angle.name);
  return entry == terms_.end() ? 0 : entry->second.factor;
}

std::vector<std::pair<const Variable*, int>> AngleSum::terms() const {
  std::vector<std::pair<const Variable*, int>> list;
  list.reserve(terms_.size());
  for (const auto& [name, entry] : terms_) {
    list.emplace_back(entry.angle, entry.factor);
  }
  return list;
}

std::string AngleSum::text() const {
  std::string text;
  for (const auto& [name, entry] : terms_) {
    if (entry.factor < 0) {
      text += text.empty() ? "-" : " - ";
    } else if (!text.empty()) {
      text += " + ";
    }
    const int size = entry.factor < 0 ? -entry.factor : entry.factor;
    text += (size == 1 ? "" : std::to_string(size) + " ") + name;
  }
  return text.empty() ? "0" : text;
}

}  // namespace assur::generator::equations
