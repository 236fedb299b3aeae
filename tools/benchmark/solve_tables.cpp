#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "results.h"

namespace flexkey::bench {
namespace {

using Choose = std::function<bool(const Case&)>;

bool same(const Setting& a, const Setting& b) {
  return a.system == b.system && a.local_scale == b.local_scale && a.lambda == b.lambda;
}

/// The cells that name a setting; their titles are `setting_titles`.
std::vector<Cell> cells_of(const Setting& setting) {
  const char* scale = setting.local_scale == LocalScale::uniform ? "uniform" : "axis";
  return {setting.lambda == 1 ? "any" : scale, setting.system == System::direct ? "direct" : "least-squares",
          Cell(fmt::format("{}", setting.lambda), setting.lambda)};
}
const std::vector<std::string> setting_titles{"local scale", "system", "λ"};

/// The scenes that were solved with a setting.
std::vector<Case> cases_with(const Study& study, const Setting& setting, const Choose& choose) {
  std::vector<Case> chosen;
  for (const Case& one : study.cases) {
    if (same(one.setting, setting) && choose(one)) chosen.push_back(one);
  }
  return chosen;
}

/// Solves a frame, marked where the cap ended some frames.
Cell counted(const Tally& tally) {
  const char* mark = tally.converged < tally.frames ? "≥ " : "";
  return {fmt::format("{}{:.1f}", mark, tally.solves_a_frame()), tally.solves_a_frame()};
}

void add_start_cells(const std::vector<Case>& cases, std::vector<Cell>& row) {
  constexpr std::size_t start_count = 3;
  for (std::size_t start = 0; start < start_count; ++start) {
    Tally sum;
    for (const Case& one : cases) sum += one.starts[start];
    row.push_back(counted(sum));
  }
  Tally sum;
  for (const Case& one : cases) sum += one.predicted;
  row.push_back(counted(sum));
}

/// What the cases are called, each once.
std::vector<std::string> names_of(const Study& study, std::string Case::*name) {
  std::vector<std::string> names;
  for (const Case& one : study.cases) {
    if (std::find(names.begin(), names.end(), one.*name) == names.end()) names.push_back(one.*name);
  }
  return names;
}

Honesty honesty_of(const std::vector<Case>& cases) {
  Honesty sum;
  for (const Case& one : cases) sum += one.honesty;
  return sum;
}

/// "3 of 12", and the share behind it.
Cell part(int some, int all) {
  return {fmt::format("{} of {}", some, all), all > 0 ? static_cast<double>(some) / all : 0};
}

}  // namespace

Table start_table(const Study& study) {
  Table table{.title = "Global solves a frame until the solver's own stop at 0.1 % of the diagonal, by start",
              .header = setting_titles};
  for (const char* scene : {"bar", "blob"}) {
    for (const char* start : {"cold", "warm", "warm, Anderson", "predicted, Anderson"})
      table.header.push_back(fmt::format("{}: {}", scene, start));
  }
  for (const Setting& setting : all_settings()) {
    std::vector<Cell> row = cells_of(setting);
    add_start_cells(cases_with(study, setting, [](const Case& one) { return one.mesh == "bar"; }), row);
    add_start_cells(cases_with(study, setting, [](const Case& one) { return one.mesh == "blob"; }), row);
    table.rows.push_back(std::move(row));
  }
  table.note =
      "bar: the five scenes of the 4:1 bar together. A frame that the cap stops counts its cap (30 for the "
      "last of each four, 200 for the others); ≥ marks where that happened.";
  return table;
}

Table scene_table(const Study& study) {
  Table table{.title = "Global solves a frame by scene, with the defaults", .header = setting_titles};
  const std::vector<std::string> scenes = names_of(study, &Case::scene);
  table.header.insert(table.header.end(), scenes.begin(), scenes.end());
  table.header.insert(table.header.end(), {"mean of scenes", "frames converged"});
  for (const Setting& setting : all_settings()) {
    std::vector<Cell> row = cells_of(setting);
    Tally sum;
    double mean = 0;
    for (const Case& one : cases_with(study, setting, [](const Case&) { return true; })) {
      row.push_back(counted(one.predicted));
      mean += one.predicted.solves_a_frame() / static_cast<double>(scenes.size());
      sum += one.predicted;
    }
    row.push_back(count(mean));
    row.push_back(percent(sum.converged_share()));
    table.rows.push_back(std::move(row));
  }
  table.note = "Frames that only repeat the one before do not count.";
  return table;
}

Table shot_table(const Study& study) {
  Table table{.title = "The sample shots as they are",
              .header = {"shot", "frames that move", "solves a frame", "frames converged"}};
  for (const auto& [name, tally] : study.shots) {
    table.rows.push_back({name, Cell(fmt::format("{}", tally.frames), tally.frames),
                          count(tally.solves_a_frame()), percent(tally.converged_share())});
  }
  return table;
}

Table honesty_table(const Study& study) {
  Table table{
      .title = "Frames reported converged that are farther than twice the tolerance from where they lead",
      .header = setting_titles};
  const std::vector<std::string> meshes = names_of(study, &Case::mesh);
  table.header.insert(table.header.end(), meshes.begin(), meshes.end());
  table.header.insert(table.header.end(), {"all", "share", "worst", "unsettled"});
  for (const Setting& setting : all_settings()) {
    std::vector<Cell> row = cells_of(setting);
    Honesty all;
    for (const std::string& mesh : meshes) {
      const Honesty sum =
          honesty_of(cases_with(study, setting, [&](const Case& one) { return one.mesh == mesh; }));
      row.push_back(part(sum.beyond, sum.checked));
      all += sum;
    }
    row.push_back(part(all.beyond, all.checked));
    row.push_back(percent(all.checked > 0 ? static_cast<double>(all.beyond) / all.checked : 0));
    row.push_back(share_of_diagonal(all.worst));
    row.push_back(part(all.unsettled, all.checked));
    table.rows.push_back(std::move(row));
  }
  table.note =
      "At most a dozen frames a scene, evenly spread, each carried on by accelerated steps to 1e-9 of the "
      "diagonal. "
      "Unsettled: not there after 1,000 more solves; the distance so far counts.";
  return table;
}

}  // namespace flexkey::bench
