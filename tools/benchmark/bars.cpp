#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>

#include "results.h"
#include "statistics.h"

namespace flexkey::bench {
namespace {

enum class Sense { at_least, at_most };

void add(Table& table, const std::string& what, Sense sense, double bar, double reached) {
  const bool is_met = sense == Sense::at_least ? reached >= bar : reached <= bar;
  table.rows.push_back({what, sense == Sense::at_least ? "at least" : "at most",
                        Cell(fmt::format("{:g}", bar), bar), Cell(fmt::format("{:.3g}", reached), reached),
                        is_met ? "yes" : "no"});
}

void add_peer_bars(Table& table, const PeerResult& result) {
  const std::string& size = result.size.name;
  if (size == "10k" || size == "50k" || size == "200k") {
    add(table, fmt::format("one iteration, {}: CGAL / flexkey", size), Sense::at_least,
        size == "200k" ? 10 : 12, median_ratio(result.cgal, result.plain, &StepCost::iteration));
  }
  if (size == "50k") {
    add(table, "60 frames, 50k: CGAL's 5 iterations a frame / flexkey to 1e-3", Sense::at_least, 20,
        median_ratio(result.cgal_5, result.converged, &ClipCost::seconds));
    add(table, "set-up, 50k: CGAL / flexkey", Sense::at_least, 3,
        median_ratio(result.cgal, result.plain, &StepCost::set_up));
  }
  if (size == "200k") {
    add(table, "memory, 200k: flexkey with prediction / CGAL", Sense::at_most, 1,
        1 / median_ratio(result.cgal, result.standard, &StepCost::peak));
  }
}

using Choose = std::function<bool(const Setting&)>;

/// Mean over the scenes and settings of the solves a frame.
double mean_solves(const Study& study, const Choose& choose) {
  double sum = 0;
  int cases = 0;
  for (const Case& one : study.cases) {
    if (!choose(one.setting)) continue;
    sum += one.predicted.solves_a_frame();
    ++cases;
  }
  return sum / cases;
}

double honest_share(const Study& study, const Choose& choose) {
  Honesty sum;
  for (const Case& one : study.cases) {
    if (choose(one.setting)) sum += one.honesty;
  }
  return 1 - static_cast<double>(sum.beyond) / sum.checked;
}

double converged_share(const Study& study, const Choose& choose) {
  Tally sum;
  for (const Case& one : study.cases) {
    if (choose(one.setting)) sum += one.predicted;
  }
  return sum.converged_share();
}

void add_study_bars(Table& table, const Study& study) {
  const auto below_1 = [](LocalScale local_scale) {
    return [=](const Setting& s) { return s.local_scale == local_scale && s.lambda < 1; };
  };
  const Choose uniform = below_1(LocalScale::uniform), axis = below_1(LocalScale::axis);
  const Choose rigid = [](const Setting& s) { return s.lambda == 1; };
  const Choose rigid_least_squares = [](const Setting& s) {
    return s.lambda == 1 && s.system == System::least_squares;
  };
  add(table, "solves a frame, λ < 1, uniform", Sense::at_most, 3.5, mean_solves(study, uniform));
  add(table, "solves a frame, λ < 1, axis", Sense::at_most, 4.5, mean_solves(study, axis));
  add(table, "solves a frame, λ = 1, least-squares", Sense::at_most, 18,
      mean_solves(study, rigid_least_squares));
  add(table, "converged frames within twice the tolerance, λ < 1, uniform", Sense::at_least, 0.99,
      honest_share(study, uniform));
  add(table, "converged frames within twice the tolerance, λ < 1, axis", Sense::at_least, 0.97,
      honest_share(study, axis));
  add(table, "converged frames within twice the tolerance, λ = 1", Sense::at_least, 0.90,
      honest_share(study, rigid));
  add(table, "frames reported converged, λ < 1", Sense::at_least, 0.95,
      converged_share(study, [](const Setting& s) { return s.lambda < 1; }));
}

void add_gltf_bars(Table& table, const GltfResult& result) {
  const bool is_long = result.frames >= 240;
  const std::string clip = fmt::format("{}, {} frames", result.name, result.frames);
  const auto compat = static_cast<double>(result.compat.report.bytes);
  const auto web = static_cast<double>(result.web.report.bytes);
  add(table, fmt::format("{}: dense / compat", clip), Sense::at_least, is_long ? 3 : 2,
      result.dense / compat);
  add(table, fmt::format("{}: dense / web", clip), Sense::at_least, is_long ? 25 : 12, result.dense / web);
  for (const Packed& packed : result.packed) {
    if (packed.options != "-cc") continue;
    add(table, fmt::format("{}: gltfpack -cc / web at its error", clip), Sense::at_least, 4,
        packed.bytes / static_cast<double>(packed.web.report.bytes));
    add(table, fmt::format("{}: that web's error / gltfpack's", clip), Sense::at_most, 1,
        packed.web.report.error / packed.error);
  }
  if (is_long)
    add(table, fmt::format("{}: web's export, CPU seconds", clip), Sense::at_most,
        std::max(5.0, result.solve_seconds), result.web.seconds);
}

void add_preview_bars(Table& table, const PreviewResult& result) {
  add(table, "applying stencils against PrimvarRefiner, 10k, level 2", Sense::at_most, 0.5,
      stencil_ratio(result.stencils));
  add(table, "subdivision and tree as a share of a final frame", Sense::at_most, 0.15,
      geometry_share(result.frame));
  add(table, "memory growth from 24 to 240 pictures", Sense::at_most, 0.05,
      result.memory.of_240 / result.memory.of_24 - 1);
}

}  // namespace

Table bar_table(const Results& results) {
  Table table{.title = "The bars", .header = {"bar", "sense", "is", "reached", "met"}};
  for (const PeerResult& result : results.peers) add_peer_bars(table, result);
  if (results.study) add_study_bars(table, *results.study);
  for (const GltfResult& result : results.gltf) add_gltf_bars(table, result);
  if (results.preview) add_preview_bars(table, *results.preview);
  if (results.limit) {
    add(table, "a global solve against reading its factor twice", Sense::at_most, 3,
        results.limit->solve / results.limit->bound());
  }
  if (results.threads) {
    add(table, "one iteration, two threads against one", Sense::at_least, 1.4,
        median(results.threads->one) / median(results.threads->two));
  }
  return table;
}

std::vector<Table> all_tables(const Results& results) {
  std::vector<Table> tables;
  if (!results.peers.empty()) tables.push_back(peer_table(results.peers));
  if (results.threads) tables.push_back(thread_table(*results.threads));
  if (results.limit) tables.push_back(limit_table(*results.limit));
  if (results.study) {
    tables.push_back(start_table(*results.study));
    tables.push_back(scene_table(*results.study));
    if (!results.study->shots.empty()) tables.push_back(shot_table(*results.study));
    tables.push_back(honesty_table(*results.study));
  }
  if (!results.gltf.empty()) {
    tables.push_back(gltf_table(results.gltf));
    tables.push_back(gltfpack_table(results.gltf));
  }
  if (results.preview) tables.push_back(preview_table(*results.preview));
  tables.push_back(bar_table(results));
  return tables;
}

}  // namespace flexkey::bench
