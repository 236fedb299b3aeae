#include "cli/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/sweep_runs.h"

namespace flexkey::cli {
namespace {

using nlohmann::json;

std::string size_text(std::uintmax_t bytes) {
  const double size = static_cast<double>(bytes);
  if (bytes >= 1'000'000) return fmt::format("{:.1f} MB", size / 1e6);
  if (bytes >= 1'000) return fmt::format("{:.1f} kB", size / 1e3);
  return fmt::format("{} bytes", bytes);
}

/// "3 of 48 frames WHAT (7, 8, 9)"
std::string frames_text(const std::vector<int>& frames, std::size_t of, const char* what) {
  constexpr std::size_t shown = 6;
  const auto last = frames.begin() + static_cast<std::ptrdiff_t>(std::min(shown, frames.size()));
  return fmt::format("{} of {} frames {} ({}{})", frames.size(), of, what,
                     fmt::join(frames.begin(), last, ", "), frames.size() > shown ? ", …" : "");
}

std::string convergence_text(const RunReport& run) {
  if (!run.claims_convergence) return "a fixed count of iterations, no convergence claimed";
  const std::vector<int> unconverged = run.unconverged();
  if (unconverged.empty()) return "every frame converged";
  return frames_text(unconverged, run.frames.size(), "did not converge");
}

/// "solved before; ", "24 of 48 frames solved before; "
std::string before_text(const RunReport& run) {
  if (run.solved_before() == 0) return {};
  if (run.solved_now == 0) return "solved before; ";
  return fmt::format("{} of {} frames solved before; ", run.solved_before(), run.frames.size());
}

json frame_json(const FrameReport& frame) {
  return {{"frame", frame.frame},
          {"lambda", frame.lambda},
          {"solves", frame.solves},
          {"estimate", std::isfinite(frame.estimate) ? json(frame.estimate) : json()},
          {"converged", frame.converged},
          {"slipped", frame.slipped}};
}

json pose_json(const PoseNote& pose) {
  json solved = frame_json(pose.solved);
  solved.erase("frame");
  solved["name"] = pose.name;
  return solved;
}

json split_json(const SplitNote& note) {
  return {{"mesh", note.mesh},         {"vertices", note.vertices},       {"moved", note.moved},
          {"targeted", note.targeted}, {"split", note.why_whole.empty()}, {"why_whole", note.why_whole}};
}

json gltf_json(const WrittenFile& file) {
  const GltfReport& gltf = file.gltf;
  json clients = json::array();
  for (const ClientNote& note : gltf.clients)
    clients.push_back({{"client", note.client}, {"plays", note.plays}, {"why", note.why}});
  json splits = json::array();
  for (const SplitNote& note : gltf.splits) splits.push_back(split_json(note));
  return {{"path", file.path.string()},
          {"bytes", gltf.bytes},
          {"profile", gltf.profile},
          {"targets", gltf.targets},
          {"keys", gltf.keys},
          {"vertices", gltf.vertices},
          {"target_vertices", gltf.target_vertices},
          {"error", gltf.error},
          {"kg_error", gltf.kg_error},
          {"normal_error_mean", gltf.normal_error_mean},
          {"normal_error_largest", gltf.normal_error_largest},
          {"pose_error", gltf.pose_error},
          {"gpu_bytes", gltf.gpu_bytes},
          {"gpu_bytes_whole", gltf.gpu_bytes_whole},
          {"splits", std::move(splits)},
          {"extensions", gltf.extensions},
          {"clients", std::move(clients)}};
}

json cache_json(const WrittenCache& cache) {
  return {{"path", cache.path.string()},
          {"format", cache.format},
          {"files", cache.files},
          {"bytes", cache.bytes},
          {"seconds", cache.seconds}};
}

json page_json(const WrittenPage& page) {
  return {{"path", page.path.string()},   {"bytes", page.bytes},      {"profile", page.gltf.profile},
          {"targets", page.gltf.targets}, {"error", page.gltf.error}, {"seconds", page.seconds}};
}

std::string cache_text(const WrittenCache& cache) {
  const std::string files = cache.files > 1 ? fmt::format("{} files, ", cache.files) : "";
  return fmt::format("  write  {:6.2f} s   {}, {}{}\n", cache.seconds, cache.path.string(), files,
                     size_text(cache.bytes));
}

std::string page_text(const WrittenPage& page) {
  return fmt::format(
      "  write  {:6.2f} s   {}, {}\n         {}: {} targets, off by at most {:.2g} % of the "
      "diagonal; open it in a browser\n",
      page.seconds, page.path.string(), size_text(page.bytes), page.gltf.profile, page.gltf.targets,
      100 * page.gltf.error);
}

json preview_json(const WrittenPreview& preview) {
  json files = json::array();
  for (const std::filesystem::path& file : preview.files) files.push_back(file.string());
  return {{"path", preview.path.string()},
          {"format", preview.format},
          {"pictures", preview.drawn + preview.kept},
          {"drawn", preview.drawn},
          {"seconds", preview.seconds},
          {"ffmpeg", preview.ffmpeg},
          {"files", std::move(files)}};
}

std::string preview_text(const WrittenPreview& preview) {
  std::string text = fmt::format("  draw   {:6.2f} s   {}, {} pictures", preview.seconds,
                                 preview.path.string(), preview.drawn + preview.kept);
  if (preview.kept > 0) text += fmt::format(", {} of them drawn before", preview.kept);
  text += "\n";
  for (const std::filesystem::path& file : preview.files) text += fmt::format("         {}\n", file.string());
  if (!preview.ffmpeg.empty()) text += fmt::format("         film: {}\n", preview.ffmpeg);
  return text;
}

/// "plays in three.js and Godot; not in Blender (reads no …)"
std::string clients_text(const std::vector<ClientNote>& notes) {
  std::vector<std::string> plays, fails;
  for (const ClientNote& note : notes) {
    std::string text = note.why.empty() ? note.client : fmt::format("{} ({})", note.client, note.why);
    (note.plays ? plays : fails).push_back(std::move(text));
  }
  std::string text = plays.empty() ? "" : fmt::format("plays in {}", fmt::join(plays, ", "));
  if (!fails.empty()) text += fmt::format("{}not in {}", text.empty() ? "" : "; ", fmt::join(fails, ", "));
  return text;
}

/// "3 targets of 80 vertices take 7.7 kB of GPU memory"
std::string targets_text(const GltfReport& gltf) {
  std::string text = fmt::format("         {} targets of {} vertices take {} of GPU memory", gltf.targets,
                                 gltf.target_vertices, size_text(gltf.gpu_bytes));
  if (gltf.gpu_bytes < gltf.gpu_bytes_whole)
    text += fmt::format(", instead of {} of all {}", size_text(gltf.gpu_bytes_whole), gltf.vertices);
  for (const SplitNote& note : gltf.splits)
    if (!note.why_whole.empty())
      text += fmt::format("\n         '{}' is not split: {}", note.mesh, note.why_whole);
  return text + "\n";
}

std::string file_text(const WrittenFile& file, double seconds) {
  const GltfReport& gltf = file.gltf;
  return fmt::format(
      "  write  {:6.2f} s   {}, {}\n         {}: {} targets, off by at most {:.2g} % of the diagonal; {}\n{}",
      seconds, file.path.string(), size_text(gltf.bytes), gltf.profile, gltf.targets, 100 * gltf.error,
      clients_text(gltf.clients), targets_text(gltf));
}

/// "poses    0.12 s   smile, frown; all converged"
std::string poses_text(const RunReport& run) {
  if (run.poses.empty()) return {};
  std::vector<std::string> names;
  for (const PoseNote& pose : run.poses) names.push_back(pose.name);
  const std::vector<std::string> unconverged = run.unconverged_poses();
  std::string fate = run.claims_convergence ? "all converged" : "no convergence claimed";
  if (!unconverged.empty()) fate = fmt::format("not converged: {}", fmt::join(unconverged, ", "));
  return fmt::format("  poses  {:6.2f} s   {}; {}\n", run.pose_seconds, fmt::join(names, ", "), fate);
}

json mesh_json(const FamilyReport& family) {
  return {{"file", family.mesh.string()}, {"vertices", family.vertices}, {"faces", family.faces}};
}

json run_json(const RunReport& run) {
  json swept = json::object();
  for (const SweptValue& value : run.swept) swept[value.key] = value.text;
  json frames = json::array(), written = json::array(), poses = json::array();
  for (const PoseNote& pose : run.poses) poses.push_back(pose_json(pose));
  for (const FrameReport& frame : run.frames) frames.push_back(frame_json(frame));
  for (const WrittenFile& file : run.written) written.push_back(gltf_json(file));
  for (const WrittenCache& cache : run.caches) written.push_back(cache_json(cache));
  for (const WrittenPage& page : run.pages) written.push_back(page_json(page));
  for (const WrittenPreview& preview : run.previews) written.push_back(preview_json(preview));
  return {
      {"swept", std::move(swept)},
      {"lambda", {{"first", run.lambda_first}, {"last", run.lambda_last}}},
      {"gap", run.gap ? json(*run.gap) : json()},
      {"frames", run.frames.size()},
      {"solved_before", run.solved_before()},
      {"solves", run.solves()},
      {"claims_convergence", run.claims_convergence},
      {"unconverged", run.unconverged()},
      {"slipped", run.slipped()},
      {"poses", std::move(poses)},
      {"seconds", {{"solve", run.solve_seconds}, {"poses", run.pose_seconds}, {"write", run.write_seconds}}},
      {"outputs", std::move(written)},
      {"frame_reports", std::move(frames)}};
}

std::string run_text(const RunReport& run) {
  const double mean =
      run.frames.empty() ? 0 : static_cast<double>(run.solves()) / static_cast<double>(run.frames.size());
  std::string text = fmt::format("  solve  {:6.2f} s   {}{:.1f} solves a frame; {}\n", run.solve_seconds,
                                 before_text(run), mean, convergence_text(run));
  if (const std::vector<int> slipped = run.slipped(); !slipped.empty())
    text += fmt::format("  slip   the surface lost a turn that its handles made: {}\n",
                        frames_text(slipped, run.frames.size(), "slipped"));
  if (run.gap)
    text += fmt::format("  loop   ends within {:.2g} % of the diagonal of where it begins\n", 100 * *run.gap);
  text += poses_text(run);
  for (const WrittenFile& file : run.written) text += file_text(file, run.write_seconds);
  for (const WrittenCache& cache : run.caches) text += cache_text(cache);
  for (const WrittenPage& page : run.pages) text += page_text(page);
  for (const WrittenPreview& preview : run.previews) text += preview_text(preview);
  return text;
}

}  // namespace

std::size_t RunReport::solved_before() const {
  return frames.size() - solved_now;
}

int RunReport::solves() const {
  int total = 0;
  for (const FrameReport& frame : frames) total += frame.solves;
  return total;
}

std::vector<int> RunReport::unconverged() const {
  std::vector<int> result;
  if (!claims_convergence) return result;
  for (const FrameReport& frame : frames)
    if (!frame.converged) result.push_back(frame.frame);
  return result;
}

std::vector<int> RunReport::slipped() const {
  std::vector<int> result;
  for (const FrameReport& frame : frames)
    if (frame.slipped) result.push_back(frame.frame);
  return result;
}

std::vector<std::string> RunReport::unconverged_poses() const {
  std::vector<std::string> result;
  if (!claims_convergence) return result;
  for (const PoseNote& pose : poses)
    if (!pose.solved.converged) result.push_back(pose.name);
  return result;
}

FamilyReport family_report(const LoadedShot& loaded, double load_seconds) {
  return {loaded.shot.name,
          loaded.shot.file,
          loaded.hash,
          loaded.shot.fps,
          loaded.shot.frame_count(),
          loaded.mesh_path,
          loaded.mesh.vertex_count(),
          loaded.mesh.face_count(),
          load_seconds,
          loaded.warnings,
          {}};
}

std::string report_json(const std::vector<FamilyReport>& families) {
  const FamilyReport& first = families.front();
  json list = json::array();
  std::vector<std::string> warnings;
  double load_seconds = 0;
  for (const FamilyReport& family : families) {
    load_seconds += family.load_seconds;
    for (const RunReport& run : family.runs) {
      list.push_back(run_json(run));
      list.back().update({{"fps", family.fps}, {"mesh", mesh_json(family)}});
    }
    for (const std::string& warning : family.warnings)
      if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end()) warnings.push_back(warning);
  }
  const json report = {{"shot", first.shot},       {"file", first.file},
                       {"hash", first.hash},       {"fps", first.fps},
                       {"mesh", mesh_json(first)}, {"seconds", {{"load", load_seconds}}},
                       {"runs", std::move(list)},  {"warnings", warnings}};
  return report.dump(2, ' ', false, json::error_handler_t::replace);
}

std::string report_text(const FamilyReport& family) {
  std::string text = fmt::format("{}: {} frames of {} vertices\n  load   {:6.2f} s\n", family.shot,
                                 family.frames, family.vertices, family.load_seconds);
  for (const RunReport& run : family.runs) {
    if (const std::string title = run_title(run.swept); !title.empty()) text += fmt::format("  {}\n", title);
    text += run_text(run);
  }
  return text;
}

}  // namespace flexkey::cli
