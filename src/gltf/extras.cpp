#include "flexkey/gltf/extras.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>

#include "flexkey/gltf/utf8.h"

namespace flexkey {
namespace {

using tinygltf::Value;

/// [first, count, …] of the triangles whose faces are in the group.
Value::Array triangle_runs(const Group& group, const Primitive& primitive) {
  const std::vector<int>& faces = primitive.faces;
  Value::Array runs;
  auto run_begin = faces.begin(), run_end = faces.begin();
  const auto close_run = [&] {
    if (run_begin == run_end) return;
    runs.emplace_back(static_cast<int>(run_begin - faces.begin()));
    runs.emplace_back(static_cast<int>(run_end - run_begin));
  };
  for (const int face : group.faces) {
    const auto [first, last] = std::equal_range(run_end, faces.end(), face);
    if (first != run_end) {
      close_run();
      run_begin = first;
    }
    run_end = last;
  }
  close_run();
  return runs;
}

}  // namespace

std::string target_name(int frame) {
  return fmt::format("f{:04}", frame);
}

Value describe_clip(const Clip& clip, const std::string& hash, const PlaybackError& error) {
  Value::Array lambdas, frames;
  for (const FrameReport& report : clip.reports) {
    lambdas.emplace_back(report.lambda);
    frames.emplace_back(report.frame);
  }
  Value::Object extras;
  extras["profile"] = Value(std::string("exact"));
  extras["fps"] = Value(clip.fps);
  extras["frames"] = Value(static_cast<int>(clip.frames.size()));
  extras["sourceFrames"] = Value(frames);
  extras["lambda"] = Value(lambdas);
  extras["hash"] = Value(valid_utf8(hash));
  extras["error"] = Value(error.largest);
  extras["kgError"] = Value(error.kg);
  if (error.has_normals) {
    extras["normalErrorMean"] = Value(error.normal_mean);
    extras["normalErrorLargest"] = Value(error.normal_largest);
  }
  return Value(extras);
}

Value describe_groups(const Mesh& mesh, const Primitive& primitive) {
  Value::Array groups;
  for (const Group& group : mesh.groups) {
    Value::Array runs = triangle_runs(group, primitive);
    if (runs.empty()) continue;
    groups.emplace_back(Value::Object{{"name", Value(valid_utf8(group.name))}, {"triangles", Value(runs)}});
  }
  return groups.empty() ? Value() : Value(Value::Object{{"groups", Value(groups)}});
}

}  // namespace flexkey
