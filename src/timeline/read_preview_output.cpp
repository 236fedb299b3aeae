#include "flexkey/timeline/read_preview_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

#include "flexkey/mesh/limits.h"
#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/parse.h"
#include "flexkey/timeline/read_frame_ranges.h"
#include "flexkey/timeline/read_path.h"
#include "flexkey/timeline/read_preview_camera.h"
#include "flexkey/timeline/scalar.h"
#include "flexkey/timeline/steps.h"
#include "flexkey/timeline/words.h"

namespace flexkey {
namespace {

using Format = PreviewOutput::Format;
using Quality = PreviewOutput::Quality;
using Style = PreviewOutput::Style;

constexpr int longest_webp_side = 16'383;
constexpr int most_samples = 4096;
constexpr int highest_level = 4;
constexpr int most_turns = 1000;
constexpr std::string_view default_preview_dir = "<shot>/";

/// Bounds of a whole number, both included.
struct WholeRange {
  int low = 0, high = 0;
};

std::optional<int> read_whole_in(const Node& node, std::string_view what, const WholeRange& range,
                                 Scope& scope) {
  const std::optional<int> value = read_whole(node, scope);
  if (!value || (*value >= range.low && *value <= range.high)) return value;
  scope.findings.error(node.where,
                       fmt::format("{} {} is outside {}..{}", what, node.text, range.low, range.high));
  return std::nullopt;
}

void read_size(const Node& node, PreviewOutput& output, Scope& scope) {
  if (node.kind != Node::Kind::list || node.items.size() != 2) {
    scope.findings.error(
        node.where,
        fmt::format("size is [width, height] in pixels, such as [960, 540], not {}", describe(node)));
    return;
  }
  const WholeRange side{1, limits::picture_side};
  const std::optional<int> width = read_whole_in(node.items[0], "width", side, scope);
  const std::optional<int> height = read_whole_in(node.items[1], "height", side, scope);
  if (!width || !height) return;
  output.width = *width;
  output.height = *height;
  if (std::int64_t{*width} * *height > limits::drawn_pixels)
    scope.findings.error(node.where,
                         fmt::format("a picture of {} x {} pixels is too large: at most {} million", *width,
                                     *height, limits::drawn_pixels / 1'000'000));
}

PreviewOutput::Handles read_handles_shown(const Node& node, Scope& scope) {
  using Handles = PreviewOutput::Handles;
  if (node.kind == Node::Kind::scalar && node.text == "borders") return Handles::borders;
  return read_switch(node, scope).value_or(false) ? Handles::all : Handles::none;
}

std::optional<Style> read_style(const Node& node, Scope& scope) {
  return read_word<Style>(node, "style",
                          {{"clay", Style::clay},
                           {"normals", Style::normals},
                           {"displacement", Style::displacement},
                           {"lambda", Style::lambda},
                           {"error", Style::error},
                           {"wire", Style::wire},
                           {"textured", Style::textured}},
                          scope);
}

std::optional<Format> read_format(const Node& node, Scope& scope) {
  return read_word<Format>(node, "format",
                           {{"png", Format::png},
                            {"exr", Format::exr},
                            {"webp", Format::webp},
                            {"jpg", Format::jpg},
                            {"jpeg", Format::jpg}},
                           scope);
}

std::optional<double> read_turns(const Node& node, Scope& scope) {
  const std::optional<double> turns = read_number(node, scope);
  if (!turns || (*turns >= -most_turns && *turns <= most_turns)) return turns;
  scope.findings.error(node.where, fmt::format("turntable {} is outside {}..{} turns over the clip",
                                               node.text, -most_turns, most_turns));
  return std::nullopt;
}

/// The path of a file with one of these endings, or nothing and an error.
std::optional<std::string> read_file_path(const Node& node, std::string_view place,
                                          std::span<const std::string_view> endings, Scope& scope) {
  const std::optional<std::string> path = read_path(node, place, scope);
  if (!path) return std::nullopt;
  std::string ending = std::filesystem::path(*path).extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  for (const std::string_view known : endings)
    if (ending == known) return path;
  scope.findings.error(node.where, fmt::format("{} names a file that ends in '{}', not '{}'", place,
                                               fmt::join(endings, "' or '"), *path));
  return std::nullopt;
}

GifOutput read_gif(const Node& node, Scope& scope) {
  static constexpr std::string_view endings[] = {".gif"};
  GifOutput gif;
  gif.where = node.where;
  if (node.kind != Node::Kind::map) {
    gif.path = read_file_path(node, "'gif'", endings, scope).value_or("");
    return gif;
  }
  const std::optional<Fields> fields = read_fields(node, gif_keys, "'gif'", scope.findings);
  if (const Node* path = require(*fields, "path", node.where, "'gif'", scope.findings)) {
    gif.path = read_file_path(*path, "'path' in 'gif'", endings, scope).value_or("");
    gif.where = path->where;
  }
  if (const Node* width = fields->value("width"))
    gif.width = read_whole_in(*width, "width", {1, limits::picture_side}, scope);
  return gif;
}

std::vector<MarkedTime> read_times_at(const Node& node, Scope& scope) {
  std::vector<MarkedTime> times;
  const std::span<const Node> items =
      node.kind == Node::Kind::list ? std::span(node.items) : std::span(&node, 1);
  for (const Node& item : items)
    if (const std::optional<double> time = read_time(item, scope)) times.push_back({*time, item.where});
  return times;
}

SheetOutput read_sheet(const Node& node, Scope& scope) {
  static constexpr std::string_view endings[] = {".png", ".exr", ".webp", ".jpg", ".jpeg"};
  SheetOutput sheet{"<shot>.png", node.where, {}, {}};
  if (node.kind != Node::Kind::map) {
    sheet.path = read_file_path(node, "'contact_sheet'", endings, scope).value_or("");
    return sheet;
  }
  const std::optional<Fields> fields = read_fields(node, sheet_keys, "'contact_sheet'", scope.findings);
  if (const Node* path = fields->value("path")) {
    sheet.path = read_file_path(*path, "'path' in 'contact_sheet'", endings, scope).value_or("");
    sheet.where = path->where;
  }
  if (const Node* at = fields->value("at")) sheet.at = read_times_at(*at, scope);
  if (const Node* width = fields->value("width"))
    sheet.width = read_whole_in(*width, "width", {1, limits::picture_side}, scope);
  return sheet;
}

/// How a picture is drawn.
void read_looks(const Fields& fields, PreviewOutput& output, Scope& scope) {
  if (const Node* value = fields.value("size")) read_size(*value, output, scope);
  if (const Node* value = fields.value("samples"))
    output.samples = read_whole_in(*value, "samples", {1, most_samples}, scope).value_or(output.samples);
  if (const Node* value = fields.value("subdivide"))
    output.subdivide =
        read_whole_in(*value, "subdivide", {0, highest_level}, scope).value_or(output.subdivide);
  if (const Node* value = fields.value("style"))
    output.style = read_style(*value, scope).value_or(output.style);
  if (const Node* value = fields.value("quality"))
    output.quality =
        read_word<Quality>(*value, "quality", {{"draft", Quality::draft}, {"final", Quality::final}}, scope)
            .value_or(output.quality);
  if (const Node* value = fields.value("camera")) output.camera = read_preview_camera(*value, scope);
  if (const Node* value = fields.value("turntable"))
    output.turntable = read_turns(*value, scope).value_or(output.turntable);
  if (const Node* value = fields.value("handles")) output.handles = read_handles_shown(*value, scope);
  if (const Node* value = fields.value("overlay"))
    output.overlay = read_switch(*value, scope).value_or(output.overlay);
}

/// Which files are made of the pictures.
void read_files(const Fields& fields, PreviewOutput& output, Scope& scope) {
  if (const Node* value = fields.value("dir")) {
    output.dir = read_path(*value, "'dir' in 'preview'", scope).value_or("");
    output.where = value->where;
  }
  if (const Node* value = fields.value("frames")) output.frames = read_frame_ranges(*value, scope);
  if (const Node* value = fields.value("format"))
    output.format = read_format(*value, scope).value_or(output.format);
  if (const Node* value = fields.value("gif")) output.gif = read_gif(*value, scope);
  if (const Node* value = fields.value("contact_sheet")) output.sheet = read_sheet(*value, scope);
}

}  // namespace

PreviewOutput read_preview_output(const Node& node, Scope& scope) {
  PreviewOutput output;
  output.dir = default_preview_dir;
  output.where = node.where;
  if (node.kind != Node::Kind::map) {
    output.dir = read_path(node, "'preview'", scope).value_or("");
    return output;
  }
  const std::optional<Fields> fields = read_fields(node, preview_keys, "'preview'", scope.findings);
  read_looks(*fields, output, scope);
  read_files(*fields, output, scope);
  if (output.format == Format::webp && std::max(output.width, output.height) > longest_webp_side)
    scope.findings.error(fields->value("format")->where,
                         fmt::format("a WebP has at most {} pixels a side", longest_webp_side));
  return output;
}

std::string preview_folder(const Shot& shot) {
  constexpr std::size_t most_keys = 3;
  std::string keys;
  std::size_t varied = 0;
  for (const SweptValue& value : shot.swept) {
    if (!value.varies) continue;
    keys += fmt::format("_<{}>", value.key);
    ++varied;
  }
  if (varied == 0) return std::string(default_preview_dir);
  return fmt::format("<shot>{}/", varied > most_keys ? "_<run>" : keys);
}

void complete_preview(Shot& shot, Findings& findings) {
  PreviewOutput& preview = shot.preview;
  if (preview.dir == default_preview_dir) preview.dir = preview_folder(shot);
  if (!preview.camera.up) preview.camera.up = shot.mesh.up;
  const int last = shot.frame_count() - 1;
  for (FrameRange& range : preview.frames) {
    if (range.last <= last) continue;
    findings.warning(range.where, fmt::format("frame {} is past the shot's last frame, {}, and is left out",
                                              range.last, last));
    range.last = last;
  }
  const bool had_frames = !preview.frames.empty();
  const Mark where = had_frames ? preview.frames.front().where : Mark{};
  std::erase_if(preview.frames, [](const FrameRange& range) { return range.first > range.last; });
  if (had_frames && preview.frames.empty())
    findings.error(where, fmt::format("no frame of these is within the shot, whose last frame is {}", last));
  std::erase_if(preview.sheet.at, [&](const MarkedTime& moment) {
    if (moment.time <= played_duration(shot) + 1e-6) return false;
    findings.warning(moment.where, fmt::format("{:g}s is past the shot's end, {:g}s, and is left out",
                                               moment.time, played_duration(shot)));
    return true;
  });
}

}  // namespace flexkey
