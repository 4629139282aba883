#include "compare/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>

namespace lute::compare {
namespace {

constexpr int kCannotExecute = 127;

double seconds(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

void redirect(const char* path, int flags, int target) {
  const int descriptor = open(path, flags | O_CLOEXEC, 0644);
  if (descriptor < 0) _exit(kCannotExecute);
  dup2(descriptor, target);
}

// Runs between vfork and exec, in the parent's memory, where only async-signal-safe calls are allowed.
[[noreturn]] void become(const ProcessRequest& request, char* const* arguments) {
  setpgid(0, 0);
  if (!request.working_directory.empty() && chdir(request.working_directory.c_str()) != 0) _exit(kCannotExecute);
  redirect("/dev/null", O_RDONLY, STDIN_FILENO);
  redirect(request.standard_output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
  redirect(request.standard_error.c_str(), O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
  // The sanitizer of addresses reserves terabytes of them.
#ifdef __SANITIZE_ADDRESS__
  constexpr bool kLimits = false;
#else
  constexpr bool kLimits = true;
#endif
  if (kLimits && request.memory_limit > 0) {
    const rlimit limit{request.memory_limit, request.memory_limit};
    setrlimit(RLIMIT_AS, &limit);
  }
  execvp(arguments[0], arguments);
  _exit(kCannotExecute);
}

// Waits until the process has ended or the limit has passed; true if it ended.
bool wait_until_end(int descriptor, double time_limit) {
  const auto start = std::chrono::steady_clock::now();
  while (true) {
    int timeout = -1;
    if (time_limit > 0) {
      const double used = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      if (used >= time_limit) return false;
      timeout = static_cast<int>(std::ceil((time_limit - used) * 1000.0));
    }
    pollfd entry{descriptor, POLLIN, 0};
    const int ready = poll(&entry, 1, timeout);
    if (ready > 0 || (ready < 0 && errno != EINTR)) return true;
  }
}

}  // namespace

ProcessResult run_process(const ProcessRequest& request) {
  std::vector<char*> arguments;
  for (const std::string& argument : request.arguments) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);

  ProcessResult result;
  const auto start = std::chrono::steady_clock::now();
  // Not fork(): taking down the copied memory of this program would count as the child's time, some milliseconds.
  const pid_t child = vfork();
  if (child < 0) return result;
  if (child == 0) become(request, arguments.data());
  setpgid(child, child);

  const int descriptor = static_cast<int>(syscall(SYS_pidfd_open, child, 0));  // the wrapper of Debian 12 is C only
  result.timed_out = !wait_until_end(descriptor, request.time_limit);
  if (result.timed_out) kill(-child, SIGKILL);
  int status = 0;
  rusage usage{};
  while (wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  if (descriptor >= 0) close(descriptor);
  kill(-child, SIGKILL);  // whatever the program started and left behind

  result.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.user = seconds(usage.ru_utime);
  result.cpu = result.user + seconds(usage.ru_stime);
  result.peak_memory = std::int64_t{usage.ru_maxrss} * 1024;
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  result.started = result.exit_code != kCannotExecute;
  return result;
}

}  // namespace lute::compare
