#include "cli/sweep_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

namespace flexkey::cli {
namespace {

/// Whether a key changes the numbers of λ and nothing else. The whole of `lambda` may bring regions.
bool is_lambda_alone(const std::string& key, bool has_regions) {
  return key.starts_with("lambda.keys") || (!has_regions && (key == "lambda" || key.starts_with("lambda.")));
}

/// What runs that are solved together have in common, as a text.
std::string family_name(const Shot& run, bool has_regions) {
  std::string name = fmt::format("{} {} {}", run.fps, run.duration, run.frame_count());
  for (const SweptValue& value : run.swept)
    if (!is_lambda_alone(value.key, has_regions)) name += fmt::format("\n{}: {}", value.key, value.text);
  return name;
}

}  // namespace

std::vector<Shot> runs_of_chunk(const Chunk& chunk, const std::vector<Shot>& runs) {
  const auto [first, last] = range_of(chunk, runs.size(), "run");
  return {runs.begin() + first, runs.begin() + last};
}

std::vector<std::vector<Shot>> families_of(const std::vector<Shot>& runs) {
  const bool has_regions =
      std::any_of(runs.begin(), runs.end(), [](const Shot& run) { return !run.regions.empty(); });
  std::vector<std::vector<Shot>> families;
  std::map<std::string, std::size_t> numbers;
  for (const Shot& run : runs) {
    const auto [found, is_new] = numbers.emplace(family_name(run, has_regions), families.size());
    if (is_new) families.emplace_back();
    families[found->second].push_back(run);
  }
  return families;
}

std::string run_title(const std::vector<SweptValue>& swept) {
  std::string title;
  for (const SweptValue& value : swept)
    if (value.varies)
      title += fmt::format("{}{} = {}", title.empty() ? "" : ", ", value.key == "lambda" ? "λ" : value.key,
                           value.text);
  return title;
}

}  // namespace flexkey::cli
