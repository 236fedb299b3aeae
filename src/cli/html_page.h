#pragma once

#include <vector>

#include "cli/load.h"
#include "cli/report.h"
#include "flexkey/animate/clip.h"
#include "flexkey/animate/scene.h"
#include "flexkey/html/write_page.h"

namespace flexkey::cli {

/// Throws TimelineError for a page that is no .html, or would replace an input or the run's GLB.
void check_pages(const LoadedShot& loaded, const ShotOptions& options, const std::vector<Shot>& runs);

/// Throws OutputError for what cannot be written now. Checked before hours of solving.
void probe_pages(const ShotOptions& options, const std::vector<Shot>& runs);

/// A run of the shot, solved.
struct SolvedRun {
  const Shot& shot;
  const Scene& scene;
  const Clip& clip;
};

/// The handles of a shot as its page marks them at the frames of the clip: in their middle, or along their
/// chain.
std::vector<PageHandle> page_handles(const SolvedRun& run);

/// Writes the run's page with the GLB that is `written` already; or else with one of its own, as `gltf` has
/// it where the shot names a GLB, and of the profile `web` where it names none.
WrittenPage write_html_page(const SolvedRun& run, const GltfOptions& gltf, const std::filesystem::path& path,
                            const std::vector<WrittenFile>& written);

}  // namespace flexkey::cli
