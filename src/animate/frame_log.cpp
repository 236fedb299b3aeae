#include "flexkey/animate/frame_log.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "flexkey/animate/seal.h"
#include "flexkey/animate/state_format.h"

namespace flexkey {

template <MaybeConst<FrameReport> Self>
auto members_of(Self& report) {
  auto& [frame, lambda, solves, estimate, converged, slipped] = report;
  return std::tie(frame, lambda, solves, estimate, converged, slipped);
}

namespace {

/// What a file begins with.
struct Head {
  StateMark mark{{"flexkey frames"}};
  SolveInputs inputs;
};

template <MaybeConst<Head> Self>
auto members_of(Self& head) {
  auto& [mark, inputs] = head;
  return std::tie(mark, inputs);
}

/// What a frame's positions stand behind.
struct RecordHead {
  LoggedFrame logged;
  Digest positions;
};

template <MaybeConst<RecordHead> Self>
auto members_of(Self& record) {
  auto& [logged, positions] = record;
  return std::tie(logged.report, logged.motion, positions);
}

std::size_t head_size() {
  static const std::size_t size = sealed(Head{}).size();
  return size;
}

std::size_t record_head_size() {
  static const std::size_t size = sealed(RecordHead{}).size();
  return size;
}

std::span<const std::byte> as_bytes(const std::string& text) {
  return std::as_bytes(std::span(text));
}

std::span<const std::byte> bytes_of(const Positions& positions) {
  return std::as_bytes(std::span(positions.data(), static_cast<std::size_t>(positions.size())));
}

/// As many bytes as there are from a place of a file, at most `size`.
std::size_t read_some(const Descriptor& file, std::uint64_t at, void* into, std::size_t size) {
  std::size_t done = 0;
  while (done < size) {
    const ssize_t got =
        pread(file.number(), static_cast<char*>(into) + done, size - done, static_cast<off_t>(at + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

/// What stands sealed at a place of a file, or nothing.
template <class Value>
std::optional<Value> read_sealed(const Descriptor& file, std::uint64_t at, std::size_t size) {
  std::string bytes(size, '\0');
  if (read_some(file, at, bytes.data(), size) < size) return std::nullopt;
  const auto contents = unseal(as_bytes(bytes));
  if (!contents) return std::nullopt;
  Value value;
  Loading{*contents}(value);
  return value;
}

}  // namespace

FrameLog::FrameLog(std::filesystem::path path, const SolveInputs& inputs, Eigen::Index vertices)
    : path_(std::move(path)), inputs_(inputs), vertices_(vertices) {
  file_ = Descriptor(open(path_.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file_.is_open() && errno == ENOENT) return;
  if (!file_.is_open()) {
    fault_ = fmt::format("it cannot be read: {}", std::strerror(errno));
    return;
  }
  read_head();
  if (solved_from_ == inputs_) read_frames();
}

void FrameLog::read_head() {
  const std::optional<Head> head = read_sealed<Head>(file_, 0, head_size());
  if (head && head->mark == Head{}.mark) {
    solved_from_ = head->inputs;
  } else {
    fault_ = "it is damaged or of another format";
  }
}

void FrameLog::read_frames() {
  struct stat file {};
  if (fstat(file_.number(), &file) != 0) return;
  while (place_of(frames_.size() + 1) <= static_cast<std::uint64_t>(file.st_size)) {
    const auto record = read_sealed<RecordHead>(file_, place_of(frames_.size()), record_head_size());
    if (!record || record->logged.report.frame != static_cast<int>(frames_.size())) return;
    frames_.push_back(record->logged);
  }
}

std::uint64_t FrameLog::place_of(std::size_t frame) const {
  const std::size_t positions = static_cast<std::size_t>(vertices_) * 3 * sizeof(double);
  return head_size() + static_cast<std::uint64_t>(frame) * (record_head_size() + positions);
}

Positions FrameLog::positions(int frame) const {
  const std::uint64_t place = place_of(static_cast<std::size_t>(frame));
  const auto record = read_sealed<RecordHead>(file_, place, record_head_size());
  Positions positions(vertices_, 3);
  const std::span<const std::byte> bytes = bytes_of(positions);
  const bool is_whole =
      read_some(file_, place + record_head_size(), positions.data(), bytes.size()) == bytes.size();
  if (!record || !is_whole || digest_of_bytes(bytes) != record->positions)
    throw StateError(fmt::format("frame {} in it is damaged", frame));
  return positions;
}

void FrameLog::keep(int count) {
  const int flags = O_RDWR | O_CREAT | O_CLOEXEC | (count == 0 ? O_TRUNC : 0);
  file_ = Descriptor(open(path_.c_str(), flags, 0666));
  if (!file_.is_open()) fail();
  frames_.resize(static_cast<std::size_t>(count));
  if (count == 0) write(as_bytes(sealed(Head{.inputs = inputs_})), 0);
  if (ftruncate(file_.number(), static_cast<off_t>(place_of(frames_.size()))) != 0) fail();
  solved_from_ = inputs_;
}

void FrameLog::add(const LoggedFrame& frame, const Positions& positions) {
  const std::uint64_t place = place_of(frames_.size());
  const std::span<const std::byte> bytes = bytes_of(positions);
  try {
    write(bytes, place + record_head_size());
    write(as_bytes(sealed(RecordHead{frame, digest_of_bytes(bytes)})), place);
  } catch (const OutputError&) {
    if (ftruncate(file_.number(), static_cast<off_t>(place)) != 0) fail();
    throw;
  }
  frames_.push_back(frame);
}

void FrameLog::remove() {
  unlink(path_.c_str());
  file_ = Descriptor();  // what is open keeps its room
  frames_.clear();
}

void FrameLog::sync() const {
  if (fdatasync(file_.number()) != 0 && errno != EINVAL && errno != EROFS) fail();
}

void FrameLog::write(std::span<const std::byte> bytes, std::uint64_t at) const {
  while (!bytes.empty()) {
    const ssize_t written = pwrite(file_.number(), bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (written < 0 && errno == EINTR) continue;
    if (written == 0) errno = ENOSPC;
    if (written <= 0) fail();
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    at += static_cast<std::uint64_t>(written);
  }
}

void FrameLog::fail() const {
  throw OutputError(fmt::format("cannot write '{}': {}", path_.string(), std::strerror(errno)));
}

}  // namespace flexkey
