#include "audit/running/limited_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <assur/text/error.hpp>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <system_error>

namespace assur::generator::audit::running {

WorkDirectory::WorkDirectory() {
  std::string name = (std::filesystem::temp_directory_path() / "assur-audit-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw text::InputError(name + ": this directory cannot be made");
  }
  path_ = name;
}

WorkDirectory::~WorkDirectory() {
  std::error_code ignored;  // files that cannot be removed do not end the audit
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path WorkDirectory::write(const std::string& name, const std::string& text) const {
  std::ofstream out(path_ / name, std::ios::binary);
  out << text;
  out.close();
  if (!out) {
    throw text::InputError((path_ / name).string() + ": cannot be written");
  }
  return path_ / name;
}

std::string WorkDirectory::read(const std::string& name) const {
  std::ifstream in(path_ / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

namespace {

constexpr std::size_t most_output = 100000;
constexpr rlim_t most_file = 64U << 20U;

/// The two ends of a pipe, which the destructor closes.
struct Pipe {
  std::array<int, 2> ends{-1, -1};

  Pipe() {
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
      throw std::system_error(errno, std::generic_category(), "a pipe");
    }
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  void close_end(std::size_t end) {
    if (ends[end] >= 0) {
      close(ends[end]);
      ends[end] = -1;
    }
  }
};

void limit(decltype(RLIMIT_CORE) what, rlim_t most) {
  const rlimit both{most, most};
  setrlimit(what, &both);
}

/// Runs in the child between fork and exec; makes only async-signal-safe calls.
[[noreturn]] void become(char* const* command, char* const* environment, const char* directory,
                         const ProcessLimits& limits, const Pipe& output, const Pipe& failure) {
  setpgid(0, 0);
  for (const int signal : {SIGPIPE, SIGXFSZ, SIGXCPU}) {
    std::signal(signal, SIG_DFL);
  }
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, most_file);
  limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(limits.seconds)) + 1);
  if (limits.bytes > 0) {
    limit(RLIMIT_AS, limits.bytes);
  }
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(output.ends[1], STDOUT_FILENO);
  dup2(output.ends[1], STDERR_FILENO);
  if (chdir(directory) == 0) {
    execvpe(command[0], command, environment);
  }
  const int error = errno;
  const ssize_t written = write(failure.ends[1], &error, sizeof error);
  _exit(written > 0 ? 127 : 126);
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  for (std::string& text : texts) {
    list.push_back(text.data());
  }
  list.push_back(nullptr);
  return list;
}

/// Reads the output that has come through the pipe so far, and keeps its beginning.
void drain(int pipe, std::string& output) {
  std::array<char, 4096> buffer{};
  for (ssize_t count = 0; (count = read(pipe, buffer.data(), buffer.size())) > 0;) {
    const std::size_t room = most_output - std::min(most_output, output.size());
    output.append(buffer.data(), std::min(room, static_cast<std::size_t>(count)));
  }
}

}  // namespace

ProcessEnd run_process(const std::vector<std::string>& command,
                       const std::filesystem::path& directory, const std::filesystem::path& home,
                       const ProcessLimits& limits) {
  const char* const path = std::getenv("PATH");
  std::vector<std::string> words = command;
  std::vector<std::string> variables = {
      std::string("PATH=") + (path == nullptr ? "/usr/bin:/bin" : path),
      "HOME=" + home.string(),
      "TMPDIR=" + home.string(),
      "LC_ALL=C",
      "MALLOC_PERTURB_=165",  // so that uninitialised memory is not zero by chance
      "OMP_NUM_THREADS=1",
      "OPENBLAS_NUM_THREADS=1"};
  const std::vector<char*> arguments = pointers(words);
  const std::vector<char*> environment = pointers(variables);
  Pipe output;
  Pipe failure;
  const pid_t child = fork();
  if (child < 0) {
    throw std::system_error(errno, std::generic_category(), "a process");
  }
  if (child == 0) {
    become(arguments.data(), environment.data(), directory.c_str(), limits, output, failure);
  }
  setpgid(child, child);
  output.close_end(1);
  failure.close_end(1);
  fcntl(output.ends[0], F_SETFL, O_NONBLOCK);

  ProcessEnd end;
  int status = 0;
  bool late = false;
  const auto begin = std::chrono::steady_clock::now();
  while (waitpid(child, &status, WNOHANG) == 0) {
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - begin;
    if (since.count() > limits.seconds) {
      late = true;
      kill(-child, SIGKILL);
      waitpid(child, &status, 0);
      break;
    }
    pollfd event{output.ends[0], POLLIN, 0};
    poll(&event, 1, 10);
    if ((event.revents & POLLHUP) != 0) {
      usleep(1000);  // it has closed its output and still runs
    }
    drain(output.ends[0], end.output);
  }
  drain(output.ends[0], end.output);
  kill(-child, SIGKILL);  // processes that it may have left running
  int error = 0;
  if (read(failure.ends[0], &error, sizeof error) > 0) {
    end.kind = ProcessEnd::Kind::not_found;
    end.code = error;
  } else if (late || (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)) {
    end.kind = ProcessEnd::Kind::too_long;
  } else if (WIFSIGNALED(status)) {
    end.kind = ProcessEnd::Kind::killed;
    end.code = WTERMSIG(status);
  } else {
    end.code = WEXITSTATUS(status);
  }
  return end;
}

}  // namespace assur::generator::audit::running
