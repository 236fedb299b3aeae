#include "blob.h"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "sphere_triangulation.h"

namespace flexkey::bench {
namespace {

/// Numbers that every standard library draws alike.
class Random {
 public:
  /// In [-1, 1).
  double number() { return static_cast<double>(bits_() >> 11) * 0x1p-52 - 1; }
  Vec3 in_cube() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }

 private:
  std::mt19937_64 bits_{20061104};
};

/// Moves every point by up to the length of its shortest edge, in small rounds, so that the triangulation
/// can follow.
void strew(SphereTriangulation& sphere, Random& random) {
  constexpr int rounds = 3;
  constexpr double share = 0.35;  // of the shortest edge, a round
  for (int round = 0; round < rounds; ++round) {
    for (int v = 0; v < sphere.point_count(); ++v) {
      const Vec3 step = share * sphere.shortest_edge(v) * random.in_cube();
      sphere.move(v, (sphere.point(v) + step).normalized());
    }
    sphere.make_delaunay();
  }
}

struct Wave {
  Vec3 direction;
  double phase = 0;
};

std::vector<Wave> make_waves(Random& random) {
  constexpr int count = 12;
  constexpr double highest = 5;  // radians a unit of length
  std::vector<Wave> waves;
  for (int k = 0; k < count; ++k) {
    const Vec3 direction = highest * random.in_cube();
    waves.push_back({direction, std::numbers::pi * random.number()});
  }
  return waves;
}

double radius(const std::vector<Wave>& waves, const Vec3& at) {
  constexpr double height = 0.03;  // of one wave
  double sum = 0;
  for (const Wave& wave : waves) sum += std::sin(wave.direction.dot(at) + wave.phase);
  return 1 + height * sum;
}

}  // namespace

Mesh make_blob(int size) {
  Random random;
  SphereTriangulation sphere = SphereTriangulation::octahedron(size);
  strew(sphere, random);
  const std::vector<Wave> waves = make_waves(random);
  Mesh mesh;
  mesh.positions.resize(sphere.point_count(), 3);
  for (int v = 0; v < sphere.point_count(); ++v)
    mesh.positions.row(v) = (radius(waves, sphere.point(v)) * sphere.point(v)).transpose();
  for (int t = 0; t < sphere.triangle_count(); ++t) mesh.add_face(sphere.triangle(t));
  return mesh;
}

}  // namespace flexkey::bench
