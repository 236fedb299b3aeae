#pragma once

#include "quad_mesh.h"

#include <functional>
#include <string>
#include <vector>

namespace flexkey::meshes {

using Patch = std::vector<Index>;

// Surface of the half box over the given grid lines; xs starts at 0 and that side stays open.
QuadMesh half_box(const std::vector<double>& xs, const std::vector<double>& ys, const std::vector<double>& zs,
                  const std::string& part);

// Faces whose centre lies in the box lo..hi and whose normal points along `facing`.
Patch select(const QuadMesh& mesh, const Vec3& lo, const Vec3& hi, const Vec3& facing);

// The one face nearest to the point among those that look about the same way; for a point on
// x = 0 only faces that touch that plane are taken, for others only those that do not.
Patch pick(const QuadMesh& mesh, const Vec3& point, const Vec3& facing);

// Brings the patch to the foot of a detail, widens it when it is too small, and puts a loop of that
// radius in it, square when the patch is a single quad; the detail grows from that loop.
void seat(QuadMesh& mesh, const Patch& patch, const std::string& part, const Vec3& foot, const Vec3& facing,
          double radius);

void set_part(QuadMesh& mesh, const Patch& patch, const std::string& part);

// Extrudes a patch: its border is doubled, walls join the two, and `place` moves the new rim and
// the patch's inner vertices. Border edges on x = 0 get no wall, as the mirror image goes on there.
void extrude(QuadMesh& mesh, const Patch& patch, const std::string& part,
             const std::function<Vec3(const Vec3&)>& place);

// Shrinks the patch towards its middle, which puts a ring of quads (an edge loop) around it.
void inset(QuadMesh& mesh, const Patch& patch, const std::string& part, double scale,
           const Vec3& shift = Vec3::Zero());

// One cross-section of a tube: where its middle lies, how large it is (mean distance of the rim's
// and inner vertices), and which way it faces; along the path when no direction is given.
struct Section {
  Vec3 centre;
  double radius;
  Vec3 facing = Vec3::Zero();
};

// Extrudes a patch along a path; each section is square to its direction.
void extrude_tube(QuadMesh& mesh, const Patch& patch, const std::string& part,
                  const std::vector<Section>& path);

}  // namespace flexkey::meshes
