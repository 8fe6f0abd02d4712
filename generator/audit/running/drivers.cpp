#include "audit/running/drivers.hpp"

namespace assur::generator::audit::running {

namespace {

/// The text with every `@NAME@` replaced.
std::string filled(std::string text,
                   const std::vector<std::pair<std::string, std::string>>& values) {
  for (const auto& [name, value] : values) {
    const std::string mark = "@" + name + "@";
    for (std::size_t at = text.find(mark); at != std::string::npos;
         at = text.find(mark, at + value.size())) {
      text.replace(at, mark.size(), value);
    }
  }
  return text;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char letter : text) {
    result += letter == '"' || letter == '\\' ? "\\" : "";
    result += letter == '\n' ? "\\n" : std::string(1, letter);
  }
  return result + "\"";
}

/// A `before` line ends as a statement does.
std::string lines(const std::vector<std::string>& statements, const std::string& indent,
                  const std::string& end) {
  std::string text;
  for (const std::string& statement : statements) {
    text += indent + statement + end + "\n";
  }
  return text;
}

/// What C and C++ have in common: the loop over the points.
const std::string c_main = R"(
#include <stdio.h>
#include <stdlib.h>
static void assur_complain(const char* what, int rows, int columns) {
  FILE* out = fopen("complaint", "w");
  if (out != NULL) {
    fprintf(out, what, rows, columns);
    fclose(out);
  }
  exit(3);
}
@compute@
int main(void) {
  FILE* in = fopen("points", "r");
  FILE* out = fopen("values", "w");
  static double quantities[@count@ + 1];
  static double entries[@rows@ * @columns@];
  if (in == NULL || out == NULL) {
    return 4;
  }
  for (;;) {
    for (int at = 0; at < @count@; ++at) {
      if (fscanf(in, "%lf", &quantities[at]) != 1) {
        return 0;
      }
    }
    if (fscanf(in, " ;") == EOF) {
      return 0;
    }
    assur_compute(quantities, entries);
    for (int at = 0; at < @rows@ * @columns@; ++at) {
      fprintf(out, "%.17g ", entries[at]);
    }
    fprintf(out, "\n");
    fflush(out);
  }
}
)";

const std::string cpp_compute = R"(
#include <type_traits>
#include <utility>
namespace assur_audit {
template <int N>
struct Rank : Rank<N - 1> {};
template <>
struct Rank<0> {};
template <class M>
struct @unclear@ : std::false_type {};

template <class M>
auto check(const M& m, Rank<3>) -> decltype(m.rows() + m.cols(), void()) {
  if (m.rows() != @rows@ || m.cols() != @columns@) {
    assur_complain("%d by %d", static_cast<int>(m.rows()), static_cast<int>(m.cols()));
  }
}
template <class M>
auto check(const M& m, Rank<2>) -> decltype(m[0].size(), void()) {
  for (const auto& row : m) {
    if (m.size() != @rows@ || row.size() != @columns@) {
      assur_complain("%d by %d", static_cast<int>(m.size()), static_cast<int>(row.size()));
    }
  }
  if (m.size() == 0) {
    assur_complain("%d by %d", 0, 0);
  }
}
template <class M>
auto check(const M& m, Rank<1>) -> decltype(m.size(), void()) {
  if (m.size() != @rows@ * @columns@) {
    assur_complain("a list of %d entries", static_cast<int>(m.size()), 0);
  }
}
template <class M>
void check(const M&, Rank<0>) {
  using Plain = std::remove_reference_t<M>;
  if constexpr (std::rank_v<Plain> == 2) {
    if (std::extent_v<Plain> != @rows@ || std::extent_v<Plain, 1> != @columns@) {
      assur_complain("%d by %d", static_cast<int>(std::extent_v<Plain>),
                     static_cast<int>(std::extent_v<Plain, 1>));
    }
  }
}

template <class M>
auto entry(M& m, int i, int j, Rank<3>) -> decltype(static_cast<double>(m(i, j))) {
  return static_cast<double>(m(i, j));
}
template <class M>
auto entry(M& m, int i, int j, Rank<2>) -> decltype(static_cast<double>(m[i][j])) {
  return static_cast<double>(m[i][j]);
}
template <class M>
auto entry(M& m, int i, int j, Rank<1>) -> decltype(static_cast<double>(m[i])) {
  static_assert(@rows@ == 1 || @columns@ == 1 || @unclear@<M>::value, "@unclear@");
  return static_cast<double>(m[i + j]);
}
template <class M>
double entry(M& m, int, int, Rank<0>) {
  if constexpr (@rows@ * @columns@ == 1 && std::is_arithmetic_v<M>) {
    return static_cast<double>(m);
  } else {
    static_assert(@unclear@<M>::value, "@unclear@");
    return 0;
  }
}
}  // namespace assur_audit
static void assur_compute(double* assur_quantities, double* assur_entries) {
@quantities@@before@  auto&& result = @result@;
@check@  for (int i = 0; i < @rows@; ++i) {
    for (int j = 0; j < @columns@; ++j) {
      assur_entries[i * @columns@ + j] = static_cast<double>(@entry@);
    }
  }
}
)";

const std::string c_compute = R"(
static void assur_compute(double* assur_quantities, double* assur_entries) {
@quantities@@before@  __auto_type result = (@result@);
  for (int i = 0; i < @rows@; ++i) {
    for (int j = 0; j < @columns@; ++j) {
      assur_entries[i * @columns@ + j] = (double)(@entry@);
    }
  }
}
)";

const std::string python = R"(import importlib.util
import os
import sys

def complain(what):
    with open(os.path.join(here, "complaint"), "w", encoding="utf-8") as out:
        out.write(what)
    os._exit(3)

def rows_of(result):
    if hasattr(result, "tolist"):
        result = result.tolist()
    if not hasattr(result, "__len__"):
        result = [result]
    result = list(result)
    if all(hasattr(row, "__len__") for row in result):
        sizes = sorted({len(row) for row in result} or {0})
        if len(result) != @rows@ or sizes != [@columns@]:
            complain("%d by %s" % (len(result), " or ".join(map(str, sizes))))
        return [list(row) for row in result]
    if len(result) != @rows@ * @columns@:
        complain("a list of %d entries" % len(result))
    if @rows@ > 1 and @columns@ > 1:
        complain("@unclear@")
    return [[one] for one in result] if @columns@ == 1 else [result]

here = os.getcwd()
try:
    sys.path.insert(0, os.path.dirname(@file@))
    spec = importlib.util.spec_from_file_location("audited", @file@)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    with open("points", encoding="ascii") as points, open("values", "w", encoding="ascii") as out:
        for line in points:
            scope = dict(vars(module))
            scope.update(zip([@names@], map(float, line.split(";")[0].split())))
            exec(@before@, scope)
            scope["result"] = eval(@result@, scope)
            if @entry@:
                rows = [[eval(@entry@, dict(scope, i=i, j=j)) for j in range(@columns@)]
                        for i in range(@rows@)]
            else:
                rows = rows_of(scope["result"])
            out.write(" ".join("%.17g" % float(one) for row in rows for one in row) + "\n")
            out.flush()
except BaseException as error:
    complain("!%s: %s" % (type(error).__name__, " ".join(str(error).split())[:300]))
)";

const std::string octave = R"(1;
function complain(what)
  out = fopen("complaint", "w");
  fputs(out, what);
  fclose(out);
  exit(3);
end
function values = compute(assur_quantities)
@quantities@@before@  result = @result@;
@check@  values = zeros(1, @rows@ * @columns@);
  for i = 1:@rows@
    for j = 1:@columns@
      values((i - 1) * @columns@ + j) = double(@entry@);
    end
  end
end
try
  addpath(fileparts(@file@));
  in = fopen("points", "r");
  out = fopen("values", "w");
  while ischar(line = fgetl(in))
    values = compute(sscanf(strtok(line, ";"), "%f"));
    fprintf(out, "%.17g ", values);
    fprintf(out, "\n");
    fflush(out);
  end
catch error
  complain(["!" regexprep(error.message, '\s+', ' ')]);
end
)";

std::string cpp_driver(const UserProgram& program, const std::vector<std::string>& names) {
  const bool cpp = program.language == Language::cpp;
  std::string quantities = "  (void)assur_quantities;\n";
  for (std::size_t at = 0; at < names.size(); ++at) {
    quantities += "  double " + names[at] + " = assur_quantities[" + std::to_string(at) +
                  "];\n  (void)" + names[at] + ";\n";
  }
  std::string entry = program.entry;
  std::string check;
  if (entry.empty()) {
    entry = cpp ? "assur_audit::entry(result, i, j, assur_audit::Rank<3>())" : "result[i][j]";
    check = cpp ? "  assur_audit::check(result, assur_audit::Rank<3>());\n" : "";
  }
  // A program's own main is another function here.
  const std::string include = "#define main assur_audited_main\n#include " +
                              quoted(program.file.string()) + "\n#undef main\n";
  return include + filled(filled(c_main, {{"compute", cpp ? cpp_compute : c_compute}}),
                          {{"quantities", quantities},
                           {"before", lines(program.before, "  ", ";")},
                           {"result", program.result},
                           {"check", check},
                           {"entry", entry}});
}

std::string python_driver(const UserProgram& program, const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) {
    list += quoted(name) + ", ";
  }
  return filled(python, {{"file", quoted(program.file.string())},
                         {"names", list},
                         {"before", quoted(lines(program.before, "", ""))},
                         {"result", quoted(program.result)},
                         {"entry", quoted(program.entry)}});
}

std::string octave_driver(const UserProgram& program, const std::vector<std::string>& names) {
  std::string quantities;
  for (std::size_t at = 0; at < names.size(); ++at) {
    quantities += "  " + names[at] + " = assur_quantities(" + std::to_string(at + 1) + ");\n";
  }
  const std::string check =
      "  if rows(result) != @rows@ || columns(result) != @columns@\n"
      "    complain(sprintf(\"%d by %d\", rows(result), columns(result)));\n  end\n";
  return filled(octave, {{"file", quoted(program.file.string())},
                         {"quantities", quantities},
                         {"before", lines(program.before, "  ", ";")},
                         {"result", program.result},
                         {"check", program.entry.empty() ? check : ""},
                         {"entry", program.entry.empty() ? "result(i, j)" : program.entry}});
}

}  // namespace

Driver driver_of(const UserProgram& program, const MatrixSize& size,
                 const std::vector<std::string>& names) {
  Driver driver;
  switch (program.language) {
    case Language::cpp:
      driver = {"driver.cpp", cpp_driver(program, names)};
      break;
    case Language::c:
      driver = {"driver.c", cpp_driver(program, names)};
      break;
    case Language::python:
      driver = {"driver.py", python_driver(program, names)};
      break;
    case Language::octave:
      driver = {"driver.m", octave_driver(program, names)};
      break;
  }
  driver.text = filled(driver.text, {{"rows", std::to_string(size.rows)},
                                     {"columns", std::to_string(size.columns)},
                                     {"count", std::to_string(names.size())},
                                     {"unclear", entry_is_unclear}});
  return driver;
}

}  // namespace assur::generator::audit::running
