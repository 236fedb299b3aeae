#include "flexkey/gltf/split_note.h"

#include <fmt/format.h>

namespace flexkey {

SplitNote decide_split(SplitNote note) {
  if (note.moved >= note.vertices - note.moved)
    return left_whole(note, fmt::format("{} of its {} vertices move", note.moved, note.vertices));
  if (note.targeted >= note.vertices) return left_whole(note, "faces that move name all of its vertices");
  return note;
}

SplitNote left_whole(SplitNote note, const std::string& why) {
  note.targeted = note.vertices;
  note.why_whole = why;
  return note;
}

std::string still_name(const std::string& name) {
  return fmt::format("{}_still", name);
}

}  // namespace flexkey
