#include "cage.h"
#include "models.h"

#include <cmath>

namespace flexkey::meshes {

namespace {

void add_skull(Clay& clay) {
  clay.add(ellipsoid({0, 0.56, -0.02}, {0.61, 0.67, 0.77}), 0.1)
      // Face wedge and jaw.
      .add(ellipsoid({0, 0.16, 0.30}, {0.47, 0.66, 0.48}), 0.15)
      .add(chain({{{0.36, -0.02, 0.02}, 0.12}, {{0.33, -0.20, 0.14}, 0.12}, {{0.10, -0.42, 0.58}, 0.12}}),
           0.15)
      .add(ellipsoid({0, -0.41, 0.69}, {0.15, 0.12, 0.12}), 0.12)
      // Muzzle that carries the lips.
      .add(ellipsoid({0, -0.12, 0.62}, {0.25, 0.22, 0.24}), 0.15)
      // Cheekbones and the flesh below them.
      .add(ellipsoid({0.33, 0.20, 0.55}, {0.16, 0.12, 0.15}), 0.16)
      .add(ellipsoid({0.24, -0.08, 0.44}, {0.16, 0.22, 0.20}), 0.2);
  // Neck, wider at the foot, cut flat.
  clay.add(chain({{{0, 0.0, -0.16}, 0.32}, {{0, -0.60, -0.21}, 0.33}, {{0, -1.30, -0.23}, 0.39}}), 0.14)
      .keep(half_space({0, -1.08, 0}, {0, -1, 0}), 0.12);
}

void add_eyes(Clay& clay) {
  // Brow ridge, socket below it, and the closed lid over the eyeball.
  clay.add(chain({{{0.0, 0.545, 0.755}, 0.05},
                  {{0.12, 0.56, 0.74}, 0.06},
                  {{0.26, 0.58, 0.68}, 0.06},
                  {{0.38, 0.53, 0.54}, 0.045}}),
           0.14)
      .carve(ellipsoid({0.245, 0.40, 0.85}, {0.15, 0.095, 0.14}, {0, 20, 0}), 0.12)
      .add(ellipsoid({0.242, 0.380, 0.625}, {0.150, 0.112, 0.135}), 0.06)
      // The line where the lids meet.
      .carve(chain({{{0.125, 0.360, 0.745}, 0.008},
                    {{0.18, 0.337, 0.768}, 0.011},
                    {{0.25, 0.327, 0.768}, 0.012},
                    {{0.32, 0.342, 0.733}, 0.011},
                    {{0.365, 0.365, 0.685}, 0.008}}),
             0.032);
}

void add_nose(Clay& clay) {
  clay.add(chain({{{0, 0.47, 0.775}, 0.065}, {{0, 0.33, 0.84}, 0.062}, {{0, 0.14, 0.955}, 0.090}}), 0.11)
      // Wings and nostrils.
      .add(ellipsoid({0.095, 0.085, 0.865}, {0.062, 0.062, 0.085}), 0.07)
      .carve(ellipsoid({0.052, 0.035, 0.935}, {0.028, 0.030, 0.040}), 0.035);
}

void add_mouth(Clay& clay) {
  // Groove under the nose, then the lips and the line between them.
  clay.carve(ellipsoid({0, -0.03, 0.90}, {0.025, 0.06, 0.04}), 0.05)
      .add(chain({{{0.028, -0.116, 0.848}, 0.042},
                  {{0.09, -0.134, 0.825}, 0.034},
                  {{0.175, -0.165, 0.75}, 0.014}}),
           0.04)
      .add(
          chain(
              {{{0.0, -0.208, 0.838}, 0.048}, {{0.08, -0.202, 0.82}, 0.040}, {{0.165, -0.17, 0.755}, 0.014}}),
          0.04)
      .carve(chain({{{0.0, -0.160, 0.890}, 0.008},
                    {{0.09, -0.164, 0.862}, 0.008},
                    {{0.185, -0.168, 0.780}, 0.010}}),
             0.03)
      // Hollow between lower lip and chin.
      .carve(ellipsoid({0, -0.30, 0.86}, {0.14, 0.035, 0.07}), 0.08);
}

// Middle of the ear's shell, the way it looks, and the turn that goes with it: out, to the front
// and, as the skull widens upwards, a little down.
const Vec3 kEar(0.648, 0.27, -0.105);
const Vec3 kEarFacing(0.912, -0.227, 0.342);
const Vec3 kEarTurn(-8, -20, -14);

void add_ears(Clay& clay) {
  clay.add(ellipsoid({0.585, 0.27, -0.075}, {0.060, 0.150, 0.085}, {0, -10, -14}), 0.06)
      // The shell: a wide upper part and the lobe.
      .add(ellipsoid(kEar + Vec3(0.010, 0.045, -0.012), {0.050, 0.170, 0.122}, kEarTurn), 0.05)
      .add(ellipsoid(kEar + Vec3(-0.018, -0.110, 0.022), {0.046, 0.105, 0.085}, kEarTurn), 0.06)
      // The hollow behind the rim and the deeper one above the lobe.
      .carve(ellipsoid(kEar + Vec3(0.070, 0.045, 0.008), {0.044, 0.112, 0.072}, kEarTurn), 0.04)
      .carve(ellipsoid(kEar + Vec3(0.055, -0.045, 0.030), {0.055, 0.065, 0.050}, kEarTurn), 0.04);
}

// All but the ears, which grow from cells of their own.
Clay head_masses() {
  Clay clay;
  add_skull(clay);
  add_eyes(clay);
  add_nose(clay);
  add_mouth(clay);
  return clay;
}

Clay head_clay() {
  Clay clay = head_masses();
  add_ears(clay);
  return clay;
}

// Pulls the corners of the box in, which starts the cage nearer to the skull.
void round_off(QuadMesh& cage, const Vec3& centre, const Vec3& half) {
  for (Vec3& p : cage.vertices) {
    const Vec3 q = (p - centre).cwiseQuotient(half);
    const double norm4 = std::pow(q.array().pow(4).sum(), 0.25);
    p = centre + q.cwiseProduct(half) * (q.cwiseAbs().maxCoeff() / norm4);
  }
}

// Loops around the nose: along the crease of the wings, over the wings, and around the tip.
void add_nose_loops(QuadMesh& cage, const Patch& nose) {
  for (Vec3& p : cage.vertices)
    if (p.z() > 0.6 && std::abs(p.x() - 0.12) < 0.02 && p.y() > -0.1 && p.y() < 0.2) p.x() = 0.175;
  extrude(cage, nose, "nose", [](const Vec3& p) -> Vec3 {
    return {p.x() > 0.15 ? 0.135 : 0.80 * p.x(), 0.12 + 0.85 * (p.y() - 0.12), p.z()};
  });
  extrude(cage, nose, "nose", [](const Vec3& p) -> Vec3 {
    return {0.5 * p.x(), 0.14 + 0.75 * (p.y() - 0.14), p.z()};
  });
}

// A stalk, the back of the shell, its rim, and the hollow inside; the shell looks out and forward.
void add_ear_loops(QuadMesh& cage, const Patch& ear, const Clay& masses) {
  const Vec3 foot = masses.on_surface({0.57, 0.26, -0.07});
  const Vec3 out = masses.gradient(foot).normalized(), look = kEarFacing;
  extrude_tube(cage, ear, "skull", {{foot + 0.01 * out, 0.115, out}});
  extrude_tube(cage, ear, "ear_left",
               {{kEar - 0.02 * look, 0.155, look},
                {kEar + 0.03 * look, 0.150, look},
                {kEar + 0.03 * look, 0.105, look},
                {kEar, 0.075, look}});
}

// Sets the vertices of the face onto the clay at their x and y, so that features stay in place.
void set_face(QuadMesh& cage, const Clay& clay) {
  for (Vec3& p : cage.vertices)
    if (p.z() > 0.45 && p.x() < 0.42 && p.y() > -0.35 && p.y() < 0.8) p = clay.cast_back({p.x(), p.y(), 1.4});
}

QuadMesh head_cage(const Clay& masses) {
  const Vec3 up(0, 1, 0), down(0, -1, 0), front(0, 0, 1), side(1, 0, 0);
  QuadMesh cage = half_box({0, 0.12, 0.25, 0.39, 0.60}, {-0.50, -0.28, -0.05, 0.10, 0.26, 0.51, 0.78, 1.16},
                           {-0.76, -0.44, -0.19, 0.01, 0.36, 0.80}, "skull");
  const auto face = select(cage, {0, -0.5, 0.7}, {0.6, 0.6, 0.9}, front);
  const auto nose = select(cage, {0, -0.05, 0.7}, {0.12, 0.26, 0.9}, front);
  const auto bridge = select(cage, {0, 0.26, 0.7}, {0.12, 0.51, 0.9}, front);
  const auto eye = select(cage, {0.12, 0.26, 0.7}, {0.39, 0.51, 0.9}, front);
  const auto mouth = select(cage, {0, -0.28, 0.7}, {0.25, -0.05, 0.9}, front);
  const auto ear = select(cage, {0.5, 0.09, -0.19}, {0.7, 0.52, 0.01}, side);
  const auto neck = select(cage, {0, -0.6, -0.76}, {0.39, -0.4, 0.36}, down);
  set_part(cage, face, "face");
  set_part(cage, bridge, "nose");
  round_off(cage, {0, 0.33, 0.02}, {0.60, 0.83, 0.78});

  inset(cage, eye, "eye_left", 0.80);
  inset(cage, eye, "eye_left", 0.70);
  inset(cage, mouth, "mouth", 0.80);
  inset(cage, mouth, "mouth", 0.70);
  add_nose_loops(cage, nose);
  extrude_tube(cage, neck, "neck",
               {{{0, -0.60, -0.22}, 0.34},
                {{0, -0.80, -0.23}, 0.34},
                {{0, -0.96, -0.23}, 0.38},
                {{0, -1.07, -0.23}, 0.40}});
  inset(cage, neck, "neck", 0.6);
  set_face(cage, masses);
  fit_cage(cage, masses, {.rounds = 8, .relax = 0.4, .square = 0.3, .hold = 0.4, .max_step = 0.1});
  add_ear_loops(cage, ear, masses);
  return cage;
}

}  // namespace

Model make_head() {
  const Colour clay{0.80, 0.72, 0.64};
  WrapOptions middle{.rounds = 12, .relax = 0.5, .square = 0.5, .hold = 0.2, .max_step = 0.03};
  WrapOptions fine{.rounds = 26, .relax = 0.5, .square = 0.5, .hold = 0.1, .max_step = 0.02};
  Model model{shaped(head_cage(head_masses()), head_clay(), {middle, fine}), {}};
  for (const std::string& part : model.mesh.part_names) model.colours[part] = clay;
  return model;
}

}  // namespace flexkey::meshes
