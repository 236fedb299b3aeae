#include "study.h"

#include <tbb/parallel_for.h>

namespace flexkey::bench {
namespace {

constexpr int small_blob = 22;  // 1,938 vertices

std::vector<std::filesystem::path> sample_shots(const std::filesystem::path& timelines) {
  return {timelines / "nose.yaml", timelines / "leg.yaml", timelines / "jaw.yaml", timelines / "twist.yaml"};
}

/// A motion with what is asked of it.
struct Task {
  const Motion& motion;
  std::string mesh;
  bool every_start = false;
};

Case run_case(const Task& task, const Setting& setting) {
  Case result{.scene = task.motion.name, .mesh = task.mesh, .setting = setting};
  result.predicted = count_solves(task.motion, setting, Start::predicted);
  if (task.every_start) {
    for (const Start start : {Start::cold, Start::warm, Start::accelerated})
      result.starts.push_back(count_solves(task.motion, setting, start));
  }
  result.honesty = check_honesty(task.motion, setting);
  return result;
}

}  // namespace

Study study_solves(const std::filesystem::path& timelines, Scenes scenes) {
  const std::vector<Motion> bars = bar_motions(timelines / "meshes" / "bar.obj");
  const Motion blob = blob_motion(small_blob);
  std::vector<Motion> shots;
  Study study;
  if (scenes == Scenes::all) {
    for (const auto& timeline : sample_shots(timelines)) {
      shots.push_back(shot_motion(timeline));
      study.shots.emplace_back(shots.back().name, count_shot(timeline));
    }
  }
  std::vector<Task> tasks;
  for (const Motion& shot : shots) tasks.push_back({shot, shot.name});
  tasks.push_back({blob, blob.name, true});
  for (const Motion& bar : bars) tasks.push_back({bar, "bar", true});

  const std::vector<Setting> settings = all_settings();
  study.cases.resize(tasks.size() * settings.size());
  tbb::parallel_for(std::size_t{0}, study.cases.size(), [&](std::size_t k) {
    study.cases[k] = run_case(tasks[k / settings.size()], settings[k % settings.size()]);
  });
  return study;
}

}  // namespace flexkey::bench
