#include "usable_request.hpp"

#include <algorithm>
#include <assur/mechanism/error.hpp>
#include <assur/text/quoted.hpp>
#include <string>

namespace assur::mechanism::plan {

namespace {

/// Throws MechanismError if a reported part does not exist or is listed twice.
void expect_reported(const Mechanism& mechanism, const Reported& reported) {
  const auto expect = [](const auto& list, const auto& parts, const std::string& part) {
    if (!list) {
      return;
    }
    for (auto key = list->begin(); key != list->end(); ++key) {
      if (!key->exists() || key->place() >= parts.size()) {
        throw MechanismError(part, "the mechanism has no such part");
      }
      if (std::find(list->begin(), key, *key) != key) {
        throw MechanismError(part, text::in_quotes(parts[*key].name) + " occurs twice");
      }
    }
  };
  expect(reported.links, mechanism.links(), "report.links");
  expect(reported.joints, mechanism.joints(), "report.joints");
}

/// The largest number of parameters: in any plan, with derivatives, and with second derivatives.
constexpr std::size_t most_parameters = 20000;
constexpr std::size_t most_with_sensitivities = 2000;
constexpr std::size_t most_with_covariance = 200;

void expect_few_parameters(const Mechanism& mechanism, const Request& request) {
  const std::size_t count = mechanism.parameters().size();
  const auto expect = [count](bool counts, std::size_t most, const std::string& mend) {
    if (counts && count > most) {
      throw MechanismError("parameters", "there are " + std::to_string(count) +
                                             ", and no more than " + std::to_string(most) +
                                             " can be used" + mend);
    }
  };
  const bool derives = request.want.sensitivity;
  expect(true, most_parameters, "");
  expect(derives, most_with_sensitivities,
         " where each has sensitivities; leave 'sensitivity' out of 'want'");
  expect(derives && request.covariance, most_with_covariance,
         " with a covariance; leave that out, or 'sensitivity' out of 'want'");
}

}  // namespace

void expect_usable(const Mechanism& mechanism, const Request& request) {
  const auto expect_parameter = [&](ParameterIndex parameter, const std::string& part) {
    if (!parameter.exists() || parameter.place() >= mechanism.parameters().size()) {
      throw MechanismError(part, "the mechanism has no parameter of this index");
    }
  };
  const auto expect_number = [&](NumberIndex number, const std::string& part) {
    if (!number.exists() || number.place() >= mechanism.numbers().size()) {
      throw MechanismError(part, "the mechanism has no number of this index");
    }
  };
  expect_reported(mechanism, request.reported);
  for (const ReferenceAngle& angle : request.reference) {
    if (!angle.link.exists() || angle.link.place() >= mechanism.links().size()) {
      throw MechanismError("reference", "the mechanism has no such link");
    }
    if (angle.link == mechanism.ground()) {
      throw MechanismError("reference.ground",
                           "the ground stands still in all configurations; name a moving link");
    }
    expect_number(angle.theta, "reference");
  }
  if (request.sweep) {
    expect_parameter(request.sweep->parameter, "sweep.parameter");
    expect_number(request.sweep->from, "sweep.from");
    expect_number(request.sweep->to, "sweep.to");
    if (request.sweep->count < 1) {
      throw MechanismError("sweep.count", "expected a whole number from 1 on");
    }
  }
  if (request.covariance) {
    const std::vector<ParameterIndex>& named = request.covariance->parameters;
    for (std::size_t place = 0; place < named.size(); ++place) {
      expect_parameter(named[place], "covariance.parameters");
      if (std::find(named.begin(), named.begin() + static_cast<std::ptrdiff_t>(place),
                    named[place]) != named.begin() + static_cast<std::ptrdiff_t>(place)) {
        throw MechanismError("covariance.parameters", "a parameter occurs twice");
      }
    }
    const auto& matrix = request.covariance->matrix;
    const auto expect_each = [&named](std::size_t count) {
      if (count != named.size()) {
        throw MechanismError("covariance.matrix",
                             "expected a row and a column for each of the parameters");
      }
    };
    expect_each(matrix.size());
    for (const std::vector<NumberIndex>& row : matrix) {
      expect_each(row.size());
      for (const NumberIndex entry : row) {
        expect_number(entry, "covariance.matrix");
      }
    }
  }
  if (request.redundancy_tolerance.exists()) {
    expect_number(request.redundancy_tolerance, "redundancy.tolerance");
  }
  for (const ParameterIndex parameter : request.variable) {
    expect_parameter(parameter, "variable");
  }
  expect_few_parameters(mechanism, request);
}

}  // namespace assur::mechanism::plan
