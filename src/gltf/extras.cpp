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

/// The frames of the shot by their numbers, and λ at each.
void describe_frames(const Clip& clip, Value::Object& extras) {
  Value::Array lambdas, frames;
  for (const FrameReport& report : clip.reports) {
    lambdas.emplace_back(report.lambda);
    frames.emplace_back(report.frame);
  }
  extras["fps"] = Value(clip.fps);
  extras["frames"] = Value(static_cast<int>(clip.frames.size()));
  extras["sourceFrames"] = Value(frames);
  extras["lambda"] = Value(lambdas);
}

void describe_error(const PlaybackError& error, Value::Object& extras) {
  extras["error"] = Value(error.largest);
  extras["kgError"] = Value(error.kg);
  if (!error.has_normals) return;
  extras["normalErrorMean"] = Value(error.normal_mean);
  extras["normalErrorLargest"] = Value(error.normal_largest);
}

/// The frames at which weights are given; some lie between two.
Value::Array key_frames(const Basis& basis) {
  Value::Array frames;
  for (const double key : basis.keys) frames.emplace_back(key);
  return frames;
}

}  // namespace

void describe(tinygltf::Model& model, const Clip& clip, const Basis& basis, const GltfOptions& options,
              const PlaybackError& error) {
  model.asset.version = "2.0";
  model.asset.generator = "flexkey " FLEXKEY_VERSION;
  Value::Object extras;
  extras["profile"] = Value(profile_name(options));
  if (options.basis != BasisKind::frames) extras["tolerance"] = Value(options.tolerance);
  describe_frames(clip, extras);
  extras["keyFrames"] = Value(key_frames(basis));
  extras["hash"] = Value(valid_utf8(options.hash));
  describe_error(error, extras);
  for (tinygltf::Animation& animation : model.animations) animation.extras = Value(extras);
  Value::Array names;
  for (const std::string& name : basis.names) names.emplace_back(name);
  extras["targetNames"] = Value(names);
  model.meshes[0].extras = Value(extras);
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
