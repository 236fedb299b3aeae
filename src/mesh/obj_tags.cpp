#include "flexkey/mesh/obj_tags.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "flexkey/mesh/connectivity.h"
#include "flexkey/mesh/error.h"
#include "flexkey/mesh/numbers.h"

namespace flexkey {
namespace {

std::vector<std::string_view> words_of(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> words;
  for (std::size_t start = text.find_first_not_of(separators); start != std::string_view::npos;
       start = text.find_first_not_of(separators)) {
    text.remove_prefix(start);
    words.push_back(text.substr(0, text.find_first_of(separators)));
    text.remove_prefix(words.back().size());
  }
  return words;
}

bool is_edge(const std::vector<MeshEdge>& edges, int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  const auto found = std::lower_bound(edges.begin(), edges.end(), std::pair(low, high),
                                      [](const MeshEdge& edge, const std::pair<int, int>& ends) {
                                        return std::pair(edge.low, edge.high) < ends;
                                      });
  return found != edges.end() && found->low == low && found->high == high;
}

}  // namespace

void ObjTags::fail(int line, std::string_view message) const {
  throw InputError(fmt::format("{}:{}: {}", name_, line, message));
}

bool ObjTags::add(std::string_view text, int line) {
  const std::vector<std::string_view> words = words_of(text, " \t");
  if (words.empty() || (words[0] != "crease" && words[0] != "corner")) return false;
  Tag tag = parsed(text, line);
  const bool is_crease = words[0] == "crease";
  const std::size_t ends = is_crease ? 2 : 1, count = tag.vertices.size() / ends;
  if (tag.vertices.empty() || tag.vertices.size() % ends != 0)
    fail(line, fmt::format("a {} has {} whole numbers, {} each", words[0], tag.vertices.size(),
                           is_crease ? "two vertices" : "one vertex"));
  if (tag.sharpness.size() != 1 && tag.sharpness.size() != count)
    fail(line, fmt::format("{} {}s have {} numbers; one sharpness of all, or one each, is needed", count,
                           words[0], tag.sharpness.size()));
  (is_crease ? creases_ : corners_).push_back(std::move(tag));
  return true;
}

ObjTags::Tag ObjTags::parsed(std::string_view text, int line) const {
  const std::vector<std::string_view> words = words_of(text, " \t");
  const std::string_view name = words[0];
  const auto counts = words_of(words.size() > 1 ? words[1] : "", "/");
  const auto count_at = [&](std::size_t k) {
    return counts.size() == 3 ? whole_number_of(counts[k]).value_or(-1) : -1;
  };
  const long long wholes = count_at(0), numbers = count_at(1), texts = count_at(2);
  if (wholes < 0 || numbers < 0 || texts < 0)
    fail(line, fmt::format("the counts of a tag are written as in 't crease 2/1/0 7 8 2.5'"));
  const auto given = std::ssize(words) - 2;
  if (wholes > given || numbers > given - wholes || texts != given - wholes - numbers)
    fail(line, fmt::format("a {} says '{}' and has {} values", name, words[1].substr(0, 32), given));
  Tag tag{line, {}, {}};
  for (std::size_t k = 2; k < words.size() - static_cast<std::size_t>(texts); ++k) {
    const std::string_view word = words[k];
    const auto value = number_of(word);
    if (std::ssize(tag.vertices) < wholes) {
      const auto vertex = whole_number_of(word);
      if (!vertex) fail(line, fmt::format("'{}' is no vertex", word.substr(0, 32)));
      tag.vertices.push_back(*vertex);
    } else if (value && *value >= 0) {
      tag.sharpness.push_back(std::min(*value, infinitely_sharp));
    } else {
      fail(line, fmt::format("the sharpness '{}' is no number from 0 up", word.substr(0, 32)));
    }
  }
  return tag;
}

std::vector<int> ObjTags::vertices_of(const Tag& tag, const Mesh& mesh) const {
  std::vector<int> vertices;
  for (const long long v : tag.vertices) {
    if (v < 0 || v >= mesh.vertex_count())
      fail(tag.line, fmt::format("there is no vertex {}; tags count them from 0, and there are {}", v,
                                 mesh.vertex_count()));
    vertices.push_back(static_cast<int>(v));
  }
  return vertices;
}

std::vector<std::string> ObjTags::put_on(Mesh& mesh) const {
  std::vector<std::string> warnings;
  const std::vector<MeshEdge> edges = creases_.empty() ? std::vector<MeshEdge>() : mesh_edges(mesh);
  for (const Tag& tag : creases_) {
    const std::vector<int> vertices = vertices_of(tag, mesh);
    for (std::size_t k = 0; 2 * k < vertices.size(); ++k) {
      const int a = vertices[2 * k], b = vertices[2 * k + 1];
      if (is_edge(edges, a, b)) {
        mesh.creases.push_back({a, b, tag.sharpness[std::min(k, tag.sharpness.size() - 1)]});
      } else {
        warnings.push_back(fmt::format("{}:{}: vertices {} and {} have no edge to crease (tags count from 0)",
                                       name_, tag.line, a, b));
      }
    }
  }
  for (const Tag& tag : corners_) {
    const std::vector<int> vertices = vertices_of(tag, mesh);
    for (std::size_t k = 0; k < vertices.size(); ++k)
      mesh.sharp_vertices.push_back({vertices[k], tag.sharpness[std::min(k, tag.sharpness.size() - 1)]});
  }
  return warnings;
}

}  // namespace flexkey
