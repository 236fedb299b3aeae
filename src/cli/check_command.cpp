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
#include "cli/handle_paths.h"
#include "cli/html_page.h"
#include "cli/load.h"
#include "cli/pose_outputs.h"
#include "cli/previews.h"
#include "cli/shot_picture.h"
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

json handles_json(const Shot& shot, const Scene& scene) {
  const std::vector<double> times = moments_to_look_at(shot);
  json handles = json::array();
  for (std::size_t h = 0; h < scene.handles.size(); ++h) {
    const auto& [handle, vertices, rest, pivot] = scene.handles[h];
    json active = json::array();
    for (const Interval& interval : handle.active) active.push_back({interval.from, interval.to});
    handles.push_back({{"name", handle.name},
                       {"vertices", file_vertices(scene, vertices)},
                       {"anchor", handle.is_anchor()},
                       {"motions", motions_of(handle)},
                       {"pivot", vec_json(pivot)},
                       {"weight", handle.weight},
                       {"active", std::move(active)},
                       {"reach", reach_of(scene, static_cast<int>(h), times)}});
  }
  return handles;
}

json summary(const ReadTimeline& timeline, const LoadedShot& loaded, const Scene& scene) {
  json rigid = json::array();
  for (std::size_t k = 0; k < scene.constraints.rigid.size(); ++k)
    rigid.push_back({{"name", loaded.shot.rigid[k].name},
                     {"vertices", file_vertices(scene, scene.constraints.rigid[k])}});
  json outputs = json::array();
  for (const Shot& run : timeline.runs) {
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
            {"diagonal", bounds.diagonal()},
            {"groups", std::move(groups)},
            {"defects", describe(find_defects(scene.weld.surface))}}},
          {"fps", loaded.shot.fps},
          {"duration", loaded.shot.duration},
          {"frames", loaded.shot.frame_count()},
          {"roi", {{"vertices", scene.region_vertices}, {"free", scene.free_vertices}}},
          {"riders", scene.riders.size()},
          {"handles", handles_json(loaded.shot, scene)},
          {"rigid", std::move(rigid)},
          {"lambda",
           {{"first", loaded.shot.lambda.front().value},
            {"last", loaded.shot.lambda.back().value},
            {"regions", loaded.shot.regions.size()}}},
          {"runs", timeline.runs.size()},
          {"outputs", std::move(outputs)},
          {"warnings", loaded.warnings}};
}

/// "soft 0.5, from 1 s to 2 s": what is unusual of a handle.
std::string remarks_of(const json& handle) {
  std::vector<std::string> remarks;
  if (const double weight = handle["weight"].get<double>(); weight < 1)
    remarks.push_back(fmt::format("soft {:g}", weight));
  for (const json& interval : handle["active"])
    remarks.push_back(
        fmt::format("from {:g} s to {:g} s", interval[0].get<double>(), interval[1].get<double>()));
  return fmt::format("{}", fmt::join(remarks, ", "));
}

/// The handles in columns.
void print_handles(const json& handles, double diagonal) {
  std::size_t width = 4;
  for (const json& handle : handles) width = std::max(width, handle["name"].get<std::string>().size());
  print_result(fmt::format("         {:<{}}  vertices  farthest from rest   motion\n", "name", width));
  for (const json& handle : handles) {
    const auto motions = handle["motions"].get<std::vector<std::string>>();
    const double reach = handle["reach"].get<double>();
    const bool is_anchor = handle["anchor"].get<bool>();
    const std::string far =
        is_anchor ? std::string("-") : fmt::format("{:.4g} ({:.1f} %)", reach, 100 * reach / diagonal);
    const std::string remarks = remarks_of(handle);
    const std::string line =
        fmt::format("{}   {:<{}}  {:>8}  {:<18}   {}{}{}", is_anchor ? "anchor" : "handle",
                    handle["name"].get<std::string>(), width, handle["vertices"].get<int>(), far,
                    is_anchor ? "held" : fmt::format("{}", fmt::join(motions, ", ")),
                    remarks.empty() ? "" : "; ", remarks);
    print_result(fmt::format("{}\n", line));
  }
}

std::string lambda_text(const json& lambda) {
  const double first = lambda["first"].get<double>(), last = lambda["last"].get<double>();
  const int regions = lambda["regions"].get<int>();
  const std::string text =
      first == last ? fmt::format("{:g}", first) : fmt::format("{:g} .. {:g}", first, last);
  return regions == 0 ? text : fmt::format("{}, and {} region(s) of its own", text, regions);
}

void print_text(const json& summary) {
  const json& mesh = summary["mesh"];
  print_result(fmt::format("{}: {} frames at {:g} fps, {:g} s\n", summary["shot"].get<std::string>(),
                           summary["frames"].get<int>(), summary["fps"].get<double>(),
                           summary["duration"].get<double>()));
  print_result(fmt::format("mesh     {}: {} vertices, {} faces, {} component(s), diagonal {:.4g}\n",
                           mesh["file"].get<std::string>(), mesh["vertices"].get<int>(),
                           mesh["faces"].get<int>(), mesh["components"].get<int>(),
                           mesh["diagonal"].get<double>()));
  print_result(fmt::format("region   {} vertices, {} of them free\n", summary["roi"]["vertices"].get<int>(),
                           summary["roi"]["free"].get<int>()));
  if (const int riders = summary["riders"].get<int>(); riders > 0)
    print_result(
        fmt::format("loose    {} component(s) that no handle touches ride on the surface\n", riders));
  print_result(fmt::format("lambda   {}\n", lambda_text(summary["lambda"])));
  print_handles(summary["handles"], mesh["diagonal"].get<double>());
  for (const json& region : summary["rigid"])
    print_result(fmt::format("rigid    {}: {} vertices\n", region["name"].get<std::string>(),
                             region["vertices"].get<int>()));
  if (const int runs = summary["runs"].get<int>(); runs > 1)
    print_result(fmt::format("sweep    {} runs\n", runs));
  for (const json& output : summary["outputs"])
    print_result(fmt::format("output   {}\n", output.get<std::string>()));
}

/// Draws the picture that is asked for, and says where it is.
void draw_picture(const LoadedShot& loaded, const Scene& scene, const ShotOptions& options) {
  const std::filesystem::path path = options.out_dir / options.picture;
  check_shot_picture(loaded, path);
  write_shot_picture(loaded, scene, path);
  if (!options.json && !options.quiet) print_result(fmt::format("picture  {}\n", path.string()));
}

}  // namespace

int run_check(const ShotOptions& options) {
  const ReadTimeline timeline = read_shot(options);
  LoadedShot loaded;
  Scene scene;
  for (std::size_t family = timeline.families.size(); family-- > 0;) {  // the first last: it is summed up
    loaded = load_family(timeline, family, options);
    scene = bind_loaded(loaded.shot, loaded, options);
    plan_outputs(loaded, options, loaded.runs);  // for its errors: what `animate` would refuse
    check_pose_outputs(loaded, options);
    check_caches(loaded, options, loaded.runs);
    check_pages(loaded, options, loaded.runs);
    check_previews(loaded, options, loaded.runs);
  }
  const json report = summary(timeline, loaded, scene);
  if (!options.quiet)
    for (const std::string& warning : loaded.warnings) say(fmt::format("{}\n", warning));
  if (options.json) {
    print_result(fmt::format("{}\n", report.dump(2, ' ', false, json::error_handler_t::replace)));
  } else if (!options.quiet) {
    print_text(report);
  }
  if (!options.picture.empty()) draw_picture(loaded, scene, options);
  return done;
}

}  // namespace flexkey::cli
