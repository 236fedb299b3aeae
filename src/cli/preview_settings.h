#pragma once

#include <vector>

#include "cli/load.h"
#include "flexkey/preview/camera.h"
#include "flexkey/preview/images/image_format.h"
#include "flexkey/preview/images/overlay.h"
#include "flexkey/preview/images/sequence.h"
#include "flexkey/preview/render_options.h"

namespace flexkey::cli {

// What output.preview asks, in the renderer's terms.

CameraSettings camera_settings(const PreviewOutput& preview);

/// But for the texture and the top of the displacement's scale.
RenderOptions render_options(const LoadedShot& loaded);

/// The pictures of a run.
PictureSequence sequence_of(const PreviewOutput& preview, const ShotOptions& options);

/// The frames that are drawn: of those that the preview names, those that `--frames` does.
std::vector<int> drawn_frames(const Shot& run, const ShotOptions& options);

/// Every frame's time and λ, for the overlay.
std::vector<Moment> moments_of(const Shot& run);

}  // namespace flexkey::cli
