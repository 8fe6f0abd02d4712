// Law: all slips planted in code for the models' own Jacobians are found, entry by entry, and no
// right entry is called wrong: in C++ and MATLAB that are read, in C++, Python, Octave and
// JavaScript that run.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <random>

#include "audit/audit.hpp"
#include "coded_model.hpp"
#include "command/command.hpp"
#include "derivatives/differentiate.hpp"
#include "derivatives/mobility.hpp"
#include "whole_campaign.hpp"

namespace assur::test::slips_test {
namespace {

using namespace generator;
using namespace generator::audit;
using namespace generator::derivatives;
using namespace generator::equations;
using namespace generator::structure;

constexpr unsigned seed = 2016;

bool same(const GiNaC::ex& one, const GiNaC::ex& other) { return (one - other).expand().is_zero(); }

/// One way to get a matrix wrong; the engine chooses the entry. An audit that runs the code names
/// the slip rightly if it says one of the words.
struct Slip {
  const char* name;
  std::vector<const char*> words;
  void (*plant)(const CodedModel&, ExpressionMatrix&, std::mt19937&);
};

GiNaC::ex& entry_that(ExpressionMatrix& matrix, std::mt19937& engine,
                      const std::function<bool(const GiNaC::ex&)>& wanted) {
  std::vector<GiNaC::ex*> fit;
  std::vector<GiNaC::ex*> filled;
  for (std::vector<GiNaC::ex>& row : matrix) {
    for (GiNaC::ex& entry : row) {
      if (!entry.is_zero()) filled.push_back(&entry);
      if (!entry.is_zero() && wanted(entry)) fit.push_back(&entry);
    }
  }
  const std::vector<GiNaC::ex*>& list = fit.empty() ? filled : fit;
  return *list[engine() % list.size()];
}

bool any(const GiNaC::ex&) { return true; }
bool has_terms(const GiNaC::ex& entry) { return GiNaC::is_a<GiNaC::add>(entry.expand()); }

bool has_one_of(const GiNaC::ex& entry, const std::vector<GiNaC::symbol>& symbols) {
  return std::any_of(symbols.begin(), symbols.end(),
                     [&](const GiNaC::symbol& symbol) { return entry.has(symbol); });
}

const std::vector<Slip>& slips() {
  static const std::vector<Slip> list = {
      {"sign",
       {"the sign is wrong"},
       [](const CodedModel&, ExpressionMatrix& matrix, std::mt19937& engine) {
         GiNaC::ex& entry = entry_that(matrix, engine, any);
         entry = -entry;
       }},
      {"exchanged indices",
       {"is exchanged with", "is what should stand at"},
       [](const CodedModel&, ExpressionMatrix& matrix, std::mt19937& engine) {
         GiNaC::ex& one = entry_that(matrix, engine, any);
         const GiNaC::ex value = one;
         GiNaC::ex& other = entry_that(matrix, engine,
                                       [&](const GiNaC::ex& entry) { return !same(entry, value); });
         one.swap(other);
       }},
      {"missing term",
       {"is missing", "always zero", "is left out"},
       [](const CodedModel&, ExpressionMatrix& matrix, std::mt19937& engine) {
         GiNaC::ex& entry = entry_that(matrix, engine, has_terms);
         entry = has_terms(entry) ? entry.expand() - entry.expand().op(0) : GiNaC::ex(0);
       }},
      {"degree for radian",
       {"degree"},
       [](const CodedModel& model, ExpressionMatrix& matrix, std::mt19937& engine) {
         GiNaC::ex& entry = entry_that(matrix, engine, [&](const GiNaC::ex& each) {
           return has_one_of(each, model.angles());
         });
         GiNaC::exmap degrees;
         for (const GiNaC::symbol& angle : model.angles()) {
           degrees[angle] = angle * GiNaC::Pi / 180;
         }
         entry = entry.subs(degrees);
       }},
      {"wrong row",
       {"row"},
       [](const CodedModel&, ExpressionMatrix& matrix, std::mt19937& engine) {
         const std::size_t row = engine() % matrix.size();
         matrix[row] = matrix[(row + 1 + engine() % (matrix.size() - 1)) % matrix.size()];
       }},
      {"transposed",
       {"is transposed"},
       [](const CodedModel&, ExpressionMatrix& matrix, std::mt19937&) {
         const ExpressionMatrix before = matrix;
         for (std::size_t row = 0; row < matrix.size(); ++row) {
           for (std::size_t column = 0; column < matrix.size(); ++column) {
             matrix[row][column] = before[column][row];
           }
         }
       }},
      {"missing factor 2",
       {"1/2 times", "factor 2"},
       [](const CodedModel&, ExpressionMatrix& matrix, std::mt19937& engine) {
         GiNaC::ex& entry = entry_that(matrix, engine, any);
         entry = entry / 2;
       }},
      {"stale derivative",
       {"is missing", "always zero", "is left out", "stands where",
        "is exchanged with"},  // of closures without this length, or with another angle
       [](const CodedModel& model, ExpressionMatrix& matrix, std::mt19937& engine) {
         GiNaC::ex& entry = entry_that(matrix, engine, [&](const GiNaC::ex& each) {
           return has_terms(each) && has_one_of(each, model.lengths());
         });
         for (const GiNaC::symbol& length : model.lengths()) {
           if (entry.has(length)) {
             entry = entry.subs(length == 0);
             return;
           }
         }
         for (const GiNaC::symbol& angle : model.angles()) {
           if (entry.has(angle)) {
             entry = entry.subs(angle == 2 * angle);
             return;
           }
         }
         entry = 0;
       }}};
  return list;
}

/// How a file is audited.
struct AuditedFile {
  const char* id;
  const char* name;
  Written language;
  const char* file;
  bool run;
};

constexpr std::array<AuditedFile, 6> ways = {
    {{"CppRead", "C++, read", Written::cpp, "mine.cpp", false},
     {"MatlabRead", "MATLAB, read", Written::matlab, "fill_it.m", false},
     {"CppRun", "C++, run", Written::cpp, "mine.cpp", true},
     {"PythonRun", "Python, run", Written::python, "mine.py", true},
     {"OctaveRun", "MATLAB, run by Octave", Written::matlab, "fill_it.m", true},
     {"JavaScriptRun", "JavaScript, run", Written::javascript, "mine.js", true}}};

struct Tally {
  std::size_t planted = 0;
  std::size_t found = 0;
  std::size_t named = 0;
  std::size_t right_entries = 0;
  std::size_t false_alarms = 0;
};

std::vector<const Model*> rigid_models() {
  std::vector<const Model*> list;
  for (const Group& group : known_groups()) {
    for (const Model& model : models_of(group)) {
      const ClosureEquations equations = closure_equations(model);
      if (mobility_of(equations, closure_jacobian(equations)).rigid) {
        list.push_back(&model);
      }
    }
  }
  return list;
}

/// Audits one version of a model's code, and adds the answers for all entries to the tally.
void audit_version(const CodedModel& model, const ExpressionMatrix& version, const AuditedFile& way,
                   const std::string& what, const std::vector<const char*>& words, Tally& tally) {
  const TemporaryDirectory directory;
  directory.write(way.file, model.code(version, way.language));
  const std::string file = directory.write("mine.audit", model.audit(way.file, way.run)).string();
  RunPermission permission;
  permission.given = true;
  permission.limits.seconds = 60;  // other work may share the machine
  const AuditReport report = audit_file(file, {}, permission);
  ASSERT_EQ(report.statements.size(), 1U);
  const std::vector<Finding>& findings = report.statements[0].findings;
  ASSERT_EQ(findings.size(), version.size() * version.size());
  bool all_found = true;
  bool planted = false;
  std::string notes;
  for (std::size_t place = 0; place < findings.size(); ++place) {
    const std::size_t row = place / version.size();
    const std::size_t column = place % version.size();
    const bool right = same(version[row][column], model.jacobian()[row][column]);
    planted = planted || !right;
    all_found = all_found && (right || !findings[place].agrees());
    notes += findings[place].note + "\n";
    tally.right_entries += right ? 1 : 0;
    tally.false_alarms += right && !findings[place].agrees() ? 1 : 0;
    EXPECT_EQ(findings[place].agrees(), right)
        << way.name << ", " << what << ": " << findings[place].item << " "
        << findings[place].printed << " | " << findings[place].derived << " "
        << findings[place].comparison.evidence;
  }
  tally.planted += planted ? 1 : 0;
  tally.found += planted && all_found ? 1 : 0;
  const bool named = std::any_of(words.begin(), words.end(), [&](const char* word) {
    return notes.find(word) != std::string::npos;
  });
  tally.named += planted && named ? 1 : 0;
  if (planted && way.run && !named) {
    std::cout << way.name << ", " << what << ", is not named: " << notes;
  }
}

class PlantedSlips : public testing::TestWithParam<AuditedFile> {};

TEST_P(PlantedSlips, AreAllFoundAndNothingElse) {
  const AuditedFile& way = GetParam();
  const bool whole = is_whole_campaign();
  const std::vector<const Model*> models = rigid_models();
  ASSERT_GE(models.size(), 20U);
  Tally tally;
  // By default each way has a few slips of a few models, among which every slip occurs.
  std::size_t turn = 0;
  const auto taken = [&] { return whole || ++turn % 37 == 0; };
  for (std::size_t number = 0; number < models.size(); ++number) {
    const CodedModel model(*models[number]);
    const std::string what =
        models[number]->group->name() + " " + std::to_string(models[number]->number) + ", ";
    if (taken()) {
      audit_version(model, model.jacobian(), way, what + "right", {}, tally);
    }
    for (const Slip& slip : slips()) {
      std::mt19937 engine(seed + static_cast<unsigned>(number));
      if (taken()) {
        ExpressionMatrix version = model.jacobian();
        slip.plant(model, version, engine);
        audit_version(model, version, way, what + slip.name, slip.words, tally);
      }
    }
  }
  std::cout << way.name << ": " << tally.found << " of " << tally.planted << " slips found, "
            << tally.named << " named rightly, " << tally.false_alarms << " false alarms in "
            << tally.right_entries << " right entries, " << models.size() << " models, seed "
            << seed << '\n';
  EXPECT_EQ(tally.found, tally.planted);
  EXPECT_EQ(tally.false_alarms, 0U);
  EXPECT_GE(tally.planted, whole ? 8 * models.size() - 10 : 8);
}

/// The ways whose language is installed; configuring says when Octave or Node is not.
std::vector<AuditedFile> installed_ways() {
  std::vector<AuditedFile> installed(std::begin(ways), std::end(ways));
  if (!ASSUR_OCTAVE) {
    std::erase_if(installed, [](const AuditedFile& way) {
      return way.run && way.language == Written::matlab;
    });
  }
  if (!ASSUR_NODE) {
    std::erase_if(installed,
                  [](const AuditedFile& way) { return way.language == Written::javascript; });
  }
  return installed;
}

INSTANTIATE_TEST_SUITE_P(Ways, PlantedSlips, testing::ValuesIn(installed_ways()),
                         [](const auto& tested) { return std::string(tested.param.id); });

}  // namespace
}  // namespace assur::test::slips_test
