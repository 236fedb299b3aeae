#include "flexkey/timeline/compose.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <sstream>
#include <string_view>
#include <utility>

#include "flexkey/mesh/limits.h"
#include "flexkey/timeline/syntax_error.h"

namespace flexkey {
namespace {

constexpr std::string_view core_tag = "tag:yaml.org,2002:";
constexpr std::string_view quoted_tag = "!";  // yaml-cpp's tag of a scalar in quotes or in a block
constexpr std::string_view plain_tag = "?";

/// The offset behind anchors and tags that stand before a value.
std::size_t skip_properties(std::string_view text, std::size_t offset) {
  while (offset < text.size() && (text[offset] == '&' || text[offset] == '!')) {
    offset = std::min(text.find_first_of(" \n\t", offset), text.size());
    offset = std::min(text.find_first_not_of(" \n\t", offset), text.size());
  }
  return offset;
}

/// Whether the quote that opens at `offset` has its closing one; yaml-cpp reads on to the end of the file
/// without it.
bool quote_is_closed(std::string_view text, std::size_t offset) {
  const char quote = text[offset];
  for (std::size_t i = offset + 1; i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\') {
      ++i;
    } else if (text[i] == quote) {
      const bool doubled = quote == '\'' && i + 1 < text.size() && text[i + 1] == quote;
      if (!doubled) return true;
      ++i;
    }
  }
  return false;
}

/// Builds the tree from yaml-cpp's events, and stops it before a hostile text grows beyond the bounds.
class Composer : public YAML::EventHandler {
 public:
  explicit Composer(const SourceText& source) : source_(source) {}

  WrittenNode take_root() { return std::move(root_); }
  /// Where the innermost open list or mapping began; line 0 if none is open.
  Mark innermost_open() const { return open_.empty() ? Mark{} : open_.back().where; }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (!finished_) return;
    const auto offset = static_cast<std::size_t>(mark.pos);
    const bool announced = std::string_view(source_.text()).substr(offset).starts_with("---");
    throw YamlError(source_.mark_at(offset), announced
                                                 ? "a timeline is one document; a second one starts here"
                                                 : "this belongs to no key; check its indentation");
  }
  void OnDocumentEnd() override { finished_ = true; }

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    WrittenNode node = start(WrittenNode::Kind::null, mark, anchor);
    node.bare = is_bare(mark);
    add(std::move(node));
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    WrittenNode node = start(WrittenNode::Kind::alias, mark, anchor);
    const bool inside_itself = std::any_of(open_.begin(), open_.end(),
                                           [&](const WrittenNode& open) { return open.anchor == anchor; });
    if (inside_itself) throw YamlError(node.where, "this alias stands inside the value that it names");
    add(std::move(node));
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    WrittenNode node = start(WrittenNode::Kind::scalar, mark, anchor);
    check_tag(tag, node.where);
    check_quote(mark);
    node.plain = tag != quoted_tag;
    node.text = value;
    add(std::move(node));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(WrittenNode::Kind::list, mark, tag, anchor);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(WrittenNode::Kind::map, mark, tag, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapEnd() override { close(); }

 private:
  WrittenNode start(WrittenNode::Kind kind, const YAML::Mark& mark, YAML::anchor_t anchor) {
    WrittenNode node;
    node.kind = kind;
    node.anchor = anchor;
    node.where = source_.mark_at(static_cast<std::size_t>(mark.pos));
    if (++count_ > limits::timeline_values) {
      throw YamlError(node.where,
                      fmt::format("the timeline has more than {} values", limits::timeline_values));
    }
    return node;
  }

  void open(WrittenNode::Kind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
    WrittenNode node = start(kind, mark, anchor);
    check_tag(tag, node.where);
    if (open_.size() >= static_cast<std::size_t>(limits::timeline_depth)) {
      throw YamlError(node.where, fmt::format("values are nested more than {} deep", limits::timeline_depth));
    }
    open_.push_back(std::move(node));
  }

  void close() {
    WrittenNode node = std::move(open_.back());
    open_.pop_back();
    add(std::move(node));
  }

  void add(WrittenNode node) {
    if (open_.empty()) {
      root_ = std::move(node);
    } else {
      open_.back().children.push_back(std::move(node));
    }
  }

  /// A key alone in { }: yaml-cpp puts the missing value at the ',' or '}' behind the key.
  bool is_bare(const YAML::Mark& mark) const {
    const bool is_value = !open_.empty() && open_.back().kind == WrittenNode::Kind::map &&
                          open_.back().children.size() % 2 == 1;
    const auto end = static_cast<std::size_t>(mark.pos);
    const std::string& text = source_.text();
    if (!is_value || end == 0 || end >= text.size() || (text[end] != ',' && text[end] != '}')) return false;
    const std::size_t before = text.find_last_not_of(" \n\t", end - 1);
    return before != std::string::npos && text[before] != ':';
  }

  void check_tag(const std::string& tag, Mark where) const {
    if (tag.empty() || tag == quoted_tag || tag == plain_tag || tag.starts_with(core_tag)) return;
    throw YamlError(where, fmt::format("the tag '{}' has no meaning in a timeline", tag));
  }

  void check_quote(const YAML::Mark& mark) const {
    const std::string& text = source_.text();
    const std::size_t offset = skip_properties(text, static_cast<std::size_t>(mark.pos));
    if (offset >= text.size() || (text[offset] != '"' && text[offset] != '\'')) return;
    if (!quote_is_closed(text, offset))
      throw YamlError(source_.mark_at(offset), "this quote is never closed");
  }

  const SourceText& source_;
  std::vector<WrittenNode> open_;
  WrittenNode root_;
  std::size_t count_ = 0;
  bool finished_ = false;
};

}  // namespace

WrittenNode compose(const SourceText& source) {
  std::istringstream stream(source.text());
  Composer composer(source);
  try {
    YAML::Parser parser(stream);
    parser.HandleNextDocument(composer);
    WrittenNode root = composer.take_root();
    parser.HandleNextDocument(composer);
    return root;
  } catch (const YAML::Exception& error) {
    const std::size_t offset = error.mark.is_null() ? 0 : static_cast<std::size_t>(error.mark.pos);
    throw syntax_error(source, offset, error.msg, composer.innermost_open());
  }
}

}  // namespace flexkey
