// Packs: arithmetic on several numbers at once.
#pragma once

#include <Eigen/Core>
#include <array>
#include <assur/numeric/precision.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace assur::numeric {

/// The compiler's vector type, available with or without vector instructions, and the type of as
/// many integers of the same size.
template <typename Scalar, std::size_t Lanes>
struct SideBySide {
  /// The alignment of entries in Eigen's matrices: 16 bytes without AVX, however many lanes there
  /// are. Compilers rely on the alignment that a type asks for, so it must not ask for more.
  static constexpr std::size_t alignment = Lanes * sizeof(Scalar) < EIGEN_MAX_ALIGN_BYTES
                                               ? Lanes * sizeof(Scalar)
                                               : EIGEN_MAX_ALIGN_BYTES;
  using Type [[gnu::vector_size(Lanes * sizeof(Scalar)), gnu::aligned(alignment)]] = Scalar;
  /// The same numbers at an address of any alignment.
  struct [[gnu::packed, gnu::may_alias]] Anywhere {
    Type numbers;
  };
  using Integers = decltype(Type() < Type());
};

/// The truth of a comparison for each number of a pack (all bits set if it holds, none if not). As
/// a bool, whether it holds for all of them.
template <typename Scalar, std::size_t Lanes>
class PackTruth {
  using Integers = typename SideBySide<Scalar, Lanes>::Integers;
  Integers holds_{};

 public:
  PackTruth() = default;
  explicit PackTruth(const Integers& holds) : holds_(holds) {}

  [[nodiscard]] bool operator[](std::size_t lane) const { return holds_[lane] != 0; }
  explicit operator bool() const {
    if constexpr (Lanes == 2) {
      return (holds_[0] & holds_[1]) != 0;
    }
    return bits() == (1U << Lanes) - 1;
  }
  /// Whether it holds for at least one of them.
  [[nodiscard]] bool any() const { return bits() != 0; }
  /// A bit for each of them; that of the first is the lowest.
  [[nodiscard]] unsigned bits() const {
#if defined(__AVX512DQ__)
    if constexpr (sizeof(Scalar) == 8 && Lanes == 8) {
      return _mm512_movepi64_mask(reinterpret_cast<__m512i>(holds_));
    }
#endif
#if defined(__AVX__)
    if constexpr (sizeof(Scalar) == 8 && Lanes == 4) {
      return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(holds_)));
    }
#endif
    unsigned result = 0;
    for (std::size_t lane = 0; lane < Lanes; ++lane) {
      // In one expression GCC 12 with sanitized shifts reads the lane before it is set.
      const unsigned holds = holds_[lane] < 0 ? 1U : 0U;
      result |= holds << lane;
    }
    return result;
  }
  /// Minus one where it holds, zero where it does not.
  [[nodiscard]] const Integers& integers() const { return holds_; }

  friend PackTruth operator&(const PackTruth& a, const PackTruth& b) {
    return PackTruth(a.holds_ & b.holds_);
  }
  friend PackTruth operator|(const PackTruth& a, const PackTruth& b) {
    return PackTruth(a.holds_ | b.holds_);
  }
  friend PackTruth operator!=(const PackTruth& a, const PackTruth& b) {
    return PackTruth(a.holds_ ^ b.holds_);
  }
  friend PackTruth operator!(const PackTruth& a) { return PackTruth(~a.holds_); }
};

/// For each choice of four doubles, the order of their halves that has the chosen ones in front.
struct HalvesInFront {
  alignas(32) std::array<std::array<int, 8>, 16> order{};
  constexpr HalvesInFront() {
    for (unsigned which = 0; which < 16; ++which) {
      std::size_t place = 0;
      for (int lane = 0; lane < 4; ++lane) {
        if ((which >> lane & 1) != 0) {
          order[which][place++] = 2 * lane;
          order[which][place++] = 2 * lane + 1;
        }
      }
    }
  }
};
inline constexpr HalvesInFront halves_in_front;

/// Several numbers processed at once. A comparison is false in lanes in which an operand is NaN.
template <typename Scalar, std::size_t Lanes>
class PackOf {
  using Numbers = typename SideBySide<Scalar, Lanes>::Type;
  using Anywhere = typename SideBySide<Scalar, Lanes>::Anywhere;
  using Integers = typename SideBySide<Scalar, Lanes>::Integers;
  using Truth = PackTruth<Scalar, Lanes>;
  Numbers numbers_;

  explicit PackOf(const Numbers& numbers) : numbers_(numbers) {}
  template <std::size_t... Lane>
  PackOf(Scalar one, std::index_sequence<Lane...>) : numbers_{(static_cast<void>(Lane), one)...} {}
  template <std::size_t... Lane>
  [[nodiscard]] static PackOf counted(Scalar from, std::index_sequence<Lane...>) {
    return PackOf(Numbers{from + Scalar(Lane)...});
  }
  template <std::size_t... Lane>
  [[nodiscard]] static PackOf gather(const Scalar* from, const std::array<std::size_t, Lanes>& at,
                                     std::index_sequence<Lane...>) {
    return PackOf(Numbers{from[at[Lane]]...});
  }
  template <typename Function>
  [[nodiscard]] static PackOf by_lanes(PackOf a, const Function& function) {
    for (std::size_t lane = 0; lane < Lanes; ++lane) {
      a.numbers_[lane] = function(a.numbers_[lane]);
    }
    return a;
  }

 public:
  static constexpr std::size_t lanes = Lanes;

  PackOf() = default;
  PackOf(Scalar one) : PackOf(one, std::make_index_sequence<Lanes>()) {}
  PackOf(Scalar first, Scalar second) : numbers_{first, second} {
    static_assert(Lanes == 2, "a pack of two has a first and a second");
  }
  /// A constant of generated code.
  template <
      typename Number,
      std::enable_if_t<std::is_same_v<Number, double> && !std::is_same_v<Scalar, double>, int> = 0>
  PackOf(Number one) : PackOf(static_cast<Scalar>(one)) {}

  /// The numbers from, from + 1, from + 2, ...
  [[nodiscard]] static PackOf counted(Scalar from) {
    return counted(from, std::make_index_sequence<Lanes>());
  }
  /// Consecutive numbers in memory.
  [[nodiscard]] static PackOf load(const Scalar* from) {
    return PackOf(Numbers(reinterpret_cast<const Anywhere*>(from)->numbers));
  }
  /// Numbers at given indices in memory.
  [[nodiscard]] static PackOf gather(const Scalar* from, const std::array<std::size_t, Lanes>& at) {
    return gather(from, at, std::make_index_sequence<Lanes>());
  }
  void store(Scalar* to) const { reinterpret_cast<Anywhere*>(to)->numbers = numbers_; }

  /// Stores the numbers whose bits are set next to each other. Up to `Lanes` numbers from `to` on
  /// are overwritten.
  void store_some(unsigned which, Scalar* to) const {
#if defined(__AVX512VL__) && defined(__AVX512F__)
    if constexpr (sizeof(Scalar) == 8 && Lanes == 8) {
      _mm512_storeu_pd(to, _mm512_maskz_compress_pd(static_cast<__mmask8>(which), numbers_));
      return;
    }
    if constexpr (sizeof(Scalar) == 8 && Lanes == 4) {
      _mm256_storeu_pd(to, _mm256_maskz_compress_pd(static_cast<__mmask8>(which), numbers_));
      return;
    }
#elif defined(__AVX2__)
    if constexpr (sizeof(Scalar) == 8 && Lanes == 4) {
      const __m256i order =
          _mm256_load_si256(reinterpret_cast<const __m256i*>(halves_in_front.order[which].data()));
      _mm256_storeu_ps(reinterpret_cast<float*>(to),
                       _mm256_permutevar8x32_ps(reinterpret_cast<__m256>(numbers_), order));
      return;
    }
#endif
    for (std::size_t lane = 0; lane < Lanes; ++lane) {
      *to = numbers_[lane];
      to += which >> lane & 1;
    }
  }

  [[nodiscard]] Scalar operator[](std::size_t lane) const { return numbers_[lane]; }
  void put(std::size_t lane, Scalar number) { numbers_[lane] = number; }

  friend PackOf operator+(const PackOf& a, const PackOf& b) {
    return PackOf(a.numbers_ + b.numbers_);
  }
  friend PackOf operator-(const PackOf& a, const PackOf& b) {
    return PackOf(a.numbers_ - b.numbers_);
  }
  friend PackOf operator-(const PackOf& a) { return PackOf(-a.numbers_); }
  friend PackOf operator*(const PackOf& a, const PackOf& b) {
    return PackOf(a.numbers_ * b.numbers_);
  }
  friend PackOf operator/(const PackOf& a, const PackOf& b) {
    return PackOf(a.numbers_ / b.numbers_);
  }
  PackOf& operator+=(const PackOf& other) { return *this = *this + other; }
  PackOf& operator*=(const PackOf& other) { return *this = *this * other; }

  // There is no branch, because the choice differs from lane to lane.
  friend PackOf select(const Truth& holds, const PackOf& then, const PackOf& otherwise) {
    return PackOf(holds.integers() ? then.numbers_ : otherwise.numbers_);
  }
  friend PackOf max EIGEN_NOT_A_MACRO(const PackOf& a, const PackOf& b) {
    return PackOf(a.numbers_ < b.numbers_ ? b.numbers_ : a.numbers_);
  }
  friend PackOf min EIGEN_NOT_A_MACRO(const PackOf& a, const PackOf& b) {
    return PackOf(b.numbers_ < a.numbers_ ? b.numbers_ : a.numbers_);
  }
  friend PackOf abs(const PackOf& a) {
    const Numbers sign = PackOf(Scalar(-0.0)).numbers_;
    return PackOf(reinterpret_cast<Numbers>(reinterpret_cast<Integers>(a.numbers_) &
                                            ~reinterpret_cast<Integers>(sign)));
  }
  friend PackOf sqrt(const PackOf& a) {
    Eigen::Array<Scalar, static_cast<int>(Lanes), 1> roots;
    a.store(roots.data());
    roots = roots.sqrt().eval();
    return load(roots.data());
  }
  /// 2^-e of 2^e m, 1 <= m < 2, if both are normal numbers.
  friend PackOf inverse_power_of_two(const PackOf& a) {
    using Limits = std::numeric_limits<Scalar>;
    constexpr int below_exponent = Limits::digits - 1;
    const Integers exponent = reinterpret_cast<Integers>(a.numbers_) >> below_exponent;
    return PackOf(
        reinterpret_cast<Numbers>((2 * (Limits::max_exponent - 1) - exponent) << below_exponent));
  }
  // These are computed lane by lane.
  friend PackOf ceil(const PackOf& a) {
    return by_lanes(a, [](Scalar number) { return std::ceil(number); });
  }
  friend PackOf atan2(PackOf y, const PackOf& x) {
    for (std::size_t lane = 0; lane < Lanes; ++lane) {
      y.numbers_[lane] = std::atan2(y.numbers_[lane], x.numbers_[lane]);
    }
    return y;
  }

  /// A bit for each number, set if it is below zero or minus zero.
  [[nodiscard]] unsigned signs() const {
    return Truth(reinterpret_cast<Integers>(numbers_)).bits();
  }

  friend Truth operator==(const PackOf& a, const PackOf& b) {
    return Truth(a.numbers_ == b.numbers_);
  }
  friend Truth operator<(const PackOf& a, const PackOf& b) {
    return Truth(a.numbers_ < b.numbers_);
  }
  friend Truth operator<=(const PackOf& a, const PackOf& b) {
    return Truth(a.numbers_ <= b.numbers_);
  }
  friend Truth operator>(const PackOf& a, const PackOf& b) { return b < a; }
};

template <typename Scalar, std::size_t Lanes>
struct PartOf<PackOf<Scalar, Lanes>> {
  using Type = Scalar;
};

/// The number of doubles per vector register of the target processor; two if it has none.
#if defined(__AVX512F__)
inline constexpr std::size_t native_lanes = 8;
#elif defined(__AVX__)
inline constexpr std::size_t native_lanes = 4;
#else
inline constexpr std::size_t native_lanes = 2;
#endif

/// No pack has more lanes.
inline constexpr std::size_t most_lanes = 8;

}  // namespace assur::numeric
