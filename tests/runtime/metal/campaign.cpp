// Solves groups read as numbers, and writes all their configurations, which are the same on every
// machine, with the instructions and the stack that each group took.
//
// A group is its model's place in `Models`, its dimensions and its inputs. The answer is that
// place, status, count, mobility, instructions, bytes of the stack and how many numbers each
// configuration has; then the regularity and the unknowns of each configuration. All are written as
// doubles, even if ASSUR_SCALAR is narrower.
#include <array>
#include <assur/assembly.hpp>
#include <assur/support/flat_variables.hpp>
#include <utility>

#include "board.hpp"
#include "campaign_models.hpp"

namespace {

using assur::test::metal::Models;
using Scalar = ASSUR_SCALAR;

/// A buffer of numbers, which is written when it is full.
class Answer {
 public:
  void add(double number) {
    if (used_ == numbers_.size()) {
      flush();
    }
    numbers_[used_++] = number;
  }
  void flush() {
    board::write(numbers_.data(), used_ * sizeof(double));
    used_ = 0;
  }

 private:
  std::array<double, 512> numbers_{};
  std::size_t used_ = 0;
};

template <typename Variables>
bool read_variables(Variables& variables) {
  constexpr std::size_t count = assur::support::number_count<Variables, Scalar>;
  std::array<double, 24> wide{};
  if (board::read(wide.data(), count * sizeof(double)) != count * sizeof(double)) {
    return false;
  }
  assur::support::FlatVariables<Scalar> flat{};
  for (std::size_t place = 0; place < count; ++place) {
    flat[place] = static_cast<Scalar>(wide[place]);
  }
  variables = assur::support::unflattened<Variables>(flat);
  return true;
}

template <std::size_t Place>
[[gnu::noinline]] bool answer(Answer& out) {
  using Model = std::tuple_element_t<Place, Models>;
  using Configuration = typename Model::template Configuration<Scalar>;
  constexpr std::size_t unknowns = assur::support::number_count<Configuration, Scalar>;
  typename Model::template Dimensions<Scalar> d;
  typename Model::template Inputs<Scalar> u;
  if (!read_variables(d) || !read_variables(u)) {
    return false;
  }
  board::paint_stack();
  board::start_counting();
  const auto found = assur::assemblies<Model, Scalar>(d, u);
  const std::uint64_t instructions = board::instructions();
  const std::uint32_t stack = board::painted_over();
  for (const double number : {static_cast<double>(Place), static_cast<double>(found.status),
                              static_cast<double>(found.count), static_cast<double>(found.mobility),
                              static_cast<double>(instructions), static_cast<double>(stack),
                              static_cast<double>(1 + unknowns)}) {
    out.add(number);
  }
  for (int index = 0; index < found.count; ++index) {
    const auto place = static_cast<std::size_t>(index);
    assur::support::FlatVariables<double> flat{};
    assur::support::flatten(found.configurations[place], flat);
    out.add(static_cast<double>(found.regularity[place]));
    for (std::size_t number = 0; number < unknowns; ++number) {
      out.add(flat[number]);
    }
  }
  return true;
}

template <std::size_t... Place>
bool answer(std::size_t model, Answer& out, std::index_sequence<Place...>) {
  bool done = false;
  ((model == Place && (done = answer<Place>(out))), ...);
  return done;
}

}  // namespace

int main() {
  static Answer out;
  double model = 0;
  while (board::read(&model, sizeof(model)) == sizeof(model)) {
    if (!answer(static_cast<std::size_t>(model), out,
                std::make_index_sequence<std::tuple_size_v<Models>>())) {
      return 1;
    }
  }
  out.flush();
  return 0;
}
