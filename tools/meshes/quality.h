#pragma once

#include "quad_mesh.h"

#include <string>

namespace flexkey::meshes {

struct Quality {
  bool closed = false;  // every edge has two faces that run along it opposite ways
  bool single = false;  // one connected component
  bool fans = false;    // the faces at each vertex form one closed fan
  Index euler = 0;      // vertices - edges + faces
  double volume = 0.0;
  double least_angle = 0.0;  // degrees, over all corners
  double largest_angle = 0.0;
  double shortest_edge = 0.0;  // over the mean edge
  double mean_edge = 0.0;
  double worst_warp = 0.0;          // degrees between the two triangles of a quad
  double worst_bend = 0.0;          // degrees between the normals of neighbouring quads
  Vec3 worst_place = Vec3::Zero();  // where the worst bend is
  double asymmetry = 0.0;
};

Quality measure(const QuadMesh& mesh);

std::string report(const std::string& name, const QuadMesh& mesh, const Quality& quality);

}  // namespace flexkey::meshes
