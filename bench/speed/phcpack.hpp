// Rows for PHCpack's homotopy continuation on squared loop closures.
#pragma once

#include <complex>
#include <functional>
#include <vector>

#include "table/row.hpp"

namespace assur::speed {

/// A bar between two links: |b + g z_first - f z_second|^2 = bar^2, where z1, z2, ... are the
/// directions of the links as complex numbers.
struct SquaredClosure {
  int first, second;  ///< numbers of links, from 1
  std::complex<double> b, g, f;
  double bar;
};

/// The directions z1, z2, ... of a configuration.
using LinkDirections = std::vector<std::complex<double>>;

/// The question to PHCpack at an input, and the error of its answer, all configurations.
struct PhcQuestions {
  std::function<std::vector<SquaredClosure>(std::size_t input)> closures;
  std::function<double(std::size_t input, const std::vector<LinkDirections>& found)> error;
};

/// Adds the rows of its black-box solver on as many closures as there are links, as Laurent
/// polynomials. Each input takes a process, so there are few inputs, and the rows hold their own
/// median times: of solving, as PHCpack states it, and of the whole process.
void add_phc_rows(Task& task, std::size_t inputs, const PhcQuestions& questions);

}  // namespace assur::speed
