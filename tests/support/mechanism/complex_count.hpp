// The number of complex configurations of a group in general position, counted modulo a prime from
// rigid bodies, without loops or determinants: the independent truth for larger groups.
#pragma once

#include <algorithm>
#include <array>
#include <assur/model_tables.hpp>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace assur::test {

/// The residues of integers modulo a prime below 2^31.
class Residues {
 public:
  using Value = std::uint64_t;
  explicit Residues(Value prime) : prime_(prime) {}
  [[nodiscard]] Value prime() const { return prime_; }
  [[nodiscard]] Value negative(Value a) const { return a == 0 ? 0 : prime_ - a; }
  [[nodiscard]] Value sum(Value a, Value b) const { return (a + b) % prime_; }
  [[nodiscard]] Value product(Value a, Value b) const { return a * b % prime_; }
  [[nodiscard]] Value inverse(Value a) const {  // a^(prime - 2), by Fermat
    Value result = 1;
    for (Value left = prime_ - 2; left > 0; left /= 2) {
      result = left % 2 == 1 ? product(result, a) : result;
      a = product(a, a);
    }
    return result;
  }
  /// Adds a multiple of one row to another.
  void add(std::vector<Value>& row, Value factor, const std::vector<Value>& other) const {
    for (std::size_t place = 0; place < row.size(); ++place) {
      row[place] = (row[place] + factor * other[place]) % prime_;
    }
  }

 private:
  Value prime_;
};

/// The rigid links of a group as points of the complex plane, P + theta r, with random dimensions
/// modulo a prime. The conjugates of P, theta and r are unknowns and numbers of their own, and
/// theta times its conjugate is one. Pins and equal angles are linear; their elimination leaves
/// `free_count` unknowns u and as many conjugates v, in which the conditions
///   theta t = 1 of each link,   D conj(L) - conj(D) L = 0 of each slide
/// (D between its points, L along its line) are products of a form in u and a form in v, summed.
class GroupModuloPrime {
 public:
  using Value = Residues::Value;
  using Form = std::vector<Value>;  ///< coefficients of the unknowns, and of 1
  using Condition = std::vector<std::pair<Form, Form>>;

  GroupModuloPrime(int links, const std::vector<ModelJoint>& joints, Value prime, unsigned seed)
      : residues_(prime), links_(static_cast<std::size_t>(links)), engine_(seed) {
    std::vector<Form> pins;
    std::vector<Form> conjugated_pins;
    std::vector<std::array<Form, 4>> slides;  // D and L, and their conjugates
    for (const ModelJoint& joint : joints) {
      const auto [first, first_conjugate] = point(joint.first, any(), any());
      const auto [second, second_conjugate] = point(joint.second, any(), any());
      Form gap = difference(first, second);
      Form conjugate = difference(first_conjugate, second_conjugate);
      if (!joint.prismatic) {
        pins.push_back(std::move(gap));
        conjugated_pins.push_back(std::move(conjugate));
        continue;
      }
      // The line has a direction of length one on each link; on the move both are one.
      const Value one = any();
      const Value other = any();
      const auto [line, line_conjugate] = direction(joint.first, one);
      const auto [same, same_conjugate] = direction(joint.second, other);
      pins.push_back(difference(line, same));
      conjugated_pins.push_back(difference(line_conjugate, same_conjugate));
      slides.push_back({gap, conjugate, line, line_conjugate});
    }
    const std::vector<Form> u = solved(std::move(pins));
    const std::vector<Form> v = solved(std::move(conjugated_pins));
    free_count_ = u.front().size() - 1;
    is_counted_right_ = 2 * free_count_ == links_ && v.front().size() == u.front().size();
    Form minus_one(free_count_ + 1, 0);
    minus_one.back() = prime - 1;
    Form one(free_count_ + 1, 0);
    one.back() = 1;
    for (std::size_t link = links_; is_counted_right_ && link < 2 * links_; ++link) {
      conditions_.push_back({{u[link], v[link]}, {minus_one, one}});
    }
    for (const auto& [gap, conjugate, line, line_conjugate] : slides) {
      if (is_counted_right_) {
        conditions_.push_back({{applied(gap, u), applied(line_conjugate, v)},
                               {negative(applied(line, u)), applied(conjugate, v)}});
      }
    }
  }

  /// The dimension of the ring of polynomials in u and v modulo the conditions, by the rank of
  /// their multiples up to a degree (Macaulay), to which those of lower degree that arise are
  /// multiplied again. Empty if up to `highest_degree` the products of degree D - 1 and D are not
  /// all reduced to lower ones: the dimension is infinite, so the group moves.
  [[nodiscard]] std::optional<int> count(int highest_degree) const {
    for (int degree = 3; is_counted_right_ && degree <= highest_degree; ++degree) {
      if (const std::optional<int> result = count_up_to(degree)) {
        return result;
      }
    }
    return std::nullopt;
  }

  /// The program of the same computation for Singular: it prints the dimension, or -1 if it is
  /// infinite.
  [[nodiscard]] std::string asked_of_singular() const {
    if (!is_counted_right_) {
      return "-1;\n";
    }
    std::ostringstream text;
    text << "ring r=" << residues_.prime() << ",(";
    for (std::size_t unknown = 0; unknown < free_count_; ++unknown) {
      text << "u" << unknown << ",v" << unknown << (unknown + 1 < free_count_ ? "," : "),dp;\n");
    }
    const auto written = [&](const Form& form, const char* name) {
      text << "(" << form.back();
      for (std::size_t unknown = 0; unknown < free_count_; ++unknown) {
        text << "+" << form[unknown] << "*" << name << unknown;
      }
      text << ")";
    };
    const char* before = "ideal i=";
    for (const Condition& condition : conditions_) {
      text << std::exchange(before, ",\n");
      const char* sign = "";
      for (const auto& [in_u, in_v] : condition) {
        text << std::exchange(sign, "+");
        written(in_u, "u");
        text << "*";
        written(in_v, "v");
      }
    }
    text << ";\nvdim(std(i));\nkill r;\n";
    return text.str();
  }

 private:
  [[nodiscard]] Value any() {
    return std::uniform_int_distribution<Value>(1, residues_.prime() - 1)(engine_);
  }
  [[nodiscard]] Form nothing() const { return Form(2 * links_ + 1, 0); }

  /// theta e of a link and its conjugate, where e has the length one.
  [[nodiscard]] std::pair<Form, Form> direction(int link, Value e) const {
    std::pair<Form, Form> result{nothing(), nothing()};
    const std::size_t place =
        link == base_link ? 2 * links_ : links_ + static_cast<std::size_t>(link);
    result.first[place] = e;
    result.second[place] = residues_.inverse(e);
    return result;
  }
  /// P + theta r of a link and its conjugate.
  [[nodiscard]] std::pair<Form, Form> point(int link, Value r, Value conjugate) const {
    std::pair<Form, Form> result{nothing(), nothing()};
    if (link == base_link) {
      result.first.back() = r;
      result.second.back() = conjugate;
      return result;
    }
    const auto place = static_cast<std::size_t>(link);
    result.first[place] = result.second[place] = 1;
    result.first[links_ + place] = r;
    result.second[links_ + place] = conjugate;
    return result;
  }
  [[nodiscard]] Form difference(Form from, const Form& minus) const {
    residues_.add(from, residues_.prime() - 1, minus);
    return from;
  }
  [[nodiscard]] Form negative(Form form) const {
    for (Value& value : form) {
      value = residues_.negative(value);
    }
    return form;
  }

  /// Every unknown of linear equations as a form in those that stay free.
  [[nodiscard]] std::vector<Form> solved(std::vector<Form> equations) const {
    const std::size_t unknowns = 2 * links_;
    std::vector<std::size_t> pivots;
    for (std::size_t column = 0; column < unknowns; ++column) {
      const auto row = std::find_if(equations.begin() + std::ssize(pivots), equations.end(),
                                    [&](const Form& form) { return form[column] != 0; });
      if (row == equations.end()) {
        continue;
      }
      std::iter_swap(equations.begin() + std::ssize(pivots), row);
      Form& pivot = equations[pivots.size()];
      const Value by = residues_.inverse(pivot[column]);
      for (Value& value : pivot) {
        value = residues_.product(value, by);
      }
      for (Form& other : equations) {
        if (&other != &pivot && other[column] != 0) {
          residues_.add(other, residues_.negative(other[column]), pivot);
        }
      }
      pivots.push_back(column);
    }
    std::vector<std::size_t> free;
    for (std::size_t column = 0; column < unknowns; ++column) {
      if (std::ranges::find(pivots, column) == pivots.end()) {
        free.push_back(column);
      }
    }
    std::vector<Form> result(unknowns, Form(free.size() + 1, 0));
    for (std::size_t place = 0; place < free.size(); ++place) {
      result[free[place]][place] = 1;
      for (std::size_t row = 0; row < pivots.size(); ++row) {
        result[pivots[row]][place] = residues_.negative(equations[row][free[place]]);
      }
    }
    for (std::size_t row = 0; row < pivots.size(); ++row) {
      result[pivots[row]].back() = residues_.negative(equations[row].back());
    }
    return result;
  }

  /// A form in all unknowns as one in the free ones.
  [[nodiscard]] Form applied(const Form& form, const std::vector<Form>& solved) const {
    Form result(free_count_ + 1, 0);
    for (std::size_t unknown = 0; unknown < solved.size(); ++unknown) {
      residues_.add(result, form[unknown], solved[unknown]);
    }
    result.back() = residues_.sum(result.back(), form.back());
    return result;
  }

  /// Exponents of u and then v.
  using Product = std::vector<int>;

  [[nodiscard]] std::optional<int> count_up_to(int degree) const {
    const std::size_t unknowns = 2 * free_count_;
    // All products up to the degree, the highest ones first.
    std::vector<std::vector<Product>> by_degree = {{Product(unknowns, 0)}};
    for (int next = 1; next <= degree; ++next) {
      std::vector<Product> products;
      for (const Product& product : by_degree.back()) {
        const auto last = std::find_if(product.rbegin(), product.rend(),
                                       [](int exponent) { return exponent > 0; });
        for (auto unknown =
                 static_cast<std::size_t>(product.rend() - last) - (last == product.rend() ? 0 : 1);
             unknown < unknowns; ++unknown) {
          products.push_back(product);
          ++products.back()[unknown];
        }
      }
      by_degree.push_back(std::move(products));
    }
    std::map<Product, std::size_t> place_of;
    std::vector<int> degree_at;
    for (int next = degree; next >= 0; --next) {
      for (const Product& product : by_degree[static_cast<std::size_t>(next)]) {
        place_of[product] = degree_at.size();
        degree_at.push_back(next);
      }
    }
    const std::size_t size = degree_at.size();
    std::vector<std::vector<std::size_t>> times(unknowns, std::vector<std::size_t>(size, size));
    for (auto [product, place] : place_of) {
      for (std::size_t unknown = 0; unknown < unknowns && degree_at[place] < degree; ++unknown) {
        Product multiple = product;
        ++multiple[unknown];
        times[unknown][place] = place_of.at(multiple);
      }
    }
    std::vector<std::vector<Value>> rows(size);  // by the place of the first term, which is 1
    std::vector<std::vector<Value>> waiting;
    for (const Condition& condition : conditions_) {
      waiting.push_back(expanded(condition, place_of));
    }
    for (std::size_t next = 0; next < waiting.size(); ++next) {
      std::vector<Value> row = std::move(waiting[next]);
      std::size_t first = size;
      for (std::size_t place = 0; place < size; ++place) {
        if (row[place] == 0) {
          continue;
        }
        if (rows[place].empty()) {
          first = std::min(first, place);
          if (degree_at[place] < degree_at[first]) {
            break;  // the rest need not be reduced
          }
        } else {
          residues_.add(row, residues_.negative(row[place]), rows[place]);
        }
      }
      if (first == size) {
        continue;
      }
      const Value by = residues_.inverse(row[first]);
      for (Value& value : row) {
        value = residues_.product(value, by);
      }
      for (std::size_t unknown = 0; unknown < unknowns && degree_at[first] < degree; ++unknown) {
        std::vector<Value> multiple(size, 0);
        for (std::size_t place = first; place < size; ++place) {
          if (row[place] != 0) {
            multiple[times[unknown][place]] = row[place];
          }
        }
        waiting.push_back(std::move(multiple));
      }
      rows[first] = std::move(row);
    }
    int result = 0;
    for (std::size_t place = 0; place < size; ++place) {
      if (rows[place].empty()) {
        if (degree_at[place] >= degree - 1) {
          return std::nullopt;
        }
        ++result;
      }
    }
    return result;
  }

  [[nodiscard]] std::vector<Value> expanded(const Condition& condition,
                                            const std::map<Product, std::size_t>& place_of) const {
    std::vector<Value> result(place_of.size(), 0);
    for (const auto& [in_u, in_v] : condition) {
      for (std::size_t one = 0; one <= free_count_; ++one) {
        for (std::size_t other = 0; other <= free_count_; ++other) {
          Product product(2 * free_count_, 0);
          if (one < free_count_) {
            ++product[one];
          }
          if (other < free_count_) {
            ++product[free_count_ + other];
          }
          Value& sum = result[place_of.at(product)];
          sum = residues_.sum(sum, residues_.product(in_u[one], in_v[other]));
        }
      }
    }
    return result;
  }

  Residues residues_;
  std::size_t links_;
  std::mt19937 engine_;
  std::size_t free_count_ = 0;
  bool is_counted_right_ = false;
  std::vector<Condition> conditions_;
};

}  // namespace assur::test
