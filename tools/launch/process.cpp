// SPDX-License-Identifier: Apache-2.0
#include "tools/launch/process.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace enfilade::launch {
namespace {

/// In the child, between fork and exec: only async-signal-safe calls.
[[noreturn]] void become(char* const* arguments, int log, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(0);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  execv(arguments[0], arguments);
  _exit(127);
}

}  // namespace

std::string Ending::text() const {
  if (signal != 0) return fmt::format("ended by signal {} ({})", signal, strsignal(signal));
  return fmt::format("ended with exit status {}", exit_status);
}

Process::Process(const std::string& program, const std::vector<std::string>& arguments,
                 const std::string& log_file) {
  if (access(program.c_str(), X_OK) != 0)
    throw std::runtime_error(fmt::format("{}: not there: build it with deploy/build release", program));
  const int log = open(log_file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (log < 0)
    throw std::runtime_error(
        fmt::format("{}: cannot be written ({}): choose another --out", log_file, std::strerror(errno)));
  std::vector<std::string> all{program};
  all.insert(all.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& argument : all) argv.push_back(argument.data());
  argv.push_back(nullptr);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) become(argv.data(), log, parent);
  close(log);
  if (pid_ < 0)
    throw std::runtime_error(fmt::format("{}: cannot be started ({})", program, std::strerror(errno)));
}

Process::~Process() {
  if (poll()) return;
  signal(SIGKILL);
  int status = 0;
  waitpid(pid_, &status, 0);
}

std::optional<Ending> Process::poll() {
  int status = 0;
  if (!ending_ && waitpid(pid_, &status, WNOHANG) == pid_) {
    ending_ = WIFSIGNALED(status) ? Ending{.exit_status = 0, .signal = WTERMSIG(status)}
                                  : Ending{.exit_status = WEXITSTATUS(status), .signal = 0};
  }
  return ending_;
}

void Process::signal(int number) {
  if (!ending_) kill(-pid_, number) == 0 || kill(pid_, number) == 0;
}

}  // namespace enfilade::launch
