#include <gtest/gtest.h>

#include <numbers>
#include <optional>

#include "flexkey/timeline/number.h"
#include "flexkey/timeline/scalar.h"
#include "timeline/parsing.h"

namespace flexkey {
namespace {

constexpr double pi = std::numbers::pi;

TEST(Numbers, AreDecimal) {
  EXPECT_EQ(parse_number("-.52"), -0.52);
  EXPECT_EQ(parse_number("1e-4"), 1e-4);
  EXPECT_EQ(parse_number("+3"), 3);
  EXPECT_EQ(parse_number("5."), 5);
  EXPECT_EQ(parse_number("0.5"), 0.5);
  EXPECT_EQ(parse_number("0"), 0);
  EXPECT_EQ(parse_number("-0.25E+2"), -25);
}

TEST(Numbers, FillTheWholeText) {
  for (const char* text : {"",     "-",   ".",    "+-3",      "1 2",  "1,5",   "1_000", "3m",   "e5",
                           "1e",   "--1", "0x10", "0b1",      "010",  "-010",  "00.5",  ".inf", "-.inf",
                           ".nan", "nan", "inf",  "infinity", "1e31", "-1e31", "1e999", "½"}) {
    EXPECT_EQ(parse_number(text), std::nullopt) << text;
  }
}

TEST(Numbers, WholeOnes) {
  EXPECT_EQ(parse_whole("+12"), 12);
  for (const char* text : {"1.0", "1e3", "99999999999", "012", ""})
    EXPECT_EQ(parse_whole(text), std::nullopt) << text;
}

double parse_duration(const std::string& duration, const std::string& more = "") {
  return parse(with_base("duration: " + duration + "\n" + more)).duration;
}

TEST(Times, InSecondsFramesAndByName) {
  EXPECT_EQ(parse_duration("1.5"), 1.5);
  EXPECT_EQ(parse_duration("1.5s"), 1.5);
  EXPECT_EQ(parse_duration("36f"), 1.5);
  EXPECT_EQ(parse_duration("36f", "fps: 12\n"), 3);
  EXPECT_EQ(parse_duration("hit", "times: {hit: 2s}\n"), 2);
  EXPECT_EQ(parse_duration("hit+4f", "times: {hit: 2s}\nfps: 8\n"), 2.5);
  EXPECT_EQ(parse_duration("hit-0.5s", "times: {hit: 2s}\n"), 1.5);
  EXPECT_EQ(parse_duration("hit + 1", "times: {hit: 2s}\n"), 3);
  EXPECT_EQ(parse_duration("land", "times: {hit: 2s, land: hit+12f}\n"), 2.5);
}

TEST(Times, NearAFrameAreThatFrameToTheBit) {
  for (int k = 0; k < 200; ++k) {
    EXPECT_EQ(parse_duration("hit+" + std::to_string(k) + "f", "times: {hit: 1s}\n"), (24 + k) / 24.0) << k;
  }
  EXPECT_EQ(parse_duration("0.0416666667"), 1 / 24.0);
  EXPECT_EQ(parse_duration("0.04"), 0.04);
}

TEST(Frames, AreCountedWithTheirEnds) {
  EXPECT_EQ(parse(with_base("duration: 2s\n")).frame_count(), 49);
  EXPECT_EQ(parse(with_base("duration: 0.1s\nfps: 30\n")).frame_count(), 4);
  EXPECT_EQ(parse(with_base("")).frame_count(), 1) << "nothing moves: one frame";
  EXPECT_EQ(parse(with_base("duration: 99999f\n")).frame_count(), 100'000);
}

double parse_angle(const std::string& angle) {
  return parse_tip("    rotate: {axis: z, keys: {0s: " + angle + "}}\n").rotate.at(0).value.angle;
}

TEST(Angles, HaveUnits) {
  EXPECT_EQ(parse_angle("90deg"), pi / 2);
  EXPECT_EQ(parse_angle("720deg"), 4 * pi);
  EXPECT_EQ(parse_angle("-45deg"), -pi / 4);
  EXPECT_EQ(parse_angle("1.57rad"), 1.57);
}

TEST(Axes, AreUnitVectors) {
  const auto axis = [](const std::string& text) {
    return parse_tip("    rotate: {axis: " + text + ", keys: {0s: 1rad}}\n").rotate.at(0).value.axis;
  };
  EXPECT_EQ(axis("x"), Vec3::UnitX());
  EXPECT_EQ(axis("-y"), -Vec3::UnitY());
  EXPECT_EQ(axis("+z"), Vec3::UnitZ());
  EXPECT_TRUE(axis("[0, 3, 4]").isApprox(Vec3(0, 0.6, 0.8), 1e-15));
  EXPECT_TRUE(axis("[1e-30, 0, 0]").isApprox(Vec3::UnitX(), 1e-15));
}

TEST(Switches, HaveThreeSpellings) {
  Findings findings;
  const Sources files = no_sources();
  Scope scope(findings, files);
  Node node;
  node.kind = Node::Kind::scalar;
  for (const char* text : {"on", "true", "yes"}) {
    node.text = text;
    EXPECT_EQ(read_switch(node, scope), true) << text;
  }
  for (const char* text : {"off", "false", "no"}) {
    node.text = text;
    EXPECT_EQ(read_switch(node, scope), false) << text;
  }
  node.text = "maybe";
  EXPECT_EQ(read_switch(node, scope), std::nullopt);
  ASSERT_EQ(findings.errors().size(), 1u);
  EXPECT_EQ(findings.errors()[0].message, "'maybe' is neither on nor off");
}

TEST(Motions, AreRead) {
  const Handle tip = parse_tip(
      "    pivot: [1, 2, 3]\n"
      "    to: {keys: {2s: home, 1s: [1, 0, 0]}}\n"
      "    scale: {keys: {0s: 1, 1s: [1, 2, 0.5]}}\n"
      "points: {home: [4, 5, 6]}\n");
  EXPECT_EQ(*tip.pivot, Vec3(1, 2, 3));
  ASSERT_EQ(tip.to.size(), 2u);
  EXPECT_EQ(tip.to[0].time, 1) << "sorted by time";
  EXPECT_EQ(tip.to[1].value, Vec3(4, 5, 6));
  EXPECT_EQ(tip.scale[0].value, Vec3(1, 1, 1));
  EXPECT_EQ(tip.scale[1].value, Vec3(1, 2, 0.5));
}

TEST(Motions, KeysMayBeListed) {
  const Handle tip = parse_tip(
      "    rotate: {axis: z, ease: ease, keys: [{at: 2s, value: 90deg, ease: hold}, {at: 0, value: "
      "0deg}]}\n");
  ASSERT_EQ(tip.rotate.size(), 2u);
  EXPECT_EQ(tip.rotate[0].time, 0);
  EXPECT_EQ(tip.rotate[0].ease.kind, Easing::Kind::bezier);
  EXPECT_EQ(tip.rotate[1].ease.kind, Easing::Kind::hold);
}

TEST(Easings, TheNearestOneWins) {
  const std::string file_ease = "ease: [0.1, -1, 0.9, 2]\n";
  const auto ease_of = [&](const std::string& track) {
    return parse_tip("    move: {" + track + "}\n" + file_ease).move.at(0).ease;
  };
  EXPECT_EQ(ease_of("keys: {0s: [0, 0, 0]}").y2, 2) << "the file's";
  EXPECT_EQ(ease_of("keys: {0s: [0, 0, 0]}, ease: smooth").kind, Easing::Kind::smooth) << "the track's";
  EXPECT_EQ(ease_of("keys: [{at: 0s, value: [0, 0, 0], ease: hold}], ease: smooth").kind, Easing::Kind::hold);
  EXPECT_EQ(parse_tip("    move: {keys: {0s: [0, 0, 0]}}\n").move.at(0).ease.kind, Easing::Kind::linear);
}

TEST(Lambda, Forms) {
  EXPECT_EQ(parse(with_base("lambda: 0.25\n")).lambda.at(0).value, 0.25);
  EXPECT_EQ(parse(with_base("lambda: {hit: 1, 0s: 0}\ntimes: {hit: 2s}\n")).lambda.at(1).time, 2);
  const Track<double> eased =
      parse(with_base("lambda: {keys: {2s: 0, 3s: 0.2}, ease: ease-in-out}\n")).lambda;
  EXPECT_EQ(eased.at(0).ease.x1, 0.42);
  EXPECT_EQ(parse(with_base("lambda: {ease: 1, 0s: 0}\ntimes: {ease: 2s}\n")).lambda.size(), 2u)
      << "a time may be named like a key";
}

TEST(Curves, NamedOnesServeHandlesAndSelections) {
  const Handle ridge = parse(
                           "mesh: a.obj\n"
                           "points: {a: [0, 0, 0], b: [1, 0, 0]}\n"
                           "paths: {line: [a, b], arc: {catmull-rom: [a, b, [2, 0, 0]]}, same: line}\n"
                           "handles:\n"
                           "  ridge:\n"
                           "    select: {path: line}\n"
                           "    curve: {keys: {0s: rest, 1s: arc, 2s: {polyline: [a, b]}, 3s: same}}\n")
                           .handles.at(0);
  ASSERT_EQ(ridge.curve.size(), 4u);
  EXPECT_EQ(ridge.curve[1].value.kind, Curve::Kind::catmull_rom);
  EXPECT_EQ(ridge.curve[1].value.points.at(2), Vec3(2, 0, 0));
  EXPECT_EQ(ridge.curve[3].value.kind, Curve::Kind::polyline);
}

TEST(Solver, Presets) {
  const SolverSettings quality = parse(with_base("")).solver;
  EXPECT_EQ(quality.system, SolverSettings::System::least_squares);
  EXPECT_EQ(quality.local_scale, SolverSettings::LocalScale::uniform);
  EXPECT_EQ(quality.epsilon, 0.05);
  EXPECT_EQ(quality.weights, SolverSettings::Weights::clamped);
  EXPECT_EQ(quality.iterations, 30);
  EXPECT_EQ(quality.tolerance, 1e-3);
  const SolverSettings paper = parse(with_base("solver: {preset: paper}\n")).solver;
  EXPECT_EQ(paper.preset, SolverSettings::Preset::paper);
  EXPECT_EQ(paper.local_scale, SolverSettings::LocalScale::axis);
  EXPECT_EQ(paper.epsilon, 0);
  EXPECT_EQ(paper.weights, SolverSettings::Weights::cotangent);
  EXPECT_EQ(paper.iterations, 2);
  EXPECT_TRUE(quality.predict && quality.accelerate);
  EXPECT_NEAR(quality.max_step, std::numbers::pi / 6, 1e-15);
  EXPECT_FALSE(paper.predict || paper.accelerate);
  EXPECT_TRUE(std::isinf(paper.max_step));
}

TEST(Solver, PredictionAndAcceleration) {
  const SolverSettings solver =
      parse(with_base("solver: {predict: off, accelerate: no, max_step: 10deg}\n")).solver;
  EXPECT_FALSE(solver.predict || solver.accelerate);
  EXPECT_NEAR(solver.max_step, std::numbers::pi / 18, 1e-15);
  EXPECT_TRUE(std::isinf(parse(with_base("solver: {max_step: off}\n")).solver.max_step));
}

TEST(Solver, WeightsCellsAndRows) {
  const SolverSettings usual = parse(with_base("")).solver;
  EXPECT_EQ(usual.cell, SolverSettings::Cell::spokes);
  EXPECT_FALSE(usual.area_weighting);
  const SolverSettings solver = parse(with_base("solver: {weights: intrinsic-delaunay, cell: "
                                                "spokes-and-rims, area_weighting: on, preset: paper}\n"))
                                    .solver;
  EXPECT_EQ(solver.weights, SolverSettings::Weights::intrinsic_delaunay);
  EXPECT_EQ(solver.cell, SolverSettings::Cell::spokes_and_rims);
  EXPECT_TRUE(solver.area_weighting);
  EXPECT_FALSE(parse(with_base("solver: {area_weighting: off, system: direct}\n")).solver.area_weighting);
}

TEST(Solver, ExplicitKeysWinOverThePreset) {
  const SolverSettings solver =
      parse(with_base(
                "solver: {iterations: 9, system: direct, weights: uniform, epsilon: 0.1, tolerance: 0.5%, "
                "local_scale: none, preset: paper}\n"))
          .solver;
  EXPECT_EQ(solver.preset, SolverSettings::Preset::paper);
  EXPECT_EQ(solver.iterations, 9);
  EXPECT_EQ(solver.system, SolverSettings::System::direct);
  EXPECT_EQ(solver.weights, SolverSettings::Weights::uniform);
  EXPECT_EQ(solver.epsilon, 0.1);
  EXPECT_EQ(solver.tolerance, 0.005);
  EXPECT_EQ(solver.local_scale, SolverSettings::LocalScale::none);
  EXPECT_EQ(parse(with_base("solver: {tolerance: 1e-4}\n")).solver.tolerance, 1e-4)
      << "a plain number is a share";
}

TEST(Mesh, Forms) {
  const MeshSource mesh =
      parse("mesh: {loose: hold, weld: 0.01%, file: a.obj}\nhandles: {a: {select: {group: a}}}\n").mesh;
  EXPECT_EQ(mesh.file, "a.obj");
  EXPECT_EQ(mesh.where.column, 40);
  EXPECT_EQ(mesh.loose, MeshSource::Loose::hold);
  EXPECT_TRUE(mesh.weld.is_share);
  EXPECT_DOUBLE_EQ(mesh.weld.value, 1e-4);
}

std::vector<std::string> node_names(const std::string& mesh) {
  std::vector<std::string> names;
  for (const NodeName& node : parse("mesh: " + mesh + "\nhandles: {a: {select: {group: a}}}\n").mesh.nodes)
    names.push_back(node.name);
  return names;
}

TEST(Mesh, NodesOfAScene) {
  using testing::ElementsAre;
  EXPECT_THAT(node_names("pig.glb"), ElementsAre());
  EXPECT_THAT(node_names("{file: pig.glb, nodes: all}"), ElementsAre());
  EXPECT_THAT(node_names("{file: pig.glb, nodes: body}"), ElementsAre("body"));
  EXPECT_THAT(node_names("{file: pig.gltf, nodes: [body, left eye]}"), ElementsAre("body", "left eye"));
  EXPECT_THAT(node_names("pig.GLB#left eye"), ElementsAre("left eye"));
  EXPECT_THAT(node_names("{file: a#1/pig.gltf#b#c}"), ElementsAre("b#c"));
  EXPECT_THAT(node_names("pig#2.obj"), ElementsAre());
  const MeshSource mesh = parse("mesh: a#1/pig.gltf#b\nhandles: {a: {select: {group: a}}}\n").mesh;
  EXPECT_EQ(mesh.file, "a#1/pig.gltf");
  EXPECT_EQ(mesh.nodes[0].where.column, 7);
}

TEST(Output, Forms) {
  EXPECT_EQ(parse(with_base("")).gltf.path, "") << "a shot may be checked without outputs";
  EXPECT_EQ(parse(with_base("output: {gltf: a.glb}\n")).gltf.path, "a.glb");
  const GltfOutput gltf =
      parse(with_base("output: {gltf: {normals: none, path: a.glb, max_targets: 9}}\n")).gltf;
  EXPECT_EQ(gltf.path, "a.glb");
  EXPECT_EQ(gltf.where.column, 38);
  EXPECT_FALSE(gltf.normals);
  EXPECT_EQ(gltf.max_targets, 9);
  EXPECT_EQ(GltfOutput().max_targets, 200);
}

TEST(Values, OfAnHtmlOutput) {
  EXPECT_EQ(parse(with_base("output: a.glb\n")).html.path, "");
  const Shot shot = parse(with_base("output: {html: a.html}\n"));
  EXPECT_EQ(shot.html.path, "a.html");
  EXPECT_EQ(shot.html.where.column, 16);
  EXPECT_EQ(shot.gltf.path, "");
  EXPECT_EQ(parse(with_base("output: {gltf: a.glb, html: {path: b.html}}\n")).html.path, "b.html");
}

GltfOutput gltf_of(const std::string& keys) {
  return parse(with_base("output: {gltf: {path: a.glb" + keys + "}}\n")).gltf;
}

TEST(Output, AProfileIsAPresetOfBasisAndEncoding) {
  using Basis = GltfOutput::Basis;
  using Encoding = GltfOutput::Encoding;
  const auto choices = [](const std::string& keys) {
    return std::pair(gltf_of(keys).basis, gltf_of(keys).encoding);
  };
  EXPECT_EQ(choices(""), std::pair(Basis::knots, Encoding::floats));
  EXPECT_EQ(choices(", profile: compat"), std::pair(Basis::knots, Encoding::floats));
  EXPECT_EQ(choices(", profile: web"), std::pair(Basis::pca, Encoding::meshopt));
  EXPECT_EQ(choices(", profile: exact"), std::pair(Basis::frames, Encoding::floats));
  EXPECT_EQ(choices(", encoding: float, profile: web"), std::pair(Basis::pca, Encoding::floats));
  EXPECT_EQ(choices(", basis: frames, encoding: meshopt"), std::pair(Basis::frames, Encoding::meshopt));
  EXPECT_DOUBLE_EQ(gltf_of("").tolerance, 1e-3);
  EXPECT_DOUBLE_EQ(gltf_of(", tolerance: 0.5%").tolerance, 5e-3);
}

TEST(Output, ClipsAreNamedTimes) {
  const Shot shot = parse(with_base("clips: {walk: [0s, 1s], jump: [1s, 36f]}\n"));
  ASSERT_EQ(shot.clips.size(), 2u);
  EXPECT_EQ(shot.clips[1].name, "jump");
  EXPECT_DOUBLE_EQ(shot.clips[1].time.from, 1);
  EXPECT_DOUBLE_EQ(shot.clips[1].time.to, 1.5);
}

TEST(Output, HandlesAsNodes) {
  EXPECT_FALSE(parse(with_base("output: {gltf: {path: a.glb}}\n")).gltf.handles);
  EXPECT_TRUE(parse(with_base("output: {gltf: {path: a.glb, handles: true}}\n")).gltf.handles);
}

TEST(Output, SplitsMeshesOnRequest) {
  EXPECT_FALSE(gltf_of("").split);
  EXPECT_FALSE(gltf_of(", split: none").split);
  EXPECT_TRUE(gltf_of(", split: auto").split);
}

TEST(Output, AnimationForms) {
  const auto gltf = [](const std::string& animation) {
    return parse(with_base("output: {gltf: {path: a.glb, animation: " + animation + "}}\n")).gltf;
  };
  EXPECT_EQ(gltf("Lean").animation, "Lean");
  EXPECT_EQ(gltf("{name: Lean}").animation, "Lean");
  EXPECT_EQ(gltf("{merge_into: Walk}").merge_into.name, "Walk");
  EXPECT_EQ(gltf("{merge_into: Walk}").merge_into.where.column, 54);
  EXPECT_EQ(gltf("{merge_into: Walk}").animation, "");
}

}  // namespace
}  // namespace flexkey
