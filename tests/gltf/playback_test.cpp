#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "flexkey/gltf/primitives.h"
#include "flexkey/gltf/write_glb.h"
#include "gltf/clips.h"
#include "gltf/glb_file.h"

namespace flexkey::testing {
namespace {

/// The clip's mesh at a frame, which may lie between two, in the order of the written vertices of one
/// primitive.
Eigen::MatrixXd solved(const Clip& clip, const Primitive& primitive, double frame) {
  const auto before = static_cast<std::size_t>(frame);
  const std::size_t after = std::min(before + 1, clip.frames.size() - 1);
  const double share = frame - static_cast<double>(before);
  const Positions between = (1 - share) * clip.frames[before] + share * clip.frames[after];
  return between(primitive.vertices, Eigen::all);
}

/// The largest distance of a written vertex from the clip when the file plays at this frame.
double playback_error(const Clip& clip, const tinygltf::Model& model, double frame) {
  const std::vector<Primitive> primitives = split_primitives(clip.mesh);
  const std::vector<float> weights = weights_at(model, static_cast<float>(frame / clip.fps));
  double largest = 0;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const Eigen::MatrixXd off =
        morphed(model, i, "POSITION", weights).cast<double>() - solved(clip, primitives[i], frame);
    largest = std::max(largest, off.rowwise().norm().maxCoeff());
  }
  return largest;
}

tinygltf::Model written(const Clip& clip, const GltfOptions& options = exact()) {
  const TemporaryFolder folder;
  write_glb(clip, options, folder / "shot.glb");
  return load_glb(folder / "shot.glb");
}

TEST(Playback, ShowsEverySolvedFrameToTheLastBitOfAFloat) {
  const Clip clip = clip_of(cube(), 30, twist);
  const tinygltf::Model model = written(clip);
  for (int k = 0; k < 30; ++k) {
    SCOPED_TRACE(k);
    const std::vector<float> weights = weights_at(model, static_cast<float>(k / clip.fps));
    EXPECT_EQ(std::accumulate(weights.begin(), weights.end(), 0.0F), 1.0F);
    EXPECT_EQ(weights[static_cast<std::size_t>(k)], 1.0F);
    EXPECT_LT(playback_error(clip, model, k), 2e-7);
  }
}

TEST(Playback, MovesStraightBetweenFrames) {
  const Clip clip = clip_of(cube(), 12, twist);
  const tinygltf::Model model = written(clip);
  for (const double frame : {0.25, 3.5, 7.1, 10.9})
    EXPECT_LT(playback_error(clip, model, frame), 1e-6) << frame;
}

TEST(Playback, TheBaseIsTheRestMeshAndShowsWithoutAnimation) {
  const Clip clip = clip_of(cube(), 3, twist);
  const tinygltf::Model model = written(clip);
  EXPECT_EQ(model.meshes[0].weights, std::vector<double>(3, 0.0));
  const Primitive primitive = split_primitives(clip.mesh)[0];
  const Eigen::MatrixXf rest = clip.mesh.positions(primitive.vertices, Eigen::all).cast<float>();
  EXPECT_EQ(morphed(model, 0, "POSITION", {0, 0, 0}), rest);
}

TEST(Playback, AVertexThatReturnsIsBitForBitAtRest) {
  const Clip clip = clip_of(cube(), 5, [](const Vec3& p, int k) { return k == 2 ? twist(p, 9) : p; });
  const tinygltf::Model model = written(clip);
  for (const std::size_t still : {0u, 1u, 3u, 4u}) {
    std::vector<float> weights(5, 0.0F);
    weights[still] = 1;
    EXPECT_EQ(morphed(model, 0, "POSITION", weights), morphed(model, 0, "POSITION", {0, 0, 0, 0, 0}));
  }
}

TEST(Playback, ReportsTheErrorThatAReaderFinds) {
  const Clip clip = clip_of(cube(), 20, twist);
  const TemporaryFolder folder;
  const GltfReport report = write_glb(clip, exact(), folder / "shot.glb");
  const tinygltf::Model model = load_glb(folder / "shot.glb");
  double largest = 0;
  for (int k = 0; k < 20; ++k) largest = std::max(largest, playback_error(clip, model, k));
  EXPECT_GT(report.error, 0);
  EXPECT_NEAR(report.error, largest / bounds_of(clip.mesh.positions).diagonal(), 1e-12);
  EXPECT_GT(report.kg_error, 0);
  EXPECT_LT(report.kg_error, 1e-4);
}

TEST(Playback, OneFrameIsOneKeyAtZero) {
  const Clip clip = clip_of(cube(), 1, [](const Vec3& p, int) { return twist(p, 4); });
  const tinygltf::Model model = written(clip);
  const tinygltf::AnimationSampler& sampler = model.animations[0].samplers[0];
  EXPECT_EQ(rows_of(model, sampler.input), Eigen::MatrixXd::Zero(1, 1));
  EXPECT_EQ(rows_of(model, sampler.output), Eigen::MatrixXd::Ones(1, 1));
  EXPECT_LT(playback_error(clip, model, 0), 2e-7);
}

TEST(Playback, KeysLieAtWholeFramesFromZero) {
  Clip clip = clip_of(cube(), 50, twist);
  clip.fps = 29.97;
  const tinygltf::Model model = written(clip);
  const tinygltf::AnimationSampler& sampler = model.animations[0].samplers[0];
  const Eigen::MatrixXd times = rows_of(model, sampler.input);
  ASSERT_EQ(times.rows(), 50);
  for (int k = 0; k < 50; ++k) EXPECT_EQ(times(k, 0), static_cast<double>(static_cast<float>(k / 29.97)));
  const tinygltf::Accessor& input = model.accessors[static_cast<std::size_t>(sampler.input)];
  EXPECT_EQ(input.minValues, std::vector<double>{0});
  EXPECT_EQ(input.maxValues, std::vector<double>{times(49, 0)});
}

TEST(Playback, FarFromTheOriginIsAsGoodAsFloatsAre) {
  Mesh far = cube();
  far.positions.array() += 1000;
  const Clip clip =
      clip_of(far, 10, [](const Vec3& p, int k) { return Vec3(p + 0.013 * k * Vec3(1, 2, 3)); });
  const tinygltf::Model model = written(clip);
  for (int k = 0; k < 10; ++k) EXPECT_LT(playback_error(clip, model, k), 1001 * 6e-8 * std::sqrt(3.0));
}

TEST(Playback, DoesNotDependOnTheOrderOfVerticesAndFaces) {
  const std::vector<int> order = {5, 2, 7, 0, 3, 6, 1, 4};  // vertex order[v] of the cube becomes v
  const Mesh straight = cube();
  Mesh shuffled;
  shuffled.positions = straight.positions(order, Eigen::all);
  for (int f = straight.face_count() - 1; f >= 0; --f) {
    std::vector<int> face;
    for (const int v : straight.face(f)) {
      face.push_back(static_cast<int>(std::find(order.begin(), order.end(), v) - order.begin()));
    }
    shuffled.add_face(face);
  }
  const tinygltf::Model a = written(clip_of(straight, 4, twist)), b = written(clip_of(shuffled, 4, twist));
  const auto corners = [](const tinygltf::Model& model) {
    const Eigen::MatrixXf shape = morphed(model, 0, "POSITION", {0, 0, 0, 1});
    const Eigen::MatrixXd triangles = rows_of(model, model.meshes[0].primitives[0].indices);
    std::vector<std::array<float, 3>> points;
    for (Eigen::Index i = 0; i < triangles.rows(); ++i) {
      const auto v = static_cast<Eigen::Index>(triangles(i, 0));
      points.push_back({shape(v, 0), shape(v, 1), shape(v, 2)});
    }
    return points;
  };
  const auto forwards = corners(a), backwards = corners(b);
  ASSERT_EQ(forwards.size(), 36u);
  for (std::size_t face = 0; face < 6; ++face) {
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(forwards[face * 6 + i], backwards[(5 - face) * 6 + i]);
  }
}

TEST(Playback, TheNodeAndItsAnimationBearTheShotsName) {
  const tinygltf::Model model = written(clip_of(cube(), 2, twist));
  ASSERT_EQ(model.nodes.size(), 1u);
  EXPECT_EQ(model.nodes[0].name, "test shot");
  EXPECT_EQ(model.nodes[0].mesh, 0);
  EXPECT_EQ(model.meshes[0].name, "test shot");
  EXPECT_EQ(model.animations[0].name, "test shot");
  EXPECT_EQ(model.animations[0].channels[0].target_node, 0);
  EXPECT_EQ(model.animations[0].channels[0].target_path, "weights");
  EXPECT_EQ(model.scenes[static_cast<std::size_t>(model.defaultScene)].nodes, std::vector<int>{0});
}

}  // namespace
}  // namespace flexkey::testing
