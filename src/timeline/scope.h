#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "flexkey/timeline/findings.h"
#include "flexkey/timeline/node.h"
#include "flexkey/timeline/sources.h"
#include "flexkey/timeline/track.h"

namespace flexkey {

/// Values that the file names; an empty one was defined with an error, which is not reported again where it
/// is used.
template <class Value>
using Names = std::map<std::string, std::optional<Value>, std::less<>>;

/// What the readers of a file share: the values named in it, its defaults, and where findings go.
struct Scope {
  Scope(Findings& sink, const Sources& files) : findings(sink), sources(files) {}

  Findings& findings;
  const Sources& sources;
  double fps = 24;
  Easing ease;                                   // the file's default
  std::map<std::string, std::string> variables;  // those that are one word
  Names<double> times;
  Names<Vec3> points;
  Names<Curve> paths;
  Names<NamedPose> poses;
  std::vector<std::string> pose_names;  // in the file's order
  double last_key = 0;                  // seconds; of all tracks read so far
  Mark last_key_where;
};

template <class Value>
std::vector<std::string> known_words(const Names<Value>& names) {
  std::vector<std::string> words;
  words.reserve(names.size());
  for (const auto& [name, value] : names) words.push_back(name);
  return words;
}

/// The value of a name. what: "point"; where_defined: "points", the key under which such names stand.
template <class Value>
std::optional<Value> look_up(const Names<Value>& names, const Node& name, std::string_view what,
                             std::string_view where_defined, Findings& findings) {
  const auto found = names.find(name.text);
  if (found != names.end()) return found->second;
  const std::string hint = "; such names are defined under '" + std::string(where_defined) + "'";
  const std::vector<std::string> known =
      findings.proposes(names.size()) ? known_words(names) : std::vector<std::string>();
  findings.error(name.where, "unknown " + std::string(what) + " '" + name.text + "'" +
                                 findings.proposal(name.text, known, hint));
  return std::nullopt;
}

}  // namespace flexkey
