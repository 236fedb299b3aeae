#include "flexkey/timeline/read_cache_output.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "flexkey/timeline/frame_pattern.h"
#include "flexkey/timeline/read_path.h"

namespace flexkey {
namespace {

using Form = CacheOutput::Form;

struct Ending {
  std::string_view text;  // in small letters
  Form form;
};

/// A key of `output` and the files that it may name.
struct CacheKey {
  std::string_view name;
  std::span<const Ending> endings;
};

constexpr Ending cache_endings[] = {{".pc2", Form::pc2}, {".mdd", Form::mdd}};
constexpr Ending frame_endings[] = {{".obj", Form::obj}, {".npz", Form::npz}};
constexpr Ending usd_endings[] = {{".usda", Form::usda}};
constexpr CacheKey cache_keys[] = {{"cache", cache_endings}, {"frames", frame_endings}, {"usd", usd_endings}};

std::string endings_text(const CacheKey& key) {
  std::string text;
  for (const Ending& ending : key.endings)
    text += fmt::format("{}'{}'", text.empty() ? "" : " or ", ending.text);
  return text;
}

std::optional<Form> form_of(const std::string& path, const CacheKey& key) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  for (const Ending& ending : key.endings)
    if (extension == ending.text) return ending.form;
  return std::nullopt;
}

/// What is wrong with the path of a sequence, or nothing.
std::string fault_of_pattern(const std::string& path) {
  const std::optional<int> numbers = count_frame_numbers(path);
  if (!numbers)
    return fmt::format(
        "'{}' has a '%' that is no '%d' or '%04d', the frame's number, nor '%%', a percent sign", path);
  if (*numbers == 1) return {};
  return fmt::format("'{}' names the frame's number {}; write '%04d' into it, once", path,
                     *numbers == 0 ? "nowhere" : "more than once");
}

std::optional<CacheOutput> read_one(const Node& node, const CacheKey& key, Scope& scope) {
  const std::string place = fmt::format("'{}'", key.name);
  const Node* source = &node;
  if (node.kind == Node::Kind::map) {
    const std::optional<Fields> fields = read_fields(node, file_keys, place, scope.findings);
    source = require(*fields, "path", node.where, place, scope.findings);
    if (source == nullptr) return std::nullopt;
  }
  const std::optional<std::string> path = read_path(*source, place, scope);
  if (!path) return std::nullopt;
  const std::optional<Form> form = form_of(*path, key);
  if (!form) {
    scope.findings.error(source->where, fmt::format("{} names a file that ends in {}, not '{}'", place,
                                                    endings_text(key), *path));
    return std::nullopt;
  }
  CacheOutput output{*form, *path, source->where};
  if (const std::string fault = output.is_sequence() ? fault_of_pattern(*path) : ""; !fault.empty())
    scope.findings.error(source->where, fault);
  return output;
}

}  // namespace

std::vector<CacheOutput> read_cache_outputs(const Fields& output, Scope& scope) {
  std::vector<CacheOutput> outputs;
  for (const CacheKey& key : cache_keys) {
    const Node* node = output.value(key.name);
    if (node == nullptr) continue;
    const std::span<const Node> items =
        node->kind == Node::Kind::list ? std::span(node->items) : std::span(node, 1);
    for (const Node& item : items)
      if (std::optional<CacheOutput> one = read_one(item, key, scope)) outputs.push_back(std::move(*one));
  }
  return outputs;
}

}  // namespace flexkey
