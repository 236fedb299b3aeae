#include "flexkey/html/write_page.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "flexkey/html/base64.h"
#include "flexkey/html/script_text.h"
#include "flexkey/html/viewer.h"
#include "flexkey/mesh/output_file.h"

namespace flexkey {
namespace {

/// JSON whose numbers are floats, which take half the digits of doubles.
using Json =
    nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t, std::uint64_t, float>;

Json numbers(const Eigen::Ref<const Eigen::RowVectorXd>& row) {
  Json list = Json::array();
  for (const double value : row) list.push_back(static_cast<float>(value));
  return list;
}

/// Of everything that the clip ever shows.
Json bounds_json(const Clip& clip) {
  Eigen::RowVector3d low = clip.mesh.positions.colwise().minCoeff();
  Eigen::RowVector3d high = clip.mesh.positions.colwise().maxCoeff();
  for (const Positions& frame : clip.frames) {
    low = low.cwiseMin(frame.colwise().minCoeff());
    high = high.cwiseMax(frame.colwise().maxCoeff());
  }
  return {{"min", numbers(low)}, {"max", numbers(high)}};
}

Json handle_json(const PageHandle& handle) {
  Json positions = Json::array();
  Eigen::Index points = 0;
  for (const Positions& frame : handle.points) {
    points = std::max(points, frame.rows());
    positions.push_back(frame.rows() == 0 ? Json() : numbers(frame.reshaped<Eigen::RowMajor>().transpose()));
  }
  return {{"name", handle.name},
          {"anchor", handle.is_anchor},
          {"points", points},
          {"positions", std::move(positions)}};
}

Json shot_json(const Clip& clip, const PageContents& contents) {
  Json handles = Json::array(), starts = Json::object();
  for (const PageHandle& handle : contents.handles) handles.push_back(handle_json(handle));
  for (const PageClip& part : contents.clips) starts[part.name] = static_cast<float>(part.from);
  return {{"name", clip.name},
          {"bounds", bounds_json(clip)},
          {"starts", std::move(starts)},
          {"handles", std::move(handles)}};
}

}  // namespace

std::uintmax_t write_page(const Clip& clip, const PageContents& contents, const std::filesystem::path& path) {
  constexpr std::string_view shot_place = "@shot@", glb_place = "@glb@";
  const std::string_view page = viewer_page();
  const std::size_t shot = page.find(shot_place), glb = page.find(glb_place);
  const std::size_t after_shot = shot + shot_place.size();
  OutputFile file(path);
  file.write(page.substr(0, shot));
  file.write(script_text(shot_json(clip, contents).dump(-1, ' ', false, Json::error_handler_t::replace)));
  file.write(page.substr(after_shot, glb - after_shot));
  file.write(base64(contents.glb));
  file.write(page.substr(glb + glb_place.size()));
  file.commit();
  return file.bytes_written();
}

}  // namespace flexkey
