// Measures growth: time per configuration over the groups of a chain, emission time and size over
// the number of models, compile time of a generated header. Writes growth.json, .md and .dat into a
// directory: growth DIRECTORY.
#include <benchmark/benchmark.h>

#include <assur/assembly.hpp>
#include <assur/dyad/model_01.hpp>
#include <assur/tetrad/model_01.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>
#include <vector>

namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

template <typename Measure>
double median_of(int repetitions, Measure measure) {
  std::vector<double> values;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    values.push_back(measure());
  }
  std::nth_element(values.begin(), values.begin() + repetitions / 2, values.end());
  return values[static_cast<std::size_t>(repetitions / 2)];
}

/// Groups in a row: each is joined to the one before and to the base. One configuration of each is
/// taken, and all derivatives of the group are computed.
template <typename Model>
class Chain {
 public:
  explicit Chain(std::size_t groups) {
    std::mt19937 engine(14142);
    const auto draw = [&engine](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(engine);
    };
    Point held{0.3, 0.2};
    while (links_.size() < groups) {
      Link link;
      std::apply([&](auto&... member) { ((member = draw(-2, 2)), ...); }, link.d.members());
      link.base = {held.x + draw(-1, 1), held.y + draw(-1, 1)};
      const auto found = assur::assemblies<Model>(link.d, inputs(held, link.base));
      if (found.count == 0) {
        continue;
      }
      held = hung_on(held, link, found.configurations[0]);
      links_.push_back(link);
    }
  }

  [[nodiscard]] double configuration() const {
    Point held{0.3, 0.2};
    const assur::Vector<double, Model::input_count> rate =
        assur::Vector<double, Model::input_count>::Constant(0.1);
    for (const Link& link : links_) {
      const auto u = inputs(held, link.base);
      const auto found = assur::assemblies<Model>(link.d, u);
      const auto& q = found.configurations[0];
      assur::Sensitivities<Model, double> sensitive;
      assur::Motion<Model, double> moving;
      auto status = assur::sensitivities_and_motion<Model, double>(link.d, u, q, rate, rate,
                                                                   sensitive, moving);
      benchmark::DoNotOptimize(status);
      benchmark::DoNotOptimize(sensitive);
      benchmark::DoNotOptimize(moving);
      held = hung_on(held, link, q);
    }
    return held.x;
  }

 private:
  struct Point {
    double x, y;
  };
  struct Link {
    typename Model::template Dimensions<double> d;
    Point base;
  };

  static typename Model::template Inputs<double> inputs(const Point& held, const Point& base) {
    return {held.x, held.y, base.x, base.y};
  }
  /// The origin of the group's last link.
  static Point hung_on(const Point& held, const Link& link,
                       const typename Model::template Configuration<double>& q) {
    assur::Poses<double, Model::link_count> poses;
    Model::link_poses(link.d, inputs(held, link.base), q, poses);
    return {poses.back().x, poses.back().y};
  }

  std::vector<Link> links_;
};

template <typename Model>
Json chain_rows(const std::string& kind) {
  Json rows = Json::array();
  for (std::size_t groups = 1; groups <= 64; groups *= 2) {
    const Chain<Model> chain(groups);
    const int evaluations = static_cast<int>(4096 / groups);
    const double seconds = median_of(15, [&] {
      const auto start = Clock::now();
      for (int evaluation = 0; evaluation < evaluations; ++evaluation) {
        double end = chain.configuration();
        benchmark::DoNotOptimize(end);
      }
      return seconds_since(start);
    });
    rows.push_back(
        {{"kind", kind}, {"groups", groups}, {"ns", std::round(1e9 * seconds / evaluations)}});
  }
  return rows;
}

std::string run(const std::string& command) {
  if (std::system((command + " > /dev/null").c_str()) != 0) {
    throw std::runtime_error("failed: " + command);
  }
  return command;
}

double rounded(double value) { return std::round(1000 * value) / 1000; }

/// Models 1 to n of the tetrad, one after the other.
Json emission_rows(const std::filesystem::path& scratch) {
  Json rows = Json::array();
  double seconds = 0;
  std::uintmax_t bytes = 0;
  for (int model = 1; model <= 24; ++model) {
    seconds += median_of(3, [&] {
      const auto start = Clock::now();
      run(std::string(ASSUR_COMMAND) + " emit --group tetrad --model " + std::to_string(model) +
          " --output " + scratch.string());
      return seconds_since(start);
    });
    const std::string number = (model < 10 ? "0" : "") + std::to_string(model);
    bytes +=
        std::filesystem::file_size(scratch / "assur" / "tetrad" / ("model_" + number + ".hpp"));
    rows.push_back({{"models", model}, {"seconds", rounded(seconds)}, {"bytes", bytes}});
  }
  return rows;
}

/// A program that calls every user function of one model, and one that only includes its header.
Json compile_rows(const std::filesystem::path& scratch) {
  const auto compile = [&](const std::string& text) {
    const std::filesystem::path source = scratch / "compiled.cpp";
    const std::filesystem::path object = scratch / "compiled.o";
    std::ofstream(source) << text;
    const double seconds = median_of(3, [&] {
      const auto start = Clock::now();
      run(std::string(ASSUR_COMPILER) +
          " -std=c++17 -O2 -I" ASSUR_RUNTIME " -I" ASSUR_GENERATED " -isystem " ASSUR_EIGEN " -c " +
          source.string() + " -o " + object.string());
      return seconds_since(start);
    });
    return std::pair(rounded(seconds), std::filesystem::file_size(object));
  };
  Json rows = Json::array();
  const auto add = [&](const std::string& what, const std::string& text) {
    const auto [seconds, bytes] = compile(text);
    rows.push_back({{"what", what}, {"seconds", seconds}, {"bytes", bytes}});
  };
  add("Eigen's Core and LU alone", "#include <Eigen/LU>\n");
  add("the runtime and model 1, included",
      "#include <assur/assembly.hpp>\n#include <assur/tetrad/model_01.hpp>\n");
  for (const char* model : {"01", "04", "15"}) {
    const std::string name = "assur::tetrad::Model" + std::string(model);
    const std::string header = "#include <assur/assembly.hpp>\n#include <assur/tetrad/model_" +
                               std::string(model) + ".hpp>\nusing M = " + name + ";\n";
    add("model " + std::to_string(std::stoi(model)) + ", sensitivities and motion",
        "#include <assur/kinematics.hpp>\n" + header +
            "template assur::Status assur::sensitivities_and_motion<M, double>(const "
            "M::Dimensions<double>&, const M::Inputs<double>&, const M::Configuration<double>&, "
            "const assur::Vector<double, M::input_count>&, const assur::Vector<double, "
            "M::input_count>&, assur::Sensitivities<M, double>&, assur::Motion<M, double>&);\n");
    add("model " + std::to_string(std::stoi(model)) + ", all configurations",
        header +
            "template assur::Assemblies<M> assur::assemblies<M>(const "
            "M::Dimensions<double>&, const M::Inputs<double>&, const "
            "assur::support::Displacement&);\n");
  }
  return rows;
}

/// Writes an array of flat objects as a table.
void write_table(const Json& rows, std::ostream& out) {
  std::string line = "|";
  out << "|";
  for (const auto& [key, value] : rows.front().items()) {
    out << ' ' << key << " |";
    line += "---|";
  }
  out << '\n' << line << '\n';
  for (const Json& row : rows) {
    out << "|";
    for (const auto& [key, value] : row.items()) {
      out << ' ' << (value.is_string() ? value.get<std::string>() : value.dump()) << " |";
    }
    out << '\n';
  }
  out << '\n';
}

/// Writes the numbers of each table as a block.
void write_columns(const Json& rows, std::ostream& out) {
  for (const Json& row : rows) {
    for (const auto& [key, value] : row.items()) {
      if (value.is_number()) {
        out << value.dump() << ' ';
      }
    }
    out << '\n';
  }
  out << "\n\n";
}

void measure(const std::filesystem::path& directory) {
  const std::filesystem::path scratch = directory / "growth";
  std::filesystem::create_directories(scratch);
  struct Table {
    const char* name;
    const char* caption;
    Json rows;
  };
  const std::vector<Table> tables = {
      {"chain_of_dyads", "Dyads RRR in a chain:", chain_rows<assur::dyad::Model01>("RRR")},
      {"chain_of_tetrads",
       "Tetrads RRR-RRR in a chain:", chain_rows<assur::tetrad::Model01>("RRR-RRR")},
      {"emission", "Emission of the first models of the tetrad:", emission_rows(scratch)},
      {"compilation",
       "Compilation of one file, and the bytes of its object:", compile_rows(scratch)}};
  std::filesystem::remove_all(scratch);
  Json all;
  std::ofstream markdown(directory / "growth.md");
  std::ofstream columns(directory / "growth.dat");
  for (const Table& table : tables) {
    all[table.name] = table.rows;
    markdown << table.caption << "\n\n";
    write_table(table.rows, markdown);
    write_columns(table.rows, columns);
  }
  std::ofstream(directory / "growth.json") << all.dump(1) << '\n';
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: growth DIRECTORY\n";
    return 2;
  }
  try {
    measure(arguments[1]);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 2;
  }
}
