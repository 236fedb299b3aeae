// Measures flexkey beside CGAL and the machine, and counts its solves: what tools/bench runs.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "flexkey/mesh/error.h"
#include "results.h"

namespace flexkey::bench {
namespace {

const std::vector<std::string> all_parts{"peers", "threads", "limit", "solves", "gltf", "preview"};

struct Options {
  std::vector<std::string> parts = all_parts;
  std::string timelines = "timelines";
  std::vector<std::string> sizes;  // of the peers' blobs; empty: all
  bool quick = false;
  bool json = false;
  bool markdown = false;

  bool wants(const std::string& part) const {
    return std::find(parts.begin(), parts.end(), part) != parts.end();
  }
  bool wants_size(const std::string& size) const {
    return sizes.empty() || std::find(sizes.begin(), sizes.end(), size) != sizes.end();
  }
};

/// Blobs of 1,938, 10,002, 50,178 and 200,706 vertices.
std::vector<Size> sizes_of(const Options& options) {
  const Size k2{"2k", 22, 5, 5}, k10{"10k", 50, 5, 3}, k50{"50k", 112, 3, 3}, k200{"200k", 224, 3, 1};
  if (options.quick) return {k2, k10};
  return {k2, k10, k50, k200};
}

void say(const std::string& what) {
  std::fprintf(stderr, "bench: %s\n", what.c_str());
}

ThreadTimes time_threads(const Size& size) {
  ThreadTimes times{.vertices = 4 * size.blob * size.blob + 2};
  for (int k = 0; k < 3; ++k) {
    times.one.push_back(iteration_on_threads(size.blob, 1));
    times.two.push_back(iteration_on_threads(size.blob, 2));
  }
  return times;
}

/// The timed parts come first: counting starts threads.
Results measure(const Options& options) {
  Results results;
  const std::vector<Size> sizes = sizes_of(options);
  if (options.wants("preview")) {
    say("the memory of previews");
    results.preview = PreviewResult{measure_render_memory(options.timelines), {}, {}};
  }
  if (options.wants("peers")) {
    for (const Size& size : sizes) {
      if (!options.wants_size(size.name)) continue;
      say("flexkey and CGAL, " + size.name);
      results.peers.push_back(compare_with_peer(size));
    }
  }
  if (options.wants("threads")) {
    say("one and two threads");
    results.threads = time_threads(sizes[sizes.size() / 2]);
  }
  if (options.wants("limit")) {
    say("the limit of the memory");
    results.limit = measure_limit(sizes.back().blob);
  }
  if (options.wants("solves")) {
    say("counting solves");
    results.study = study_solves(options.timelines, options.quick ? Scenes::bars_and_blob : Scenes::all);
  }
  if (options.wants("gltf")) {
    say("writing glTF");
    results.gltf = measure_gltf(options.timelines);
  }
  if (results.preview) {
    say("drawing previews");
    results.preview->stencils = time_stencils();
    results.preview->frame = time_frames();
  }
  return results;
}

void print(const Options& options, const std::vector<Table>& tables) {
  const std::string text = options.json       ? as_json(tables)
                           : options.markdown ? as_markdown(tables)
                                              : as_text(tables);
  std::fputs(text.c_str(), stdout);
}

}  // namespace
}  // namespace flexkey::bench

int main(int argc, char** argv) {
  using namespace flexkey::bench;
  Options options;
  CLI::App app(
      "Measures flexkey beside CGAL's Surface_mesh_deformation and the machine's memory, and counts its "
      "solves.",
      "tools/bench");
  app.add_option("parts", options.parts, "what to measure (default: all of it)")
      ->check(CLI::IsMember(all_parts));
  app.add_option("--timelines", options.timelines, "folder of the sample shots")->capture_default_str();
  app.add_option("--sizes", options.sizes, "of the blobs for the peers (default: all)")
      ->check(CLI::IsMember({"2k", "10k", "50k", "200k"}))
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_flag("--quick", options.quick, "2k and 10k vertices only, and no sample shots");
  const auto json = app.add_flag("--json", options.json, "print the tables as JSON: seconds, bytes, shares");
  app.add_flag("--markdown", options.markdown, "print the tables as Markdown")->excludes(json);
  CLI11_PARSE(app, argc, argv);
  try {
    print(options, all_tables(measure(options)));
  } catch (const flexkey::Error& error) {
    say(error.what());
    return 1;
  }
  return 0;
}
