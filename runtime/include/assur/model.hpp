// Turns numbers into the vocabulary of generated models: directions, poses, and tables that
// describe a model.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <tuple>

namespace assur {

/// An angle as (cos, sin). Generated code never calls a trigonometric function.
template <typename Scalar>
struct Direction {
  Scalar cos{1};
  Scalar sin{0};
};

template <typename Scalar, int Rows>
using Vector = Eigen::Matrix<Scalar, Rows, 1>;
template <typename Scalar, int Rows, int Columns>
using Matrix = Eigen::Matrix<Scalar, Rows, Columns>;

/// T(x) = sum over k of cosine[k] cos(k x) + sine[k] sin(k x), k = 0 .. Degree; sine[0] counts not.
template <typename Scalar, std::size_t Degree>
struct TrigonometricPolynomial {
  std::array<Scalar, Degree + 1> cosine{};
  std::array<Scalar, Degree + 1> sine{};
};

/// A link's frame in the fixed frame: a point p of the link lies at (x, y) + R(direction) p.
template <typename Scalar>
struct Pose {
  Scalar x{};
  Scalar y{};
  Direction<Scalar> direction{};
};

template <typename Scalar, int Links>
using Poses = std::array<Pose<Scalar>, static_cast<std::size_t>(Links)>;

/// A number of generated code that is no double: the double nearest to it and what is left.
template <typename Scalar>
[[nodiscard]] constexpr Scalar constant(double nearest, double rest) {
  return Scalar(nearest) + Scalar(rest);
}

/// A dimension or an input of a model as its vectors and matrices index it.
struct ModelVariable {
  const char* name;
  bool is_angle;  ///< radians; otherwise a length
};

/// An unknown of a model: the angle of a link, or the displacement of a prismatic joint.
struct ModelUnknown {
  const char* name;
  bool is_angle;
  int owner;  ///< index of the link whose angle it is, or of the joint that slides
};

/// The base, to which external joints attach, in place of a link index.
inline constexpr int base_link = -1;

/// A joint of a model: the links it joins (`first` may be the base) and its type.
struct ModelJoint {
  char name;
  int first;
  int second;
  bool prismatic;
};

/// A link of a model by its joints; a binary link has -1 in the third place.
struct ModelLink {
  const char* name;
  std::array<int, 3> joints;
};

/// A kind, and which joint of the model each of its joints plays.
template <int Joints>
struct KindRoles {
  const char* kind;
  std::array<int, static_cast<std::size_t>(Joints)> role;
};

}  // namespace assur
