#include "flexkey/timeline/keys.h"

namespace flexkey {
namespace {

constexpr KeySpec shot[] = {
    {"version", "the format's version: 1"},
    {"mesh", "the mesh file, or a mapping that says how to read it"},
    {"fps", "frames a second, above 0 and at most 1000; default 24"},
    {"duration", "the last frame's time; default the last key"},
    {"loop", "none (default); cycle: the last frame goes over into the first; ping-pong: there and back"},
    {"vars", "values by name; $name stands for one wherever a value does"},
    {"times", "named times"},
    {"points", "named positions, mesh units"},
    {"paths", "named curves"},
    {"poses", "named poses: {smile: {corner_L: {move: [0, 1, 0]}, …}, …}"},
    {"roi", "selection outside which everything is held at rest; default the whole mesh"},
    {"handles", "what the timeline leads, by name"},
    {"rigid", "selections that each move as one body, by name"},
    {"attach",
     "a list of {select, to}: vertices that are not solved and ride on the nearest cell of the surface"},
    {"clips", "{name: [from, to], …}: several named animations on one set of targets in the GLB"},
    {"lambda", "0 smooth to 1 rigid: a number, values by time, or keys with an easing; default 0.5"},
    {"ease", "the file's default easing"},
    {"solver", "how the surface is solved"},
    {"output", "the files to write"},
    {"sweep",
     "runs: lists of values by key path, every combination of them, or {csv: file} with a run a line"},
};

constexpr KeySpec mesh[] = {
    {"file", "path of the mesh, from the timeline's folder; scene.glb#Node for one node"},
    {"nodes", "which nodes of a glTF file are solved, as one surface: names, or all (default)"},
    {"loose", "components that no handle touches: attach (default), hold or error"},
    {"weld", "vertices this near to each other are solved as one; mesh units or % of the diagonal"},
    {"up", "the file's upward axis, y (default) or z; pictures, pages and GLBs are upright by it"},
};

constexpr KeySpec handle[] = {
    {"select", "which vertices"},
    {"move", "offset from rest by time, mesh units"},
    {"to", "where the pivot goes by time; instead of move"},
    {"rotate", "turn about the pivot by time, deg or rad"},
    {"scale", "factors along the world axes by time"},
    {"pivot", "the point to turn and scale about; default the centroid at rest"},
    {"follow", "a path that the pivot rides on by arc length; instead of move and to"},
    {"curve", "curves on which a path selection lies, by time; instead of every other motion"},
    {"motion",
     "a motion from elsewhere: an animated node of a glTF file, or a CSV; relative to its first sample"},
    {"pose", "named poses by time, of keys or of a cue file"},
    {"wave", "a sine that is added to the motion, or a list of them"},
    {"noise", "smooth random motion that is added, or a list of them"},
    {"repeat", "how often the keyed motion is played, one time after another; default 1"},
    {"delay", "time by which all of the motion is later"},
    {"mirror", "another handle's motion as in a mirror, instead of keyed motions"},
    {"parent", "another handle whose whole motion comes after this one's own"},
    {"weight", "in (0, 1]; below 1 the handle is soft and goes about that share of the way; default 1"},
    {"active", "[from, to), or a list of such: the vertices are free outside; default always"},
    {"fade", "time over which an active handle takes hold and lets go"},
};

constexpr KeySpec selection[] = {
    {"vertices", "indices of the file from 0, and ranges such as 12-40"},
    {"group", "a group of the mesh file"},
    {"material", "a material of the mesh file"},
    {"node", "a node of a glTF file"},
    {"sphere", "within a radius of a centre"},
    {"box", "between two corners"},
    {"plane", "within a distance of a plane"},
    {"axis", "x, y or z, with above or below"},
    {"above",
     "beside axis or attribute: lower bound; in mesh units or the attribute's, or % of the extent or its "
     "range"},
    {"below", "beside axis or attribute: upper bound, likewise"},
    {"nearest", "the vertex nearest to a point"},
    {"geodesic", "within a radius along the surface"},
    {"path", "an ordered chain of vertices along edges, through points"},
    {"boundary", "the longest boundary loop, or all"},
    {"attribute", "a custom vertex attribute of a glTF file, _NAME, with above or below"},
    {"component", "a connected component, counted from 0 by its lowest vertex"},
    {"any", "vertices in any of a list of selections"},
    {"all", "vertices in all of a list of selections"},
    {"not", "vertices outside a selection"},
    {"grow", "beside any kind: rings of neighbours added last, 0..1000"},
};

constexpr KeySpec sphere[] = {
    {"center", "a point"},
    {"radius", "mesh units or % of the diagonal"},
};
constexpr KeySpec box[] = {
    {"min", "the lowest corner"},
    {"max", "the highest corner"},
};
constexpr KeySpec plane[] = {
    {"point", "a point of the plane"},
    {"normal", "its direction"},
    {"within", "largest distance, mesh units or % of the diagonal"},
};
constexpr KeySpec geodesic[] = {
    {"from", "a point, taken to the nearest vertex"},
    {"radius", "along the surface, mesh units or % of the diagonal"},
};

constexpr KeySpec track[] = {
    {"keys", "values by time"},
    {"ease", "easing of the track's stretches"},
};
constexpr KeySpec rotate[] = {
    {"axis", "x, y, z, their negatives or a vector, for all keys"},
    {"euler", "the order of turns about the fixed axes, such as xyz; keys are then [x, y, z], deg or rad"},
    {"keys", "angles by time, or {axis, angle} by time"},
    {"ease", "easing of the track's stretches"},
};
constexpr KeySpec follow[] = {
    {"path", "a curve, or the name of one"},
    {"keys", "shares of its length by time, 0..100%"},
    {"ease", "easing of the track's stretches"},
    {"orient", "none (default) or tangent: turns as the curve turns"},
};
constexpr KeySpec motion[] = {
    {"from", "an animated node: rig.glb#Ear_L"},
    {"csv", "a table: time, tx ty tz, and rx ry rz (degrees, about x first) or qx qy qz qw"},
};
constexpr KeySpec pose[] = {
    {"keys", "names of poses, or rest, by time"},
    {"ease", "easing of the track's stretches"},
    {"cues", "a file with a time and a pose's name a line, instead of keys"},
};
constexpr KeySpec posed[] = {
    {"move", "offset from rest, mesh units"},
    {"rotate", "{axis, angle} about the handle's pivot"},
    {"scale", "factors along the world axes"},
};
constexpr KeySpec wave[] = {
    {"amplitude", "of an offset mesh units or % of the diagonal; of a turn deg or rad"},
    {"along", "the direction of an offset: x, y, z, their negatives or a vector"},
    {"axis", "the axis of a turn, instead"},
    {"frequency", "swings a second, above 0; default 1"},
    {"phase", "at 0s, deg or rad; default 0deg"},
};
constexpr KeySpec noise[] = {
    {"amplitude", "the most of it: of an offset mesh units or % of the diagonal; of a turn deg or rad"},
    {"along", "the direction of an offset: x, y, z, their negatives or a vector"},
    {"axis", "the axis of a turn, instead"},
    {"frequency", "changes of direction a second, about; above 0; default 1"},
    {"seed", "a whole number from 0; each gives another motion; default 0"},
};
constexpr KeySpec mirror[] = {
    {"of", "the handle whose motion is mirrored"},
    {"plane", "x, y or z: the axis across which left and right change places"},
};
constexpr KeySpec turn[] = {
    {"axis", "x, y, z, their negatives or a vector"},
    {"angle", "deg or rad"},
};
constexpr KeySpec key[] = {
    {"at", "the key's time"},
    {"value", "its value"},
    {"ease", "easing of the stretch after it"},
};
constexpr KeySpec curve[] = {
    {"polyline", "points joined by straight lines"},
    {"catmull-rom", "points on a uniform Catmull-Rom curve"},
    {"bezier", "control points of cubic pieces, 3n + 1 of them"},
};

constexpr KeySpec lambda[] = {
    {"keys", "values in 0..1 by time"},
    {"ease", "easing of the stretches"},
    {"regions", "a list of {select, value, feather}: parts of the surface with a value of their own"},
};
constexpr KeySpec region[] = {
    {"select", "which vertices"},
    {"value", "their lambda: a number, values by time, or {keys, ease}"},
    {"feather", "how far outside it fades along the surface, mesh units or % of the diagonal; default 0"},
};
constexpr KeySpec attach[] = {
    {"select", "vertices that are not solved"},
    {"to", "the vertices that they ride on; default all that is solved"},
};

constexpr KeySpec solver[] = {
    {"preset", "quality (default) or paper; explicit keys win over it"},
    {"system", "least-squares (default) or direct"},
    {"local_scale", "axis, uniform (default) or none"},
    {"epsilon", "0 or more; how far axis is drawn towards uniform; default 0.05"},
    {"weights", "clamped (default), cotangent, intrinsic-delaunay or uniform"},
    {"cell", "what rotations are fitted to: spokes (default) or spokes-and-rims"},
    {"iterations", "most global solves a frame, 1..100000; default 30"},
    {"tolerance", "share of the diagonal, or %; default 0.1%"},
    {"predict", "whether a frame starts from rotations predicted by the handles' turns: on (default) or off"},
    {"accelerate", "Anderson acceleration of the iterations: on (default) or off"},
    {"max_step", "largest turn of a handle in one solve, deg or rad, above 0, or off; default 30deg"},
    {"area_weighting", "whether least-squares rows count by vertex area: on or off (default)"},
};

constexpr KeySpec output[] = {
    {"gltf", "path of the GLB, or a mapping"},
    {"preview", "pictures of the clip: their folder, or a mapping"},
    {"cache", "a vertex cache: path ending in .pc2 or .mdd, or a list of them"},
    {"html", "path of a page that plays the clip in a browser, or a mapping"},
    {"frames", "a file a frame: pattern such as frames/%04d.obj or frames/%04d.npz, or a list of them"},
    {"usd", "the clip as USD: path ending in .usda"},
    {"report", "path of a report for scripts, JSON: what --json prints"},
};

constexpr KeySpec gltf[] = {
    {"path", "path of the GLB, in the output folder"},
    {"profile", "compat (default: knots, float), web (pca, meshopt) or exact (frames, float)"},
    {"basis", "what the targets are: knots, pca or frames; wins over the profile"},
    {"encoding", "float or meshopt; wins over the profile"},
    {"tolerance",
     "largest error of the playback: share of the diagonal, or %; default 0.1%; frames need none"},
    {"normals", "smooth (default) or none"},
    {"max_targets", "most morph targets, 1 to 65535; default 200"},
    {"animation", "name of the animation, or a mapping that says where it goes"},
    {"handles", "whether handles are written as animated nodes: true or false (default)"},
    {"poses", "all, or a list of names under 'poses': a morph target each, of weight 0"},
    {"split", "auto: faces that never move become a mesh without targets; none (default): one mesh"},
};

constexpr KeySpec file[] = {
    {"path", "path of the file, in the output folder"},
};

constexpr KeySpec animation[] = {
    {"name", "of the animation; default the shot's name"},
    {"merge_into", "an animation of the mesh's glTF file that gets the weights, instead of one of their own"},
};

constexpr KeySpec preview[] = {
    {"dir", "folder of the pictures 0000.png, 0001.png …, in the output folder; default the shot's name"},
    {"size", "[width, height] of a picture, pixels; default [960, 540]"},
    {"samples", "rays a pixel, 1..4096; default 8"},
    {"subdivide", "level of the subdivision surface, 0..4; default 2"},
    {"frames", "which frames: a list such as [0-30, 47, 60-90x2]; default all"},
    {"format", "png (default), exr, webp or jpg"},
    {"camera", "where the pictures are taken from; default frames the whole clip"},
    {"turntable", "turns of the camera over the clip; default 0"},
    {"style", "clay (default), normals, displacement, lambda, error, wire or textured"},
    {"quality", "final (default), traced, or draft, by z-buffer"},
    {"handles",
     "which handles' vertices are blue, anchors' red and targets green: true, borders or false (default)"},
    {"overlay", "whether time, frame and λ stand along the lower edge: true or false (default)"},
    {"gif", "path of an animated GIF of the pictures, or a mapping"},
    {"contact_sheet", "path of one picture of several times side by side, or a mapping"},
};

constexpr KeySpec camera[] = {
    {"look_at", "the point in the middle of the picture; default the middle of what it holds"},
    {"azimuth", "deg or rad about the vertical, 0 from the front (+z, or -y with up z); default 35deg"},
    {"elevation", "deg or rad above the horizon, -90deg..90deg; default 15deg"},
    {"fov", "the picture's height as an angle, 0.1deg..170deg; default 30deg"},
    {"zoom", "enlarges what fits, 0.001..1000; default 1"},
    {"fit", "what the picture holds: clip (default), all frames, or rest, the mesh at rest"},
    {"up", "the upward axis, y (default) or z"},
};

constexpr KeySpec gif[] = {
    {"path", "path of the GIF, in the output folder"},
    {"width", "its width, pixels; default the pictures'"},
};

constexpr KeySpec sheet[] = {
    {"path", "path of the picture, in the output folder; default the shot's name"},
    {"at", "times of the pictures on it; default four, evenly over the clip"},
    {"width", "of a picture on it, pixels; default at most 480"},
};

}  // namespace

constinit const MappingSpec shot_keys{"{mesh: bar.obj, handles: {…}}", shot};
constinit const MappingSpec mesh_keys{"{file: bar.obj, weld: 0.1%}", mesh};
constinit const MappingSpec handle_keys{"{select: {axis: z, above: 99%}}", handle};
constinit const MappingSpec selection_keys{"{axis: z, above: 99%}", selection};
constinit const MappingSpec sphere_keys{"{center: [0, 0, 0], radius: 5%}", sphere};
constinit const MappingSpec box_keys{"{min: [0, 0, 0], max: [1, 1, 1]}", box};
constinit const MappingSpec plane_keys{"{point: [0, 0, 0], normal: z, within: 1%}", plane};
constinit const MappingSpec geodesic_keys{"{from: [0, 0, 0], radius: 30%}", geodesic};
constinit const MappingSpec track_keys{"{keys: {0s: …, 2s: …}}", track};
constinit const MappingSpec rotate_keys{"{axis: z, keys: {0s: 0deg, 2s: 90deg}}", rotate};
constinit const MappingSpec follow_keys{"{path: arc, keys: {0s: 0%, 2s: 100%}}", follow};
constinit const MappingSpec motion_keys{"{from: rig.glb#Ear_L}", motion};
constinit const MappingSpec pose_keys{"{keys: {0s: rest, 1s: smile}}", pose};
constinit const MappingSpec posed_keys{"{move: [0, 1, 0], rotate: {axis: x, angle: 10deg}}", posed};
constinit const MappingSpec wave_keys{"{amplitude: 2%, along: z, frequency: 1}", wave};
constinit const MappingSpec noise_keys{"{amplitude: 2%, along: z, frequency: 1, seed: 0}", noise};
constinit const MappingSpec mirror_keys{"{of: ear_L, plane: x}", mirror};
constinit const MappingSpec turn_keys{"{axis: z, angle: 90deg}", turn};
constinit const MappingSpec key_keys{"{at: 2s, value: …, ease: hold}", key};
constinit const MappingSpec curve_keys{"{polyline: [[0, 0, 0], [0, 1, 0]]}", curve};
constinit const MappingSpec lambda_keys{"{keys: {0s: 0, 2s: 1}, ease: ease-in-out}", lambda};
constinit const MappingSpec region_keys{"{select: {group: nose}, value: 1, feather: 2%}", region};
constinit const MappingSpec attach_keys{"{select: {group: button}, to: {group: coat}}", attach};
constinit const MappingSpec solver_keys{"{preset: paper}", solver};
constinit const MappingSpec output_keys{"{gltf: bar.glb}", output};
constinit const MappingSpec gltf_keys{"{path: bar.glb}", gltf};
constinit const MappingSpec file_keys{"{path: bar.pc2}", file};
constinit const MappingSpec animation_keys{"{merge_into: Walk}", animation};
constinit const MappingSpec preview_keys{"{dir: bar/}", preview};
constinit const MappingSpec camera_keys{"{azimuth: 35deg, elevation: 15deg}", camera};
constinit const MappingSpec gif_keys{"{path: bar.gif, width: 480}", gif};
constinit const MappingSpec sheet_keys{"{path: bar.png, at: [0s, 1s, 2s]}", sheet};

}  // namespace flexkey
