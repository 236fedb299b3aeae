#pragma once

#include <vector>

#include "flexkey/deform/deformer.h"
#include "flexkey/deform/weights.h"

namespace flexkey {

/// Each throws a DeformError that names the first thing wrong.
void require_sound(const DeformOptions& options);
void require_sound(const Mesh& rest);
void require_sound(const Constraints& constraints, int vertex_count);

/// order: none, or a number a vertex.
void require_order(const std::vector<int>& order, int vertex_count);

/// That every component with a loose vertex has an area and touches one that is fixed or softly held.
/// A rigid region makes one component of all that it touches.
void require_held(const Mesh& rest, const Cells& cells, const std::vector<bool>& is_loose,
                  const std::vector<std::vector<int>>& rigid);

/// That a frame's values fit the surface: targets #handles x 3 and lambda #V in [0, 1], positions #V x 3, all
/// finite, and a pose of #V vertices.
void require_targets(const Positions& targets, std::size_t handle_count);
/// turns: none, or handle_count x 3 where the deformer predicts.
void require_turns(const Positions& turns, Eigen::Index handle_count, bool predicts);
void require_lambda(const Eigen::VectorXd& lambda, Eigen::Index vertex_count);
void require_positions(const Positions& positions, Eigen::Index vertex_count);
void require_batch(std::size_t frame_count, std::size_t pose_count);
void require_pose(const Pose& pose, Eigen::Index vertex_count);

}  // namespace flexkey
