#pragma once

#include <string>
#include <vector>

#include "flexkey/mesh/connectivity.h"
#include "flexkey/mesh/selection.h"
#include "flexkey/mesh/weld.h"

namespace flexkey {

/// Resolves the selections of one timeline on one mesh. Selections are made on the welded surface, so that
/// two sides of a seam are never told apart; `vertices` alone counts the file's own vertices.
class Selector {
 public:
  /// mesh_name stands in messages. The weld must outlive the selector.
  Selector(const Weld& weld, std::string mesh_name);

  /// Surface vertices: along the chain for a `path`, in increasing order for every other kind.
  /// Throws SelectionError if the selection takes no vertex (naming the nearest miss), or names a group,
  /// material, component or vertex that is not there.
  std::vector<int> select(const Selection& selection) const;

 private:
  std::vector<int> take(const SelectVertices& vertices, Mark where) const;
  std::vector<int> take(const SelectGroup& group, Mark where) const;
  std::vector<int> take(const SelectMaterial& material, Mark where) const;
  std::vector<int> take(const SelectNode& node, Mark where) const;
  std::vector<int> take(const SelectSphere& sphere, Mark where) const;
  std::vector<int> take(const SelectBox& box, Mark where) const;
  std::vector<int> take(const SelectPlane& plane, Mark where) const;
  std::vector<int> take(const SelectAxis& axis, Mark where) const;
  std::vector<int> take(const SelectNearest& nearest, Mark where) const;
  std::vector<int> take(const SelectGeodesic& geodesic, Mark where) const;
  std::vector<int> take(const SelectPath& path, Mark where) const;
  std::vector<int> take(const SelectBoundary& boundary, Mark where) const;
  std::vector<int> take(const SelectAttribute& attribute, Mark where) const;
  std::vector<int> take(const SelectComponent& component, Mark where) const;
  std::vector<int> take(const SelectAny& any, Mark where) const;
  std::vector<int> take(const SelectAll& all, Mark where) const;
  std::vector<int> take(const SelectNot& none_of, Mark where) const;

  std::vector<int> within(const Eigen::VectorXd& outside_by, Mark where) const;
  std::vector<int> of_group(const char* kind, const std::string& name, Mark where) const;
  std::vector<int> vertices_of(const std::vector<int>& faces) const;
  std::vector<int> grown(std::vector<int> vertices, int rings) const;

  const Weld& weld_;
  const Mesh& surface_;
  std::string mesh_name_;
  Neighbours neighbours_;
  Bounds bounds_;
  double rounding_;  // slack of comparisons, mesh units: a plane through vertices takes them
};

}  // namespace flexkey
