#pragma once

#include <vector>

#include "flexkey/deform/deformer.h"
#include "flexkey/mesh/weld.h"
#include "flexkey/timeline/diagnostic.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// A handle of the shot as vertices of the surface.
struct SceneHandle {
  Handle handle;
  std::vector<int> vertices;  // of the surface; along the chain for a `path` selection
  Positions rest;             // #vertices x 3
  Vec3 pivot;
};

/// A λ of its own for a part of the surface.
struct LambdaPaint {
  Track<double> lambda;
  Eigen::VectorXd share;  // #V, 1 where it is all of λ
};

/// Vertices that are not solved and ride rigidly on the solved surface: a component that nothing leads
/// (`loose: attach`), or those of `attach` that have one nearest vertex there.
struct Rider {
  std::vector<int> vertices;  // of the surface
  std::vector<int> carriers;  // the patch of the solved surface whose rigid motion it follows
};

/// A shot bound to its mesh: every selection resolved, ready to solve.
struct Scene {
  Weld weld;
  std::vector<SceneHandle> handles;
  Constraints constraints;  // of all handles, in the order of `handles`, vertex by vertex; handles that are
                            // never active together may share vertices
  std::vector<Rider> riders;
  std::vector<LambdaPaint> paints;  // in the shot's order
  int region_vertices = 0;          // surface vertices in the region of interest
  int free_vertices = 0;            // of them, those that the solve ever moves
};

/// Resolves the shot on its mesh. Throws TimelineError with everything that does not fit: selections that
/// take nothing, handles or rigid regions that share a vertex or lie outside the region, loose components
/// under `loose: error`, a surface that nothing holds at some time.
Scene bind_shot(const Shot& shot, const Mesh& mesh);

}  // namespace flexkey
