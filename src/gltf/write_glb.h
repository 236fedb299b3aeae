#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "flexkey/animate/clip.h"
#include "flexkey/gltf/compatibility.h"
#include "flexkey/gltf/split_note.h"

namespace flexkey {

struct GltfSource;

/// Which targets the frames are made of.
enum class BasisKind {
  knots,   // frames at which the motion bends, refitted; weights 0..1
  pca,     // principal components
  frames,  // every frame
};

enum class Encoding {
  floats,   // core glTF, sparse where that is smaller
  meshopt,  // 16-bit deltas (KHR_mesh_quantization) under EXT_meshopt_compression
};

/// A named animation of some of the clip: from .. to, seconds of the shot.
struct ClipRange {
  std::string name;
  double from = 0;
  double to = 0;
};

/// How a handle of the shot moved.
struct HandleTrack {
  std::string name;
  Vec3 pivot;                             // at rest, file units
  std::vector<Eigen::Matrix4d> matrices;  // #frames, rest to frame
};

/// A shape of the clip's mesh that gets a morph target of its own.
struct PoseShape {
  std::string name;
  Positions positions;  // #V x 3, vertices in the file's order, file units
};

struct GltfOptions {
  BasisKind basis = BasisKind::knots;
  Encoding encoding = Encoding::floats;
  double tolerance =
      1e-3;             // of what plays, quantization included, a share of the rest diagonal; frames: unused
  bool normals = true;  // write smooth normals and their deltas; else none, and clients shade flat
  bool split = false;   // faces that never move become a mesh of their own, where that saves targets
  std::vector<ClipRange> clips;        // one animation each; empty: one of the whole clip
  std::string animation;               // name of that one; empty: the clip's
  const GltfSource* source = nullptr;  // the file that the clip's mesh is of: the clip is written into it
  std::string merge_into;        // with a source, an animation of it that gets the weights; empty: a new one
  std::vector<PoseShape> poses;  // behind the clip's targets, named so, of weight 0; 1 is the pose
  std::vector<HandleTrack> handles;  // to be written as animated nodes; empty: none
  std::string hash;                  // of timeline and mesh, for extras
  std::filesystem::path
      texture_folder;     // where relative texture paths of materials start: the mesh file's folder
  int max_targets = 200;  // more are an error; WebGL2 guarantees 256
  std::function<void(double share)> on_progress = {};  // how much of the writing is done, 0..1, increasing
};

/// "compat", "web", "exact", or the basis and encoding of none of them: "pca float", "knots meshopt".
std::string profile_name(const GltfOptions& options);

struct GltfReport {
  std::uintmax_t bytes = 0;
  std::string profile;
  int targets = 0;   // morph targets a mesh primitive
  int keys = 0;      // times at which weights are given
  int vertices = 0;  // of all primitives, after parting along UV and material seams
  double error =
      0;  // largest vertex distance from the solved frames, read back, as a share of the rest diagonal
  double kg_error = 0;              // percent
  double normal_error_mean = 0;     // degrees, likewise
  double normal_error_largest = 0;  // degrees
  double pose_error = 0;            // as `error`, of the poses at a weight of 1
  int target_vertices = 0;          // of those that carry targets: fewer where meshes are split
  std::uintmax_t gpu_bytes = 0;  // that the targets take in a client: 32 a vertex and target, sparse or not
  std::uintmax_t gpu_bytes_whole = 0;   // that they would take if no mesh were split
  std::vector<SplitNote> splits;        // what became of each mesh; empty where no split was asked for
  std::vector<std::string> extensions;  // that a client must know
  std::vector<ClientNote> clients;      // whether well-known clients play it
  std::vector<std::string> warnings;
};

/// Writes the clip as a GLB: the rest mesh, its morph targets and their weights over time, LINEAR.
/// One primitive a material; polygons become triangles; textures that are there as PNG or JPEG are embedded.
/// With a source the file is that one, with nothing changed but the shape of what was solved (see graft.h).
/// Written beside `path` and renamed when whole. Throws OutputError, and InputError for what glTF cannot
/// hold or for more targets than are allowed.
GltfReport write_glb(const Clip& clip, const GltfOptions& options, const std::filesystem::path& path);

/// A GLB in memory.
struct GlbFile {
  std::string bytes;
  GltfReport report;
};

/// The same for what holds a GLB inside, such as a page.
GlbFile make_glb(const Clip& clip, const GltfOptions& options);

}  // namespace flexkey
