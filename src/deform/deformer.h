#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "flexkey/deform/course.h"
#include "flexkey/deform/error.h"
#include "flexkey/deform/options.h"
#include "flexkey/mesh/mesh.h"

namespace flexkey {

/// Which vertices the solve may move and which it must meet. All indices are of the rest mesh.
struct Constraints {
  std::vector<int> handles;      // vertices whose targets are given, handles and anchors alike; no repeats
  std::vector<int> region = {};  // the region of interest; empty means the whole mesh
  std::vector<int> owner =
      {};  // #handles, which handle leads each vertex, from 0; empty: one handle leads all
  std::vector<double> strengths =
      {};  // a number a handle, in (0, 1]: below 1 it is soft and goes about that share of the way; empty: 1
  std::vector<std::vector<int>> rigid = {};  // regions of free vertices that each move as one body
};

/// Where one frame's constraints go.
struct Targets {
  Positions positions;    // #handles x 3, of Constraints::handles
  Positions turns{0, 3};  // a row a handle: its world rotation vector since the last frame, radians, whole
                          // turns counted; empty: none is known
  template <class Expression>
  Targets(const Eigen::MatrixBase<Expression>& where) : positions(where) {}  // NOLINT: no turns are known
  Targets(Positions where, Positions how_turned)
      : positions(std::move(where)), turns(std::move(how_turned)) {}
};

/// One frame's answer and the next frame's warm start. The caller owns it.
struct Pose {
  Positions positions;                     // #V x 3, rest-mesh units
  std::vector<Eigen::Matrix3d> rotations;  // #V, R_i fitted to positions (identity where no cell is fitted)
  Positions scales;                        // #V x 3, diagonal of S_i in world axes
  // What the positions answer to, so that an unchanged frame repeats them bit for bit:
  Positions targets;       // #handles x 3
  Eigen::VectorXd lambda;  // #V; empty at rest, which answers to every lambda
  bool converged = false;
  bool started =
      false;      // whether a frame was ever solved into it; `fixed_count` begins its first differently
  Course course;  // belongs to the deformer that solved last; `{}` for another
};

template <MaybeConst<Pose> Self>
auto members_of(Self& pose) {
  auto& [positions, rotations, scales, targets, lambda, converged, started, course] = pose;
  return std::tie(positions, rotations, scales, targets, lambda, converged, started, course);
}

struct SolveReport {
  int solves = 0;       // global solves spent
  double step = 0;      // the last step's largest vertex motion, as a share of the diagonal
  double estimate = 0;  // of the distance to the fixed point, likewise; infinite where nothing can be said
  bool converged = false;
  bool slipped = false;  // the surface has lost a turn that its handles made
};

/// One frame of a batch.
struct Frame {
  Targets targets;
  Eigen::VectorXd lambda;  // #V values in [0, 1]
};

/// The paper's method: weights, matrix and factorization once for a set of constraints; then one solve a
/// frame.
class Deformer {
 public:
  /// Throws DeformError if an index or option is out of range, a handle lies outside the region, a free
  /// component touches no constraint or has no area, or the factorization fails.
  /// order: of elimination, as of surface_order, for a mesh whose constraints change; empty: one is found.
  Deformer(const Mesh& rest, const Constraints& constraints, const DeformOptions& options = {},
           const std::vector<int>& order = {});
  ~Deformer();
  Deformer(Deformer&&) noexcept;
  Deformer& operator=(Deformer&&) noexcept;

  Pose rest_pose() const;

  /// A start at these positions, #V x 3, with R_i and S_i fitted to them; what is fixed at rest stays there.
  Pose pose_at(const Positions& positions) const;

  /// A pose of this mesh under other constraints as a start under these: its shape stays, with R_i and S_i
  /// fitted to it here, and what it remembers of its handles is dropped.
  Pose adopt(const Pose& pose) const;

  /// Whether a pose that comes from elsewhere, as from a file, has the sizes of one that this deformer solved
  /// last or that is at rest.
  bool could_have_solved(const Pose& pose) const;

  /// Of memory held for the solve, but for small change.
  std::size_t bytes() const;

  /// Moves `pose`, the frame before, to this frame's answer: a fixed point of one local and one global step.
  /// lambda: one value or #V values in [0, 1].
  /// Throws DeformError if a value does not fit, and leaves the pose as it was, or if the answer is not
  /// finite, and leaves the pose as it was but for its course's window.
  SolveReport solve(const Targets& targets, double lambda, Pose& pose) const;
  SolveReport solve(const Targets& targets, const Eigen::VectorXd& lambda, Pose& pose) const;

  /// The same for several frames of one constraint set at once, each with its own pose, in one pass over the
  /// factor a step: a sweep over λ costs little more than its slowest run. The answers are those of single
  /// solves. frames, poses: equally many. Throws as single solves do.
  std::vector<SolveReport> solve(std::span<const Frame> frames, std::span<Pose> poses) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace flexkey
