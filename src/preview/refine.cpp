#include "flexkey/preview/refine.h"

#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <algorithm>
#include <memory>

#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;
using Descriptor = Far::TopologyDescriptor;
using Factory = Far::TopologyRefinerFactory<Descriptor>;
// Not StencilTableFactory, which casts its tables to a type that they are not.
using StencilFactory = Far::StencilTableFactoryReal<float>;
using Refiner = std::unique_ptr<Far::TopologyRefiner>;

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

bool is_triangles(const Mesh& mesh) {
  return mesh.corners.size() == 3 * index(mesh.face_count());
}

/// Row of the file's texture coordinates at each corner of the control mesh; corners without one share a row
/// after the last. Empty where the file has none.
std::vector<int> texcoord_of_corner(const ControlMesh& control, const Mesh& source) {
  std::vector<int> rows;
  if (source.corner_texcoord.empty()) return rows;
  const int none = static_cast<int>(source.texcoords.rows());
  for (const int corner : control.corner_source) {
    const int row = source.corner_texcoord[index(corner)];
    rows.push_back(row < 0 ? none : row);
  }
  return rows;
}

/// What is sharp as OpenSubdiv takes it.
struct Sharpness {
  std::vector<int> edges;  // two vertices a crease
  std::vector<float> of_edges;
  std::vector<int> vertices;
  std::vector<float> of_vertices;
};

Sharpness sharpness_of(const Mesh& mesh) {
  Sharpness sharpness;
  for (const Crease& crease : mesh.creases) {
    sharpness.edges.insert(sharpness.edges.end(), {crease.from, crease.to});
    sharpness.of_edges.push_back(static_cast<float>(crease.sharpness));
  }
  for (const SharpVertex& sharp : mesh.sharp_vertices) {
    sharpness.vertices.push_back(sharp.vertex);
    sharpness.of_vertices.push_back(static_cast<float>(sharp.sharpness));
  }
  return sharpness;
}

Refiner make_refiner(const ControlMesh& control, const Mesh& source, int level) {
  const Mesh& mesh = control.mesh;
  std::vector<int> sizes;
  for (int f = 0; f < mesh.face_count(); ++f) sizes.push_back(static_cast<int>(mesh.face(f).size()));
  const std::vector<int> texcoords = texcoord_of_corner(control, source);
  Descriptor::FVarChannel channel;
  channel.numValues = static_cast<int>(source.texcoords.rows()) + 1;
  channel.valueIndices = texcoords.data();

  Descriptor descriptor;
  descriptor.numVertices = mesh.vertex_count();
  descriptor.numFaces = mesh.face_count();
  descriptor.numVertsPerFace = sizes.data();
  descriptor.vertIndicesPerFace = mesh.corners.data();
  descriptor.numFVarChannels = texcoords.empty() ? 0 : 1;
  descriptor.fvarChannels = &channel;
  const Sharpness sharpness = sharpness_of(mesh);
  descriptor.numCreases = static_cast<int>(sharpness.of_edges.size());
  descriptor.creaseVertexIndexPairs = sharpness.edges.data();
  descriptor.creaseWeights = sharpness.of_edges.data();
  descriptor.numCorners = static_cast<int>(sharpness.vertices.size());
  descriptor.cornerVertexIndices = sharpness.vertices.data();
  descriptor.cornerWeights = sharpness.of_vertices.data();

  Sdc::Options rules;
  // Without this OpenSubdiv makes holes of the faces along borders.
  rules.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
  rules.SetFVarLinearInterpolation(Sdc::Options::FVAR_LINEAR_CORNERS_ONLY);
  const Sdc::SchemeType scheme = is_triangles(mesh) ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK;
  Refiner refiner(Factory::Create(descriptor, Factory::Options(scheme, rules)));
  if (!refiner) throw InputError("the mesh cannot be subdivided: OpenSubdiv refuses its topology");
  Far::TopologyRefiner::UniformOptions depth(level);
  depth.fullTopologyInLastLevel = true;  // the edges, for `wires`
  refiner->RefineUniform(depth);
  return refiner;
}

Stencils make_stencils(const Far::TopologyRefiner& refiner, StencilFactory::Mode mode) {
  StencilFactory::Options options;
  options.interpolationMode = static_cast<unsigned>(mode) & 3u;  // a field of two bits
  options.generateIntermediateLevels = false;
  const std::unique_ptr<const Far::StencilTableReal<float>> table(StencilFactory::Create(refiner, options));
  Stencils stencils;
  stencils.offsets.assign(1, 0);
  for (const int size : table->GetSizes()) stencils.offsets.push_back(stencils.offsets.back() + size);
  stencils.vertices = table->GetControlIndices();
  stencils.weights = table->GetWeights();
  return stencils;
}

/// Texture coordinates of the last level's values, with a last column of zeros.
Points refine_texcoords(const Far::TopologyRefiner& refiner, const TexCoords& texcoords) {
  Points values = Points::Zero(texcoords.rows() + 1, 3);
  values.topLeftCorner(texcoords.rows(), 2) = texcoords.cast<float>();
  return apply(make_stencils(refiner, StencilFactory::INTERPOLATE_FACE_VARYING), values);
}

/// Face of the first level that a face of the last one is part of.
int base_face(const Far::TopologyRefiner& refiner, int face) {
  for (int level = refiner.GetMaxLevel(); level > 0; --level)
    face = refiner.GetLevel(level).GetFaceParentFace(face);
  return face;
}

void add_triangles(Surface& surface, const Far::TopologyRefiner& refiner, const ControlMesh& control,
                   const TexCoords& texcoords) {
  const Far::TopologyLevel& last = refiner.GetLevel(refiner.GetMaxLevel());
  const bool has_texcoords = last.GetNumFVarChannels() > 0;
  const Points values = has_texcoords ? refine_texcoords(refiner, texcoords) : Points();
  for (int f = 0; f < last.GetNumFaces(); ++f) {
    const Far::ConstIndexArray vertices = last.GetFaceVertices(f);
    const int source = control.face_source[index(base_face(refiner, f))];
    for (int k = 1; k + 1 < vertices.size(); ++k) {
      surface.triangles.push_back({vertices[0], vertices[k], vertices[k + 1]});
      surface.face_of.push_back(source);
      if (!has_texcoords) continue;
      const Far::ConstIndexArray rows = last.GetFaceFVarValues(f);
      const auto uv = [&](int corner) { return values.row(rows[corner]).head<2>().transpose(); };
      surface.texcoords.push_back({uv(0), uv(k), uv(k + 1)});
    }
  }
}

/// The edges of the last level that halve, again and again, those of the control mesh.
std::vector<std::array<int, 2>> control_edges(const Far::TopologyRefiner& refiner) {
  std::vector<int> edges(index(refiner.GetLevel(0).GetNumEdges()));
  for (std::size_t e = 0; e < edges.size(); ++e) edges[e] = static_cast<int>(e);
  for (int level = 0; level < refiner.GetMaxLevel(); ++level) {
    std::vector<int> halves;
    for (const int e : edges)
      for (const int half : refiner.GetLevel(level).GetEdgeChildEdges(e)) halves.push_back(half);
    edges = std::move(halves);
  }
  std::vector<std::array<int, 2>> wires;
  for (const int e : edges) {
    const Far::ConstIndexArray ends = refiner.GetLevel(refiner.GetMaxLevel()).GetEdgeVertices(e);
    wires.push_back({ends[0], ends[1]});
  }
  return wires;
}

/// Where each vertex of the file has gone.
std::vector<int> follow_vertices(const Far::TopologyRefiner& refiner, std::vector<int> vertices) {
  for (int& v : vertices)
    for (int level = 0; level < refiner.GetMaxLevel() && v >= 0; ++level)
      v = refiner.GetLevel(level).GetVertexChildVertex(v);
  return vertices;
}

}  // namespace

Refined refine(const ControlMesh& control, const Mesh& source, int level) {
  const Refiner refiner = make_refiner(control, source, level);
  Refined refined;
  refined.stencils = make_stencils(*refiner, StencilFactory::INTERPOLATE_VERTEX);
  refined.surface.vertex_count = refiner->GetLevel(level).GetNumVertices();
  add_triangles(refined.surface, *refiner, control, source.texcoords);
  refined.surface.wires = control_edges(*refiner);
  refined.surface.of_vertex = follow_vertices(*refiner, control.of_vertex);
  return refined;
}

}  // namespace flexkey
