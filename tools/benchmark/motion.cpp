#include "motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <utility>

#include "blob.h"
#include "flexkey/animate/handle_states.h"
#include "flexkey/animate/scene.h"
#include "flexkey/mesh/read_mesh.h"
#include "flexkey/timeline/parse.h"

namespace flexkey::bench {
namespace {

constexpr double quarter_turn = std::numbers::pi / 2;

/// The rigid motion of the moved end away from rest when it has gone a share (0..1) of its way.
using Path = std::function<Eigen::Isometry3d(double share)>;

/// A mesh with a held and a moved end.
struct Ends {
  Mesh mesh;
  std::vector<int> held, moved;
};

Vec3 centre_of(const Mesh& mesh, const std::vector<int>& vertices) {
  return mesh.positions(vertices, Eigen::all).colwise().mean().transpose();
}

Constraints constraints_of(const Ends& ends) {
  Constraints constraints;
  constraints.handles = ends.held;
  constraints.handles.insert(constraints.handles.end(), ends.moved.begin(), ends.moved.end());
  constraints.owner.assign(ends.held.size(), 0);
  constraints.owner.insert(constraints.owner.end(), ends.moved.size(), 1);
  return constraints;
}

Targets targets_on(const Ends& ends, const Constraints& constraints, const Eigen::Isometry3d& before,
                   const Eigen::Isometry3d& now) {
  Positions where = ends.mesh.positions(constraints.handles, Eigen::all);
  auto moved = where.bottomRows(static_cast<Eigen::Index>(ends.moved.size()));
  moved = ((moved * now.linear().transpose()).rowwise() + now.translation().transpose()).eval();
  const Eigen::AngleAxisd turn(now.linear() * before.linear().transpose());
  Positions turns = Positions::Zero(2, 3);
  turns.row(1) = (turn.angle() * turn.axis()).transpose();
  return {std::move(where), std::move(turns)};
}

Motion along(const std::string& name, const Ends& ends, int frame_count, const Path& path) {
  Motion motion{name, ends.mesh, constraints_of(ends), {}};
  for (int frame = 1; frame <= frame_count; ++frame) {
    const double before = static_cast<double>(frame - 1) / frame_count;
    const double now = static_cast<double>(frame) / frame_count;
    motion.frames.push_back(targets_on(ends, motion.constraints, path(before), path(now)));
  }
  return motion;
}

/// A turn about a point.
Eigen::Isometry3d turned(double angle, const Vec3& axis, const Vec3& about) {
  return Eigen::Translation3d(about) * Eigen::AngleAxisd(angle, axis) * Eigen::Translation3d(-about);
}

/// The end at `tip` of a rod that stands along z, when the rod is bent about x into an arc of that angle and
/// length.
Eigen::Isometry3d bent(double angle, double length, double rest_length, const Vec3& tip) {
  const double radius = angle > 0 ? length / angle : 0;
  const Vec3 end =
      angle > 0 ? Vec3(0, -radius * (1 - std::cos(angle)), radius * std::sin(angle)) : Vec3(0, 0, length);
  return Eigen::Translation3d(end - rest_length * Vec3::UnitZ()) * turned(angle, Vec3::UnitX(), tip);
}

constexpr double bar_length = 4;

Ends bar_ends(const std::filesystem::path& bar) {
  Ends ends{read_mesh(bar).mesh, {}, {}};
  for (int v = 0; v < ends.mesh.vertex_count(); ++v) {
    const double z = ends.mesh.positions(v, 2);
    if (z == 0) ends.held.push_back(v);
    if (z == bar_length) ends.moved.push_back(v);
  }
  return ends;
}

Ends blob_ends(int size) {
  Ends ends{make_blob(size), {}, {}};
  std::vector<int> upwards(ends.mesh.vertex_count());
  std::iota(upwards.begin(), upwards.end(), 0);
  std::sort(upwards.begin(), upwards.end(),
            [&](int a, int b) { return ends.mesh.positions(a, 2) < ends.mesh.positions(b, 2); });
  ends.held.assign(upwards.begin(), upwards.begin() + ends.mesh.vertex_count() / 20);
  ends.moved.assign(upwards.end() - ends.mesh.vertex_count() / 100, upwards.end());
  std::sort(ends.held.begin(), ends.held.end());
  std::sort(ends.moved.begin(), ends.moved.end());
  return ends;
}

/// By 90° and 30 % at the end of its way.
Path bent_and_stretched(const Ends& ends) {
  const Vec3 tip = centre_of(ends.mesh, ends.moved);
  const double length = tip.z() - centre_of(ends.mesh, ends.held).z();
  return [=](double s) { return bent(quarter_turn * s, (1 + 0.3 * s) * length, length, tip); };
}

}  // namespace

std::vector<Motion> bar_motions(const std::filesystem::path& bar) {
  constexpr int frames = 12;
  constexpr double length = bar_length;
  const Ends ends = bar_ends(bar);
  const Vec3 tip = centre_of(ends.mesh, ends.moved);
  const Path twist = [&](double s) { return turned(quarter_turn * s, Vec3::UnitZ(), tip); };
  const Path bend = [&](double s) { return bent(quarter_turn * s, length, length, tip); };
  const auto shift = [](const Vec3& by) {
    return [by](double s) { return Eigen::Isometry3d(Eigen::Translation3d(s * by)); };
  };
  return {along("bar, twist", ends, frames, twist), along("bar, bend", ends, frames, bend),
          along("bar, both", ends, frames, [&](double s) { return bend(s) * twist(s); }),
          along("bar, stretch", ends, frames, shift({0, 0, 0.3 * length})),
          along("bar, sideways", ends, frames, shift({0.5 * length, 0, 0}))};
}

Motion blob_motion(int size) {
  const Ends ends = blob_ends(size);
  return along("blob", ends, 60, bent_and_stretched(ends));
}

Motion blob_there_and_back(int size, int frames) {
  const Ends ends = blob_ends(size);
  const Path out = bent_and_stretched(ends);
  const auto eased = [](double s) { return 0.5 - 0.5 * std::cos(2 * std::numbers::pi * s); };
  Motion motion = along("blob", ends, frames - 1, [&](double s) { return out(eased(s)); });
  motion.frames.insert(motion.frames.begin(), targets_on(ends, motion.constraints, out(0), out(0)));
  return motion;
}

Motion shot_motion(const std::filesystem::path& timeline) {
  const Shot shot = parse_shot(read_timeline(timeline), timeline).shot;
  const Mesh mesh = read_mesh(timeline.parent_path() / shot.mesh.file).mesh;
  const Scene scene = bind_shot(shot, mesh);
  Motion motion{shot.name, scene.weld.surface, scene.constraints, {}};
  HandleStates before = rest_states(scene);
  for (int frame = 0; frame < shot.frame_count(); ++frame) {
    const HandleStates now = sample_states(scene, frame / shot.fps);
    const Positions targets = targets_of(scene, now), turns = turns_between(scene, before, now);
    if (turns.rowwise().norm().maxCoeff() > shot.solver.max_step)
      throw Error(shot.name + " turns by more than max_step in a frame");
    if (targets != targets_of(scene, before)) motion.frames.push_back({targets, turns});
    before = now;
  }
  return motion;
}

}  // namespace flexkey::bench
