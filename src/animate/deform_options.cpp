#include "flexkey/animate/deform_options.h"

namespace flexkey {

DeformOptions deform_options(const SolverSettings& solver) {
  DeformOptions options;
  switch (solver.system) {
    case SolverSettings::System::least_squares:
      options.system = System::least_squares;
      break;
    case SolverSettings::System::direct:
      options.system = System::direct;
      break;
  }
  switch (solver.local_scale) {
    case SolverSettings::LocalScale::axis:
      options.local_scale = LocalScale::axis;
      break;
    case SolverSettings::LocalScale::uniform:
      options.local_scale = LocalScale::uniform;
      break;
    case SolverSettings::LocalScale::none:
      options.local_scale = LocalScale::none;
      break;
  }
  switch (solver.weights) {
    case SolverSettings::Weights::clamped:
      options.weights = Weights::clamped;
      break;
    case SolverSettings::Weights::cotangent:
      options.weights = Weights::cotangent;
      break;
    case SolverSettings::Weights::intrinsic_delaunay:
      options.weights = Weights::intrinsic_delaunay;
      break;
    case SolverSettings::Weights::uniform:
      options.weights = Weights::uniform;
      break;
  }
  switch (solver.cell) {
    case SolverSettings::Cell::spokes:
      options.cell = Cell::spokes;
      break;
    case SolverSettings::Cell::spokes_and_rims:
      options.cell = Cell::spokes_and_rims;
      break;
  }
  options.area_weighting = solver.area_weighting;
  options.epsilon = solver.epsilon;
  options.iterations = solver.iterations;
  options.tolerance = solver.tolerance;
  options.predict = solver.predict;
  options.accelerate = solver.accelerate;
  options.fixed_count = solver.preset == SolverSettings::Preset::paper;
  return options;
}

}  // namespace flexkey
