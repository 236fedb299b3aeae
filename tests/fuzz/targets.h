#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What reads bytes that may be hostile, each reader as a target of its own.
namespace flexkey::fuzz {

struct Target {
  std::string_view name;
  /// Hands the bytes to the reader. Returns where it takes them, or refuses them by an Error; any other
  /// exception, and a result that cannot be, ends the program.
  void (*run)(std::string_view bytes) = nullptr;
  /// Sound files that are not texts of the folder seeds/, made by the writers.
  std::vector<std::string> (*seeds)() = nullptr;
};

std::span<const Target> targets();

/// Nothing where there is no such target.
const Target* find_target(std::string_view name);

/// Ends the program where a result is not as it must be.
void promise(bool holds, std::string_view what);

void run_timeline(std::string_view bytes);
void run_cues(std::string_view bytes);
void run_table(std::string_view bytes);
void run_obj(std::string_view bytes);
void run_mtl(std::string_view bytes);
void run_ply(std::string_view bytes);
void run_off(std::string_view bytes);
void run_stl(std::string_view bytes);
void run_glb(std::string_view bytes);
void run_motion(std::string_view bytes);
void run_checkpoint(std::string_view bytes);
void run_frames(std::string_view bytes);

std::vector<std::string> no_seeds();
std::vector<std::string> ply_seeds();
std::vector<std::string> stl_seeds();
std::vector<std::string> glb_seeds();
std::vector<std::string> motion_seeds();
std::vector<std::string> checkpoint_seeds();
std::vector<std::string> frames_seeds();

}  // namespace flexkey::fuzz
