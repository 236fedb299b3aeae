#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/scope.h"

namespace flexkey {

/// One key of a track, its value still to be read.
struct WrittenKey {
  double time = 0;  // seconds
  Easing ease;
  const Node* value = nullptr;
  Mark where;  // of the time
};

/// An easing: a word, or [x1, y1, x2, y2] with x1 and x2 in 0..1.
std::optional<Easing> read_easing(const Node& node, Scope& scope);

/// The `ease` of a track's mapping, or else the file's default.
Easing track_ease(const Fields& fields, Scope& scope);

/// Keys by increasing time, from {time: value} or from [{at, value, ease}]. ease: of keys that give none.
/// Two keys at one time are an error; so are no keys at all. place: "'move' of handle 'tip'".
std::vector<WrittenKey> read_keys(const Node& keys, const Easing& ease, std::string_view place, Scope& scope);

/// The keys of a mapping {keys, ease}.
std::vector<WrittenKey> read_track(const Node& node, std::string_view place, Scope& scope);

/// The track of keys whose value `read` can read; read: std::optional<Value>(const Node&).
template <class Value, class Read>
Track<Value> track_of(const std::vector<WrittenKey>& keys, const Read& read) {
  Track<Value> track;
  for (const WrittenKey& key : keys) {
    if (const std::optional<Value> value = read(*key.value)) track.push_back({key.time, *value, key.ease});
  }
  return track;
}

}  // namespace flexkey
