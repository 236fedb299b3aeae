#include "cli/gltf_options.h"

namespace flexkey::cli {
namespace {

BasisKind basis_of(GltfOutput::Basis basis) {
  switch (basis) {
    case GltfOutput::Basis::knots:
      return BasisKind::knots;
    case GltfOutput::Basis::pca:
      return BasisKind::pca;
    case GltfOutput::Basis::frames:
      break;
  }
  return BasisKind::frames;
}

}  // namespace

GltfOptions gltf_options(const Shot& run, const LoadedShot& loaded) {
  const GltfOutput& output = run.gltf;
  GltfOptions options;
  options.basis = basis_of(output.basis);
  options.encoding = output.encoding == GltfOutput::Encoding::meshopt ? Encoding::meshopt : Encoding::floats;
  options.tolerance = output.tolerance;
  options.normals = output.normals;
  options.max_targets = output.max_targets;
  options.split = output.split;
  for (const NamedInterval& clip : run.clips)
    options.clips.push_back({clip.name, clip.time.from, clip.time.to});
  options.hash = loaded.hash;
  options.animation = output.animation;
  options.merge_into = output.merge_into.name;
  if (loaded.source) options.source = &*loaded.source;
  options.texture_folder = loaded.mesh_path.parent_path();
  return options;
}

std::vector<HandleTrack> handle_tracks(const Scene& scene) {
  std::vector<HandleTrack> tracks;
  for (const SceneHandle& handle : scene.handles) tracks.push_back({handle.handle.name, handle.pivot, {}});
  return tracks;
}

}  // namespace flexkey::cli
