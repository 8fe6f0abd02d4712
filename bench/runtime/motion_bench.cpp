// Times all sensitivities, velocity and acceleration of an RRR-RRR tetrad over the same 10,000
// configurations in one run, by generated code and by fixed-size Eigen from angles; and the
// generated function of every model of every group.
#include <benchmark/benchmark.h>

#include <Eigen/LU>
#include <assur/dyad/models.hpp>
#include <assur/kinematics.hpp>
#include <assur/tetrad/models.hpp>
#include <assur/triad/models.hpp>
#include <random>
#include <string>
#include <vector>

namespace {

constexpr int sample_count = 10000;
constexpr unsigned seed = 1618;

using assur::tetrad::Model01;

template <typename Model>
struct Sample {
  typename Model::template Dimensions<double> d;
  typename Model::template Inputs<double> u;
  typename Model::template Configuration<double> q;
  assur::Vector<double, Model::input_count> u_rate, u_second_rate;
};

/// Random configurations; the linear equations can be solved whether or not the loops close.
template <typename Model>
const std::vector<Sample<Model>>& samples() {
  static const std::vector<Sample<Model>> list = [] {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> length(0.5, 2);
    std::uniform_real_distribution<double> angle(-3.14159, 3.14159);
    const auto fill = [&](auto& member) {
      if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
        member = length(engine);
      } else {
        member = assur::direction_of(angle(engine));
      }
    };
    std::vector<Sample<Model>> made(sample_count);
    for (Sample<Model>& sample : made) {
      std::apply([&](auto&... member) { (fill(member), ...); }, sample.d.members());
      std::apply([&](auto&... member) { (fill(member), ...); }, sample.u.members());
      std::apply([&](auto&... member) { (fill(member), ...); }, sample.q.members());
      for (int index = 0; index < Model::input_count; ++index) {
        sample.u_rate(index) = length(engine);
        sample.u_second_rate(index) = length(engine);
      }
    }
    return made;
  }();
  return list;
}

/// Runs `evaluate` over the samples in turn.
template <typename List, typename Evaluate>
void over(benchmark::State& state, const List& list, Evaluate evaluate) {
  std::size_t next = 0;
  for (auto _ : state) {
    evaluate(list[next]);
    next = next + 1 == list.size() ? 0 : next + 1;
  }
}

template <typename Model>
struct Answer {
  assur::Sensitivities<Model, double> sensitive;
  assur::Motion<Model, double> moving;
};

template <typename Model>
void generated(benchmark::State& state) {
  over(state, samples<Model>(), [](const Sample<Model>& sample) {
    Answer<Model> answer;
    Model::sensitivities_and_motion(sample.d, sample.u, sample.q, sample.u_rate,
                                    sample.u_second_rate, answer.sensitive.to_dimensions,
                                    answer.sensitive.to_inputs, answer.moving.velocity,
                                    answer.moving.acceleration);
    benchmark::DoNotOptimize(answer);
  });
}

template <typename Model>
void generated_with_status(benchmark::State& state) {
  over(state, samples<Model>(), [](const Sample<Model>& sample) {
    Answer<Model> answer;
    benchmark::DoNotOptimize(assur::sensitivities_and_motion<Model, double>(
        sample.d, sample.u, sample.q, sample.u_rate, sample.u_second_rate, answer.sensitive,
        answer.moving));
    benchmark::DoNotOptimize(answer);
  });
}

/// The angles and lengths of an RRR-RRR tetrad as an engineer's own program would hold them.
struct AngleSample {
  Eigen::Vector4d theta;  // BCG, EDF, CD, GF
  Model01::Dimensions<double> d;
  Eigen::Vector4d u_rate, u_second_rate;
};

const std::vector<AngleSample>& angle_samples() {
  static const std::vector<AngleSample> list = [] {
    std::vector<AngleSample> made;
    for (const Sample<Model01>& sample : samples<Model01>()) {
      const auto& q = sample.q;
      made.push_back({{assur::angle_of(q.theta_BCG), assur::angle_of(q.theta_EDF),
                       assur::angle_of(q.theta_CD), assur::angle_of(q.theta_GF)},
                      sample.d,
                      sample.u_rate,
                      sample.u_second_rate});
    }
    return made;
  }();
  return list;
}

/// The same equations written out by hand, solved by Eigen's LU with partial pivoting.
template <bool write_out_only>
void eigen_from_angles(benchmark::State& state) {
  over(state, angle_samples(), [](const AngleSample& sample) {
    const auto& d = sample.d;
    Eigen::Vector4d c;
    Eigen::Vector4d s;
    for (int index = 0; index < 4; ++index) {
      c(index) = std::cos(sample.theta(index));
      s(index) = std::sin(sample.theta(index));
    }
    const auto turned = [&](int link, double x, double y) {
      return Eigen::Vector2d(c(link) * x - s(link) * y, s(link) * x + c(link) * y);
    };
    const Eigen::Vector2d BC = turned(0, d.BC, 0);
    const Eigen::Vector2d BG = turned(0, d.x_G_BCG, d.y_G_BCG);
    const Eigen::Vector2d ED = turned(1, d.ED, 0);
    const Eigen::Vector2d EF = turned(1, d.x_F_EDF, d.y_F_EDF);
    const Eigen::Vector2d CD = turned(2, d.CD, 0);
    const Eigen::Vector2d GF = turned(3, d.GF, 0);
    Eigen::Matrix4d J;
    J << -BC.y(), ED.y(), -CD.y(), 0,  //
        BC.x(), -ED.x(), CD.x(), 0,    //
        -BG.y(), EF.y(), 0, -GF.y(),   //
        BG.x(), -EF.x(), 0, GF.x();
    Eigen::Matrix<double, 4, 12> F;
    F << c(0), 0, 0, -c(1), 0, 0, c(2), 0, 1, 0, -1, 0,        //
        s(0), 0, 0, -s(1), 0, 0, s(2), 0, 0, 1, 0, -1,         //
        0, c(0), -s(0), 0, -c(1), s(1), 0, c(3), 1, 0, -1, 0,  //
        0, s(0), c(0), 0, -s(1), -c(1), 0, s(3), 0, 1, 0, -1;
    if constexpr (write_out_only) {
      benchmark::DoNotOptimize(J);
      benchmark::DoNotOptimize(F);
      return;
    }
    const Eigen::PartialPivLU<Eigen::Matrix4d> factors(J);
    const Eigen::Matrix<double, 4, 12> S = factors.solve(-F);
    const Eigen::Vector4d velocity = S.rightCols<4>() * sample.u_rate;
    const Eigen::Vector4d w = velocity.cwiseAbs2();
    const Eigen::Vector2d a = sample.u_second_rate.head<2>() - sample.u_second_rate.tail<2>();
    Eigen::Vector4d rhs;
    rhs << BC * w(0) + CD * w(2) - ED * w(1) - a, BG * w(0) + GF * w(3) - EF * w(1) - a;
    const Eigen::Vector4d acceleration = factors.solve(rhs);
    benchmark::DoNotOptimize(S);
    benchmark::DoNotOptimize(velocity);
    benchmark::DoNotOptimize(acceleration);
  });
}

template <typename Model>
void register_model() {
  if constexpr (Model::rigid) {
    const std::string name = std::string(Model::group) + "_" + std::to_string(Model::number);
    benchmark::RegisterBenchmark(("generated/" + name).c_str(), generated<Model>);
  }
}

template <typename... Models>
void register_models(std::tuple<Models...>) {
  (register_model<Models>(), ...);
}

BENCHMARK(generated<Model01>);
BENCHMARK(generated_with_status<Model01>);
BENCHMARK(eigen_from_angles<false>);
BENCHMARK(eigen_from_angles<true>);

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  register_models(assur::dyad::Models());
  register_models(assur::triad::Models());
  register_models(assur::tetrad::Models());
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
