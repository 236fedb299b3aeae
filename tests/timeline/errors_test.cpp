// Broken timelines and every error that each of them gives, to the character.
#include <gtest/gtest.h>

#include "timeline/parsing.h"

namespace flexkey {
namespace {

struct Broken {
  std::string text;
  std::string errors;  // without "shot.yaml:" before the first
};

void expect_errors(const std::vector<Broken>& table) {
  for (const Broken& broken : table)
    EXPECT_EQ(errors_of(broken.text), "shot.yaml:" + broken.errors) << broken.text;
}

TEST(Errors, AsDocumented) {
  EXPECT_EQ(
      errors_of("mesh: meshes/bar.obj\nhandles:\n  base: {select: {axis: z, below: 1%}}\n  tip:\n"
                "    select: {axis: z, above: 99%}\n    rotat: {axis: z, keys: {0s: 0deg, 2s: 90deg}}\n"),
      "shot.yaml:6:5: error: unknown key 'rotat' in handle 'tip'; did you mean 'rotate'?");
  EXPECT_EQ(errors_of("mesh: h.obj\nhandles: {a: {select: {group: a}}}\n\n\n\n\n\n\n\n\n\n\n"
                      "lambda: {2s: 0, 2.5s: 0.02, 3s: 0.2, 4s: 0.5, 6s:    1.2}\n"),
            "shot.yaml:13:54: error: lambda 1.2 is outside 0..1 (0 smooth, 1 most rigid)");
  EXPECT_EQ(errors_of("mesh: pig.glb\nhandles:\n  leg:\n    select: {group: leg}\n"
                      "    <<: {move: {keys: {0s: [0,0,0]}}, move: {keys: {}}}\n"),
            "shot.yaml:5:39: error: duplicate key 'move'");
}

TEST(Errors, OfTheTopLevel) {
  expect_errors({
      {"fps: 24\n", "1:1: error: a timeline needs 'mesh'\nshot.yaml:1:1: error: a timeline needs 'handles'"},
      {"mesh: a.obj\n", "1:1: error: a timeline needs 'handles'"},
      {"mesh: a.obj\nhandels: {a: {select: {group: a}}}\n",
       "2:1: error: unknown key 'handels'; did you mean 'handles'?"},
      {"mesh: a.obj\nhandles:\n", "2:1: error: 'handles' has no value"},
      {"mesh: a.obj\nhandles: {}\n", "2:10: error: 'handles' names no handle"},
      {"mesh: a.obj\nhandles: [{select: {group: a}}]\n",
       "2:10: error: 'handles' must be a mapping such as {tip: {select: {axis: z, above: 99%}}}, not a list"},
      {with_base("version: 2\n"), "4:10: error: version 2 is not known; this program reads version 1"},
      {with_base("fps: 0\n"), "4:6: error: fps 0 is outside 0..1000 (frames a second, above 0)"},
      {with_base("fps: 1001\n"), "4:6: error: fps 1001 is outside 0..1000 (frames a second, above 0)"},
      {with_base("fps: [24]\n"), "4:6: error: a number belongs here, not a list"},
      {with_base("loop: cicle\n"), "4:7: error: unknown loop 'cicle'; did you mean 'cycle'?"},
      {with_base("ease: easein\n"), "4:7: error: unknown easing 'easein'; did you mean 'ease-in'?"},
      {with_base("ease: bouncy\n"),
       "4:7: error: unknown easing 'bouncy'; known are linear, hold, ease, ease-in, "
       "ease-out, ease-in-out, smooth and [x1, y1, x2, y2]"},
      {with_base("ease: [0.5, 0, 1.5, 1]\n"), "4:16: error: x2 of an easing is 1.5, outside 0..1"},
      {with_base("ease: [0.5, 0, 1]\n"),
       "4:7: error: a cubic-bezier easing is [x1, y1, x2, y2], not a list of 3"},
      {with_base("duration: 100000f\n"),
       "4:11: error: the shot would have 100001 frames; 100000 are the most"},
      {with_base("lambda: {0s: 0, 2h: 1}\n"),
       "4:17: error: '2h' is not a time; times are seconds (1.5s), frames (36f) "
       "or names (hit, hit+4f)"},
      {with_base("lambda: {0s: 0, 1e9: 1}\n"),
       "4:17: error: the shot would have 24000000001 frames; 100000 are the most"},
      {with_base("mesh2: 1\nxyzzy: 2\n"),
       "4:1: error: unknown key 'mesh2'; did you mean 'mesh'?\nshot.yaml:5:1: error: unknown key 'xyzzy'; "
       "known are "
       "version, mesh, fps, duration, loop, vars, times, points, paths, poses, roi, handles, rigid, attach, "
       "clips, "
       "lambda, ease, solver, output, sweep"},
  });
}

TEST(Errors, OfNumbers) {
  expect_errors({
      {with_base("fps: 0x10\n"), "4:6: error: '0x10' is hexadecimal; numbers are decimal"},
      {with_base("fps: 010\n"), "4:6: error: '010' begins with 0 and could be octal; write it without the 0"},
      {with_base("fps: .inf\n"), "4:6: error: '.inf' is not a finite number"},
      {with_base("fps: -.NaN\n"), "4:6: error: '-.NaN' is not a finite number"},
      {with_base("fps: 1e40\n"), "4:6: error: '1e40' is out of range; numbers reach from -1e30 to 1e30"},
      {with_base("fps: 24fps\n"), "4:6: error: '24fps' is not a number"},
      {with_base("solver: {iterations: 2.5}\n"), "4:22: error: '2.5' is not a whole number"},
      {with_base("duration: 0x1f\n"),
       "4:11: error: '0x1f' is hexadecimal; numbers are decimal; times are seconds (1.5s), frames (36f) or "
       "names (hit, hit+4f)"},
      {with_base("duration: .nan\n"),
       "4:11: error: '.nan' is not a finite number; times are seconds (1.5s), frames "
       "(36f) or names (hit, hit+4f)"},
  });
}

TEST(Errors, OfNames) {
  expect_errors({
      {with_base("times: {hit: 1s}\nduration: hti\n"),
       "5:11: error: unknown time 'hti'; did you mean 'hit'?"},
      {with_base("times: {hit: 1s}\nduration: hit+x\n"),
       "5:11: error: 'hit+x' is not a time; times are seconds (1.5s), frames (36f) or names (hit, hit+4f)"},
      {with_base("times: {hit: 1s}\nduration: hit-2s\n"),
       "5:11: error: time hit-2s lies before the start, 0s"},
      {with_base("duration: later\n"),
       "4:11: error: unknown time 'later'; such names are defined under 'times'"},
      {with_base("times: {2hit: 1s}\n"),
       "4:9: error: '2hit' cannot name a time; use letters, digits and _, with a letter first"},
      {with_base("times: {hit: -1}\nduration: hit\n"), "4:14: error: time -1 lies before the start, 0s"},
      {with_base("times: [1s]\n"), "4:8: error: 'times' must be a mapping such as {hit: 1.5s}, not a list"},
      {with_base("points: {tip: [0, 0]}\nroi: {nearest: tip}\n"),
       "4:15: error: three numbers [x, y, z] belong here, not a list of 2"},
      {with_base("points: {tip: [0, 0, up]}\n"), "4:22: error: 'up' is not a number"},
      {with_base("points: {tip: [0, 0, 1]}\nroi: {nearest: tpi}\n"),
       "5:16: error: unknown point 'tpi'; did you mean 'tip'?"},
      {with_base("paths: {arc: [[0, 0, 0]]}\n"), "4:14: error: a curve has at least 2 points, not 1"},
      {with_base("paths: {arc: {bezier: [[0, 0, 0], [1, 0, 0], [2, 0, 0]]}}\n"),
       "4:23: error: a bezier curve has 3n + 1 points (4, 7, 10, …), not 3"},
      {with_base("paths: {arc: {bezir: []}}\n"),
       "4:15: error: unknown key 'bezir' in path 'arc'; did you mean 'bezier'?"},
      {with_base("paths: {arc: {polyline: [[0, 0, 0], [1, 0, 0]], bezier: []}}\n"),
       "4:49: error: a curve has one kind; 'bezier' stands beside 'polyline'"},
      {with_base("paths: {arc: {}}\n"), "4:14: error: path 'arc' needs polyline, catmull-rom or bezier"},
      {with_base("paths: {rest: [[0, 0, 0], [1, 0, 0]]}\n"),
       "4:9: error: a path cannot be named 'rest'; it stands for the handle's own shape"},
  });
}

TEST(Errors, OfSelections) {
  expect_errors({
      {with_base("roi: leg\n"),
       "4:6: error: 'roi' must be a mapping such as {axis: z, above: 99%}, not 'leg'"},
      {with_base("roi: {}\n"), "4:6: error: 'roi' needs a kind, such as axis, group, sphere or vertices"},
      {with_base("roi: {grow: 2}\n"),
       "4:6: error: 'roi' needs a kind, such as axis, group, sphere or vertices"},
      {with_base("roi: {gruop: leg}\n"), "4:7: error: unknown key 'gruop' in 'roi'; did you mean 'group'?"},
      {with_base("roi: {axis: z, above: 0, group: leg}\n"),
       "4:26: error: a selection has one kind; 'group' stands beside 'axis': join them with all: [{axis: …}, "
       "{group: …}] or any: […]"},
      {with_base("roi: {attribute: _MASK}\n"), "4:18: error: 'attribute' needs 'above' or 'below' beside it"},
      {with_base("roi: {attribute: MASK, above: 0.5}\n"),
       "4:18: error: 'MASK' is no custom attribute of glTF, whose names begin with '_'"},
      {with_base("roi: {axis: z}\n"), "4:13: error: 'axis' needs 'above' or 'below' beside it"},
      {with_base("roi: {axis: w, above: 1}\n"), "4:13: error: the axis of a selection is x, y or z, not 'w'"},
      {with_base("roi: {above: 1%}\n"), "4:7: error: 'above' needs 'axis' or 'attribute' beside it"},
      {with_base("roi: {axis: z, abov: 1%}\n"),
       "4:16: error: unknown key 'abov' in 'roi'; did you mean 'above'?"},
      {with_base("roi: {axis: z, above: 1 %}\n"),
       "4:23: error: '1 %' is not a number; lengths are mesh units (2) or shares (5%)"},
      {with_base("roi: {vertices: []}\n"), "4:17: error: 'vertices' lists no vertex"},
      {with_base("roi: {vertices: [5-2]}\n"), "4:18: error: the range '5-2' runs backwards"},
      {with_base("roi: {vertices: [-3]}\n"), "4:18: error: vertex -3 does not exist; indices begin at 0"},
      {with_base("roi: {vertices: [0, 1.5]}\n"),
       "4:21: error: '1.5' is not a vertex index or a range such as 12-40"},
      {with_base("roi: {vertices: [[1]]}\n"),
       "4:18: error: a vertex index or a range such as 12-40 belongs here, not a list"},
      {with_base("roi: {group: [a, b]}\n"), "4:14: error: 'group' takes one name, not a list"},
      {with_base("roi: {sphere: {center: [0, 0, 0]}}\n"), "4:15: error: 'sphere' needs 'radius'"},
      {with_base("roi: {sphere: {center: [0, 0, 0], radius: -1}}\n"), "4:43: error: length -1 is below 0"},
      {with_base("roi: {box: {min: [0, 2, 0], max: [1, 1, 1]}}\n"),
       "4:12: error: the box's min is above its max along y"},
      {with_base("roi: {plane: {point: [0, 0, 0], normal: [0, 0, 0], within: 1}}\n"),
       "4:41: error: the axis [0, 0, 0] has no direction"},
      {with_base("roi: {path: [[0, 0, 0]]}\n"), "4:13: error: a path selection has at least 2 points, not 1"},
      {with_base("roi: {path: arc}\n"),
       "4:13: error: unknown path 'arc'; such names are defined under 'paths'"},
      {with_base("roi: {boundary: short}\n"),
       "4:17: error: unknown boundary 'short'; known are longest, all"},
      {with_base("roi: {component: -1}\n"), "4:18: error: components are counted from 0"},
      {with_base("roi: {any: {group: a}}\n"), "4:12: error: 'any' takes a list of selections, not a mapping"},
      {with_base("roi: {all: []}\n"), "4:12: error: 'all' takes a list of selections, not an empty one"},
      {with_base("roi: {not: [{group: a}]}\n"),
       "4:12: error: 'not' must be a mapping such as {axis: z, above: 99%}, not a list"},
      {with_base("roi: {group: a, grow: 1001}\n"), "4:23: error: grow 1001 is outside 0..1000 rings"},
  });
}

TEST(Errors, OfHandles) {
  expect_errors({
      {with_base("  tip: {}\n"), "4:3: error: handle 'tip' needs 'select'"},
      {with_base("  tip:\n"),
       "4:3: error: handle 'tip' must be a mapping such as {select: {axis: z, above: 99%}}, not "
       "an empty value"},
      {with_base("  tip: {selct: {group: a}}\n"),
       "4:9: error: unknown key 'selct' in handle 'tip'; did you mean 'select'?"},
      {with_tip("    pivot: center\n"),
       "5:12: error: unknown point 'center'; such names are defined under 'points'"},
      {with_tip("    move: {keys: {0s: [0, 0, 0]}}\n    to: {keys: {0s: [0, 0, 0]}}\n"),
       "6:5: error: 'move' and 'to' exclude each other in handle 'tip'"},
      {with_tip("    curve: {keys: {0s: rest}}\n"),
       "5:5: error: 'curve' in handle 'tip' needs an ordered chain of vertices: select it with 'path'"},
      {"mesh: a.obj\nhandles:\n  ridge:\n    select: {path: [[0, 0, 0], [1, 0, 0]], grow: 1}\n"
       "    scale: {keys: {0s: 1}}\n    curve: {keys: {0s: rest}}\n    rotate: {axis: z, keys: {0s: 1deg}}\n",
       "6:5: error: 'scale' and 'curve' exclude each other in handle 'ridge'\n"
       "shot.yaml:6:5: error: 'curve' in handle 'ridge' needs the chain alone, without 'grow'\n"
       "shot.yaml:7:5: error: 'curve' and 'rotate' exclude each other in handle 'ridge'"},
  });
}

TEST(Errors, OfMotions) {
  expect_errors({
      {with_tip("    move: [0, 0, 1]\n"),
       "5:11: error: 'move' of handle 'tip' must be a mapping such as {keys: {0s: …, 2s: …}}, not a list"},
      {with_tip("    move: {0s: [0, 0, 1]}\n"),
       "5:12: error: unknown key '0s' in 'move' of handle 'tip'; times stand under 'keys'"},
      {with_tip("    move: {ease: hold}\n"), "5:11: error: 'move' of handle 'tip' needs 'keys'"},
      {with_tip("    move: {keys: {}}\n"), "5:18: error: 'move' of handle 'tip' has no keys"},
      {with_tip("    move: {keys: 3}\n"),
       "5:18: error: 'keys' in 'move' of handle 'tip' must be a mapping such as {0s: …, 2s: …}, not '3'"},
      {with_tip("    move: {keys: {1s: [0, 0, 0], 0s: [0, 0, 0], 24f: [1, 0, 0]}}\n"),
       "5:49: error: 'move' of handle 'tip' has two keys at 1s"},
      {with_tip("    move: {keys: {-1s: [0, 0, 0]}}\n"), "5:19: error: time -1s lies before the start, 0s"},
      {with_tip("    move: {keys: {0s: 1}}\n"), "5:23: error: three numbers [x, y, z] belong here, not '1'"},
      {with_tip("    move: {keys: {0s: }}\n"),
       "5:19: error: three numbers [x, y, z] belong here, not an empty value"},
      {with_tip("    move: {keys: [{time: 0s, value: [0, 0, 0]}]}\n"),
       "5:19: error: a key of 'move' of handle 'tip' needs 'at'\n"
       "shot.yaml:5:20: error: unknown key 'time' in a key of 'move' of handle 'tip'; known are at, value, "
       "ease"},
      {with_tip("    move: {keys: [{at: 0s, ease: hold}]}\n"),
       "5:19: error: a key of 'move' of handle 'tip' needs 'value'"},
      {with_tip("    rotate: {axis: z, keys: {0s: 90}}\n"),
       "5:34: error: angle '90' needs its unit: 90deg or 90rad"},
      {with_tip("    rotate: {axis: z, keys: {0s: 90 deg}}\n"),
       "5:34: error: '90 deg' is not an angle; write degrees (90deg) or radians (1.57rad)"},
      {with_tip("    rotate: {axis: up, keys: {0s: 90deg}}\n"),
       "5:20: error: 'up' is not an axis; write x, y, z, -x, -y, -z or [x, y, z]"},
      {with_tip("    rotate: {axis: [0, 0, 0], keys: {0s: 90deg}}\n"),
       "5:20: error: the axis [0, 0, 0] has no direction"},
      {with_tip("    rotate: {keys: {0s: 90deg}}\n"),
       "5:13: error: 'rotate' of handle 'tip' needs 'axis': x, y, z or a vector, here or in each key"},
      {with_tip("    rotate: {keys: {0s: {axis: z, angle: 0deg}, 1s: {axis: x, angle: 270deg}}}\n"),
       "5:53: error: the turn from the key at 0s to this one is 270deg, past 180deg; add a key between, or "
       "give one "
       "'axis' for all keys"},
      {with_tip("    rotate: {keys: {0s: {axis: z, angle: 0deg}, 1s: {axis: z, angle: 720deg}}}\n"),
       "5:53: error: the turn from the key at 0s to this one is 720deg, past 180deg; add a key between, or "
       "give one "
       "'axis' for all keys"},
      {with_tip("    rotate: {keys: {0s: {axis: z, angle: 0deg}, 1s: {axis: x, angle: 720deg}}}\n"),
       "5:53: error: keys about different axes turn at most 360deg; more turns need one 'axis' for all keys"},
      {with_tip("    rotate: {keys: {0s: {axis: z}}}\n"),
       "5:25: error: a key of 'rotate' of handle 'tip' needs 'angle'"},
      {with_tip("    scale: {keys: {0s: 0}}\n"),
       "5:24: error: scale factors are above 0; 0 would collapse the handle and below 0 turn it inside out"},
      {with_tip("    scale: {keys: {0s: [1, -1, 1]}}\n"),
       "5:24: error: scale factors are above 0; 0 would collapse the handle and below 0 turn it inside out"},
      {"mesh: a.obj\nhandles:\n  r:\n    select: {path: [[0, 0, 0], [1, 0, 0]]}\n    curve: {keys: {0s: "
       "reset}}\n",
       "5:24: error: unknown path 'reset'; such names are defined under 'paths'"},
  });
}

TEST(Errors, OfLambdaAndSweeps) {
  expect_errors({
      {with_base("lambda: -0.1\n"), "4:9: error: lambda -0.1 is outside 0..1 (0 smooth, 1 most rigid)"},
      {with_base("lambda: [0, 1]\n"),
       "4:9: error: 'lambda' is a number, values by time ({2s: 0, 4s: 1}) or {keys, ease}, not a list; "
       "values to run "
       "one after another stand under 'sweep'"},
      {with_base("lambda: {}\n"), "4:9: error: 'lambda' has no keys"},
      {with_base("lambda: {kyes: {0s: 1}}\n"),
       "4:10: error: unknown key 'kyes' in 'lambda'; did you mean 'keys'?"},
      {with_base("lambda: {0s: 0, 1s: 1.5, 24f: 2}\n"),
       "4:21: error: lambda 1.5 is outside 0..1 (0 smooth, 1 most rigid)\n"
       "shot.yaml:4:26: error: 'lambda' has two keys at 1s\n"
       "shot.yaml:4:31: error: lambda 2 is outside 0..1 (0 smooth, 1 most rigid)"},
      {with_base("sweep: [0, 1]\n"),
       "4:8: error: 'sweep' must be a mapping such as {lambda: [0, 0.5, 1]}, not a list"},
      {with_base("sweep: {lambda: 0.5}\n"),
       "4:17: error: a sweep takes a list of values, such as [0, 0.5, 1]"},
      {with_base("sweep: {lambda: [0, 1, 0.0]}\n"), "4:24: error: lambda 0 is in the sweep twice"},
      {with_base("sweep: {lambda: [0, 2]}\n"),
       "4:21: error: lambda 2 is outside 0..1 (0 smooth, 1 most rigid)"},
      {with_base("sweep: {lambda: [0, 1]}\noutput: x.glb\n"),
       "5:9: error: output path 'x.glb' does not name the swept key; write '<lambda>' into it"},
      {with_base("lambda: {0s: 0, 1s: 1}\noutput: x<lambda>.glb\n"),
       "5:9: error: '<lambda>' in output path 'x<lambda>.glb' has no one value; it needs a constant lambda "
       "or a sweep "
       "over it"},
  });
}

TEST(Errors, OfMeshSolverAndOutput) {
  const std::string handles = "handles: {base: {select: {group: a}}}\n";
  expect_errors({
      {"mesh: [a.obj]\n" + handles, "1:7: error: 'mesh' is a path, not a list"},
      {"mesh: ''\n" + handles, "1:7: error: 'mesh' is a path, not an empty text"},
      {"mesh: a.glb#\n" + handles, "1:7: error: no node is named after '#' in 'mesh'"},
      {"mesh: {file: a.obj, nodes: [b]}\n" + handles, "1:28: error: 'a.obj' has no nodes; a glTF file has"},
      {"mesh: {file: a.glb#b, nodes: [b]}\n" + handles,
       "1:30: error: 'nodes' stands beside a file that names a node after '#'"},
      {"mesh: {file: a.glb, nodes: []}\n" + handles,
       "1:28: error: 'nodes' names no node; leave it out, or write 'nodes: all'"},
      {"mesh: {file: a.glb, nodes: [b, [c], b]}\n" + handles,
       "1:32: error: 'nodes' takes names of nodes, not a list\n"
       "shot.yaml:1:37: error: node 'b' is named twice"},
      {"mesh: {file: a.glb, nodes: {a: b}}\n" + handles,
       "1:28: error: 'nodes' takes names of nodes, not a mapping"},
      {"mesh: {loose: hold}\n" + handles, "1:7: error: 'mesh' needs 'file'"},
      {"mesh: {file: a.obj, loose: atach}\n" + handles,
       "1:28: error: unknown loose 'atach'; did you mean 'attach'?"},
      {"mesh: {file: a.obj, weld: -1%}\n" + handles, "1:27: error: length -1% is below 0"},
      {with_base("solver: paper\n"),
       "4:9: error: 'solver' must be a mapping such as {preset: paper}, not 'paper'"},
      {with_base("solver: {preset: papr}\n"), "4:18: error: unknown preset 'papr'; did you mean 'paper'?"},
      {with_base("solver: {system: lsq}\n"),
       "4:18: error: unknown system 'lsq'; known are least-squares, direct"},
      {with_base("solver: {sytem: direct}\n"),
       "4:10: error: unknown key 'sytem' in 'solver'; did you mean 'system'?"},
      {with_base("solver: {epsilon: -1}\n"), "4:19: error: epsilon -1 is below 0 (0 is the paper's fit)"},
      {with_base("solver: {iterations: 0}\n"), "4:22: error: iterations 0 is outside 1..100000"},
      {with_base("solver: {tolerance: 0}\n"),
       "4:21: error: tolerance 0 is not above 0; it is a share of the diagonal such as 0.1% or 0.001"},
      {with_base("solver: {weights: [a]}\n"),
       "4:19: error: weights is one of clamped, cotangent, intrinsic-delaunay, uniform, not a list"},
      {with_base("solver: {cell: spoke}\n"), "4:16: error: unknown cell 'spoke'; did you mean 'spokes'?"},
      {with_base("solver: {area_weighting: 2}\n"), "4:26: error: '2' is neither on nor off"},
      {with_base("solver: {area_weighting: on, system: direct}\n"),
       "4:26: error: area_weighting scales the rows of system least-squares; direct has none"},
      {with_base("solver: {weights: uniform, cell: spokes-and-rims}\n"),
       "4:34: error: cell spokes-and-rims takes cotangents for its weights; uniform ones are none"},
      {with_base("output: {gltf: {path: a.glb, animation: [a]}}\n"),
       "4:41: error: 'animation' is a name, not a list"},
      {with_base("output: {gltf: {path: a.glb, animation: {merg_into: a}}}\n"),
       "4:42: error: unknown key 'merg_into' in 'animation'; did you mean 'merge_into'?"},
      {with_base("output: {gltf: {path: a.glb, animation: {name: a, merge_into: ''}}}\n"),
       "4:63: error: 'merge_into' is a name, not an empty text\n"
       "shot.yaml:4:63: error: 'merge_into' stands beside 'name'; the animation there has its own"},
      {with_base("output: [a.glb]\n"), "4:9: error: 'output' is a path, not a list"},
      {with_base("output: {glft: a.glb}\n"),
       "4:10: error: unknown key 'glft' in 'output'; did you mean 'gltf'?"},
      {with_base("output: {gltf: {profile: exact}}\n"), "4:16: error: 'gltf' needs 'path'"},
      {with_base("output: {gltf: {path: a.glb, basis: pac}}\n"),
       "4:37: error: unknown basis 'pac'; did you mean 'pca'?"},
      {with_base("output: {gltf: {path: a.glb, encoding: meshop}}\n"),
       "4:40: error: unknown encoding 'meshop'; did you mean 'meshopt'?"},
      {with_base("clips: [walk]\n"),
       "4:8: error: 'clips' is a mapping of names to times, such as {walk: [0s, 1s]}, not a list"},
      {with_base("clips: {walk: 1s}\n"), "4:15: error: clip 'walk' is [from, to] such as [0s, 1s], not '1s'"},
      {with_base("clips: {walk: [2s, 1s]}\n"),
       "4:15: error: clip 'walk' is from 2s to 1s, which is no time at all"},
      {with_base("output: {gltf: {path: a.glb, profile: exat}}\n"),
       "4:39: error: unknown profile 'exat'; did you mean 'exact'?"},
      {with_base("solver: {max_step: 0deg}\n"), "4:20: error: max_step 0deg is not above 0"},
      {with_base("solver: {predict: maybe}\n"), "4:19: error: 'maybe' is neither on nor off"},
      {with_base("output: {gltf: {path: a.glb, max_targets: 0}}\n"),
       "4:43: error: max_targets 0 is outside 1..65535"},
      {with_base("output: {gltf: {path: a.glb, normals: flat}}\n"),
       "4:39: error: unknown normals 'flat'; known are smooth, none"},
      {with_base("output: {gltf: {path: a.glb, split: aut}}\n"),
       "4:37: error: unknown split 'aut'; did you mean 'auto'?"},
      {with_base("output: {gltf: {path: a.glb, split: [auto]}}\n"),
       "4:37: error: split is one of none, auto, not a list"},
      {with_base("output: {html: [a.html]}\n"), "4:16: error: 'html' is a path, not a list"},
      {with_base("output: {html: {pth: a.html}}\n"),
       "4:17: error: unknown key 'pth' in 'html'; did you mean 'path'?"},
      {with_base("output: {html: {}}\n"), "4:16: error: 'html' needs 'path'"},
      {with_base("output: {html: <name>.html}\n"),
       "4:16: error: unknown placeholder '<name>' in output path '<name>.html'; known are <shot> and "
       "<lambda>"},
      {with_base("sweep: {lambda: [0, 1]}\noutput: {html: x.html}\n"),
       "5:16: error: output path 'x.html' does not name the swept key; write '<lambda>' into it"},
      {with_base("output: <name>.glb\n"),
       "4:9: error: unknown placeholder '<name>' in output path '<name>.glb'; known are <shot> and <lambda>"},
      {with_base("output: <shto>.glb\n"),
       "4:9: error: unknown placeholder '<shto>' in output path '<shto>.glb'; did you mean '<shot>'?"},
  });
}

TEST(Errors, AreAllReportedByPosition) {
  expect_errors({
      {"mesh: a.obj\nlambda: 3\nhandles:\n  a: {select: {axis: q, above: 0}, mve: 1}\nfps: 0\n",
       "2:9: error: lambda 3 is outside 0..1 (0 smooth, 1 most rigid)\n"
       "shot.yaml:4:22: error: the axis of a selection is x, y or z, not 'q'\n"
       "shot.yaml:4:36: error: unknown key 'mve' in handle 'a'; did you mean 'move'?\n"
       "shot.yaml:5:6: error: fps 0 is outside 0..1000 (frames a second, above 0)"},
  });
}

TEST(Errors, CarryTheirPlaces) {
  try {
    parse_shot(with_base("lambda: 3\nfps: 0\n"), "shot.yaml");
    FAIL() << "no error";
  } catch (const TimelineError& error) {
    EXPECT_EQ(error.file(), "shot.yaml");
    ASSERT_EQ(error.diagnostics().size(), 2u);
    EXPECT_EQ(error.diagnostics()[0].where.line, 4);
    EXPECT_EQ(error.diagnostics()[0].where.column, 9);
    EXPECT_EQ(error.diagnostics()[0].severity, Diagnostic::Severity::error);
  }
}

}  // namespace
}  // namespace flexkey
