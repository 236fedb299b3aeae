#include <memory>
#include <optional>
#include <utility>

#include "side.h"

namespace flexkey::bench {
namespace {

struct State {
  Mesh mesh;
  Constraints constraints;
  DeformOptions options;
  double lambda = 0;
  std::optional<Deformer> deformer = {};
  Pose pose = {};
};

}  // namespace

Side flexkey_side(Mesh mesh, Constraints constraints, const DeformOptions& options, double lambda) {
  const auto state = std::make_shared<State>(State{std::move(mesh), std::move(constraints), options, lambda});
  return {[state] {
            state->deformer.emplace(state->mesh, state->constraints, state->options);
            state->pose = state->deformer->rest_pose();
          },
          [state](const Targets& targets) {
            // A turn is news only to a deformer that predicts.
            return state->options.predict
                       ? state->deformer->solve(targets, state->lambda, state->pose)
                       : state->deformer->solve(targets.positions, state->lambda, state->pose);
          },
          [state] { return state->pose.positions; }};
}

}  // namespace flexkey::bench
