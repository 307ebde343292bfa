// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/host/helper_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>

extern char** environ;

namespace spin {
namespace {

/// Address space that the readers' libraries take by themselves, on top of the memory for the file.
constexpr std::size_t kLibrarySpace = std::size_t{1} << 30;
constexpr std::size_t kChatterKept = 4096;
constexpr int kPollMs = 50;
constexpr int kCannotStart = 127;

/// AddressSanitizer reserves terabytes of addresses, so there only the watch on resident memory limits.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kLimitAddressSpace = false;
#else
constexpr bool kLimitAddressSpace = true;
#endif

void setLimit(int resource, rlim_t value) {
  const struct rlimit limit { value, value };
  setrlimit(static_cast<__rlimit_resource_t>(resource), &limit);
}

/// What the child needs, prepared before the fork: after it, only async-signal-safe calls are allowed,
/// because other threads may have held locks.
struct Launch {
  const char* program;
  int request;
  int answer;
  int chatter;
  rlim_t addressSpace;
  rlim_t answerSize;
  rlim_t cpuSeconds;
};

[[noreturn]] void becomeHelper(const Launch& launch) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (kLimitAddressSpace) setLimit(RLIMIT_AS, launch.addressSpace);
  setLimit(RLIMIT_CPU, launch.cpuSeconds);
  setLimit(RLIMIT_FSIZE, launch.answerSize);
  setLimit(RLIMIT_CORE, 0);
  // Out of the way of the numbers they shall get.
  const int request = fcntl(launch.request, F_DUPFD, 16);
  const int answer = fcntl(launch.answer, F_DUPFD, 16);
  const int chatter = fcntl(launch.chatter, F_DUPFD, 16);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, 0);
  dup2(chatter, 1);
  dup2(chatter, 2);
  dup2(request, kHelperRequestFd);
  dup2(answer, kHelperAnswerFd);
  close_range(kHelperAnswerFd + 1, ~0U, 0);
  char* const arguments[] = {const_cast<char*>(launch.program), nullptr};
  execve(launch.program, arguments, environ);
  _exit(kCannotStart);
}

std::size_t residentBytes(pid_t pid) {
  std::FILE* file = std::fopen(fmt::format("/proc/{}/statm", pid).c_str(), "re");
  if (!file) return 0;
  unsigned long total = 0, resident = 0;
  const int found = std::fscanf(file, "%lu %lu", &total, &resident);
  std::fclose(file);
  return found == 2 ? resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) : 0;
}

enum class Ending { Exited, TimedOut, Cancelled, TooMuchMemory };

/// The running child and what it said.
class Child {
 public:
  Child(pid_t pid, int chatter) : m_pid(pid), m_chatterFd(chatter) {}

  Ending wait(const ImportLimits& limits, const CancelToken& cancel) {
    using Clock = std::chrono::steady_clock;
    const auto deadline = Clock::now() + std::chrono::duration<double>(limits.seconds);
    for (;;) {
      pollfd poller{m_chatterFd, POLLIN, 0};
      // A child that closed its end would wake the poll at once, so its end is looked for by waitpid.
      if (m_chatterOpen)
        poll(&poller, 1, kPollMs);
      else
        poll(nullptr, 0, kPollMs);
      drain();
      if (finished()) return Ending::Exited;
      if (cancel.cancelled()) return kill(Ending::Cancelled);
      if (Clock::now() >= deadline) return kill(Ending::TimedOut);
      if (residentBytes(m_pid) > limits.memoryBytes + kLibrarySpace) return kill(Ending::TooMuchMemory);
    }
  }

  int status() const { return m_status; }

  /// The last lines, on one line.
  std::string chatter() const {
    std::string text;
    for (const char c : m_chatter) {
      if (c == '\n') {
        if (!text.empty() && text.back() != ' ') text += "; ";
      } else if (static_cast<unsigned char>(c) >= 32) {
        text += c;
      }
    }
    while (!text.empty() && (text.back() == ' ' || text.back() == ';')) text.pop_back();
    return text.size() > 400 ? "..." + text.substr(text.size() - 400) : text;
  }

 private:
  bool finished() {
    int status = 0;
    const pid_t ended = waitpid(m_pid, &status, WNOHANG);
    // ECHILD: the program ignores SIGCHLD, so the ending is unknown; the answer's seal decides.
    if (ended == 0 || (ended < 0 && errno != ECHILD)) return false;
    m_status = ended == m_pid ? status : 0;
    ::kill(-m_pid, SIGKILL);
    drain();
    return true;
  }

  Ending kill(Ending why) {
    ::kill(-m_pid, SIGKILL);
    ::kill(m_pid, SIGKILL);
    while (waitpid(m_pid, &m_status, 0) < 0 && errno == EINTR) {
    }
    drain();
    return why;
  }

  void drain() {
    char buffer[4096];
    ssize_t n = 0;
    // Bounded, so that a child that never stops talking cannot keep us here.
    for (int i = 0; i < 64 && (n = read(m_chatterFd, buffer, sizeof buffer)) > 0; ++i) {
      m_chatter.append(buffer, static_cast<std::size_t>(n));
      if (m_chatter.size() > kChatterKept) m_chatter.erase(0, m_chatter.size() - kChatterKept);
    }
    if (n == 0) m_chatterOpen = false;
  }

  pid_t m_pid;
  int m_chatterFd;
  bool m_chatterOpen = true;
  int m_status = 0;
  std::string m_chatter;
};

std::string withChatter(const std::string& why, const std::string& chatter) {
  return chatter.empty() ? why : why + " (it said: " + chatter + ")";
}

bool speaksOfMemory(const std::string& chatter) {
  for (const char* sign : {"bad_alloc", "annot allocate", "ut of memory", "not enough memory",
                           "memory exhausted", "MemoryError", "failed to map segment"})
    if (chatter.find(sign) != std::string::npos) return true;
  return false;
}

Error outOfMemory(const std::string& path, const ImportLimits& limits, const std::string& chatter) {
  return {ErrorKind::OutOfResources, "The file could not be read", path,
          withChatter(fmt::format("reading it takes more than the {} MiB of memory allowed for an import",
                                  limits.memoryBytes >> 20),
                      chatter),
          "Reduce the file, or cut out the part you need"};
}

Error outOfTime(const std::string& path, const ImportLimits& limits) {
  return {ErrorKind::OutOfResources, "The file could not be read", path,
          fmt::format("reading it took longer than the {:g} s allowed for an import", limits.seconds),
          "Reduce the file; if it is small, it may be damaged"};
}

Error crashed(const std::string& path, int signal, const std::string& chatter) {
  return badInput("The file could not be read", path,
                  withChatter(fmt::format("the reader crashed on it ({})", strsignal(signal)), chatter),
                  "The file may be damaged: open it in the program that made it and export it again");
}

Status judge(const Child& child, Ending ending, const ImportLimits& limits, const std::string& path) {
  const int status = child.status();
  const std::string chatter = child.chatter();
  if (ending == Ending::Cancelled)
    return Error{ErrorKind::Cancelled, "The import was cancelled", path, "", ""};
  if (ending == Ending::TimedOut) return outOfTime(path, limits);
  if (ending == Ending::TooMuchMemory) return outOfMemory(path, limits, "");
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    if (signal == SIGXCPU) return outOfTime(path, limits);
    if (signal == SIGKILL || signal == SIGXFSZ || speaksOfMemory(chatter))
      return outOfMemory(path, limits, chatter);
    return crashed(path, signal, chatter);
  }
  if (WEXITSTATUS(status) == 0) return {};
  if (speaksOfMemory(chatter)) return outOfMemory(path, limits, chatter);
  return Error{
      ErrorKind::Failed, "The file could not be read", path,
      withChatter(fmt::format("the import helper ended with exit code {}", WEXITSTATUS(status)), chatter),
      "Install the program again if no file can be imported"};
}

Error cannotStart(const std::string& program, const std::string& why) {
  return {ErrorKind::Failed, "The import helper could not be started", program, why,
          "Install the program again"};
}

}  // namespace

Status runHelper(const std::string& program, const std::vector<char>& request, const ImportLimits& limits,
                 const CancelToken& cancel, const std::string& path, SharedBytes& answer) {
  if (access(program.c_str(), X_OK) != 0) return cannotStart(program, std::strerror(errno));
  SharedBytes question;
  if (Status status = question.write(request); !status) return status;
  if (answer.fd() < 0) return cannotStart(program, "there is no memory for the answer");
  int chatter[2];
  if (pipe2(chatter, O_CLOEXEC) != 0) return cannotStart(program, std::strerror(errno));
  fcntl(chatter[0], F_SETFL, O_NONBLOCK);  // our end only: the helper's writes may wait
  const Launch launch{program.c_str(),
                      question.fd(),
                      answer.fd(),
                      chatter[1],
                      limits.memoryBytes + kLibrarySpace,
                      limits.memoryBytes,
                      static_cast<rlim_t>(2.0 * std::ceil(limits.seconds)) + 1};
  const pid_t pid = fork();
  if (pid == 0) becomeHelper(launch);
  close(chatter[1]);
  if (pid < 0) {
    close(chatter[0]);
    return cannotStart(program, std::strerror(errno));
  }
  setpgid(pid, pid);
  Child child(pid, chatter[0]);
  const Ending ending = child.wait(limits, cancel);
  close(chatter[0]);
  if (Status status = judge(child, ending, limits, path); !status) return status;
  return answer.map();
}

}  // namespace spin
