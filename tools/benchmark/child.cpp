#include "child.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <exception>

#include "flexkey/mesh/error.h"

namespace flexkey::bench {
namespace {

void write_all(int pipe, const std::vector<double>& values) {
  const char* at = reinterpret_cast<const char*>(values.data());
  std::size_t left = values.size() * sizeof(double);
  while (left > 0) {
    const ssize_t written = ::write(pipe, at, left);
    if (written < 0) throw Error("a measurement cannot be handed over");
    at += written;
    left -= static_cast<std::size_t>(written);
  }
}

std::vector<double> read_all(int pipe) {
  std::vector<double> values;
  std::FILE* stream = ::fdopen(pipe, "rb");
  for (double value = 0; std::fread(&value, sizeof value, 1, stream) == 1;) values.push_back(value);
  std::fclose(stream);
  return values;
}

[[noreturn]] void run_and_leave(const std::function<std::vector<double>()>& work, int pipe) {
  int status = 1;
  try {
    write_all(pipe, work());
    status = 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench: %s\n", error.what());
  }
  ::_exit(status);
}

}  // namespace

Measured in_child(const std::function<std::vector<double>()>& work) {
  std::array<int, 2> pipe{};
  if (::pipe(pipe.data()) != 0) throw Error("no pipe for a measurement");
  const pid_t child = ::fork();
  if (child < 0) throw Error("no process for a measurement");
  if (child == 0) {
    ::close(pipe[0]);
    run_and_leave(work, pipe[1]);
  }
  ::close(pipe[1]);
  Measured measured{read_all(pipe[0])};
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  if (status != 0) throw Error("a measurement failed");
  measured.peak_bytes = 1024.0 * static_cast<double>(usage.ru_maxrss);
  return measured;
}

}  // namespace flexkey::bench
