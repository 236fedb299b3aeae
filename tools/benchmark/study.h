#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "solves.h"

namespace flexkey::bench {

enum class Scenes { bars_and_blob, all };

/// One scene solved in one way.
struct Case {
  std::string scene;
  std::string mesh;  // "bar" for the five of the 4:1 bar, else the scene
  Setting setting;
  Tally predicted = {};            // the default start
  std::vector<Tally> starts = {};  // cold, warm, accelerated; only of the bar and the blob
  Honesty honesty = {};
};

struct Study {
  std::vector<Case> cases;                           // every scene in every setting
  std::vector<std::pair<std::string, Tally>> shots;  // the sample shots as they are
};

/// Counts the solves of the bench's scenes: the bar's five, the blob of 2k vertices and, for `all`, the
/// sample shots nose, leg, jaw and twist of that folder. Uses all processors: it times nothing.
Study study_solves(const std::filesystem::path& timelines, Scenes scenes);

}  // namespace flexkey::bench
