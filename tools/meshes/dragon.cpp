#include "cage.h"
#include "models.h"

#include <string>
#include <vector>

namespace flexkey::meshes {

namespace {

// Middle lines of the parts; cage and clay share them.
const std::vector<Section> kUpper{
    {{0, 0.51, 0.38}, 0.330}, {{0, 0.51, 0.63}, 0.300}, {{0, 0.495, 0.88}, 0.270}, {{0, 0.445, 1.09}, 0.215}};
const std::vector<Section> kLower{{{0, 0.05, 0.35}, 0.275},
                                  {{0, -0.085, 0.57}, 0.245},
                                  {{0, -0.195, 0.78}, 0.210},
                                  {{0, -0.27, 0.96}, 0.165}};
const std::vector<Section> kNeck{{{0, 0.20, -0.60}, 0.36},
                                 {{0, -0.10, -0.83}, 0.32},
                                 {{0, -0.50, -0.91}, 0.33},
                                 {{0, -0.90, -0.86}, 0.38}};
const std::vector<Section> kHorn{{{0.272, 0.79, -0.37}, 0.098},
                                 {{0.31, 0.94, -0.56}, 0.085},
                                 {{0.345, 1.02, -0.77}, 0.060},
                                 {{0.365, 1.03, -0.97}, 0.030}};
const std::vector<Section> kCheek{{{0.48, 0.12, -0.38}, 0.070}, {{0.60, 0.09, -0.54}, 0.028}};

const Vec3 kEye(0.40, 0.57, 0.20);

// A fin on the middle line or a tooth: from its foot on the skin to its tip.
struct Spike {
  Vec3 foot, tip;
  double radius;
};
const std::vector<Spike> kFins{{{0, 0.62, -0.66}, {0, 0.86, -0.94}, 0.10},
                               {{0, 0.34, -0.96}, {0, 0.50, -1.26}, 0.10},
                               {{0, -0.05, -1.17}, {0, 0.02, -1.42}, 0.09}};
const std::vector<Spike> kTeeth{{{0.150, 0.350, 1.00}, {0.165, 0.16, 1.01}, 0.048},
                                {{0.200, 0.370, 0.68}, {0.210, 0.23, 0.69}, 0.042},
                                {{0.110, -0.14, 0.86}, {0.125, 0.00, 0.90}, 0.042}};

std::vector<Ball> balls(const std::vector<Section>& path) {
  std::vector<Ball> result;
  for (const Section& s : path) result.push_back({s.centre, s.radius});
  return result;
}

// A chain whose sections are flattened in y while its middle line stays where it is.
Field flat_chain(std::vector<Ball> path, double factor) {
  for (Ball& ball : path) ball.centre.y() /= factor;
  return squeezed(chain(path), Vec3::Zero(), {1.0, factor, 1.0});
}

// The spike with its foot moved onto the skin.
Spike planted(const Spike& spike, const Clay& masses) {
  return {masses.on_surface(spike.foot), spike.tip, spike.radius};
}

Field spike_field(const Spike& spike, double tip_radius) {
  // It starts below the skin so that its foot blends in all around.
  const Vec3 root = spike.foot - 0.2 * (spike.tip - spike.foot);
  return round_cone(root, spike.radius, spike.tip, tip_radius);
}

void add_spikes(Clay& clay, const Clay& masses) {
  std::vector<Ball> horn = balls(kHorn), cheek = balls(kCheek);
  horn.insert(horn.begin(), Ball{{0.25, 0.62, -0.24}, 0.10});
  cheek.insert(cheek.begin(), Ball{{0.34, 0.16, -0.24}, 0.10});
  horn.push_back({{0.37, 1.02, -1.04}, 0.024});
  clay.add(chain(horn), 0.05).add(chain(cheek), 0.05);
  for (const Spike& fin : kFins)
    clay.add(squeezed(spike_field(planted(fin, masses), 0.036), Vec3::Zero(), {0.45, 1, 1}), 0.06);
  for (const Spike& tooth : kTeeth) clay.add(spike_field(planted(tooth, masses), 0.020), 0.02);
}

// The masses, without the details that grow from cells of their own.
Clay dragon_masses() {
  Clay clay;
  // Upper half: skull and snout.
  std::vector<Ball> upper = balls(kUpper), lower = balls(kLower);
  upper.insert(upper.begin(), Ball{{0, 0.48, 0.05}, 0.38});
  lower.insert(lower.begin(), Ball{{0, 0.16, 0.05}, 0.30});
  clay.add(ellipsoid({0, 0.42, -0.10}, {0.42, 0.37, 0.44}), 0.1)
      .add(flat_chain(upper, 0.64), 0.12)
      .add(flat_chain(lower, 0.52), 0.06)
      .add(ellipsoid({0.30, 0.22, -0.06}, {0.15, 0.20, 0.22}), 0.1);
  std::vector<Ball> neck = balls(kNeck);
  neck.insert(neck.begin(), Ball{{0, 0.36, -0.25}, 0.34});
  neck.push_back({{0, -1.1, -0.80}, 0.42});
  clay.add(chain(neck), 0.12);
  // Brow ridges.
  clay.add(chain({{{0.12, 0.67, 0.48}, 0.055},
                  {{0.24, 0.71, 0.27}, 0.070},
                  {{0.31, 0.71, 0.07}, 0.065},
                  {{0.31, 0.66, -0.10}, 0.05}}),
           0.12);
  // Nostrils.
  clay.add(ellipsoid({0.12, 0.58, 1.10}, {0.08, 0.075, 0.10}), 0.07)
      .carve(ellipsoid({0.160, 0.605, 1.175}, {0.034, 0.030, 0.050}), 0.035);
  clay.keep(half_space({0, -0.95, 0}, {0, -1, 0}), 0.12);
  return clay;
}

Clay dragon_clay() {
  const Clay masses = dragon_masses();
  Clay clay = masses;
  const Vec3 eye = clay.on_surface(kEye), out = clay.gradient(eye).normalized();
  clay.add(ellipsoid(eye - 0.025 * out, {0.085, 0.085, 0.085}), 0.025);
  add_spikes(clay, masses);
  return clay;
}

// Seats the cell nearest to the foot there, with a loop of skin around, and pulls it out to the
// tip; `narrow` thins the spike sideways. The last ring lies past the tip: from outside, vertices
// find the tip, from inside they would slide off to one side of it.
void add_spike(QuadMesh& cage, const Clay& masses, const std::string& skin, const std::string& part,
               const Spike& spike, double narrow) {
  const Vec3 along = (spike.tip - spike.foot).normalized();
  const auto at = [&](double t) -> Vec3 { return spike.foot + t * (spike.tip - spike.foot); };
  const Vec3& foot = spike.foot;
  const Vec3 out = masses.gradient(foot);
  const auto patch = pick(cage, foot, out);
  seat(cage, patch, skin, foot, out, 1.5 * spike.radius);
  extrude(cage, patch, part, [&](const Vec3& p) -> Vec3 {
    const Vec3 arm = p - foot;
    return at(0.35) + 0.6 * Vec3(narrow * arm.x(), arm.y(), arm.z());
  });
  extrude_tube(cage, patch, part, {{at(1.15), 0.4 * spike.radius, along}});
}

void add_all_spikes(QuadMesh& cage, const Clay& masses) {
  for (const Spike& fin : kFins) {
    const std::string skin = fin.foot.y() > 0.7 ? "head" : "neck";
    add_spike(cage, masses, skin, "crest", planted(fin, masses), 0.7);
  }
  for (const Spike& tooth : kTeeth) {
    const std::string jaw = tooth.tip.y() < tooth.foot.y() ? "upper_jaw" : "lower_jaw";
    add_spike(cage, masses, jaw + ":mouth", jaw + ":tooth", planted(tooth, masses), 1.0);
  }
}

void add_eye_loops(QuadMesh& cage, const Clay& masses) {
  const Vec3 foot = masses.on_surface(kEye), out = masses.gradient(foot).normalized();
  const auto eye = pick(cage, foot, out);
  seat(cage, eye, "head", foot, out, 0.115);
  extrude_tube(cage, eye, "head:eye", {{foot + 0.03 * out, 0.080, out}, {foot + 0.06 * out, 0.040, out}});
}

void add_horns(QuadMesh& cage, const Clay& masses) {
  const Vec3 top = masses.on_surface({0.265, 0.70, -0.29});
  const auto horn = pick(cage, top, masses.gradient(top));
  seat(cage, horn, "head", top, masses.gradient(top), 0.130);
  std::vector<Section> path = kHorn;
  path.back().centre += Vec3(0.005, -0.010, -0.09);
  extrude_tube(cage, horn, "horn_left", path);
  const Vec3 low = masses.on_surface({0.38, 0.14, -0.28});
  const auto cheek = pick(cage, low, masses.gradient(low));
  seat(cage, cheek, "head", low, masses.gradient(low), 0.125);
  extrude_tube(cage, cheek, "cheek_left", kCheek);
  inset(cage, cheek, "cheek_left", 0.6, {0.045, -0.01, -0.06});
}

// The inside of the mouth gets a material of its own, along the edge loops of the lips.
void paint_mouth(QuadMesh& cage) {
  const Vec3 roof_lo(0, 0.2, 0.24), roof_hi(0.4, 0.5, 1.1), floor_lo(0, -0.3, 0.24);
  set_part(cage, select(cage, roof_lo, roof_hi, {0, -1, 0}), "upper_jaw:mouth");
  set_part(cage, select(cage, floor_lo, {0.4, 0.3, 1.05}, {0, 1, 0.4}), "lower_jaw:mouth");
  set_part(cage, select(cage, {0, 0.2, 0.2}, {0.4, 0.35, 0.26}, {0, 0, 1}), "head:mouth");
}

QuadMesh dragon_cage(const Clay& masses) {
  const Vec3 front(0, 0, 1), back(0, 0, -1);
  QuadMesh cage =
      half_box({0, 0.19, 0.40}, {0.0, 0.22, 0.32, 0.52, 0.76}, {-0.42, -0.22, 0.02, 0.24}, "head");
  const auto upper = select(cage, {0, 0.32, 0.2}, {0.4, 0.8, 0.3}, front);
  const auto lower = select(cage, {0, 0, 0.2}, {0.4, 0.22, 0.3}, front);
  const auto neck = select(cage, {0, 0, -0.5}, {0.4, 0.8, -0.4}, back);
  extrude_tube(cage, upper, "upper_jaw", kUpper);
  inset(cage, upper, "upper_jaw", 0.6, {0, 0, 0.05});
  extrude_tube(cage, lower, "lower_jaw", kLower);
  inset(cage, lower, "lower_jaw", 0.6, {0, 0, 0.05});
  extrude_tube(cage, neck, "neck", kNeck);
  inset(cage, neck, "neck", 0.6);
  paint_mouth(cage);
  fit_cage(cage, masses, {.rounds = 8, .relax = 0.4, .square = 0.3, .hold = 0.3, .max_step = 0.05});
  add_eye_loops(cage, masses);
  add_horns(cage, masses);
  add_all_spikes(cage, masses);
  return cage;
}

}  // namespace

Model make_dragon() {
  const Colour skin{0.42, 0.60, 0.47}, pale{0.62, 0.70, 0.50}, horn{0.86, 0.80, 0.66};
  WrapOptions middle{.rounds = 12, .relax = 0.5, .square = 0.5, .hold = 0.1, .max_step = 0.03};
  WrapOptions fine{.rounds = 20, .relax = 0.5, .square = 0.5, .hold = 0.05, .max_step = 0.02};
  return {shaped(dragon_cage(dragon_masses()), dragon_clay(), {middle, fine}),
          {{"head", skin},
           {"upper_jaw", skin},
           {"lower_jaw", pale},
           {"neck", skin},
           {"horn_left", horn},
           {"horn_right", horn},
           {"cheek_left", horn},
           {"cheek_right", horn},
           {"crest", {0.72, 0.46, 0.30}},
           {"mouth", {0.62, 0.27, 0.27}},
           {"tooth", {0.93, 0.90, 0.80}},
           {"eye", {0.90, 0.66, 0.20}}}};
}

}  // namespace flexkey::meshes
