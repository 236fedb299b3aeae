#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flexkey/gltf/glb.h"
#include "flexkey/gltf/gltf_scene.h"

namespace flexkey {

/// Faces of a primitive. Accessors are those of the addition.
struct PrimitivePart {
  int indices = -1;               // of a list of triangles; -1: all faces, as the file has them
  GltfAttributes attributes;      // of vertices of their own; none: the file's
  std::vector<GltfGroup> groups;  // among those triangles
};

/// What one primitive of a solved node gets. Accessors are those of the addition.
struct PrimitiveAddition {
  std::optional<PrimitivePart> moving = PrimitivePart();  // what has the targets; none: nothing of it does
  std::optional<PrimitivePart> still;   // what goes into a mesh without targets; none: nothing of it does
  std::vector<GltfAttributes> targets;  // #new targets, all of the same attributes
  GltfAttributes zeros;                 // for those of the attributes that some target lacks
  bool drop_normals = false;            // its normals would stay at rest: clients shade flat without them
};

struct NodeAddition {
  int node = 0;  // of the file
  std::vector<PrimitiveAddition> primitives;
};

/// A weights channel that stands in the file, whose values change.
struct ChannelChange {
  int animation = 0, channel = 0;  // of the file
  int input = -1;                  // accessor of the addition, or -1: the times stay
  int output = 0;                  // accessor of the addition
  std::string interpolation;       // of the new values; empty: as it was
};

/// A channel that is new.
struct NewChannel {
  int node = 0;               // of the file; those that are new count on from its last
  int input = 0, output = 0;  // accessors of the addition; LINEAR
  std::string path = "weights";
};

/// A node that is new, beside the roots of the default scene.
struct NewNode {
  std::string name;
  Vec3 translation;
};

/// An animation of the new targets.
struct AnimationAddition {
  std::string name;
  int into = -1;  // animation of the file that gets the channels; -1: a new one of that name does
  std::vector<NewChannel> channels;
};

/// What a clip adds to a file.
struct Addition {
  Glb glb;  // its buffers, views, accessors and extensions are appended to the file's; what the extras of its
            // mesh 0 say is said of the meshes and animations that it adds to
  std::vector<NodeAddition> nodes;  // the solved ones
  std::vector<NewNode> new_nodes;
  std::vector<std::string> names;  // of the new targets
  std::vector<ChannelChange> changed;
  std::vector<AnimationAddition> animations;
};

/// The file with the addition in it, and everything else as it was. A mesh that other nodes show too is
/// copied for the solved one. Names of new targets that the file has already get a number behind them. Where
/// parts of a mesh move and others are still, these become a mesh and a node of their own below the solved
/// one; of a skinned one beside it, since joints alone place a skin. Accessors that nothing uses any longer
/// give their place to new ones.
Glb graft(const Glb& file, const Addition& addition);

}  // namespace flexkey
