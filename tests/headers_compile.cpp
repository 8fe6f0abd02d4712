// Compiles every generated model as C++17 with a project's strictest warnings; there is no more to
// it than the includes and one use of each function.
#include <assur/assembly.hpp>
#include <assur/dyad/models.hpp>
#include <assur/kinematics.hpp>
#include <assur/normal_form.hpp>
#include <assur/placed_group.hpp>
#include <assur/second_order.hpp>
#include <assur/singularity.hpp>
#include <assur/solved_by_lu.hpp>
#include <assur/special_points.hpp>
#include <assur/tetrad/models.hpp>
#include <assur/tracking.hpp>
#include <assur/triad/models.hpp>

static_assert(std::tuple_size_v<assur::dyad::Models> == 6);
static_assert(std::tuple_size_v<assur::triad::Models> == 20);
static_assert(std::tuple_size_v<assur::tetrad::Models> == 24);
