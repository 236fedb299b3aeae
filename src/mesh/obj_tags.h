#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "flexkey/mesh/mesh.h"

namespace flexkey {

/// The `t` lines of an OBJ, with which OpenSubdiv's own shapes are sharpened:
///   t crease 2/1/0 7 8 2.5      the edge of vertices 7 and 8 (from 0), of sharpness 2.5
///   t corner 1/1/0 7 10         vertex 7
/// Behind the name stand the counts of whole numbers, numbers and words. A tag may hold several edges or
/// vertices, of one sharpness or one each.
class ObjTags {
 public:
  /// name: of the file, for messages.
  explicit ObjTags(std::string name) : name_(std::move(name)) {}

  /// text: what stands behind the `t`. False for tags of other names, which are passed over. Throws
  /// InputError with the line where counts, vertices or a sharpness cannot be.
  bool add(std::string_view text, int line);

  /// Gives the mesh its creases and sharp vertices. Returns a warning for each crease on what is no edge,
  /// which is left out. Throws InputError with the line for a vertex that is not there.
  std::vector<std::string> put_on(Mesh& mesh) const;

 private:
  struct Tag {
    int line = 0;
    std::vector<long long> vertices;  // two a crease, one a sharp vertex
    std::vector<double> sharpness;    // one of all, or one each
  };
  Tag parsed(std::string_view text, int line) const;
  std::vector<int> vertices_of(const Tag& tag, const Mesh& mesh) const;
  [[noreturn]] void fail(int line, std::string_view message) const;

  std::string name_;
  std::vector<Tag> creases_, corners_;
};

}  // namespace flexkey
