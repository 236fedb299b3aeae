#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/starter.h"
#include "cli/starter_text.h"
#include "cli/work_folder.h"
#include "flexkey/animate/animate.h"
#include "flexkey/mesh/read_file.h"
#include "flexkey/timeline/parse.h"

namespace flexkey::test {
namespace {

using cli::Starter;
using testing::HasSubstr;
using testing::Not;

Mesh stretched(Mesh mesh, const Vec3& factors, double degrees = 0) {
  mesh.positions = meshes::moved(mesh.positions, meshes::turn(degrees, {0, 1, 1}) * factors.asDiagonal(),
                                 Vec3(7, -2, 100));
  return mesh;
}

Mesh lying_sheet() {
  Mesh mesh = meshes::grid(12, 8);
  mesh.positions = meshes::moved(mesh.positions, meshes::turn(-90, Vec3::UnitX()), Vec3::Zero());
  return mesh;
}

/// A shape of each kind that people have.
struct Kind {
  const char* name;
  Mesh mesh;
  bool is_spread = false;  // far wider than what moves
};
const std::vector<Kind> kinds{
    {"upright", stretched(meshes::sphere(3), {1, 1.6, 0.7})},
    {"ball", meshes::sphere(3)},
    {"bar", meshes::bar(3, 3, 12)},
    {"slantedBar", stretched(meshes::bar(3, 3, 16), {1, 1, 1}, 40)},
    {"sheet", meshes::grid(9, 9)},
    {"lyingSheet", lying_sheet()},
    {"tiny", stretched(meshes::bar(2, 2, 7), {1e-6, 1e-6, 1e-6})},
    {"cube", meshes::cube()},
    {"tetrahedron", meshes::tetrahedron()},
    {"triangle", meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}})},
    {"farPieces", meshes::joined(meshes::sphere(3), stretched(meshes::cube(), {1, 1, 1})), true},
    {"pieces", meshes::joined(meshes::joined(meshes::cube(), meshes::sphere(3)), lying_sheet())},
};

class StarterOf : public testing::TestWithParam<Kind> {};

TEST_P(StarterOf, RunsHoldsItsBaseAndMovesVisibly) {
  const Mesh& mesh = GetParam().mesh;
  const Weld surface = weld(mesh);
  const Starter starter = cli::propose_starter(surface, "mesh.obj");
  const std::string text = cli::starter_text(starter, surface, {"mesh.obj", "shot.yaml", "shot"});
  const ParsedShot parsed = parse_shot(text, "shot.yaml");
  EXPECT_TRUE(parsed.warnings.empty());
  const Clip clip = animate(parsed.shot, mesh);
  const double diagonal = bounds_of(mesh.positions).diagonal();
  double farthest = 0;
  for (const Positions& frame : clip.frames) {
    const Eigen::VectorXd offsets = (frame - mesh.positions).rowwise().norm();
    farthest = std::max(farthest, offsets.maxCoeff());
    for (std::size_t v = 0; v < surface.to_surface.size(); ++v) {
      if (std::ranges::binary_search(starter.base.vertices, surface.to_surface[v])) {
        EXPECT_EQ(offsets[static_cast<Eigen::Index>(v)], 0);
      }
    }
  }
  EXPECT_GT(farthest, (GetParam().is_spread ? 0.002 : 0.05) * diagonal);
  EXPECT_LT(farthest, 0.6 * diagonal);
  EXPECT_LT((clip.frames.back() - mesh.positions).rowwise().norm().maxCoeff(), 0.01 * diagonal);
}

TEST_P(StarterOf, ItsTextTakesTheVerticesThatItSpeaksOf) {
  const Weld surface = weld(GetParam().mesh);
  const Starter starter = cli::propose_starter(surface, "mesh.obj");
  const std::string text = cli::starter_text(starter, surface, {"mesh.obj", "shot.yaml", "shot"});
  const Scene scene = bind_shot(parse_shot(text, "shot.yaml").shot, GetParam().mesh);
  ASSERT_EQ(scene.handles.size(), starter.tips.size() + 1);
  EXPECT_EQ(scene.handles[0].vertices, starter.base.vertices);
  for (std::size_t k = 0; k < starter.tips.size(); ++k)
    EXPECT_EQ(scene.handles[k + 1].vertices, starter.tips[k].part.vertices);
}

void PrintTo(const Kind& kind, std::ostream* out) {
  *out << kind.name;
}

INSTANTIATE_TEST_SUITE_P(, StarterOf, testing::ValuesIn(kinds),
                         [](const auto& kind) { return kind.param.name; });

TEST(Starter, TakesTheGroupAtAnEndWhole) {
  Mesh bar = meshes::bar(2, 2, 10);
  bar.groups = {{"all of it", {}}, {"lid \"3\"", {}}};
  for (int f = 0; f < bar.face_count(); ++f) {
    bar.groups[0].faces.push_back(f);
    double low = 10;
    for (const int v : bar.face(f)) low = std::min(low, bar.positions(v, 2));
    if (low >= 8) bar.groups[1].faces.push_back(f);
  }
  const Weld surface = weld(bar);
  const Starter starter = cli::propose_starter(surface, "bar.obj");
  ASSERT_EQ(starter.tips.size(), 1u);
  EXPECT_EQ(starter.tips[0].part.name, "lid \"3\"");
  EXPECT_EQ(starter.tips[0].part.vertices, meshes::between(bar, 2, 8, 10));
  const std::string text = cli::starter_text(starter, surface, {"bar.obj", "shot.yaml", "shot"});
  EXPECT_EQ(parse_shot(text, "shot.yaml").shot.handles[1].name, "lid \"3\"");
}

class Init : public WorkFolder {};

TEST_F(Init, WritesATimelineThatAnimates) {
  const ProgramResult result = run({"init", "bar.obj", "shot.yaml"});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.output, "shot.yaml\n");
  EXPECT_THAT(result.errors, HasSubstr("flexkey animate shot.yaml -d out"));
  EXPECT_EQ(run({"animate", "shot.yaml", "-d", "out"}).exit_code, 0);
  EXPECT_THAT(names_in("out"), testing::IsSupersetOf({"shot.glb", "shot.html"}));
}

TEST_F(Init, NamesTheMeshAsTheTimelineSeesIt) {
  EXPECT_EQ(run({"init", "bar.obj", "shots/first.yaml"}).exit_code, 0);
  EXPECT_THAT(read_file(folder() / "shots/first.yaml"), HasSubstr("mesh: ../bar.obj\n"));
  EXPECT_EQ(run({"check", "shots/first.yaml"}).exit_code, 0);
}

TEST_F(Init, ReplacesNothingUnlessItIsForced) {
  write("bar.yaml", "mine");
  const ProgramResult refused = run({"init", "bar.obj"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("'bar.yaml' is there already; --force replaces it"));
  EXPECT_EQ(read_file(folder() / "bar.yaml"), "mine");
  EXPECT_EQ(run({"init", "bar.obj", "--force"}).exit_code, 0);
  EXPECT_THAT(read_file(folder() / "bar.yaml"), HasSubstr("handles:"));
  EXPECT_EQ(run({"init", "bar.obj", "bar.obj", "--force"}).exit_code, 2);
  EXPECT_THAT(read_file(folder() / "bar.obj"), Not(HasSubstr("handles:")));
}

TEST_F(Init, PrintsTheTimelineForADash) {
  const ProgramResult result = run({"init", "bar.obj", "-"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(names_in("."), std::vector<std::string>{"bar.obj"});
  EXPECT_EQ(run({"check", "-"}, result.output).exit_code, 0);
}

TEST_F(Init, RefusesWhatHasNoSurface) {
  write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  write("points.obj", "v 0 0 0\nv 1 0 0\n");
  for (const char* mesh : {"line.obj", "points.obj", "missing.obj"}) {
    const ProgramResult result = run({"init", mesh, "shot.yaml"});
    EXPECT_EQ(result.exit_code, 3) << mesh;
    EXPECT_THAT(result.errors, HasSubstr("error: "));
    EXPECT_FALSE(std::filesystem::exists(folder() / "shot.yaml"));
  }
}

}  // namespace
}  // namespace flexkey::test
