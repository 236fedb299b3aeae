// The paper's figures 2 to 4 on the sample meshes, with its own settings (`preset: paper`): what is pulled
// gets thinner as λ grows.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <functional>
#include <string>
#include <vector>

#include "flexkey/animate/animate.h"
#include "flexkey/mesh/read_mesh.h"
#include "flexkey/mesh/select.h"
#include "flexkey/timeline/parse.h"

namespace flexkey {
namespace {

struct Figure {
  std::string timeline;
  std::vector<Override> changes;
  int frame;         // at the pull's end, at 4 frames a second
  Selection across;  // whose width is measured
};

/// Root mean square distance of points from the line along which they spread most.
double thickness(const Positions& points) {
  const Positions centred = points.rowwise() - points.colwise().mean();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(centred.transpose() * centred);
  return std::sqrt((spread.eigenvalues()[0] + spread.eigenvalues()[1]) / static_cast<double>(points.rows()));
}

/// Mean distance from the plane of symmetry x = 0.
double half_width(const Positions& points) {
  return points.col(0).cwiseAbs().mean();
}

std::vector<double> widths_over_lambda(const Figure& figure,
                                       const std::function<double(const Positions&)>& width) {
  const std::string folder = FLEXKEY_TIMELINES "/", file = folder + figure.timeline;
  std::vector<double> widths;
  for (const char* lambda : {"0", "0.2", "0.5", "0.8", "1"}) {
    std::vector<Override> changes{{"solver", "{preset: paper}"}, {"lambda", lambda}, {"fps", "4"}};
    changes.insert(changes.end(), figure.changes.begin(), figure.changes.end());
    const Shot shot = parse_shot(read_timeline(file), file, changes).shot;
    const Mesh mesh = read_mesh(folder + shot.mesh.file).mesh;
    const Scene scene = bind_shot(shot, mesh);
    const std::vector<int> measured = Selector(scene.weld, shot.mesh.file).select(figure.across);
    const Clip clip = animate(shot, mesh, scene, {figure.frame});
    widths.push_back(width(clip.frames[0](measured, Eigen::all)));
  }
  return widths;
}

void expect_falling(const std::vector<double>& widths) {
  for (std::size_t k = 1; k < widths.size(); ++k) EXPECT_LT(widths[k], widths[k - 1]) << "at λ number " << k;
}

Selection of_group(const std::string& name, const SelectAxis& part) {
  return {SelectAll{{{SelectGroup{name}, 0, {}}, {part, 0, {}}}}, 0, {}};
}

TEST(Figure2, TheNoseGetsThinnerAsLambdaGrows) {
  const Figure nose{"nose.yaml", {}, 8, of_group("nose", {2, Length{0.9, false}, {}})};
  expect_falling(widths_over_lambda(nose, half_width));
}

// Pulled by a line of vertices, as the paper's blue and green lines do. A handle that holds the whole hoof
// shows the opposite: the leg keeps its girth at λ = 1 and is drawn thinner at λ = 0.
TEST(Figure3, TheStretchedLegGetsThinnerAsLambdaGrows) {
  const Figure leg{"leg.yaml",
                   {{"roi", "{group: leg_hind_left}"},
                    {"handles.hoof",
                     "{select: {path: [[0.27, 0.4, -0.62], [0.27, 0, -0.5]]}, curve: {keys: {0s: rest, "
                     "1s: {polyline: [[0.27, 0.4, -0.62], [0.3, -0.3, -0.7]]}}}}"}},
                   4,
                   of_group("leg_hind_left", {1, Length{0.1, false}, Length{0.4, false}})};
  expect_falling(widths_over_lambda(leg, thickness));
}

TEST(Figure4, TheExtendedJawGetsThinnerAsLambdaGrows) {
  const Figure jaw{"jaw.yaml", {}, 8, of_group("upper_jaw", {2, Length{0.5, false}, Length{1.0, false}})};
  expect_falling(widths_over_lambda(jaw, thickness));
}

}  // namespace
}  // namespace flexkey
