#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "flexkey/animate/animate.h"
#include "flexkey/animate/checkpoint.h"
#include "flexkey/animate/deform_options.h"
#include "flexkey/animate/frame_log.h"
#include "flexkey/animate/seal.h"
#include "flexkey/timeline/parse.h"
#include "fuzz/targets.h"
#include "support/meshes.h"

namespace flexkey::fuzz {
namespace {

namespace fs = std::filesystem;

/// A place for one file, which the readers of a state take by its name.
class Scratch {
 public:
  Scratch() : path_(fs::temp_directory_path() / ("flexkey-fuzz-" + std::to_string(getpid()))) {}
  ~Scratch() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  const fs::path& path() const { return path_; }
  void write(std::string_view bytes) const {
    std::ofstream(path_, std::ios::binary | std::ios::trunc) << bytes;
  }
  std::string read() const {
    std::ifstream stream(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

 private:
  fs::path path_;
};

/// A short shot in which a handle lets go, so that a waypoint has every part that it can.
struct Stage {
  Mesh bar = meshes::bar(1, 1, 3);
  Shot shot = parse_shot(
                  "mesh: bar.obj\nfps: 4\nhandles:\n  base: {select: {axis: z, below: 0%}}\n"
                  "  tip: {select: {axis: z, above: 100%}, active: [0s, 2s], fade: 1s, "
                  "move: {keys: {0s: [0, 0, 0], 2s: [0, 1, 0]}}}\n",
                  "x.yaml")
                  .shot;
  Scene scene = bind_shot(shot, bar);
  DeformerCache cache{scene, deform_options(shot.solver)};
};

Stage& stage() {
  static Stage stage;
  return stage;
}

std::size_t seal_bytes() {
  return sealed().size();
}

}  // namespace

/// The bytes without their seal: behind a checksum nothing would be reached.
void run_checkpoint(std::string_view bytes) {
  static const Scratch scratch;
  std::string file(bytes);
  Saving saving([&](std::span<const std::byte> more) {
    file.append(reinterpret_cast<const char*>(more.data()), more.size());
  });
  saving(digest_of_bytes(std::as_bytes(std::span(bytes))));
  scratch.write(file);
  try {
    const auto checkpoint = read_checkpoint(scratch.path());
    if (checkpoint != nullptr) load_waypoint(checkpoint->waypoint, stage().scene, stage().cache);
  } catch (const Error&) {
    // Refused, as it may be.
  }
}

void run_frames(std::string_view bytes) {
  static const Scratch scratch;
  constexpr Eigen::Index vertices = 4;
  scratch.write(bytes);
  FrameLog log(scratch.path(), SolveInputs{}, vertices);
  for (std::size_t frame = 0; frame < log.frames().size(); ++frame) {
    promise(log.frames()[frame].report.frame == static_cast<int>(frame), "frames in their order");
    try {
      promise(log.positions(static_cast<int>(frame)).rows() == vertices, "a row a vertex");
    } catch (const Error&) {
      // Damaged, and said to be.
    }
  }
}

std::vector<std::string> checkpoint_seeds() {
  std::vector<std::string> seeds;
  const Scratch scratch;
  AnimateHooks hooks;
  hooks.on_solved = [&](std::size_t, const SolvedStep& step) {
    write_checkpoint(scratch.path(), {{}, {}, step.waypoint.next}, step.waypoint);
    seeds.push_back(scratch.read());
    seeds.back().resize(seeds.back().size() - seal_bytes());
  };
  animate(stage().shot, stage().bar, stage().scene, {}, hooks);
  return seeds;
}

std::vector<std::string> frames_seeds() {
  const Scratch scratch;
  FrameLog log(scratch.path(), SolveInputs{}, 4);
  log.keep(0);
  for (int frame = 0; frame < 3; ++frame) {
    FrameReport report;
    report.frame = frame;
    log.add({report, {}}, Positions::Constant(4, 3, frame));
  }
  return {scratch.read()};
}

}  // namespace flexkey::fuzz
