#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/cache_outputs.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/html_page.h"
#include "cli/load.h"
#include "cli/previews.h"
#include "flexkey/animate/scene.h"
#include "flexkey/mesh/connectivity.h"
#include "flexkey/mesh/defects.h"
#include "flexkey/timeline/parse.h"

namespace flexkey::cli {
namespace {

using nlohmann::json;

/// How many of the file's vertices a set of surface vertices stands for: what a person counts.
int file_vertices(const Scene& scene, const std::vector<int>& surface_vertices) {
  std::vector<bool> taken(static_cast<std::size_t>(scene.weld.surface.vertex_count()), false);
  for (const int v : surface_vertices) taken[static_cast<std::size_t>(v)] = true;
  return static_cast<int>(std::count_if(scene.weld.to_surface.begin(), scene.weld.to_surface.end(),
                                        [&](int v) { return taken[static_cast<std::size_t>(v)]; }));
}

std::vector<const char*> motions_of(const Handle& handle) {
  std::vector<const char*> motions;
  if (!handle.move.empty()) motions.push_back("move");
  if (!handle.to.empty()) motions.push_back("to");
  if (handle.follow) motions.push_back("follow");
  if (!handle.rotate.empty() || !handle.euler.keys.empty()) motions.push_back("rotate");
  if (!handle.scale.empty()) motions.push_back("scale");
  if (!handle.curve.empty()) motions.push_back("curve");
  if (!handle.layers.empty()) motions.push_back("pose or motion");
  if (!handle.waves.empty()) motions.push_back("wave");
  if (!handle.noises.empty()) motions.push_back("noise");
  if (handle.mirror) motions.push_back("mirror");
  if (handle.parent >= 0) motions.push_back("parent");
  return motions;
}

json vec_json(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

json summary(const LoadedShot& loaded, const Scene& scene) {
  json handles = json::array();
  for (const SceneHandle& bound : scene.handles)
    handles.push_back({{"name", bound.handle.name},
                       {"vertices", file_vertices(scene, bound.vertices)},
                       {"anchor", bound.handle.is_anchor()},
                       {"motions", motions_of(bound.handle)},
                       {"pivot", vec_json(bound.pivot)}});
  json outputs = json::array();
  for (const Shot& run : runs_of(loaded.shot)) {
    if (!run.gltf.path.empty()) outputs.push_back(run.gltf.path);
    for (const CacheOutput& cache : run.caches) outputs.push_back(cache.path);
    if (!run.html.path.empty()) outputs.push_back(run.html.path);
    for (const std::string& path : {run.preview.dir, run.preview.gif.path, run.preview.sheet.path})
      if (!path.empty() && std::find(outputs.begin(), outputs.end(), path) == outputs.end())
        outputs.push_back(path);
  }
  json groups = json::array();
  for (const Group& group : loaded.mesh.groups)
    groups.push_back({{"name", group.name}, {"faces", group.faces.size()}});
  const Bounds bounds = bounds_of(loaded.mesh.positions);
  return {{"shot", loaded.shot.name},
          {"file", loaded.shot.file},
          {"mesh",
           {{"file", loaded.mesh_path.string()},
            {"vertices", loaded.mesh.vertex_count()},
            {"surface_vertices", scene.weld.surface.vertex_count()},
            {"faces", loaded.mesh.face_count()},
            {"components", find_components(scene.weld.surface).count},
            {"bounds", {{"min", vec_json(bounds.min)}, {"max", vec_json(bounds.max)}}},
            {"groups", std::move(groups)},
            {"defects", describe(find_defects(scene.weld.surface))}}},
          {"fps", loaded.shot.fps},
          {"duration", loaded.shot.duration},
          {"frames", loaded.shot.frame_count()},
          {"roi", {{"vertices", scene.region_vertices}, {"free", scene.free_vertices}}},
          {"riders", scene.riders.size()},
          {"handles", std::move(handles)},
          {"outputs", std::move(outputs)},
          {"warnings", loaded.warnings}};
}

void print_text(const json& summary) {
  const json& mesh = summary["mesh"];
  print_result(fmt::format("{}: {} frames at {:g} fps, {:g} s\n", summary["shot"].get<std::string>(),
                           summary["frames"].get<int>(), summary["fps"].get<double>(),
                           summary["duration"].get<double>()));
  print_result(fmt::format("mesh     {}: {} vertices, {} faces, {} component(s)\n",
                           mesh["file"].get<std::string>(), mesh["vertices"].get<int>(),
                           mesh["faces"].get<int>(), mesh["components"].get<int>()));
  print_result(fmt::format("region   {} vertices, {} of them free\n", summary["roi"]["vertices"].get<int>(),
                           summary["roi"]["free"].get<int>()));
  if (const int riders = summary["riders"].get<int>(); riders > 0)
    print_result(
        fmt::format("loose    {} component(s) that no handle touches ride on the surface\n", riders));
  for (const json& handle : summary["handles"]) {
    const auto motions = handle["motions"].get<std::vector<std::string>>();
    print_result(fmt::format(
        "{}   {:<16} {:>6} vertices   {}\n", handle["anchor"].get<bool>() ? "anchor" : "handle",
        handle["name"].get<std::string>(), handle["vertices"].get<int>(), fmt::join(motions, ", ")));
  }
  for (const json& output : summary["outputs"])
    print_result(fmt::format("output   {}\n", output.get<std::string>()));
}

}  // namespace

int run_check(const ShotOptions& options) {
  const LoadedShot loaded = load_shot(options);
  const Scene scene = bind_loaded(loaded, options);
  const std::vector<Shot> runs = runs_of(loaded.shot);
  plan_outputs(loaded, options, runs);  // for its errors: what `animate` would refuse
  check_caches(loaded, options, runs);
  check_pages(loaded, options, runs);
  check_previews(loaded, options, runs);
  const json report = summary(loaded, scene);
  if (!options.quiet)
    for (const std::string& warning : loaded.warnings) say(fmt::format("{}\n", warning));
  if (options.json) {
    print_result(fmt::format("{}\n", report.dump(2, ' ', false, json::error_handler_t::replace)));
  } else if (!options.quiet) {
    print_text(report);
  }
  return done;
}

}  // namespace flexkey::cli
