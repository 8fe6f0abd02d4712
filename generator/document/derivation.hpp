// The derivation of a model as text, from its graph to its final polynomial, for the renderers.
#pragma once

#include <array>
#include <assur/loops/elimination.hpp>
#include <optional>
#include <string>
#include <vector>

#include "program/expression_graph.hpp"
#include "structure/kind.hpp"

namespace assur::generator::document {

/// An unknown, dimension or input. All formulas below are in the syntax of scene files.
struct DerivedVariable {
  std::string name;
  bool is_angle;
  std::string rate, second_rate;
  std::string meaning;
};

/// A quantity with a name.
struct DerivedQuantity {
  std::string name;
  std::string value;
  std::string meaning;
  bool vanishes;  ///< zero in every assembled configuration
};

/// One vector loop closure and its two components.
struct DerivedClosure {
  std::string loop;      ///< `BCDEB`
  std::string equation;  ///< `B + BC + CD - ED - E = 0`
  std::array<std::string, 2> names;
  std::array<std::string, 2> values;
};

using TextMatrix = std::vector<std::vector<std::string>>;

/// A matrix of the derivatives of its rows with respect to the variables of its columns.
struct DerivedMatrix {
  std::string name;
  std::vector<std::string> rows;
  std::vector<std::string> columns;
  TextMatrix entries;
};

/// A factor of the Jacobian's determinant.
struct DerivedPivot {
  std::string value;
  std::string zero;     ///< `CD = 0`, `a dead centre`
  std::string meaning;  ///< its consequence for the group
};

/// The Jacobian in the frames of its loops, where its determinant is a product.
struct DerivedDeterminant {
  std::vector<DerivedQuantity> quantities;  ///< in addition to those of the closures
  DerivedMatrix framed;
  std::vector<DerivedPivot> pivots;
  std::string value;  ///< sign times product of the pivots
  std::string text;   ///< the same with the core's determinant written out
};

/// One coefficient of a series: (re + i im) w^power.
struct DerivedTerm {
  int power;
  std::string re, im;
};

struct DerivedSeries {
  std::string name;
  std::string formula;
  std::string base;  ///< the base of the powers: `w`, or the unknown
  std::vector<DerivedTerm> terms;
};

struct DerivedStep {
  std::string title;
  std::string rule;
  std::vector<std::string> formulas;
  std::vector<std::string> eliminated;
  std::vector<DerivedQuantity> quantities;
  std::vector<DerivedSeries> series;
};

/// The formula of an unknown in those known before it: the numerators over the denominator are a
/// displacement, or an angle's cosine and sine.
struct DerivedBackSubstitution {
  std::string unknown;
  bool is_angle;
  std::vector<std::string> numerators;
  std::string denominator;
  std::string degeneracy;
};

struct DerivedElimination {
  std::vector<DerivedStep> steps;
  std::string unknown;
  bool is_angle;
  std::string polynomial;  ///< in the coefficients named by the steps; zero at a configuration
  std::vector<DerivedBackSubstitution> back_substitution;
  std::size_t degree;
  std::size_t max_configurations;
};

/// The force of a joint, and the couple of a slide, on a link or on a neighbour of the group.
struct DerivedReaction {
  std::string joint;
  std::string on;
  std::array<std::string, 2> force;
  std::string couple;  ///< empty for a revolute joint
};

/// The joint forces under given loads, by the elimination transposed.
struct DerivedForces {
  /// For each link: the names of x and y of the force on it, and of the moment.
  structure::LinkTable<std::array<std::string, 3>> loads;
  std::vector<DerivedQuantity> generalised;  ///< the loads along the unknowns, and their parts
  std::vector<DerivedQuantity> multipliers;  ///< the forces in the cut joints, and their parts
  std::vector<std::string> equations;        ///< J^T lambda + Q = 0
  std::vector<DerivedQuantity> reactions;    ///< the other forces, from the leaves to the base
  std::vector<DerivedQuantity> couples;
  std::vector<DerivedReaction> joints;      ///< on the second link of each joint
  std::vector<DerivedReaction> neighbours;  ///< on the neighbours of the group
  program::OperationCount operations;       ///< of all formulas
  program::OperationCount of_loads;         ///< of the loads along the unknowns
};

/// The elimination for a group of more than four links: all angles but a hidden one are eliminated
/// by determinants, which leaves an eigenproblem.
struct DerivedEigenproblem {
  int configurations;                  ///< number of complex ones
  std::string ground, hidden;          ///< the angles for which the equations are written
  std::size_t size, degree;            ///< of the matrix, and of its entries
  std::size_t choices;                 ///< of ground and hidden angle
  std::vector<std::string> equations;  ///< one for each row
};

struct Derivation {
  const structure::Model* model;
  structure::Kind kind;                      ///< the requested kind
  structure::JointTable<std::string> roles;  ///< for each of its joints, the model's joint it plays

  structure::LinkTable<std::string> frames;  ///< of the links, in words
  structure::LinkTable<std::string> angles;  ///< of the links, as sums
  std::vector<DerivedVariable> unknowns, dimensions, inputs;
  std::vector<DerivedQuantity> quantities;
  std::vector<DerivedClosure> closures;
  std::vector<std::string> compatibility;  ///< sums of angles that must be zero
  DerivedMatrix jacobian, dimension_jacobian, input_jacobian;
  std::vector<std::string> velocity_rhs, acceleration_rhs;

  bool rigid;
  unsigned rank;
  unsigned mobility;
  std::string reason;
  std::optional<DerivedDeterminant> determinant;    ///< of a rigid model
  std::optional<DerivedElimination> elimination;    ///< of a rigid model
  std::optional<DerivedForces> forces;              ///< of a rigid model
  std::optional<DerivedEigenproblem> eigenproblem;  ///< of a group of more than four links
};

/// The derivation of the model of `kind`.
[[nodiscard]] Derivation derive(const structure::Group& group, const structure::Kind& kind);
/// The derivation of a group of more than four links with this number of complex configurations,
/// and the eliminations that find them, of which the first is written out.
[[nodiscard]] Derivation derive(const structure::Model& model, int configurations,
                                const std::vector<loops::Elimination>& eliminations);

}  // namespace assur::generator::document
