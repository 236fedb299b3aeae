#include "flexkey/timeline/keys.h"

namespace flexkey {
namespace {

constexpr KeySpec shot[] = {
    {"version", "whole[1,1]", "the format's version: 1"},
    {"mesh", "required path | {mesh}", "the mesh file, or a mapping that says how to read it"},
    {"fps", "number(0,1000]", "frames a second, above 0 and at most 1000; default 24"},
    {"duration", "time", "the last frame's time; default the last key"},
    {"loop", "'none' | 'cycle' | 'ping-pong'",
     "none (default); cycle: the last frame goes over into the first; ping-pong: there and back"},
    {"vars", "names(any)", "values by name; $name stands for one wherever a value does"},
    {"times", "names(time)", "named times"},
    {"points", "names(vector)", "named positions, mesh units"},
    {"paths", "names(curve | list(point))", "named curves"},
    {"poses", "names(names({posed}))", "named poses: {smile: {corner_L: {move: [0, 1, 0]}, …}, …}"},
    {"roi", "{selection}", "selection outside which everything is held at rest; default the whole mesh"},
    {"handles", "required names({handle})", "what the timeline leads, by name"},
    {"rigid", "names({selection})", "selections that each move as one body, by name"},
    {"attach", "list({attach})",
     "a list of {select, to}: vertices that are not solved and ride on the nearest cell of the surface"},
    {"clips", "names(pair(time))",
     "{name: [from, to], …}: several named animations on one set of targets in the GLB"},
    {"lambda", "number[0,1] | keys(number[0,1]) | {lambda}",
     "0 smooth to 1 rigid: a number, values by time, or keys with an easing; default 0.5"},
    {"ease", "ease", "the file's default easing"},
    {"solver", "{solver}", "how the surface is solved"},
    {"output", "path | {output}", "the files to write"},
    {"sweep", "{sweep}",
     "runs: lists of values by key path, every combination of them, or {csv: file} with a run a line"},
};

constexpr KeySpec mesh[] = {
    {"file", "required path", "path of the mesh, from the timeline's folder; scene.glb#Node for one node"},
    {"nodes", "'all' | text | list(text)",
     "which nodes of a glTF file are solved, as one surface: names, or all (default)"},
    {"loose", "'attach' | 'hold' | 'error'",
     "components that no handle touches: attach (default), hold or error"},
    {"weld", "length", "vertices this near to each other are solved as one; mesh units or % of the diagonal"},
    {"up", "'y' | 'z'",
     "the file's upward axis, y (default) or z; pictures, pages and GLBs are upright by it"},
};

constexpr KeySpec handle[] = {
    {"select", "required {selection}", "which vertices"},
    {"move", "{track of vector}", "offset from rest by time, mesh units"},
    {"to", "{track of point}", "where the pivot goes by time; instead of move"},
    {"rotate", "{rotate}", "turn about the pivot by time, deg or rad"},
    {"scale", "{track of number(0,) | vector}", "factors along the world axes by time"},
    {"pivot", "point", "the point to turn and scale about; default the centroid at rest"},
    {"follow", "{follow}", "a path that the pivot rides on by arc length; instead of move and to"},
    {"curve", "{track of curve}",
     "curves on which a path selection lies, by time; instead of every other motion"},
    {"motion", "{motion}",
     "a motion from elsewhere: an animated node of a glTF file, or a CSV; relative to its first sample"},
    {"pose", "{pose}", "named poses by time, of keys or of a cue file"},
    {"wave", "{wave} | list({wave})", "a sine that is added to the motion, or a list of them"},
    {"noise", "{noise} | list({noise})", "smooth random motion that is added, or a list of them"},
    {"repeat", "whole[1,100000]", "how often the keyed motion is played, one time after another; default 1"},
    {"delay", "time", "time by which all of the motion is later"},
    {"mirror", "{mirror}", "another handle's motion as in a mirror, instead of keyed motions"},
    {"parent", "text", "another handle whose whole motion comes after this one's own"},
    {"weight", "number(0,1]",
     "in (0, 1]; below 1 the handle is soft and goes about that share of the way; default 1"},
    {"active", "pair(time) | list(pair(time))",
     "[from, to), or a list of such: the vertices are free outside; default always"},
    {"fade", "time", "time over which an active handle takes hold and lets go"},
};

constexpr KeySpec selection[] = {
    {"vertices", "whole[0,] | range | list(whole[0,] | range)",
     "indices of the file from 0, and ranges such as 12-40"},
    {"group", "text", "a group of the mesh file"},
    {"material", "text", "a material of the mesh file"},
    {"node", "text", "a node of a glTF file"},
    {"sphere", "{sphere}", "within a radius of a centre"},
    {"box", "{box}", "between two corners"},
    {"plane", "{plane}", "within a distance of a plane"},
    {"axis", "'x' | 'y' | 'z'", "x, y or z, with above or below"},
    {"above", "length",
     "beside axis or attribute: lower bound; in mesh units or the attribute's, or % of the extent or its "
     "range"},
    {"below", "length", "beside axis or attribute: upper bound, likewise"},
    {"nearest", "point", "the vertex nearest to a point"},
    {"geodesic", "{geodesic}", "within a radius along the surface"},
    {"path", "text | list(point)", "an ordered chain of vertices along edges, through points"},
    {"boundary", "'longest' | 'all'", "the longest boundary loop, or all"},
    {"attribute", "text", "a custom vertex attribute of a glTF file, _NAME, with above or below"},
    {"component", "whole[0,]", "a connected component, counted from 0 by its lowest vertex"},
    {"any", "list({selection})", "vertices in any of a list of selections"},
    {"all", "list({selection})", "vertices in all of a list of selections"},
    {"not", "{selection}", "vertices outside a selection"},
    {"grow", "whole[0,1000]", "beside any kind: rings of neighbours added last, 0..1000"},
};

constexpr KeySpec sphere[] = {
    {"center", "required point", "a point"},
    {"radius", "required length", "mesh units or % of the diagonal"},
};
constexpr KeySpec box[] = {
    {"min", "required point", "the lowest corner"},
    {"max", "required point", "the highest corner"},
};
constexpr KeySpec plane[] = {
    {"point", "required point", "a point of the plane"},
    {"normal", "required axis", "its direction"},
    {"within", "required length", "largest distance, mesh units or % of the diagonal"},
};
constexpr KeySpec geodesic[] = {
    {"from", "required point", "a point, taken to the nearest vertex"},
    {"radius", "required length", "along the surface, mesh units or % of the diagonal"},
};

constexpr KeySpec track[] = {
    {"keys", "required keys(any)", "values by time"},
    {"ease", "ease", "easing of the track's stretches"},
};
constexpr KeySpec rotate[] = {
    {"axis", "axis", "x, y, z, their negatives or a vector, for all keys"},
    {"euler", "'xyz' | 'xzy' | 'yxz' | 'yzx' | 'zxy' | 'zyx'",
     "the order of turns about the fixed axes, such as xyz; keys are then [x, y, z], deg or rad"},
    {"keys", "required keys(angle | {turn} | triple(angle))", "angles by time, or {axis, angle} by time"},
    {"ease", "ease", "easing of the track's stretches"},
};
constexpr KeySpec follow[] = {
    {"path", "required curve", "a curve, or the name of one"},
    {"keys", "required keys(length)", "shares of its length by time, 0..100%"},
    {"ease", "ease", "easing of the track's stretches"},
    {"orient", "'none' | 'tangent'", "none (default) or tangent: turns as the curve turns"},
};
constexpr KeySpec motion[] = {
    {"from", "path", "an animated node: rig.glb#Ear_L"},
    {"csv", "path", "a table: time, tx ty tz, and rx ry rz (degrees, about x first) or qx qy qz qw"},
};
constexpr KeySpec pose[] = {
    {"keys", "keys(text)", "names of poses, or rest, by time"},
    {"ease", "ease", "easing of the track's stretches"},
    {"cues", "path", "a file with a time and a pose's name a line, instead of keys"},
};
constexpr KeySpec posed[] = {
    {"move", "vector", "offset from rest, mesh units"},
    {"rotate", "{turn}", "{axis, angle} about the handle's pivot"},
    {"scale", "number(0,) | vector", "factors along the world axes"},
};
constexpr KeySpec wave[] = {
    {"amplitude", "required length | angle",
     "of an offset mesh units or % of the diagonal; of a turn deg or rad"},
    {"along", "axis", "the direction of an offset: x, y, z, their negatives or a vector"},
    {"axis", "axis", "the axis of a turn, instead"},
    {"frequency", "number(0,1000000]", "swings a second, above 0; default 1"},
    {"phase", "angle", "at 0s, deg or rad; default 0deg"},
};
constexpr KeySpec noise[] = {
    {"amplitude", "required length | angle",
     "the most of it: of an offset mesh units or % of the diagonal; of a turn deg or rad"},
    {"along", "axis", "the direction of an offset: x, y, z, their negatives or a vector"},
    {"axis", "axis", "the axis of a turn, instead"},
    {"frequency", "number(0,1000000]", "changes of direction a second, about; above 0; default 1"},
    {"seed", "whole[0,]", "a whole number from 0; each gives another motion; default 0"},
};
constexpr KeySpec mirror[] = {
    {"of", "required text", "the handle whose motion is mirrored"},
    {"plane", "required 'x' | 'y' | 'z'", "x, y or z: the axis across which left and right change places"},
};
constexpr KeySpec turn[] = {
    {"axis", "required axis", "x, y, z, their negatives or a vector"},
    {"angle", "required angle", "deg or rad"},
};
constexpr KeySpec key[] = {
    {"at", "required time", "the key's time"},
    {"value", "required any", "its value"},
    {"ease", "ease", "easing of the stretch after it"},
};
constexpr KeySpec curve[] = {
    {"polyline", "list(point)", "points joined by straight lines"},
    {"catmull-rom", "list(point)", "points on a uniform Catmull-Rom curve"},
    {"bezier", "list(point)", "control points of cubic pieces, 3n + 1 of them"},
};

constexpr KeySpec lambda[] = {
    {"keys", "number[0,1] | keys(number[0,1])", "values in 0..1 by time"},
    {"ease", "ease", "easing of the stretches"},
    {"regions", "list({region})",
     "a list of {select, value, feather}: parts of the surface with a value of their own"},
};
constexpr KeySpec region[] = {
    {"select", "required {selection}", "which vertices"},
    {"value", "required number[0,1] | keys(number[0,1]) | {track of number[0,1]}",
     "their lambda: a number, values by time, or {keys, ease}"},
    {"feather", "length",
     "how far outside it fades along the surface, mesh units or % of the diagonal; default 0"},
};
constexpr KeySpec attach[] = {
    {"select", "required {selection}", "vertices that are not solved"},
    {"to", "{selection}", "the vertices that they ride on; default all that is solved"},
};

constexpr KeySpec solver[] = {
    {"preset", "'quality' | 'paper'", "quality (default) or paper; explicit keys win over it"},
    {"system", "'least-squares' | 'direct'", "least-squares (default) or direct"},
    {"local_scale", "'axis' | 'uniform' | 'none'", "axis, uniform (default) or none"},
    {"epsilon", "number[0,]", "0 or more; how far axis is drawn towards uniform; default 0.05"},
    {"weights", "'clamped' | 'cotangent' | 'intrinsic-delaunay' | 'uniform'",
     "clamped (default), cotangent, intrinsic-delaunay or uniform"},
    {"cell", "'spokes' | 'spokes-and-rims'",
     "what rotations are fitted to: spokes (default) or spokes-and-rims"},
    {"iterations", "whole[1,100000]", "most global solves a frame, 1..100000; default 30"},
    {"tolerance", "length", "share of the diagonal, or %; default 0.1%"},
    {"predict", "switch",
     "whether a frame starts from rotations predicted by the handles' turns: on (default) or off"},
    {"accelerate", "switch", "Anderson acceleration of the iterations: on (default) or off"},
    {"max_step", "angle | 'off'",
     "largest turn of a handle in one solve, deg or rad, above 0, or off; default 30deg"},
    {"area_weighting", "switch", "whether least-squares rows count by vertex area: on or off (default)"},
};

constexpr KeySpec sweep[] = {
    {"csv", "path", "a table: key paths in its first line, and a run in each other"},
};

constexpr KeySpec output[] = {
    {"gltf", "path | {gltf}", "path of the GLB, or a mapping"},
    {"preview", "path | {preview}", "pictures of the clip: their folder, or a mapping"},
    {"cache", "path | {file} | list(path | {file})",
     "a vertex cache: path ending in .pc2 or .mdd, or a list of them"},
    {"html", "path | {file}", "path of a page that plays the clip in a browser, or a mapping"},
    {"frames", "path | {file} | list(path | {file})",
     "a file a frame: pattern such as frames/%04d.obj or frames/%04d.npz, or a list of them"},
    {"usd", "path | {file} | list(path | {file})", "the clip as USD: path ending in .usda"},
    {"report", "path", "path of a report for scripts, JSON: what --json prints"},
};

constexpr KeySpec gltf[] = {
    {"path", "required path", "path of the GLB, in the output folder"},
    {"profile", "'compat' | 'web' | 'exact'",
     "compat (default: knots, float), web (pca, meshopt) or exact (frames, float)"},
    {"basis", "'knots' | 'pca' | 'frames'",
     "what the targets are: knots, pca or frames; wins over the profile"},
    {"encoding", "'float' | 'meshopt'", "float or meshopt; wins over the profile"},
    {"tolerance", "length",
     "largest error of the playback: share of the diagonal, or %; default 0.1%; frames need none"},
    {"normals", "'smooth' | 'none'", "smooth (default) or none"},
    {"max_targets", "whole[1,65535]", "most morph targets, 1 to 65535; default 200"},
    {"animation", "text | {animation}", "name of the animation, or a mapping that says where it goes"},
    {"handles", "switch", "whether handles are written as animated nodes: true or false (default)"},
    {"poses", "'all' | text | list(text)",
     "all, or a list of names under 'poses': a morph target each, of weight 0"},
    {"split", "'none' | 'auto'",
     "auto: faces that never move become a mesh without targets; none (default): one mesh"},
};

constexpr KeySpec file[] = {
    {"path", "required path", "path of the file, in the output folder"},
};

constexpr KeySpec animation[] = {
    {"name", "text", "of the animation; default the shot's name"},
    {"merge_into", "text",
     "an animation of the mesh's glTF file that gets the weights, instead of one of their own"},
};

constexpr KeySpec preview[] = {
    {"dir", "path",
     "folder of the pictures 0000.png, 0001.png …, in the output folder; default the shot's name"},
    {"size", "pair(whole[1,16384])", "[width, height] of a picture, pixels; default [960, 540]"},
    {"samples", "whole[1,4096]", "rays a pixel, 1..4096; default 8"},
    {"subdivide", "whole[0,4]", "level of the subdivision surface, 0..4; default 2"},
    {"frames", "whole[0,] | range | list(whole[0,] | range)",
     "which frames: a list such as [0-30, 47, 60-90x2]; default all"},
    {"format", "'png' | 'exr' | 'webp' | 'jpg' | 'jpeg'", "png (default), exr, webp or jpg"},
    {"camera", "{camera}", "where the pictures are taken from; default frames the whole clip"},
    {"turntable", "number", "turns of the camera over the clip; default 0"},
    {"style", "'clay' | 'normals' | 'displacement' | 'lambda' | 'error' | 'wire' | 'textured'",
     "clay (default), normals, displacement, lambda, error, wire or textured"},
    {"quality", "'final' | 'draft'", "final (default), traced, or draft, by z-buffer"},
    {"handles", "switch | 'borders'",
     "which handles' vertices are blue, anchors' red and targets green: true, borders or false (default)"},
    {"overlay", "switch", "whether time, frame and λ stand along the lower edge: true or false (default)"},
    {"gif", "path | {gif}", "path of an animated GIF of the pictures, or a mapping"},
    {"contact_sheet", "path | {sheet}", "path of one picture of several times side by side, or a mapping"},
};

constexpr KeySpec camera[] = {
    {"look_at", "point", "the point in the middle of the picture; default the middle of what it holds"},
    {"azimuth", "angle",
     "deg or rad about the vertical, 0 from the front (+z, or -y with up z); default 35deg"},
    {"elevation", "angle", "deg or rad above the horizon, -90deg..90deg; default 15deg"},
    {"fov", "angle", "the picture's height as an angle, 0.1deg..170deg; default 30deg"},
    {"zoom", "number[0.001,1000]", "enlarges what fits, 0.001..1000; default 1"},
    {"fit", "'clip' | 'rest'",
     "what the picture holds: clip (default), all frames, or rest, the mesh at rest"},
    {"up", "'y' | 'z'", "the upward axis, y (default) or z"},
};

constexpr KeySpec gif[] = {
    {"path", "required path", "path of the GIF, in the output folder"},
    {"width", "whole[1,16384]", "its width, pixels; default the pictures'"},
};

constexpr KeySpec sheet[] = {
    {"path", "path", "path of the picture, in the output folder; default the shot's name"},
    {"at", "time | list(time)", "times of the pictures on it; default four, evenly over the clip"},
    {"width", "whole[1,16384]", "of a picture on it, pixels; default at most 480"},
};

}  // namespace

constinit const MappingSpec shot_keys{"shot", "{mesh: bar.obj, handles: {…}}", shot};
constinit const MappingSpec mesh_keys{"mesh", "{file: bar.obj, weld: 0.1%}", mesh};
constinit const MappingSpec handle_keys{"handle", "{select: {axis: z, above: 99%}}", handle};
constinit const MappingSpec selection_keys{"selection", "{axis: z, above: 99%}", selection};
constinit const MappingSpec sphere_keys{"sphere", "{center: [0, 0, 0], radius: 5%}", sphere};
constinit const MappingSpec box_keys{"box", "{min: [0, 0, 0], max: [1, 1, 1]}", box};
constinit const MappingSpec plane_keys{"plane", "{point: [0, 0, 0], normal: z, within: 1%}", plane};
constinit const MappingSpec geodesic_keys{"geodesic", "{from: [0, 0, 0], radius: 30%}", geodesic};
constinit const MappingSpec track_keys{"track", "{keys: {0s: …, 2s: …}}", track};
constinit const MappingSpec rotate_keys{"rotate", "{axis: z, keys: {0s: 0deg, 2s: 90deg}}", rotate};
constinit const MappingSpec follow_keys{"follow", "{path: arc, keys: {0s: 0%, 2s: 100%}}", follow};
constinit const MappingSpec motion_keys{"motion", "{from: rig.glb#Ear_L}", motion};
constinit const MappingSpec pose_keys{"pose", "{keys: {0s: rest, 1s: smile}}", pose};
constinit const MappingSpec posed_keys{"posed", "{move: [0, 1, 0], rotate: {axis: x, angle: 10deg}}", posed};
constinit const MappingSpec wave_keys{"wave", "{amplitude: 2%, along: z, frequency: 1}", wave};
constinit const MappingSpec noise_keys{"noise", "{amplitude: 2%, along: z, frequency: 1, seed: 0}", noise};
constinit const MappingSpec mirror_keys{"mirror", "{of: ear_L, plane: x}", mirror};
constinit const MappingSpec turn_keys{"turn", "{axis: z, angle: 90deg}", turn};
constinit const MappingSpec key_keys{"key", "{at: 2s, value: …, ease: hold}", key};
constinit const MappingSpec curve_keys{"curve", "{polyline: [[0, 0, 0], [0, 1, 0]]}", curve};
constinit const MappingSpec lambda_keys{"lambda", "{keys: {0s: 0, 2s: 1}, ease: ease-in-out}", lambda};
constinit const MappingSpec region_keys{"region", "{select: {group: nose}, value: 1, feather: 2%}", region};
constinit const MappingSpec attach_keys{"attach", "{select: {group: button}, to: {group: coat}}", attach};
constinit const MappingSpec solver_keys{"solver", "{preset: paper}", solver};
constinit const MappingSpec sweep_keys{"sweep", "{lambda: [0, 0.5, 1]}", sweep};
constinit const MappingSpec output_keys{"output", "{gltf: bar.glb}", output};
constinit const MappingSpec gltf_keys{"gltf", "{path: bar.glb}", gltf};
constinit const MappingSpec file_keys{"file", "{path: bar.pc2}", file};
constinit const MappingSpec animation_keys{"animation", "{merge_into: Walk}", animation};
constinit const MappingSpec preview_keys{"preview", "{dir: bar/}", preview};
constinit const MappingSpec camera_keys{"camera", "{azimuth: 35deg, elevation: 15deg}", camera};
constinit const MappingSpec gif_keys{"gif", "{path: bar.gif, width: 480}", gif};
constinit const MappingSpec sheet_keys{"sheet", "{path: bar.png, at: [0s, 1s, 2s]}", sheet};

std::span<const MappingSpec* const> all_mappings() {
  static constexpr const MappingSpec* all[] = {
      &shot_keys,      &mesh_keys,    &handle_keys, &selection_keys, &sphere_keys, &box_keys,   &plane_keys,
      &geodesic_keys,  &track_keys,   &rotate_keys, &follow_keys,    &motion_keys, &pose_keys,  &posed_keys,
      &wave_keys,      &noise_keys,   &mirror_keys, &turn_keys,      &key_keys,    &curve_keys, &lambda_keys,
      &region_keys,    &attach_keys,  &solver_keys, &sweep_keys,     &output_keys, &gltf_keys,  &file_keys,
      &animation_keys, &preview_keys, &camera_keys, &gif_keys,       &sheet_keys};
  return all;
}

}  // namespace flexkey
