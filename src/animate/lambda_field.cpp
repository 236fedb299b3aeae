#include "flexkey/animate/lambda_field.h"

#include <algorithm>

#include "flexkey/mesh/geodesic.h"
#include "flexkey/timeline/sampling.h"

namespace flexkey {
namespace {

double smoothstep(double s) {
  const double within = std::clamp(s, 0.0, 1.0);
  return within * within * (3 - 2 * within);
}

}  // namespace

std::vector<LambdaPaint> paint_regions(const Shot& shot, const Mesh& surface, const Selector& selector) {
  std::vector<LambdaPaint> paints;
  const double diagonal = bounds_of(surface.positions).diagonal();
  for (const LambdaRegion& region : shot.regions) {
    LambdaPaint paint{region.lambda, Eigen::VectorXd::Zero(surface.vertex_count())};
    const std::vector<int> vertices = selector.select(region.select);
    if (const double feather = region.feather.resolve(diagonal); feather > 0) {
      const std::vector<double> distances = geodesic_distances(surface, vertices, feather);
      for (int v = 0; v < surface.vertex_count(); ++v)
        paint.share[v] = smoothstep(1 - distances[static_cast<std::size_t>(v)] / feather);
    }
    for (const int v : vertices) paint.share[v] = 1;
    paints.push_back(std::move(paint));
  }
  return paints;
}

Eigen::VectorXd lambda_at(const Shot& shot, const Scene& scene, double time) {
  Eigen::VectorXd lambda =
      Eigen::VectorXd::Constant(scene.weld.surface.vertex_count(), sample_lambda(shot.lambda, time));
  for (const LambdaPaint& paint : scene.paints) {
    const double value = sample_lambda(paint.lambda, time);
    lambda.array() += paint.share.array() * (value - lambda.array());
  }
  return lambda.cwiseMax(0).cwiseMin(1);  // against rounding
}

}  // namespace flexkey
