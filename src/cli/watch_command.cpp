#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/file_watch.h"
#include "cli/guarded.h"
#include "cli/load.h"
#include "cli/previews.h"
#include "cli/timeline_files.h"
#include "cli/watch_round.h"
#include "flexkey/timeline/parse.h"

namespace flexkey::cli {
namespace {

namespace fs = std::filesystem;

/// Signals as they come, by a descriptor, so that one wait is for them and for files.
class Signals {
 public:
  Signals() {
    sigemptyset(&set_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) sigaddset(&set_, signal);
    sigprocmask(SIG_BLOCK, &set_, &before_);
    descriptor_ = signalfd(-1, &set_, SFD_CLOEXEC | SFD_NONBLOCK);
  }
  ~Signals() { close(descriptor_); }
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;

  int descriptor() const { return descriptor_; }
  /// The next signal that came, or 0.
  int next() const {
    signalfd_siginfo info{};
    return read(descriptor_, &info, sizeof info) == sizeof info ? static_cast<int>(info.ssi_signo) : 0;
  }
  /// In a child, whose signals are its own.
  void restore() const { sigprocmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t set_{}, before_{};
  int descriptor_ = -1;
};

/// Rounds in processes of their own: each can be stopped at any time, and whatever becomes of it the watch
/// goes on. The next one's process stands by, with what takes time to load. The watch itself loads nothing of
/// that, as it brings threads, which a process that forks must not have.
class Rounds {
 public:
  Rounds(const ShotOptions& options, const Signals& signals) : options_(options), signals_(signals) {}
  ~Rounds() {
    if (standby_ <= 0) return;
    close(cause_);  // without one it ends
    waitpid(standby_, nullptr, 0);
  }
  Rounds(const Rounds&) = delete;
  Rounds& operator=(const Rounds&) = delete;

  void start(const std::string& cause) {
    if (standby_ <= 0) prepare();
    const auto size = static_cast<ssize_t>(cause.size());
    if (write(cause_, cause.data(), cause.size()) != size) throw Error("the process of a round is gone");
    close(cause_);
    process_ = standby_;
    prepare();
  }

  /// Whether it has ended by itself.
  bool is_over() {
    if (process_ > 0 && waitpid(process_, nullptr, WNOHANG) == process_) process_ = 0;
    return process_ == 0;
  }

  /// Lets it finish its frame; a signal that comes meanwhile ends it at once. Returns that signal, or 0.
  int stop() {
    if (is_over()) return 0;
    kill(process_, SIGINT);
    while (!is_over()) {
      pollfd waiting{signals_.descriptor(), POLLIN, 0};
      poll(&waiting, 1, -1);
      if (const int signal = signals_.next(); signal != 0 && signal != SIGCHLD) {
        kill(process_, SIGKILL);
        waitpid(process_, nullptr, 0);
        process_ = 0;
        return signal;
      }
    }
    return 0;
  }

 private:
  void prepare();
  [[noreturn]] void run(int cause) const;

  const ShotOptions& options_;
  const Signals& signals_;
  pid_t process_ = 0, standby_ = 0;
  int cause_ = -1;  // a pipe to the one that stands by: its round begins when the pipe is closed
};

void Rounds::prepare() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    throw Error(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
  standby_ = fork();
  if (standby_ < 0) throw Error(fmt::format("cannot start a process: {}", std::strerror(errno)));
  if (standby_ == 0) {
    close(ends[1]);
    run(ends[0]);
  }
  close(ends[0]);
  cause_ = ends[1];
}

void Rounds::run(int cause) const {
  signals_.restore();
  setpgid(0, 0);  // Ctrl-C reaches the watch alone, which stops the round
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  const int code = guarded([&] {
    try {
      preload_previews();
    } catch (const OutputError&) {
      // The round says so.
    }
    std::string text;
    std::array<char, 256> part;
    for (ssize_t length = 0; (length = read(cause, part.data(), part.size())) > 0;)
      text.append(part.data(), static_cast<std::size_t>(length));
    return text.empty() ? static_cast<int>(done) : run_round(options_, text);
  });
  if (code == bad_timeline || code == bad_input) say("waiting for the next save\n");
  _exit(code);
}

/// The files that a shot is made of; those of a broken one as far as it names them, beside what was known.
std::vector<fs::path> files_of(const ShotOptions& options, std::vector<fs::path> known) {
  TimelineFiles named{fs::path(options.shot).parent_path(), {}, {}};
  try {
    const ParsedShot parsed =
        parse_shot(read_timeline(options.shot), options.shot, options.overrides(), sources_of(named));
    known.push_back(named.folder / parsed.shot.mesh.file);
    return load_shot(options).inputs;
  } catch (const Error&) {
    // The round has said what is wrong.
    known.insert(known.end(), named.paths.begin(), named.paths.end());
    return known;
  }
}

/// What has changed, once it is quiet: an editor's save is several changes.
std::string settled_change(FileWatch& watch) {
  constexpr int quiet = 25;  // milliseconds
  std::set<std::string> changed = watch.changed();
  pollfd waiting{watch.descriptor(), POLLIN, 0};
  while (!changed.empty() && poll(&waiting, 1, quiet) > 0) changed.merge(watch.changed());
  return fmt::format("{}", fmt::join(changed, ", "));
}

/// The rounds, until a signal comes: that signal.
int watch_rounds(const ShotOptions& options, const Signals& signals) {
  FileWatch watch;
  std::vector<fs::path> files{options.shot};
  watch.follow(files);
  Rounds rounds(options, signals);
  rounds.start(options.shot);
  for (bool is_new = true;;) {
    if (is_new) {
      files = files_of(options, std::move(files));
      watch.follow(files);
    }
    std::array<pollfd, 2> waiting{pollfd{signals.descriptor(), POLLIN, 0},
                                  pollfd{watch.descriptor(), POLLIN, 0}};
    poll(waiting.data(), waiting.size(), -1);
    for (int signal = signals.next(); signal != 0; signal = signals.next()) {
      if (signal == SIGCHLD) continue;
      rounds.stop();
      return signal;
    }
    rounds.is_over();
    const std::string changed = settled_change(watch);
    is_new = !changed.empty();
    if (!is_new) continue;
    if (const int signal = rounds.stop(); signal != 0) return signal;
    rounds.start(fmt::format("{} saved", changed));
  }
}

}  // namespace

int run_watch(const ShotOptions& options) {
  if (options.shot == "-") throw UsageError("standard input cannot be watched; name a file");
  const Signals signals;
  const int signal = watch_rounds(options, signals);
  say("\n");
  return stopped_by_signal + signal;
}

}  // namespace flexkey::cli
