#pragma once

#include <string>

namespace flexkey::cli {

/// The JSON Schema (draft 2020-12) of timelines, from the tables that their readers use: for editors that
/// complete and check. It takes all that the readers take; they alone know what fits together and what is
/// in the mesh.
std::string timeline_schema();

}  // namespace flexkey::cli
