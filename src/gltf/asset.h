#pragma once

#include <optional>
#include <vector>

#include "flexkey/animate/clip.h"
#include "flexkey/gltf/primitives.h"
#include "flexkey/gltf/shape.h"
#include "flexkey/gltf/textures.h"
#include "flexkey/gltf/write_glb.h"

namespace flexkey {

/// What a file shows of the clip beside its motion.
struct Asset {
  const Clip& clip;
  std::vector<Primitive> primitives;
  TextureSet textures;
  std::optional<SeamlessNormals> normals;  // none: the file has no normals
  Shape rest;                              // the base as written, a row a vertex of the mesh
  double texcoord_step = 0;  // of which texture coordinates are written as multiples; 0: as they are
};

/// The asset's normals at some positions of its mesh; empty without. The asset has to outlive it.
NormalsAt normals_of(const Asset& asset);

/// Splits the clip's mesh and reads its textures. The clip has to outlive what it returns.
Asset asset_of(const Clip& clip, const GltfOptions& options);

}  // namespace flexkey
