// Search for all configurations of several instances of an emitted solver at once; doubtful
// instances are reported.
#pragma once

#include <algorithm>
#include <array>
#include <assur/detail/batch/closed_pack.hpp>
#include <assur/detail/batch/general_block.hpp>
#include <assur/detail/batch/placed_pack.hpp>
#include <assur/numeric/pack.hpp>
#include <assur/numeric/pack_directions.hpp>
#include <assur/support/scene_search.hpp>
#include <cstddef>
#include <tuple>
#include <type_traits>

namespace assur::support {

template <typename Groups>
struct BatchGroups;
template <typename... Group>
struct BatchGroups<std::tuple<Group...>> {
  /// Whether all groups are solved by formula.
  static constexpr bool are_closed = (true && ... && detail::has_closed_form<Specialised<Group>>);
};

/// The search of `Search` for several packs of instances, one instance per lane. An instance is
/// dropped once a result is uncertain: each of its groups must have no configuration, or isolated
/// and regular ones only. `List` receives every configuration by list(pack, placed, lanes), with a
/// bit of `lanes` for each lane that has it, and returns the lanes in which it is uncertain.
template <typename Solver, std::size_t Lanes, typename List>
class BatchSearch {
  using Pack = numeric::PackOf<double, Lanes>;
  using Truth = decltype(Pack() < Pack());
  using Own = Access<Solver, Pack>;
  using Groups = typename Own::Groups;
  using Placed = typename Own::Placed;
  static constexpr std::size_t group_count = std::tuple_size_v<Groups>;

 public:
  /// Arcs are isolated for many groups together; closed formulas need only one pack.
  static constexpr std::size_t packs = BatchGroups<Groups>::are_closed ? 1 : 32 / Lanes;
  using Given = std::array<typename Own::Given, packs>;
  using Sets = std::array<unsigned, packs>;  ///< a bit for each lane of each pack

  explicit BatchSearch(List& list) : list_(list) {}

  /// Searches the instances in the first `count` packs; to be called once. Returns the doubtful
  /// ones.
  [[nodiscard, gnu::flatten]] Sets run(const Given& given, std::size_t count) {
    Sets lanes{};
    for (std::size_t pack = 0; pack < count; ++pack) {
      Own::drive(given[pack], placed_[pack]);
      lanes[pack] = (1U << Lanes) - 1;
    }
    proceed<0>(lanes);
    return unsure_;
  }

 private:
  template <std::size_t Place>
  using GroupAt = std::tuple_element_t<Place, Groups>;
  template <std::size_t Place>
  using HeldAt = HeldJoints<GroupAt<Place>, Pack, Solver::order, Solver::parameter_count>;

  /// Searches the groups from `Place` on; beyond the last, configurations are listed.
  template <std::size_t Place>
  void proceed(const Sets& lanes) {
    if (std::all_of(lanes.begin(), lanes.end(), [](unsigned set) { return set == 0; })) {
      return;
    }
    if constexpr (Place == group_count) {
      for (std::size_t pack = 0; pack < packs; ++pack) {
        if (lanes[pack] != 0) {
          unsure_[pack] |= list_(pack, placed_[pack], lanes[pack]);
        }
      }
    } else if constexpr (Place == 0) {
      descend<Place>(lanes);
    } else {
      descend_apart<Place>(lanes);
    }
  }
  template <std::size_t Place>
  [[gnu::noinline, gnu::flatten]] void descend_apart(const Sets& lanes) {
    descend<Place>(lanes);
  }

  template <std::size_t Place>
  void descend(const Sets& lanes) {
    if constexpr (detail::has_closed_form<Specialised<GroupAt<Place>>>) {
      descend_by_formula<Place>(lanes);
    } else {
      descend_by_isolation<Place>(lanes);
    }
  }

  template <std::size_t Place>
  void descend_by_formula(const Sets& lanes) {
    using Model = Specialised<GroupAt<Place>>;
    using Rounding = detail::batch::DisplacedInputs<Model, Pack>;
    using Found = detail::batch::ClosedPack<Model, Pack, Rounding>;
    std::array<HeldAt<Place>, packs> held;
    std::array<std::array<typename Found::Configuration, Found::root_count>, packs> found;
    Sets assembled{};
    for (std::size_t pack = 0; pack < packs; ++pack) {
      if (packs > 1 && lanes[pack] == 0) {
        continue;
      }
      Own::hold(placed_[pack], held[pack]);
      const Found closed({}, held[pack].u, {held[pack].displaced});
      unsure_[pack] |= lanes[pack] & ~closed.settled.bits();
      assembled[pack] = lanes[pack] & closed.settled.bits() & closed.assembled.bits();
      found[pack] = closed.configurations;
    }
    for (std::size_t index = 0; index < Found::root_count; ++index) {
      Sets next{};
      for (std::size_t pack = 0; pack < packs; ++pack) {
        next[pack] = place<Place>(pack, assembled[pack], held[pack], found[pack][index]);
      }
      proceed<Place + 1>(next);
    }
  }

  template <std::size_t Place>
  void descend_by_isolation(const Sets& lanes) {
    using Model = Specialised<GroupAt<Place>>;
    using Configuration = typename Model::template Configuration<Pack>;
    constexpr auto most = static_cast<std::size_t>(Model::max_configurations);
    std::array<HeldAt<Place>, packs> held;
    std::array<std::array<Configuration, most>, packs> found;
    std::array<Sets, most> having{};
    isolate<Place>(lanes, held, found, having);
    for (std::size_t index = 0; index < most; ++index) {
      Sets next{};
      for (std::size_t pack = 0; pack < packs; ++pack) {
        next[pack] = place<Place>(pack, having[index][pack], held[pack], found[pack][index]);
      }
      proceed<Place + 1>(next);
    }
  }
  /// A separate function, so that its stack frame is released during the deeper search.
  template <std::size_t Place, typename Held, typename Found, typename Having>
  [[gnu::noinline]] void isolate(const Sets& lanes, Held& held, Found& found, Having& having) {
    using Model = Specialised<GroupAt<Place>>;
    detail::batch::GeneralBlock<Model, Lanes> block;
    static_assert(block.capacity >= packs * Lanes);
    block.begin();
    std::array<std::size_t, packs> owner{};
    std::size_t filled = 0;
    for (std::size_t pack = 0; pack < packs; ++pack) {
      if (lanes[pack] != 0) {
        Own::hold(placed_[pack], held[pack]);
        block.add({}, held[pack].u, held[pack].displaced, Lanes * filled);
        owner[filled++] = pack;
      }
    }
    block.search(Lanes * filled);
    for (std::size_t place = 0; place < filled; ++place) {
      const std::size_t pack = owner[place];
      for (std::size_t lane = 0; lane < Lanes; ++lane) {
        const std::size_t group = Lanes * place + lane;
        const unsigned bit = lanes[pack] & 1U << lane;
        if (!block.is_settled(group) || !block.put_in_order(group)) {
          unsure_[pack] |= bit;
          continue;
        }
        for (std::size_t index = 0; index < block.count(group); ++index) {
          having[index][pack] |= bit;
        }
      }
      for (std::size_t index = 0; index < having.size(); ++index) {
        if (having[index][pack] != 0) {
          found[pack][index] = block.configuration(Lanes * place, index);
        }
      }
    }
  }

  /// Places a group in some lanes of a pack. Returns those in which the result is certain.
  template <std::size_t Place, typename Held, typename Configuration>
  [[nodiscard]] unsigned place(std::size_t pack, unsigned lanes, const Held& held,
                               const Configuration& q) {
    lanes &= ~unsure_[pack];
    if (lanes == 0) {
      return 0;
    }
    const detail::batch::PlacedPack<GroupAt<Place>, Pack, Solver::order, Solver::parameter_count>
        at(held, q);
    Own::place(at.group, placed_[pack]);
    const unsigned certain = at.certain.bits();
    unsure_[pack] |= lanes & ~certain;
    return lanes & certain;
  }

  List& list_;
  std::array<Placed, packs> placed_;
  Sets unsure_{};
};

}  // namespace assur::support
