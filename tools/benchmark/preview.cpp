#include "preview.h"

#include <fmt/format.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <sys/resource.h>
#include <tbb/global_control.h>

#include <cstdlib>
#include <memory>

#include "blob.h"
#include "child.h"
#include "clock.h"
#include "flexkey/mesh/error.h"
#include "flexkey/preview/normals.h"
#include "flexkey/preview/renderer.h"
#include "flexkey/preview/subdivision.h"
#include "flexkey/preview/tracer.h"
#include "scratch.h"

namespace flexkey::bench {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

constexpr int level = 2;
constexpr int rounds = 7;

/// A point as PrimvarRefiner wants it.
struct Value {
  float x = 0, y = 0, z = 0;
  void Clear() { x = y = z = 0; }
  void AddWithWeight(const Value& other, float weight) {
    x += weight * other.x;
    y += weight * other.y;
    z += weight * other.z;
  }
};

std::unique_ptr<Far::TopologyRefiner> refiner_of(const Mesh& mesh) {
  const std::vector<int> sizes(static_cast<std::size_t>(mesh.face_count()), 3);
  Far::TopologyDescriptor descriptor;
  descriptor.numVertices = mesh.vertex_count();
  descriptor.numFaces = mesh.face_count();
  descriptor.numVertsPerFace = sizes.data();
  descriptor.vertIndicesPerFace = mesh.corners.data();
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  std::unique_ptr<Far::TopologyRefiner> refiner(
      Factory::Create(descriptor, Factory::Options(Sdc::SCHEME_LOOP, Sdc::Options())));
  refiner->RefineUniform(Far::TopologyRefiner::UniformOptions(level));
  return refiner;
}

Points single(const Positions& positions) {
  return positions.cast<float>();
}

/// The most memory that `flexkey render` has resident.
double peak_of_render(const std::filesystem::path& timeline, int frames) {
  const Measured measured = in_child([&] {
    const Scratch scratch;
    const std::string command = fmt::format(
        "'{}' render '{}' -q -d '{}' --set duration={}f --set 'output={{preview: {{size: [320, 180], "
        "subdivide: 1, "
        "quality: draft}}}}'",
        FLEXKEY_PROGRAM, timeline.string(), scratch.path().string(), frames - 1);
    if (std::system(command.c_str()) != 0)
      throw Error("flexkey render failed");  // NOLINT(concurrency-mt-unsafe)
    rusage usage{};
    ::getrusage(RUSAGE_CHILDREN, &usage);
    return std::vector<double>{1024.0 * static_cast<double>(usage.ru_maxrss)};
  });
  return measured.values.at(0);
}

}  // namespace

StencilTimes time_stencils() {
  constexpr int blob = 50;  // 10,002 vertices
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const Mesh mesh = make_blob(blob);
  const Subdivision subdivision(mesh, level);
  const Points control = single(mesh.positions);
  const auto refiner = refiner_of(mesh);
  const Far::PrimvarRefiner primvars(*refiner);
  std::vector<std::vector<Value>> levels;
  for (int k = 0; k <= level; ++k)
    levels.emplace_back(static_cast<std::size_t>(refiner->GetLevel(k).GetNumVertices()));
  for (std::size_t v = 0; v < levels[0].size(); ++v) {
    const auto row = static_cast<Eigen::Index>(v);
    levels[0][v] = {control(row, 0), control(row, 1), control(row, 2)};
  }
  StencilTimes times{mesh.vertex_count(), subdivision.surface().vertex_count, {}, {}};
  for (int round = 0; round < rounds; ++round) {
    Points refined;
    times.stencils.push_back(seconds_of(cpu_seconds, [&] { refined = subdivision.points(control); }));
    times.refining.push_back(seconds_of(cpu_seconds, [&] {
      for (int k = 1; k <= level; ++k) {
        const auto to = static_cast<std::size_t>(k);
        primvars.Interpolate(k, levels[to - 1], levels[to]);
      }
    }));
    if (refined.rows() != static_cast<Eigen::Index>(levels.back().size()))
      throw Error("the two subdivisions differ");
  }
  return times;
}

/// The frame's geometry as the tracer takes it, after the renderer's own steps.
FrameTimes time_frames() {
  constexpr int blob = 40;  // 204,800 triangles at level 2
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const Mesh mesh = make_blob(blob);
  const Subdivision subdivision(mesh, level);
  const Normals normals(subdivision.surface());
  const Points control = single(mesh.positions);
  Tracer tracer(subdivision.surface());
  const RenderOptions options;  // 960 x 540, 8 samples
  Renderer renderer(mesh, bounds_of(mesh.positions), options);
  const Camera camera = fit_camera({}, std::span(&mesh.positions, 1), 16.0 / 9);
  FrameTimes times{static_cast<int>(subdivision.surface().triangles.size()), {}, {}};
  for (int round = 0; round < rounds; ++round) {
    times.geometry.push_back(seconds_of(cpu_seconds, [&] {
      Points points = subdivision.points(control);
      Points directions = normals.at(points);
      tracer.update({subdivision.surface(), std::move(points), std::move(directions), {}, {}});
    }));
    times.whole.push_back(seconds_of(cpu_seconds, [&] { renderer.render({mesh.positions}, camera); }));
  }
  return times;
}

RenderMemory measure_render_memory(const std::filesystem::path& timelines) {
  return {peak_of_render(timelines / "nose.yaml", 24), peak_of_render(timelines / "nose.yaml", 240)};
}

}  // namespace flexkey::bench
