#pragma once

#include <filesystem>
#include <vector>

#include "cli/options.h"
#include "flexkey/timeline/shot.h"

namespace flexkey::cli {

/// Makes the GIF of a run from its pictures as they lie on disk, so that it is the same whether they were
/// drawn now or before. Throws InputError or OutputError.
void write_gif_of(const Shot& run, const ShotOptions& options);

/// Makes the sheet that these runs share: of one run its times in a row, of several a row a time and a column
/// a run.
void write_sheet_of(const std::vector<const Shot*>& runs, const ShotOptions& options);

}  // namespace flexkey::cli
