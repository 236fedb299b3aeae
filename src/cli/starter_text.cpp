#include "cli/starter_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/yaml_text.h"

namespace flexkey::cli {
namespace {

/// A line of YAML with its comment behind it, comments in one column where they fit.
std::string line(const std::string& yaml, const std::string& comment) {
  return fmt::format("{:<50}  # {}\n", yaml, comment);
}

/// "the +y +z end": where a part lies in the bounds.
std::string place_of(const StarterPart& part, const Bounds& bounds, const Positions& positions) {
  const Vec3 middle = positions(part.vertices, Eigen::all).colwise().mean().transpose();
  const Vec3 offset = (middle - (bounds.min + bounds.max) / 2).array() /
                      (bounds.max - bounds.min).array().max(1e-6 * bounds.diagonal());
  std::string place;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(offset[axis]) > 0.2)
      place += fmt::format("{}{} ", offset[axis] > 0 ? '+' : '-', "xyz"[axis]);
  return place.empty() ? "the middle" : fmt::format("the {}end", place);
}

std::string count_text(const StarterPart& part) {
  return fmt::format("{} {}", part.vertices.size(), part.vertices.size() == 1 ? "vertex" : "vertices");
}

/// Out, past rest to the other side, and back; later tips follow the first.
std::string swing_text(double angle, std::size_t number) {
  const double late = 0.2 * static_cast<double>(number);
  return fmt::format("{{{:g}s: 0deg, {:g}s: {:g}deg, {:g}s: {:g}deg, 3s: 0deg}}", late, late + 0.9, angle,
                     late + 1.9, -angle / 2);
}

}  // namespace

std::string starter_text(const Starter& starter, const Weld& weld, const StarterFiles& files) {
  const Positions& positions = weld.surface.positions;
  const Bounds bounds = bounds_of(positions);
  const std::string shot = quoted(files.shot);
  std::string text = fmt::format(
      "# A first timeline for {}, which runs as it is. Change it to what you want to see, then:\n"
      "#   flexkey check {}              what each selection takes\n"
      "#   flexkey animate {} -d out     writes out/{}.glb, and out/{}.html to look at it\n"
      "# The mesh lies in {} .. {}.\n",
      quoted(files.mesh), shot, shot, files.stem, files.stem, yaml_of(rounded(bounds.min, bounds.diagonal())),
      yaml_of(rounded(bounds.max, bounds.diagonal())));
  text += fmt::format("mesh: {}\n", quoted(files.mesh));
  text += line("lambda: 0.5", "0 bends smoothly, 1 keeps its shape; {0s: 0, 3s: 1} goes over");
  text += line("ease: ease-in-out", "from each key to the next; or linear, smooth, hold, ...");
  text += "handles:\n";
  text += line(fmt::format("  {}:", quoted(starter.base.name)), "without a motion: held where it is");
  text += line(fmt::format("    select: {}", starter.base.select), count_text(starter.base));
  for (std::size_t k = 0; k < starter.tips.size(); ++k) {
    const StarterTip& tip = starter.tips[k];
    text += line(fmt::format("  {}:", quoted(tip.part.name)), place_of(tip.part, bounds, positions));
    text += line(fmt::format("    select: {}", tip.part.select), count_text(tip.part));
    text += line(fmt::format("    pivot: {}", yaml_of(tip.joint)), "the joint about which it turns");
    text += fmt::format("    rotate:\n      axis: {}\n      keys: {}\n", yaml_of(tip.axis),
                        swing_text(tip.angle, k));
    if (k == 0)
      text +=
          "    # move: {keys: {0s: [0, 0, 0], 1s: [0, 0.1, 0], 3s: [0, 0, 0]}}   # an offset, in the mesh's "
          "units\n";
  }
  text += fmt::format("output: {{gltf: {}, html: {}}}\n", quoted(files.stem + ".glb"),
                      quoted(files.stem + ".html"));
  return text;
}

}  // namespace flexkey::cli
