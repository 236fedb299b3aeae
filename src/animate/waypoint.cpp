#include "flexkey/animate/waypoint.h"

#include <algorithm>

#include "flexkey/animate/members.h"

namespace flexkey {

template <MaybeConst<Passage> Self>
auto members_of(Self& passage) {
  auto& [active, deformer, pose, before] = passage;  // the deformer follows from what is active
  return std::tie(active, pose, before);
}

template <MaybeConst<Waypoint> Self>
auto members_of(Self& waypoint) {
  auto& [next, passage, without_fading] = waypoint;
  return std::tie(next, passage, without_fading);
}

namespace {

void require(bool holds) {
  if (!holds) throw ArchiveError("the archive is not of this scene");
}

void bind_to(const Scene& scene, DeformerCache& cache, Passage& passage) {
  const ActiveSet& active = passage.active;
  const int count = static_cast<int>(scene.handles.size());
  require(std::is_sorted(active.begin(), active.end(), std::less_equal<>()) &&
          (active.empty() || (active.front() >= 0 && active.back() < count)));
  require(passage.before.motions.size() == scene.handles.size() &&
          passage.before.curves.size() == scene.handles.size());
  for (std::size_t h = 0; h < scene.handles.size(); ++h) {
    const Eigen::Index rows = passage.before.curves[h].rows();
    const bool may_have_none = scene.handles[h].handle.curve.empty();
    require((may_have_none && rows == 0) || rows == scene.handles[h].rest.rows());
  }
  passage.deformer = cache.of(active);
  require(passage.deformer->could_have_solved(passage.pose));
}

}  // namespace

Waypoint first_waypoint(const Scene& scene, DeformerCache& cache) {
  return {0, start_of(scene, cache), std::nullopt};
}

void save(const Waypoint& waypoint, Saving& saving) {
  saving(waypoint);
}

Waypoint load_waypoint(std::span<const std::byte> bytes, const Scene& scene, DeformerCache& cache) {
  Waypoint waypoint;
  Loading loading(bytes);
  loading(waypoint);
  require(loading.rest().empty());
  bind_to(scene, cache, waypoint.passage);
  if (waypoint.without_fading) bind_to(scene, cache, *waypoint.without_fading);
  return waypoint;
}

}  // namespace flexkey
