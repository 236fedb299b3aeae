#pragma once

namespace flexkey {

enum class System { least_squares, direct };    // eq 7, or eq 5 on the free rows
enum class LocalScale { axis, uniform, none };  // S_i: eq 8, its one-number form, or 1
enum class Weights { clamped, cotangent, intrinsic_delaunay, uniform };  // ω_ij
enum class Cell { spokes, spokes_and_rims };                             // what R_i and S_i are fitted to

struct DeformOptions {
  System system = System::least_squares;
  LocalScale local_scale = LocalScale::uniform;
  double epsilon = 0.05;  // of S_i (`axis`): how far the fit is drawn to the cell's uniform scale; 0 is eq 8
  Weights weights = Weights::clamped;
  Cell cell = Cell::spokes;     // the second takes its triangles' cotangents: not with `uniform`
  bool area_weighting = false;  // of the rows of eq 7, see row_weights; `least_squares` only
  int iterations = 30;          // most global solves a frame, at least 1
  double tolerance = 1e-3;      // share of the rest mesh's bounding-box diagonal
  bool predict = true;          // start a frame from turned rotations, not from the last frame's as they are
  bool accelerate = true;       // Anderson acceleration of the fixed-point iteration
  bool fixed_count = false;     // run all iterations and claim no convergence (`preset: paper`)
};

}  // namespace flexkey
