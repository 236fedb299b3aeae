#include "cage.h"
#include "models.h"

namespace flexkey::meshes {

namespace {

// Joints of the animal's left legs, from the body down; cage and clay share them.
const std::vector<Section> kFrontLeg{{{0.235, 0.45, 0.44}, 0.160},
                                     {{0.247, 0.34, 0.452}, 0.133},
                                     {{0.250, 0.23, 0.452}, 0.115},
                                     {{0.250, 0.12, 0.448}, 0.108},
                                     {{0.250, 0.02, 0.460}, 0.125}};
const std::vector<Section> kHindLeg{{{0.245, 0.46, -0.42}, 0.185},
                                    {{0.257, 0.35, -0.425}, 0.145},
                                    {{0.260, 0.24, -0.447}, 0.116},
                                    {{0.260, 0.12, -0.445}, 0.108},
                                    {{0.260, 0.02, -0.430}, 0.125}};
const std::vector<Section> kTail{{{0.0, 1.01, -0.86}, 0.070},
                                 {{0.0, 1.06, -0.96}, 0.050},
                                 {{0.0, 1.16, -1.00}, 0.044},
                                 {{0.0, 1.23, -0.93}, 0.039},
                                 {{0.0, 1.18, -0.84}, 0.032}};
const std::vector<Section> kHead{{{0.0, 0.93, 0.84}, 0.36},
                                 {{0.0, 0.98, 0.98}, 0.37},
                                 {{0.0, 0.99, 1.12}, 0.33},
                                 {{0.0, 0.97, 1.24}, 0.25}};
const std::vector<Section> kSnout{{{0.0, 0.945, 1.37}, 0.185}, {{0.0, 0.93, 1.49}, 0.175}};
const Vec3 kEye(0.185, 1.135, 1.190);

std::vector<Ball> balls(const std::vector<Section>& path, double scale) {
  std::vector<Ball> result;
  for (const Section& s : path) result.push_back({s.centre, scale * s.radius});
  return result;
}

void add_leg(Clay& clay, const std::vector<Section>& leg, const Vec3& top, double top_radius) {
  std::vector<Ball> shank = balls(leg, 0.92);
  const Vec3 hoof = shank.back().centre;
  shank.pop_back();
  shank.insert(shank.begin(), Ball{top, top_radius});
  clay.add(chain(shank), 0.12);
  clay.add(round_cone(hoof + Vec3(0, 0.10, -0.01), 0.095, hoof + Vec3(0, -0.01, 0.01), 0.128), 0.03);
  // The cleft of the hoof.
  clay.carve(ellipsoid(hoof + Vec3(0, 0.03, 0.14), {0.018, 0.09, 0.06}), 0.03);
}

// The masses, without the details that grow from cells of their own.
Clay pig_masses() {
  Clay clay;
  clay.add(ellipsoid({0, 0.83, -0.01}, {0.43, 0.41, 0.82}), 0.1)
      .add(ellipsoid({0, 0.73, 0.0}, {0.42, 0.37, 0.58}), 0.3)
      .add(ellipsoid({0.08, 0.82, -0.48}, {0.34, 0.38, 0.36}), 0.3)
      .add(ellipsoid({0.08, 0.80, 0.46}, {0.33, 0.37, 0.34}), 0.3);
  add_leg(clay, kHindLeg, {0.21, 0.70, -0.42}, 0.22);
  add_leg(clay, kFrontLeg, {0.21, 0.68, 0.42}, 0.19);
  // Head: skull, cheeks, snout with a raised rim.
  clay.add(ellipsoid({0, 1.02, 0.98}, {0.345, 0.33, 0.36}), 0.15)
      .add(ellipsoid({0.18, 0.90, 1.04}, {0.17, 0.17, 0.18}), 0.12)
      .add(round_cone({0, 0.97, 1.15}, 0.23, {0, 0.935, 1.45}, 0.165), 0.12)
      .add(squeezed(round_cone({0, 0.93, 1.44}, 0.165, {0, 0.93, 1.48}, 0.165), {0, 0.93, 1.46},
                    {1.12, 0.92, 0.55}),
           0.05)
      .keep(half_space({0, 0.93, 1.525}, {0, 0.05, 1}), 0.05)
      .carve(ellipsoid({0.068, 0.935, 1.54}, {0.034, 0.052, 0.055}), 0.03);
  clay.add(chain(balls(kTail, 0.9)), 0.05);
  clay.keep(half_space({0, 0, 0}, {0, -1, 0}), 0.06);
  return clay;
}

Clay pig_clay() {
  Clay clay = pig_masses();
  const Vec3 eye = clay.on_surface(kEye), out = clay.gradient(eye).normalized();
  clay.add(ellipsoid(eye - 0.012 * out, {0.062, 0.062, 0.062}), 0.02);
  // Ears: flat shells that lean out and forward, hollowed in front.
  clay.add(ellipsoid({0.340, 1.41, 0.99}, {0.140, 0.215, 0.064}, {12, 20, -32}), 0.08)
      .carve(ellipsoid({0.370, 1.42, 1.062}, {0.088, 0.155, 0.050}, {12, 20, -32}), 0.05);
  return clay;
}

void add_leg_loops(QuadMesh& cage, const Patch& patch, const std::string& part,
                   const std::vector<Section>& leg) {
  extrude_tube(cage, patch, part, {leg.begin(), leg.end() - 1});
  extrude_tube(cage, patch, part + ":hoof", {leg.back()});
  inset(cage, patch, part + ":hoof", 0.6);
}

void add_eye_loops(QuadMesh& cage, const Clay& masses) {
  const Vec3 foot = masses.on_surface(kEye), out = masses.gradient(foot).normalized();
  const auto eye = pick(cage, foot, out);
  seat(cage, eye, "head", foot, out, 0.085);
  extrude_tube(cage, eye, "head:eye", {{foot + 0.025 * out, 0.055, out}, {foot + 0.050 * out, 0.025, out}});
}

// A leaf on a narrow stalk.
void add_ear(QuadMesh& cage, const Clay& masses) {
  const Vec3 foot = masses.on_surface({0.235, 1.27, 0.98});
  const auto ear = pick(cage, foot, {0.5, 1, 0});
  seat(cage, ear, "head", foot, masses.gradient(foot), 0.13);
  extrude(cage, ear, "ear_left", [&](const Vec3& p) -> Vec3 {
    const Vec3 arm = p - foot;
    return foot + Vec3(0.03 + 0.75 * arm.x(), 0.04 + 0.75 * arm.y(), 0.42 * arm.z());
  });
  extrude_tube(cage, ear, "ear_left",
               {{{0.305, 1.37, 0.985}, 0.11},
                {{0.345, 1.43, 0.995}, 0.125},
                {{0.385, 1.50, 1.010}, 0.105},
                {{0.42, 1.565, 1.03}, 0.06}});
}

QuadMesh pig_cage(const Clay& masses) {
  const Vec3 up(0, 1, 0), down(0, -1, 0), front(0, 0, 1), back(0, 0, -1);
  QuadMesh cage = half_box({0, 0.11, 0.38}, {0.52, 0.72, 0.95, 1.18},
                           {-0.74, -0.62, -0.42, -0.22, 0.0, 0.24, 0.44, 0.62, 0.74}, "body");
  const auto hind = select(cage, {0.12, 0.4, -0.62}, {0.4, 0.6, -0.22}, down);
  const auto fore = select(cage, {0.12, 0.4, 0.24}, {0.4, 0.6, 0.62}, down);
  const auto rear = select(cage, {0, 0.96, -0.8}, {0.11, 1.2, -0.7}, back);
  const auto face = select(cage, {0, 0.4, 0.7}, {0.4, 1.2, 0.8}, front);
  add_leg_loops(cage, hind, "leg_hind_left", kHindLeg);
  add_leg_loops(cage, fore, "leg_front_left", kFrontLeg);
  extrude_tube(cage, rear, "body", {{{0, 1.0, -0.80}, 0.085, {0, 0.25, -1}}});
  extrude_tube(cage, rear, "tail", kTail);
  extrude_tube(cage, face, "head", kHead);
  extrude_tube(cage, face, "snout:head", {kSnout.front()});
  extrude_tube(cage, face, "snout", {kSnout.back()});
  inset(cage, face, "snout", 0.6);
  fit_cage(cage, masses, {.rounds = 8, .relax = 0.4, .square = 0.3, .hold = 0.3, .max_step = 0.05});
  add_eye_loops(cage, masses);
  add_ear(cage, masses);
  return cage;
}

}  // namespace

Model make_pig() {
  const Colour skin{0.93, 0.68, 0.64}, pale{0.90, 0.58, 0.56}, leg{0.90, 0.64, 0.60};
  WrapOptions middle{.rounds = 12, .relax = 0.5, .square = 0.5, .hold = 0.1, .max_step = 0.03};
  WrapOptions fine{.rounds = 20, .relax = 0.5, .square = 0.5, .hold = 0.05, .max_step = 0.02};
  return {shaped(pig_cage(pig_masses()), pig_clay(), {middle, fine}),
          {{"body", skin},
           {"head", skin},
           {"snout", pale},
           {"ear_left", pale},
           {"ear_right", pale},
           {"leg_front_left", leg},
           {"leg_front_right", leg},
           {"leg_hind_left", leg},
           {"leg_hind_right", leg},
           {"tail", pale},
           {"hoof", {0.42, 0.30, 0.27}},
           {"eye", {0.12, 0.09, 0.08}}}};
}

}  // namespace flexkey::meshes
