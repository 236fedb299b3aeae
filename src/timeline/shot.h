#pragma once

#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "flexkey/mesh/selection.h"
#include "flexkey/timeline/motion.h"
#include "flexkey/timeline/preview_output.h"
#include "flexkey/timeline/track.h"

namespace flexkey {

/// from <= t < to, seconds.
struct Interval {
  double from = 0;
  double to = 0;
};

/// Vertices that the timeline leads; without any motion an anchor, held at rest.
struct Handle {
  std::string name;
  Mark where;
  Selection select;
  std::optional<Vec3> pivot;         // default: the centroid of its vertices at rest
  Track<Vec3> move;                  // offset from rest
  Track<Vec3> to;                    // where the pivot goes; excludes `move` and `follow`
  std::optional<Follow> follow;      // the pivot's path
  Track<AxisAngle> rotate;           // with one axis for all keys, or an axis a key (then slerped)
  EulerTrack euler;                  // instead of it
  Track<Vec3> scale;                 // factors along the world axes
  Track<Curve> curve;                // for a `path` selection; excludes every other motion
  std::vector<MotionTracks> layers;  // of poses and of files, one after another after the keyed ones
  std::vector<Wave> waves;           // added to the keyed motion
  std::vector<Noise> noises;         // likewise
  std::optional<Mirror> mirror;      // instead of keyed motions
  int parent = -1;                   // a handle of the shot whose whole motion comes after its own, or none
  double weight = 1;                 // in (0, 1]; below 1 the handle is soft
  std::vector<Interval> active;      // when it holds, one after another; empty: always
  double fade = 0;                   // seconds, at both ends of each

  bool is_anchor() const {
    const bool is_keyed = !(move.empty() && to.empty() && rotate.empty() && euler.keys.empty() &&
                            scale.empty() && curve.empty());
    return !is_keyed && !follow && layers.empty() && waves.empty() && noises.empty() && !mirror && parent < 0;
  }
};

/// Vertices that move as one body.
struct RigidSelection {
  std::string name;
  Mark where;
  Selection select;
};

/// A part of the surface with a λ of its own.
struct LambdaRegion {
  Mark where;
  Selection select;
  Track<double> lambda;  // never empty
  Length feather;        // over which it goes over into what is around it; share of the diagonal
};

/// Vertices that are not solved and ride on the surface.
struct Attachment {
  Mark where;
  Selection select;
  std::optional<Selection> to;  // what they ride on; default: all that is solved
};

/// What the `solver` key says, its preset already applied. The terms are those of the deformer.
struct SolverSettings {
  enum class Preset { quality, paper };
  enum class System { least_squares, direct };
  enum class LocalScale { axis, uniform, none };
  enum class Weights { clamped, cotangent, intrinsic_delaunay, uniform };
  enum class Cell { spokes, spokes_and_rims };
  Preset preset = Preset::quality;
  System system = System::least_squares;
  LocalScale local_scale = LocalScale::uniform;
  double epsilon = 0.05;
  Weights weights = Weights::clamped;
  Cell cell = Cell::spokes;
  bool area_weighting = false;
  int iterations = 30;
  double tolerance = 1e-3;  // share of the diagonal
  bool predict = true;
  bool accelerate = true;
  double max_step = std::numbers::pi / 6;  // radians that a handle turns in one solve; infinite: off
};

/// A node of a glTF file, as the timeline names it.
struct NodeName {
  std::string name;
  Mark where;
};

/// What the mesh key says.
struct MeshSource {
  std::string file;  // as the timeline gives it, without "#Node"
  Mark where;
  std::vector<NodeName> nodes;  // of a glTF file, to be solved; empty: all of its scene
  enum class Loose { attach, hold, error };
  Loose loose = Loose::attach;  // components that no handle or anchor touches
  UpAxis up = UpAxis::y;
  Length weld;  // vertices at most this far apart are solved as one; share of the diagonal
};

/// A pose of the shot that becomes a morph target.
struct PoseOutput {
  std::string name;
  NamedPose handles;  // those that it leads; all others are at rest
  Mark where;
};

/// What output.gltf says; path is empty where no GLB is asked for.
struct GltfOutput {
  std::string path;  // as the timeline gives it, placeholders and all
  Mark where;
  enum class Basis { knots, pca, frames };
  enum class Encoding { floats, meshopt };
  Basis basis = Basis::knots;  // with floats `profile: compat`; pca with meshopt is `web`, frames `exact`
  Encoding encoding = Encoding::floats;
  double tolerance = 1e-3;     // of what plays, a share of the diagonal; frames need none
  bool normals = true;         // `normals: smooth`
  int max_targets = 200;       // more are refused
  bool handles = false;        // written as animated nodes
  bool split = false;          // `split: auto`: what never moves becomes a mesh without targets
  std::string animation = {};  // its name; empty: the shot's
  struct Merge {
    std::string name;  // of a clip of the mesh's file that gets the weights instead; empty: none
    Mark where;
  };
  Merge merge_into = {};
  std::vector<PoseOutput> poses = {};  // a morph target each, of weight 0
};

/// The solved clip in another form: what output.cache, output.frames or output.usd names.
struct CacheOutput {
  enum class Form { pc2, mdd, obj, npz, usda };
  Form form = Form::pc2;
  std::string
      path;  // as the timeline gives it; of a sequence a pattern with one "%04d" for the frame's number
  Mark where;

  bool is_sequence() const { return form == Form::obj || form == Form::npz; }
};

/// What output.report says; path is empty where none is asked for.
struct ReportOutput {
  std::string path;  // as the timeline gives it, placeholders and all; one for all runs of a sweep
  Mark where;
};

/// What output.html says; path is empty where no page is asked for.
struct HtmlOutput {
  std::string path;  // as the timeline gives it, placeholders and all
  Mark where;
};

/// A part of the shot under a name of its own.
struct NamedInterval {
  std::string name;
  Interval time;
};

/// What a run of a sweep gives a key.
struct SweptValue {
  std::string key;      // its path, "solver.iterations"
  std::string text;     // as it stands in the names of outputs
  bool varies = false;  // other runs have other values
};

/// How a shot is played again and again.
enum class Loop {
  none,
  cycle,     // its last frame goes over into its first: of two laps that are solved the second is kept
  ping_pong  // there and, by the same frames, back
};

/// One timeline file as plain values. Times in seconds, angles in radians, lengths in mesh units.
struct Shot {
  std::string name;  // the file's name without folder and extension
  std::string file;  // as given; "-" for standard input
  MeshSource mesh;
  std::map<std::string, std::string> variables;  // those that are one word, for placeholders
  double fps = 24;
  double duration = 0;  // seconds of the keys, and with ping-pong those of the way there
  Loop loop = Loop::none;
  std::optional<Selection> roi;
  std::vector<Handle> handles;
  std::vector<RigidSelection> rigid;
  std::vector<Attachment> attachments;
  Track<double> lambda;               // never empty: a constant is one key
  std::vector<LambdaRegion> regions;  // of later ones it is the value where they overlap
  SolverSettings solver;
  GltfOutput gltf;
  std::vector<CacheOutput> caches;
  HtmlOutput html;
  PreviewOutput preview;
  ReportOutput report;
  std::vector<NamedInterval> clips;  // an animation each in the GLB; empty: one of the whole shot
  std::vector<SweptValue> swept;     // where it is a run of a sweep
  int run = 0;                       // and its number there

  /// Frame k is at k / fps. A cycle lacks the one at its end, which is frame 0.
  int frame_count() const {
    const int last = static_cast<int>(duration * fps + 1e-6);
    if (loop == Loop::cycle) return last;
    return loop == Loop::ping_pong ? 2 * last + 1 : last + 1;
  }
};

}  // namespace flexkey
