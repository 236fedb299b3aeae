#include "cli/starter.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "cli/principal_axes.h"
#include "cli/yaml_text.h"
#include "flexkey/mesh/connectivity.h"
#include "flexkey/mesh/error.h"
#include "flexkey/mesh/geodesic.h"
#include "flexkey/mesh/select.h"

namespace flexkey::cli {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double slab = 0.05;  // of an end, a share of the extent

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

template <class Kind>
Selection selection(Kind kind) {
  Selection result;
  result.kind = std::move(kind);
  return result;
}

/// The component with the most vertices: what is held and led. The others ride on it.
struct Body {
  int number = 0;
  bool is_all = true;
  std::vector<bool> has;  // #V
};

Body body_of(const Mesh& surface) {
  const Components components = find_components(surface);
  if (components.count == 0) throw InputError("the mesh has no faces: there is nothing to animate");
  std::vector<int> sizes(index(components.count), 0);
  for (const int component : components.of_vertex)
    if (component >= 0) ++sizes[index(component)];
  Body body;
  body.number = static_cast<int>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  body.is_all = components.count == 1;
  for (const int component : components.of_vertex) body.has.push_back(component == body.number);
  return body;
}

/// A proposal in the making.
class Search {
 public:
  Search(const Weld& weld, const std::string& mesh_name)
      : surface_(weld.surface),
        selector_(weld, mesh_name),
        bounds_(bounds_of(surface_.positions)),
        body_(body_of(surface_)),
        shape_(principal_axes(surface_, body_.has)),
        size_(shape_.extents.norm()),
        is_taken_(index(surface_.vertex_count()), false) {}

  Starter propose() {
    Starter starter;
    starter.base = find_base();
    take(starter.base);
    for (const int end : ends())
      if (distance_[index(end)] >= 0.4 * reach_) lead(starter, end);
    if (starter.tips.empty()) lead(starter, farthest());
    if (starter.tips.empty()) throw InputError("the mesh has too few vertices to hold some and move others");
    return starter;
  }

 private:
  Vec3 down() const;
  StarterPart find_base() const;
  StarterPart slab_at(const Vec3& direction, const std::string& name) const;
  std::optional<StarterPart> group_with(int vertex) const;
  StarterPart ball_around(int vertex, const std::string& name) const;
  std::optional<StarterPart> part_at(int end, std::size_t number) const;
  StarterTip swing_of(StarterPart part, const StarterPart& base, std::size_t number) const;
  Vec3 swing_towards(const Vec3& arm) const;

  void lead(Starter& starter, int end);
  std::vector<int> ends() const;
  int farthest() const;
  int extreme(const Vec3& direction) const;
  Vec3 middle_of(const std::vector<int>& vertices) const;
  bool is_free(const std::vector<int>& vertices) const;
  void take(const StarterPart& part);

  const Mesh& surface_;
  Selector selector_;
  Bounds bounds_;
  Body body_;
  PrincipalAxes shape_;
  double size_;                   // of the body, mesh units
  std::vector<bool> is_taken_;    // #V, is in a part
  std::vector<int> taken_;        // those
  std::vector<double> distance_;  // #V, from the parts along the surface; infinite off the body
  double reach_ = 0;              // of the base, the largest distance
};

/// The vertex of the body in the middle of its end that way: of a head with two ears the top between them.
int Search::extreme(const Vec3& direction) const {
  const Eigen::VectorXd along = surface_.positions * direction;
  double low = infinite, high = -infinite;
  for (int v = 0; v < surface_.vertex_count(); ++v) {
    if (!body_.has[index(v)]) continue;
    low = std::min(low, along[v]);
    high = std::max(high, along[v]);
  }
  std::vector<int> end;
  for (int v = 0; v < surface_.vertex_count(); ++v)
    if (body_.has[index(v)] && along[v] >= high - slab * (high - low)) end.push_back(v);
  const Vec3 middle = middle_of(end);
  const auto from_middle = [&](int v) { return (surface_.positions.row(v).transpose() - middle).norm(); };
  return *std::min_element(end.begin(), end.end(),
                           [&](int a, int b) { return from_middle(a) < from_middle(b); });
}

Vec3 Search::middle_of(const std::vector<int>& vertices) const {
  return surface_.positions(vertices, Eigen::all).colwise().mean().transpose();
}

bool Search::is_free(const std::vector<int>& vertices) const {
  return std::all_of(vertices.begin(), vertices.end(),
                     [&](int v) { return body_.has[index(v)] && !is_taken_[index(v)]; });
}

void Search::take(const StarterPart& part) {
  const bool is_base = taken_.empty();
  for (const int v : part.vertices) is_taken_[index(v)] = true;
  taken_.insert(taken_.end(), part.vertices.begin(), part.vertices.end());
  distance_ = geodesic_distances(surface_, taken_, infinite);
  if (!is_base) return;
  for (const double distance : distance_)
    if (std::isfinite(distance)) reach_ = std::max(reach_, distance);
}

/// The body's end in the direction of a coordinate axis.
StarterPart Search::slab_at(const Vec3& direction, const std::string& name) const {
  int axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  SelectAxis select{axis, std::nullopt, std::nullopt};
  (direction[axis] > 0 ? select.above : select.below) = Length{direction[axis] > 0 ? 1 - slab : slab, true};
  Selection whole = selection(select);
  std::string text =
      fmt::format("{{axis: {}, {}: {:g}%}}", "xyz"[axis], direction[axis] > 0 ? "above" : "below",
                  100 * (direction[axis] > 0 ? 1 - slab : slab));
  if (!body_.is_all) {
    whole = selection(SelectAll{{selection(SelectComponent{body_.number}), whole}});
    text = fmt::format("{{all: [{{component: {}}}, {}]}}", body_.number, text);
  }
  StarterPart part{name, text, {}};
  try {
    part.vertices = selector_.select(whole);
  } catch (const SelectionError&) {
    // The body ends short of the other components' end: the part stays empty.
  }
  return part;
}

StarterPart Search::ball_around(int vertex, const std::string& name) const {
  const double room = taken_.empty() ? infinite : distance_[index(vertex)];
  const double share = std::min(0.14 * size_, 0.4 * room) / bounds_.diagonal();
  const Length radius{rounded(share, 100 * share), true};
  const Vec3 point = rounded(surface_.positions.row(vertex), size_);
  return {name, fmt::format("{{geodesic: {{from: {}, radius: {:g}%}}}}", yaml_of(point), 100 * radius.value),
          selector_.select(selection(SelectGeodesic{point, radius}))};
}

/// Where the base is: on the ground, or at the far end of what has a far end.
Vec3 Search::down() const {
  const double height = bounds_.max.y() - bounds_.min.y();
  const bool is_lying = height < 0.25 * (bounds_.max - bounds_.min).maxCoeff();
  if (!shape_.is_long() && !is_lying) return -Vec3::UnitY();
  const Vec3 end = shape_.axes.col(0);
  const bool is_upper = std::abs(end.y()) > 0.3 ? end.y() > 0 : end.sum() > 0;
  return is_upper ? Vec3(-end) : end;
}

StarterPart Search::find_base() const {
  constexpr double aligned = 0.95;
  if (down().cwiseAbs().maxCoeff() > aligned) {
    StarterPart base = slab_at(down(), "base");
    if (!base.vertices.empty()) return base;
  }
  return ball_around(extreme(down()), "base");
}

/// Where tips may be, the likeliest first: across from the base of what is long or flat; else both ends of
/// the principal axes, the upper one first, but for the thinnest, along which little sticks out.
std::vector<int> Search::ends() const {
  if (shape_.is_long() || shape_.is_flat()) return {extreme(-down())};
  std::vector<int> ends;
  for (int k = 0; k < 2; ++k) {
    Vec3 direction = shape_.axes.col(k);
    if (direction.y() < 0 || (direction.y() == 0 && direction.sum() < 0)) direction = -direction;
    ends.push_back(extreme(direction));
    ends.push_back(extreme(-direction));
  }
  return ends;
}

/// The vertex of the body farthest from the parts along the surface.
int Search::farthest() const {
  int best = taken_.front();
  for (int v = 0; v < surface_.vertex_count(); ++v)
    if (std::isfinite(distance_[index(v)]) && distance_[index(v)] > distance_[index(best)]) best = v;
  return best;
}

/// Adds a tip at a vertex, where there is room for one.
void Search::lead(Starter& starter, int end) {
  std::optional<StarterPart> part = part_at(end, starter.tips.size());
  if (!part) return;
  take(*part);
  starter.tips.push_back(swing_of(std::move(*part), starter.base, starter.tips.size()));
}

/// A group of moderate size, none of it in another part.
std::optional<StarterPart> Search::group_with(int vertex) const {
  for (const Group& group : surface_.groups) {
    const std::vector<int> vertices = selector_.select(selection(SelectGroup{group.name}));
    const bool is_there = std::binary_search(vertices.begin(), vertices.end(), vertex);
    const bool is_moderate = 3 * vertices.size() < index(surface_.vertex_count());
    if (is_there && is_moderate && is_free(vertices))
      return StarterPart{group.name, fmt::format("{{group: {}}}", quoted(group.name)), vertices};
  }
  return std::nullopt;
}

std::optional<StarterPart> Search::part_at(int end, std::size_t number) const {
  const std::string name = number == 0 ? "tip" : fmt::format("tip_{}", number + 1);
  if (std::optional<StarterPart> group = group_with(end)) return group;
  StarterPart ball = ball_around(end, name);
  if (ball.vertices.size() < 3) {  // a coarse mesh, whose ends are flat
    const StarterPart flat = slab_at(surface_.positions.row(end).transpose() - shape_.centre, name);
    if (flat.vertices.size() >= 3 && is_free(flat.vertices)) return flat;
  }
  if (!is_free(ball.vertices)) return std::nullopt;
  return ball;
}

/// Where a tip on an arm swings to: across the shape where that is flat, else up, and what stands upright
/// bows over its thinner side.
Vec3 Search::swing_towards(const Vec3& arm) const {
  const Vec3 up = Vec3::UnitY(), thinnest = shape_.axes.col(2), middle = shape_.axes.col(1);
  const bool is_upright = std::abs(arm.y()) > 0.7;
  for (const Vec3& wish : {shape_.is_flat() || is_upright ? thinnest : up, middle, up}) {
    const Vec3 across = wish - wish.dot(arm) * arm;
    if (across.norm() > 0.5) return across.normalized();
  }
  return arm.unitOrthogonal();
}

StarterTip Search::swing_of(StarterPart part, const StarterPart& base, std::size_t number) const {
  const Vec3 middle = middle_of(part.vertices), base_middle = middle_of(base.vertices);
  Vec3 joint = shape_.is_long() ? Vec3((middle + base_middle) / 2) : Vec3((middle + shape_.centre) / 2);
  if ((middle - joint).norm() < 0.02 * size_) joint = (middle + base_middle) / 2;
  joint = rounded(joint, size_);
  const Vec3 arm = middle - joint;
  const Vec3 axis = arm.normalized().cross(swing_towards(arm.normalized()));
  const double widest = number == 0 ? 35 : 20;  // degrees: later ones only follow
  const double wanted = 0.2 * size_ / arm.norm() * 180 / std::numbers::pi;
  return {std::move(part), joint, rounded(axis, 1), 5 * std::round(std::clamp(wanted, 15.0, widest) / 5)};
}

}  // namespace

Starter propose_starter(const Weld& weld, const std::string& mesh_name) {
  return Search(weld, mesh_name).propose();
}

}  // namespace flexkey::cli
