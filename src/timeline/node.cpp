#include "flexkey/timeline/node.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "flexkey/mesh/limits.h"
#include "flexkey/timeline/compose.h"

namespace flexkey {
namespace {

using Written = WrittenNode;

/// `{frames: 1-30,47}`: YAML takes 47 for a key. index: of the first such key among the map's children.
std::string bare_key_message(const Written& map, std::size_t index) {
  const std::vector<Written>& children = map.children;
  const std::string& word = children[index].text;
  const std::size_t colon = word.find(':');
  if (colon != std::string::npos && colon + 1 < word.size()) {
    return fmt::format("'{}' needs a space after its ':'", word);
  }
  const bool follows_scalar = index >= 2 && children[index - 1].kind == Written::Kind::scalar;
  if (!follows_scalar) return fmt::format("'{}' has no value", word);
  std::string list = children[index - 1].text;
  std::string quoted = list;
  for (std::size_t i = index; i + 1 < children.size() && children[i + 1].bare; i += 2) {
    list += ", " + children[i].text;
    quoted += "," + children[i].text;
  }
  const std::string& key = children[index - 2].text;
  return fmt::format(
      "'{0}' has no value: a comma inside {{ }} begins a new key; write a list, {1}: [{2}], or quotes, "
      "{1}: \"{3}\"",
      word, key, list, quoted);
}

/// Where the expansion stands.
struct Place {
  int depth = 0;  // lists and mappings around the value
  Mark where;  // of the outermost alias that is being followed: what stands inside is not to blame for bounds
  bool in_alias = false;
};

Place deeper(Place place) {
  ++place.depth;
  return place;
}

/// Follows aliases and merge keys from the written tree to the expanded one.
class Expander {
 public:
  Expander(const Written& root, Findings& findings) : findings_(findings) { note_anchors(root); }

  Node expand(const Written& written, Place place) {
    const Written& source = follow(written);
    if (!place.in_alias) place = {place.depth, written.where, written.kind == Written::Kind::alias};
    check_bounds(place);
    Node node;
    node.where = source.where;
    if (source.kind == Written::Kind::scalar) {
      node.kind = Node::Kind::scalar;
      node.text = source.text;
    } else if (source.kind == Written::Kind::list) {
      node.kind = Node::Kind::list;
      for (const Written& item : source.children) node.items.push_back(expand(item, deeper(place)));
    } else if (source.kind == Written::Kind::map) {
      node.kind = Node::Kind::map;
      node.entries = expand_entries(source, place);
    }
    return node;
  }

 private:
  void check_bounds(Place place) {
    if (++count_ > limits::timeline_values) {
      throw YamlError(place.where, fmt::format("with its aliases the timeline has more than {} values",
                                               limits::timeline_values));
    }
    if (place.depth > limits::timeline_depth) {
      throw YamlError(place.where, fmt::format("with its aliases, values are nested more than {} deep",
                                               limits::timeline_depth));
    }
  }

  void note_anchors(const Written& written) {
    if (written.anchor != 0 && written.kind != Written::Kind::alias)
      anchors_.emplace(written.anchor, &written);
    for (const Written& child : written.children) note_anchors(child);
  }

  const Written& follow(const Written& written) const {
    return written.kind == Written::Kind::alias ? *anchors_.at(written.anchor) : written;
  }

  std::vector<Entry> expand_entries(const Written& map, Place place) {
    std::vector<Entry> entries;
    std::vector<const Written*> merges;  // values of `<<`, taken last since explicit keys win
    std::unordered_set<std::string> seen;
    for (std::size_t i = 0; i + 1 < map.children.size(); i += 2) {
      const Written& key = follow(map.children[i]);
      const Written& value = map.children[i + 1];
      if (!is_key(key, map.children[i].where)) continue;
      if (value.bare) {
        const bool first_of_run = i < 2 || !map.children[i - 1].bare;
        if (first_of_run) findings_.error(key.where, bare_key_message(map, i));
      } else if (!seen.insert(key.text).second) {
        findings_.error(map.children[i].where, fmt::format("duplicate key '{}'", key.text));
      } else if (key.plain && key.text == "<<") {
        merges.push_back(&value);
      } else {
        entries.push_back({expand(map.children[i], deeper(place)), expand(value, deeper(place))});
        if (entries.back().value.kind == Node::Kind::null)
          entries.back().value.where = entries.back().key.where;
      }
    }
    for (const Written* merge : merges) {
      for (Node& merged : expand_merge(*merge, place)) {
        for (Entry& entry : merged.entries) {
          if (seen.insert(entry.key.text).second) entries.push_back(std::move(entry));
        }
      }
    }
    return entries;
  }

  bool is_key(const Written& key, Mark where) {
    if (key.kind == Written::Kind::scalar) return true;
    findings_.error(where, "a key must be a single word");
    return false;
  }

  /// The mappings that a `<<` names, one or a list of them.
  std::vector<Node> expand_merge(const Written& merge, Place place) {
    std::vector<Node> maps;
    const Written& source = follow(merge);
    if (source.kind == Written::Kind::list) {
      for (const Written& item : source.children) maps.push_back(expand(item, place));
    } else {
      maps.push_back(expand(merge, place));
    }
    for (const Node& map : maps) {
      if (map.kind == Node::Kind::map) continue;
      findings_.error(merge.where, fmt::format("'<<' merges mappings, not {}", describe(map)));
    }
    return maps;
  }

  Findings& findings_;
  std::unordered_map<std::size_t, const Written*> anchors_;
  std::size_t count_ = 0;
};

}  // namespace

const Entry* Node::find(std::string_view key) const {
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.key.text == key; });
  return found == entries.end() ? nullptr : &*found;
}

std::string describe(const Node& node) {
  switch (node.kind) {
    case Node::Kind::scalar:
      return fmt::format("'{}'", node.text);
    case Node::Kind::list:
      return "a list";
    case Node::Kind::map:
      return "a mapping";
    case Node::Kind::null:
      break;
  }
  return "an empty value";
}

Node parse_yaml(std::string_view text, Findings& findings) {
  const SourceText source(text);
  const Written root = compose(source);
  return Expander(root, findings).expand(root, Place{});
}

}  // namespace flexkey
