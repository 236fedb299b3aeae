#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/load.h"
#include "flexkey/animate/clip.h"
#include "flexkey/gltf/write_glb.h"

namespace flexkey::cli {

/// A file that a run wrote.
struct WrittenFile {
  std::filesystem::path path;
  GltfReport gltf;
};

/// A vertex cache, a sequence of files or a USD file that a run wrote.
struct WrittenCache {
  std::filesystem::path path;  // of a sequence its pattern
  std::string_view format;     // "pc2"
  std::size_t files = 0;
  std::uintmax_t bytes = 0;  // of all files
  double seconds = 0;        // of writing
};

/// A page that a run wrote.
struct WrittenPage {
  std::filesystem::path path;
  std::uintmax_t bytes = 0;
  GltfReport gltf;     // of the GLB in it
  double seconds = 0;  // of writing
};

/// The pictures of a run.
struct WrittenPreview {
  std::filesystem::path path;  // their pattern, "nose/%04d.png"
  std::string_view format;     // "png"
  std::size_t drawn = 0;       // now
  std::size_t kept = 0;        // drawn before, from the same inputs
  double seconds = 0;          // of drawing and writing, beside the solve or after it
  std::string ffmpeg;          // the shell line that makes a film of them; none for a single picture
  std::vector<std::filesystem::path> files;  // GIF and sheet made of them
};

/// A pose that a run solved for its GLB.
struct PoseNote {
  std::string name;
  FrameReport solved;
};

/// One solve of the shot, one of several in a sweep.
struct RunReport {
  std::vector<SweptValue> swept = {};  // of a run of a sweep
  double lambda_first = 0, lambda_last = 0;
  std::vector<FrameReport> frames;  // every solved frame; those of a cycle's first lap have numbers below 0
  std::optional<double> gap;        // of a cycle, see Clip
  std::size_t solved_now = 0;       // of them; the others come from the shot's state
  bool claims_convergence = true;   // `preset: paper` does not
  std::vector<PoseNote> poses;
  double solve_seconds = 0, pose_seconds = 0, write_seconds = 0;
  std::vector<WrittenFile> written;
  std::vector<WrittenCache> caches;
  std::vector<WrittenPage> pages;
  std::vector<WrittenPreview> previews;

  std::size_t solved_before() const;
  int solves() const;
  std::vector<int> unconverged() const;
  std::vector<int> slipped() const;
  std::vector<std::string> unconverged_poses() const;
};

/// What a command did with runs that are solved together.
struct FamilyReport {
  std::string shot, file, hash;
  double fps = 24;
  int frames = 0;
  std::filesystem::path mesh;
  int vertices = 0, faces = 0;
  double load_seconds = 0;
  std::vector<std::string> warnings;  // whole lines
  std::vector<RunReport> runs;
};

/// Without runs yet.
FamilyReport family_report(const LoadedShot& loaded, double load_seconds);

/// What a command did with all runs of a shot, for scripts.
std::string report_json(const std::vector<FamilyReport>& families);

/// For a person, several lines.
std::string report_text(const FamilyReport& family);

}  // namespace flexkey::cli
