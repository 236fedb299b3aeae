#include "flexkey/gltf/fill_gaps.h"

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>
#include <vector>

namespace flexkey {
namespace {

using nlohmann::json;
using Numbers = std::set<std::size_t>;
using Visit = std::function<void(json& number)>;

/// Visits each item of a list of `owner`, which may not be there.
void each(json& owner, const char* list, const Visit& visit) {
  if (owner.contains(list))
    for (json& item : owner[list]) visit(item);
}

void member(json& owner, const char* key, const Visit& visit) {
  if (owner.contains(key)) visit(owner[key]);
}

/// The places that name accessors, and below those that name buffer views: glTF 2.0, sections 5.
void visit_accessors(json& root, const Visit& visit) {
  each(root, "meshes", [&](json& mesh) {
    each(mesh, "primitives", [&](json& primitive) {
      each(primitive, "attributes", visit);
      member(primitive, "indices", visit);
      each(primitive, "targets", [&](json& target) {
        for (json& number : target) visit(number);
      });
    });
  });
  each(root, "skins", [&](json& skin) { member(skin, "inverseBindMatrices", visit); });
  each(root, "animations", [&](json& animation) {
    each(animation, "samplers", [&](json& sampler) {
      member(sampler, "input", visit);
      member(sampler, "output", visit);
    });
  });
}

void visit_views(json& root, const Visit& visit) {
  each(root, "accessors", [&](json& accessor) {
    member(accessor, "bufferView", visit);
    member(accessor, "sparse", [&](json& sparse) {
      member(sparse["indices"], "bufferView", visit);
      member(sparse["values"], "bufferView", visit);
    });
  });
  each(root, "images", [&](json& image) { member(image, "bufferView", visit); });
}

using VisitAll = void (*)(json& root, const Visit& visit);

Numbers numbers_of(json& root, VisitAll visit_all) {
  Numbers numbers;
  visit_all(root, [&](json& number) { numbers.insert(number.get<std::size_t>()); });
  return numbers;
}

/// Every whole number in what extensions say: it may be a place in any list.
void collect_from_extensions(const json& value, bool is_inside, Numbers& numbers) {
  if (is_inside && value.is_number_unsigned()) numbers.insert(value.get<std::size_t>());
  if (!value.is_structured()) return;
  for (const auto& [key, item] : value.items())
    collect_from_extensions(item, is_inside || key == "extensions", numbers);
}

void fill(const char* list, VisitAll visit_all, json& before, json& after) {
  const Numbers was_used = numbers_of(before, visit_all), is_used = numbers_of(after, visit_all);
  Numbers kept;
  collect_from_extensions(before, false, kept);
  const std::size_t first_new = before.contains(list) ? before[list].size() : 0;
  json& things = after[list];
  std::map<std::size_t, std::size_t> moves;
  for (const std::size_t gap : was_used) {
    const std::size_t last = things.size() - 1;
    if (is_used.count(gap) > 0 || kept.count(gap) > 0) continue;
    if (last < first_new) break;
    things[gap] = std::move(things[last]);
    things.erase(last);
    moves[last] = gap;
  }
  visit_all(after, [&](json& number) {
    const auto moved = moves.find(number.get<std::size_t>());
    if (moved != moves.end()) number = moved->second;
  });
}

}  // namespace

std::string fill_gaps(const std::string& before, const std::string& after) {
  json was = json::parse(before), is = json::parse(after);
  fill("accessors", visit_accessors, was, is);
  fill("bufferViews", visit_views, was, is);
  return is.dump();
}

}  // namespace flexkey
