#include "flexkey/mesh/spelling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <vector>

namespace flexkey {
namespace {

std::string lower(std::string_view word) {
  std::string result(word);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Optimal string alignment distance: insert, delete, replace or swap of neighbours, each one step.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replace});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

}  // namespace

std::string nearest_word(std::string_view word, std::span<const std::string> candidates) {
  constexpr std::size_t longest_word = 64;  // keeps hostile input cheap; no key is near this length
  if (word.empty() || word.size() > longest_word) return {};
  const std::string wanted = lower(word);
  std::string best;
  std::size_t best_distance = std::numeric_limits<std::size_t>::max();
  for (const std::string& candidate : candidates) {
    const std::string known = lower(candidate);
    std::size_t distance = edit_distance(wanted, known);
    // An abbreviation ('leg_hind_l' for 'leg_hind_left') is near however much it leaves out.
    const bool abbreviates = wanted.size() >= 3 && known.starts_with(wanted);
    const bool extends = known.size() >= 3 && wanted.starts_with(known);  // 'tangential' for 'tangent'
    if (abbreviates || extends) distance = std::min<std::size_t>(distance, 2);
    const std::size_t allowed =
        abbreviates || extends ? 2 : std::max<std::size_t>(1, std::min(wanted.size(), known.size()) / 3);
    const bool has_in_common = distance < std::max(wanted.size(), known.size());
    if (has_in_common && distance <= allowed && distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::string did_you_mean(std::string_view word, std::span<const std::string> candidates) {
  const std::string near = nearest_word(word, candidates);
  return near.empty() ? std::string() : "; did you mean '" + near + "'?";
}

std::string no_such_name(std::string_view kind, std::string_view name, std::string_view where,
                         std::span<const std::string> known) {
  std::string message = fmt::format("no {} '{}' in {}", kind, name, where);
  const std::string hint = did_you_mean(name, known);
  if (!hint.empty()) return message + hint;
  if (known.empty()) return message + fmt::format("; it has no {}s", kind);
  constexpr std::size_t shown = 12;
  const std::span<const std::string> first = known.first(std::min(shown, known.size()));
  message += fmt::format("; it has {}", fmt::join(first, ", "));
  return known.size() > shown ? message + ", …" : message;
}

}  // namespace flexkey
