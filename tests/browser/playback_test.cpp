// What three.js shows of written files, in Chromium: its loader, its mixer, its morphing.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <ostream>

#include "browser/browser_test.h"
#include "cli/load.h"
#include "flexkey/animate/animate.h"
#include "flexkey/gltf/primitives.h"
#include "flexkey/mesh/read_file.h"
#include "gltf/images.h"

namespace flexkey::testing {
namespace {

struct Profile {
  const char* name;
  BasisKind basis;
  Encoding encoding;
};

void PrintTo(const Profile& profile, std::ostream* stream) {
  *stream << profile.name;
}

constexpr Profile profiles[] = {
    {"compat", BasisKind::knots, Encoding::floats},           {"web", BasisKind::pca, Encoding::meshopt},
    {"exact", BasisKind::frames, Encoding::floats},           {"pca_float", BasisKind::pca, Encoding::floats},
    {"frames_meshopt", BasisKind::frames, Encoding::meshopt},
};

GltfOptions options_of(const Profile& profile) {
  GltfOptions options;
  options.basis = profile.basis;
  options.encoding = profile.encoding;
  return options;
}

/// What the profile promises, a share of the diagonal: floats of one target a frame only round.
double promise_of(const Profile& profile) {
  const bool is_exact = profile.basis == BasisKind::frames && profile.encoding == Encoding::floats;
  return is_exact ? 1e-6 : GltfOptions().tolerance;
}

/// When each frame plays, seconds.
std::vector<double> frame_times(const Clip& clip) {
  std::vector<double> times;
  for (const FrameReport& report : clip.reports)
    times.push_back((report.frame - clip.reports.front().frame) / clip.fps);
  return times;
}

/// The times of all frames, and after each but the last one time before the next, every one elsewhere.
std::vector<double> frames_and_between(const Clip& clip) {
  std::vector<double> times = frame_times(clip);
  const std::size_t frames = times.size();
  for (std::size_t k = 0; k + 1 < frames; ++k) {
    const double share = std::fmod(0.5 + 0.618 * static_cast<double>(k), 1);
    times.push_back(times[k] + share * (times[k + 1] - times[k]));
  }
  return times;
}

/// The clip's mesh at a time, straight between frames, in the order of the file's vertices.
Positions solved(const Clip& clip, double time) {
  const std::vector<double> times = frame_times(clip);
  const auto after = std::upper_bound(times.begin(), times.end() - 1, time) - times.begin();
  const auto next = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after, 1));
  const double share = (time - times[next - 1]) / (times[next] - times[next - 1]);
  const Positions between = (1 - share) * clip.frames[next - 1] + share * clip.frames[next];
  std::vector<int> vertices;
  for (const Primitive& primitive : split_primitives(clip.mesh))
    vertices.insert(vertices.end(), primitive.vertices.begin(), primitive.vertices.end());
  return between(vertices, Eigen::all);
}

class Playback : public BrowserTest {
 protected:
  /// The vertices of the file's animation at each time, as the browser has them, #times of #vertices x 3.
  std::vector<FloatRows> played(const std::string& animation, const std::vector<double>& times) {
    std::ofstream(folder_ / "times.json") << fmt::format("[{:.17g}]", fmt::join(times, ", "));
    const Outcome outcome = run_script(
        "proof/play.mjs", {glb().string(), animation, folder_ / "times.json", folder_ / "played.f32"});
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    if (outcome.status != 0) return {};
    const std::string bytes = read_file(folder_ / "played.f32");
    const auto rows = static_cast<Eigen::Index>(bytes.size() / times.size() / (3 * sizeof(float)));
    const auto* floats = reinterpret_cast<const float*>(bytes.data());
    std::vector<FloatRows> shapes;
    for (std::size_t k = 0; k < times.size(); ++k, floats += 3 * rows)
      shapes.emplace_back(Eigen::Map<const FloatRows>(floats, rows, 3));
    return shapes;
  }

  std::filesystem::path glb() const { return folder_ / "shot.glb"; }
};

/// The largest distance from the clip, which the animation enters at `from`, as a share of the diagonal.
double largest_error(const Clip& clip, const std::vector<FloatRows>& shapes, const std::vector<double>& times,
                     double from = 0) {
  double largest = 0;
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    const Positions expected = solved(clip, from + times[k]);
    if (shapes[k].rows() != expected.rows()) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, (shapes[k].cast<double>() - expected).rowwise().norm().maxCoeff());
  }
  return largest / bounds_of(clip.mesh.positions).diagonal();
}

class PlaybackOfProfile : public Playback, public ::testing::WithParamInterface<Profile> {
 protected:
  /// Writes the clip, plays it, and compares at frames and between them.
  void expect_plays(const Clip& clip, const GltfOptions& options) {
    const GltfReport report = write_glb(clip, options, glb());
    const std::vector<double> times = frames_and_between(clip);
    const std::vector<FloatRows> shapes = played(clip.name, times);
    ASSERT_EQ(shapes.size(), times.size());
    const double largest = largest_error(clip, shapes, times);
    EXPECT_LE(largest, promise_of(GetParam()) + 1e-6);
    EXPECT_LE(largest, report.error + 1e-6) << "what the report says of the file";
    EXPECT_GE(largest, 0.5 * report.error) << "and no more";
    EXPECT_GT((shapes[clip.frames.size() / 2] - shapes[0]).norm(), 0) << "nothing moves";
  }
};

TEST_P(PlaybackOfProfile, ShowsATwistedSheetOfTwoTexturedMaterials) {
  Mesh mesh = sheet(12);
  mesh.materials = {material("left"), material("right")};
  for (Material& one : mesh.materials) one.texture = "map.png";
  std::ofstream(folder_ / "map.png", std::ios::binary) << red_png();
  unwrap_flat(mesh);
  for (int f = 0; f < mesh.face_count(); ++f) mesh.face_material.push_back(f % 12 < 6 ? 0 : 1);
  GltfOptions options = options_of(GetParam());
  options.texture_folder = folder_.path();
  expect_plays(clip_of(mesh, 30, twist), options);
}

TEST_P(PlaybackOfProfile, ShowsAMeshWithoutNormalsFarFromTheOrigin) {
  Mesh far = cube();
  far.positions.rowwise() += Vec3(3, -2, 5).transpose();
  GltfOptions options = options_of(GetParam());
  options.normals = false;
  expect_plays(clip_of(far, 9, [](const Vec3& p, int k) { return twist(p - Vec3(3, -2, 5), k); }), options);
}

TEST_P(PlaybackOfProfile, ShowsTheNose) {
  cli::ShotOptions shot;
  shot.shot = FLEXKEY_SOURCE "/timelines/nose.yaml";
  const cli::LoadedShot loaded = cli::load_shot(shot);
  expect_plays(animate(loaded.shot, loaded.mesh), options_of(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(, PlaybackOfProfile, ::testing::ValuesIn(profiles),
                         [](const auto& profile) { return profile.param.name; });

TEST_F(Playback, ShowsWhatIsSplitWhereItWasSolved) {
  const Clip clip = clip_of(sheet(12), 9, bump);
  const std::vector<double> times = frame_times(clip);
  for (const Profile& profile : {profiles[0], profiles[1]}) {
    GltfOptions options = options_of(profile);
    options.split = true;
    const GltfReport report = write_glb(clip, options, glb());
    EXPECT_EQ(report.splits.at(0).why_whole, "");
    const std::vector<FloatRows> shapes = played(clip.name, times);
    ASSERT_EQ(shapes.size(), times.size());
    EXPECT_GT(shapes[0].rows(), report.vertices) << "border vertices are in both meshes";
    double largest = 0;  // to the nearest vertex, since the meshes' vertices have no order in common
    for (std::size_t k = 0; k < shapes.size(); ++k)
      for (Eigen::Index row = 0; row < shapes[k].rows(); ++row) {
        const Positions off = clip.frames[k].rowwise() - shapes[k].row(row).cast<double>();
        largest = std::max(largest, off.rowwise().norm().minCoeff());
      }
    EXPECT_LE(largest / bounds_of(clip.mesh.positions).diagonal(), promise_of(profile) + 1e-6)
        << profile.name;
    EXPECT_GT((shapes.back() - shapes[0]).norm(), 0) << "nothing moves";
  }
}

TEST_F(Playback, PlaysNamedClipsFromTheirOwnStarts) {
  const Clip clip = clip_of(sheet(6), 25, twist);
  GltfOptions options = options_of(profiles[1]);
  options.clips = {{"first", 0, 0.5}, {"second", 0.4, 1}};
  write_glb(clip, options, glb());
  const std::vector<double> times = {0, 0.1, 0.25, 0.3, 0.5};
  for (const ClipRange& range : options.clips) {
    const std::vector<FloatRows> shapes = played(range.name, times);
    ASSERT_EQ(shapes.size(), times.size());
    EXPECT_LE(largest_error(clip, shapes, times, range.from), promise_of(profiles[1]) + 1e-6) << range.name;
  }
}

TEST_F(Playback, AnotherClipIsNoticed) {
  write_glb(clip_of(sheet(6), 10, bump), exact(), glb());
  const std::vector<double> times = {0, 0.2};
  const std::vector<FloatRows> shapes = played("test shot", times);
  ASSERT_EQ(shapes.size(), 2u);
  EXPECT_GT(largest_error(clip_of(sheet(6), 10, twist), shapes, times), 0.01);
}

}  // namespace
}  // namespace flexkey::testing
