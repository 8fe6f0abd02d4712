// Sensitivities of point M of the six-bar of Zhauyt et al. at one crank angle by the published
// equations, corrected or with the slips in the paper.
//
// Numbers in brackets are those of the paper's equations: docs/reports/zhauyt_2017.md.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "mechanism/scene_solutions.hpp"

namespace assur::test {

inline constexpr double degree = 3.14159265358979323846 / 180;
/// a1 ... a13 of the paper.
inline const std::array<std::string, 13> symbols = {"x_O", "y_O", "OA",  "AB",  "BE",  "BD", "EF",
                                                    "DG",  "x_F", "y_F", "x_G", "y_G", "ED"};

using Parameters = Eigen::Matrix<double, 13, 1>;
using ByParameter4 = Eigen::Matrix<double, 4, 13>;
using ByParameter2 = Eigen::Matrix<double, 2, 13>;

/// One configuration at one crank angle, from the program.
struct Posture {
  Parameters a;
  Parameters tolerance;
  Eigen::Matrix<double, 5, 1> phi;  ///< of OA, AB, BE, FE, GD
  double em;
  double gamma;  ///< of EM, which turns with the ternary link
  Json point;    ///< the program's report of M
};

inline std::vector<Posture> postures(double crank_degrees) {
  Json scene = example("zhauyt_2017_six_bar.json");
  scene["parameters"]["phi"] = crank_degrees * degree;
  std::vector<Posture> result;
  const Json root = report_of(scene);
  for (const Json& configuration : root["configurations"]) {
    Posture posture;
    for (std::size_t j = 0; j < symbols.size(); ++j) {
      const Json& parameter = scene["parameters"][symbols[j]];
      posture.a(static_cast<Eigen::Index>(j)) = parameter["value"].get<double>();
      posture.tolerance(static_cast<Eigen::Index>(j)) = parameter["tolerance"].get<double>();
    }
    Eigen::Index row = 0;
    for (const char* link : {"crank", "bar", "plate", "upper", "output"}) {
      posture.phi(row++) = configuration["links"][link]["theta"].get<double>();
    }
    posture.em = scene["parameters"]["EM"].get<double>();
    posture.gamma = posture.phi(2) + 60 * degree;
    posture.point = configuration["outputs"]["M"];
    result.push_back(posture);
  }
  return result;
}

/// Both configurations at crank angles around the turn.
inline std::vector<Posture> turn() {
  std::vector<Posture> all;
  for (int angle = 0; angle < 360; angle += 15) {
    const std::vector<Posture> at = postures(angle);
    EXPECT_EQ(at.size(), 2U) << angle;
    all.insert(all.end(), at.begin(), at.end());
  }
  return all;
}

/// The configuration whose output dwells.
inline Posture dwelling(double crank_degrees) {
  for (const Posture& posture : postures(crank_degrees)) {
    if (std::cos(posture.phi(4)) > 0) {
      return posture;
    }
  }
  ADD_FAILURE() << "no dwelling configuration at " << crank_degrees;
  return {};
}

/// The angle from BD to BE, by the law of cosines.
inline double alpha(const Parameters& a) {
  return std::acos((a(4) * a(4) + a(5) * a(5) - a(12) * a(12)) / (2 * a(4) * a(5)));
}

/// (4), with the pivot O that it leaves at the origin.
inline Eigen::Vector4d closure(const Parameters& a, const Eigen::Matrix<double, 5, 1>& phi) {
  const auto along = [](double length, double angle) {
    return Eigen::Vector2d(length * std::cos(angle), length * std::sin(angle));
  };
  const Eigen::Vector2d b = a.segment<2>(0) + along(a(2), phi(0)) + along(a(3), phi(1));
  Eigen::Vector4d f;
  f << a.segment<2>(8) + along(a(6), phi(3)) - along(a(4), phi(2)) - b,
      a.segment<2>(10) + along(a(7), phi(4)) - along(a(5), phi(2) - alpha(a)) - b;
  return f;
}

/// Which slips are left as the paper prints them.
struct AsPrinted {
  std::string name;
  bool entry_4_3 = false;  ///< -cos phi1 in (8)
  bool b_36_46 = false;    ///< B36, B46 in (8)
  bool ternary = false;    ///< columns 5 and 13 of (8) without the change of alpha
  bool pivot = false;      ///< columns 1 and 2 of (8) zero
  bool sign = false;       ///< of (6)

  friend std::ostream& operator<<(std::ostream& out, const AsPrinted& slip) {
    return out << slip.name;
  }
};

/// df/da: (8).
inline ByParameter4 closure_by_parameters(const Posture& posture, const AsPrinted& printed) {
  const Parameters& a = posture.a;
  const Eigen::Matrix<double, 5, 1>& phi = posture.phi;
  const double c = std::cos(phi(2) - alpha(a));
  const double s = std::sin(phi(2) - alpha(a));
  const double m = std::sin(alpha(a));
  ByParameter4 f = ByParameter4::Zero();
  if (!printed.pivot) {
    f(0, 0) = f(1, 1) = f(2, 0) = f(3, 1) = -1;
  }
  for (const Eigen::Index row : {0, 2}) {
    f.col(2).segment<2>(row) << -std::cos(phi(0)), -std::sin(phi(0));
    f.col(3).segment<2>(row) << -std::cos(phi(1)), -std::sin(phi(1));
  }
  if (printed.entry_4_3) {
    f(3, 2) = -std::cos(phi(0));
  }
  f.col(4).head<2>() << -std::cos(phi(2)), -std::sin(phi(2));
  f.col(6).head<2>() << std::cos(phi(3)), std::sin(phi(3));
  f.col(7).tail<2>() << std::cos(phi(4)), std::sin(phi(4));
  f(0, 8) = f(1, 9) = f(2, 10) = f(3, 11) = 1;
  const double squares_5 = a(4) * a(4) - a(5) * a(5) + a(12) * a(12);
  const double squares_6 = a(5) * a(5) - a(4) * a(4) + a(12) * a(12);
  if (printed.b_36_46) {
    const double k = squares_5 / (2 * a(4) * a(5) * m);
    f.col(5).tail<2>() << c - k * s, s + k * c;
  } else {
    const double k = squares_6 / (2 * a(4) * a(5) * m);
    f.col(5).tail<2>() << -c + k * s, -s - k * c;
  }
  if (!printed.ternary) {
    const double k = squares_5 / (2 * a(4) * a(4) * m);
    f.col(4).tail<2>() << k * s, -k * c;
    f.col(12).tail<2>() << -a(12) / (a(4) * m) * s, a(12) / (a(4) * m) * c;
  }
  return f;
}

/// df/dphi: (7).
inline Eigen::Matrix<double, 4, 5> closure_by_angles(const Posture& posture) {
  const Parameters& a = posture.a;
  const auto turned = [](double length, double angle) {
    return Eigen::Vector2d(length * std::sin(angle), -length * std::cos(angle));
  };
  const Eigen::Matrix<double, 5, 1>& phi = posture.phi;
  Eigen::Matrix<double, 4, 5> f = Eigen::Matrix<double, 4, 5>::Zero();
  for (const Eigen::Index row : {0, 2}) {
    f.col(0).segment<2>(row) = turned(a(2), phi(0));
    f.col(1).segment<2>(row) = turned(a(3), phi(1));
  }
  f.col(2) << turned(a(4), phi(2)), turned(a(5), phi(2) - alpha(a));
  f.col(3).head<2>() = -turned(a(6), phi(3));
  f.col(4).tail<2>() = -turned(a(7), phi(4));
  return f;
}

/// dM/da by (3) and (6), the crank's angle held: its column of (7) has no unknown.
inline ByParameter2 published(const Posture& posture, const AsPrinted& printed) {
  const Eigen::Matrix4d jacobian = closure_by_angles(posture).rightCols<4>();
  const ByParameter4 by_parameters = closure_by_parameters(posture, printed);
  const ByParameter4 solved = jacobian.partialPivLu().solve(by_parameters);
  const ByParameter4 angles = printed.sign ? solved : ByParameter4(-solved);
  const double phi4 = posture.phi(3);
  const Eigen::Vector2d ef(std::cos(phi4), std::sin(phi4));
  const Eigen::Vector2d ef_turned = posture.a(6) * Eigen::Vector2d(-ef.y(), ef.x());
  const Eigen::Vector2d em_turned =
      posture.em * Eigen::Vector2d(-std::sin(posture.gamma), std::cos(posture.gamma));
  ByParameter2 m = ef_turned * angles.row(2) + em_turned * angles.row(1);
  m.col(6) += ef;
  m(0, 8) += 1;
  m(1, 9) += 1;
  return m;
}

/// dM/da as the program says.
inline ByParameter2 reported(const Posture& posture) {
  ByParameter2 m;
  for (std::size_t j = 0; j < symbols.size(); ++j) {
    const Json& entry = posture.point["sensitivity"][symbols[j]];
    m.col(static_cast<Eigen::Index>(j)) << entry[0].get<double>(), entry[1].get<double>();
  }
  return m;
}

}  // namespace assur::test
