#include "models.h"

#include <map>
#include <utility>

namespace flexkey::meshes {

namespace {

// Lays the quads of a box side by side, sharing the vertices at equal lattice places.
class BarBuilder {
 public:
  BarBuilder(double length, Index across, Index along) : length_(length), counts_{across, across, along} {}

  QuadMesh build() {
    mesh_.part_names = {"bottom", "side", "top"};
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (bool last : {false, true}) add_side(axis, last);
    return mesh_;
  }

 private:
  void add_side(std::size_t axis, bool last) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Index part = axis < 2 ? 1 : (last ? 2 : 0);
    for (Index i = 0; i < counts_[u]; ++i)
      for (Index j = 0; j < counts_[v]; ++j) {
        std::array<Index, 3> at{};
        at[axis] = last ? counts_[axis] : 0;
        Quad quad{};
        for (Index corner = 0; corner < 4; ++corner) {
          at[u] = i + (corner == 1 || corner == 2 ? 1 : 0);
          at[v] = j + (corner >= 2 ? 1 : 0);
          quad[corner] = vertex(at);
        }
        if (!last) std::swap(quad[1], quad[3]);
        mesh_.faces.push_back(quad);
        mesh_.parts.push_back(part);
      }
  }

  Index vertex(const std::array<Index, 3>& at) {
    const auto [found, is_new] = ids_.try_emplace(at, mesh_.vertices.size());
    if (is_new) {
      const auto share = [&](std::size_t axis) {
        return static_cast<double>(at[axis]) / static_cast<double>(counts_[axis]);
      };
      mesh_.vertices.emplace_back(share(0) - 0.5, share(1) - 0.5, share(2) * length_);
    }
    return found->second;
  }

  double length_;
  std::array<Index, 3> counts_;
  QuadMesh mesh_;
  std::map<std::array<Index, 3>, Index> ids_;
};

}  // namespace

Model make_bar(double length, Index across, Index along) {
  return {BarBuilder(length, across, along).build(),
          {{"bottom", {0.36, 0.42, 0.50}}, {"side", {0.80, 0.72, 0.58}}, {"top", {0.82, 0.45, 0.32}}}};
}

}  // namespace flexkey::meshes
