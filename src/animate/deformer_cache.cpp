#include "flexkey/animate/deformer_cache.h"

#include <algorithm>

#include "flexkey/deform/surface_order.h"

namespace flexkey {

DeformerCache::DeformerCache(const Scene& scene, const DeformOptions& options, std::size_t bound)
    : scene_(scene),
      options_(options),
      bound_(bound),
      changes_(std::any_of(scene.handles.begin(), scene.handles.end(),
                           [](const SceneHandle& each) { return !each.handle.active.empty(); })) {}

std::shared_ptr<const Deformer> DeformerCache::of(const ActiveSet& active) {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& entry) { return entry.active == active; });
  if (found != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, found);
  } else {
    if (changes_ && order_.empty()) order_ = surface_order(scene_.weld.surface, options_);
    entries_.push_front({active, std::make_shared<Deformer>(
                                     scene_.weld.surface, constraints_of(scene_, active), options_, order_)});
    let_go();
  }
  return entries_.front().deformer;
}

void DeformerCache::let_go() {
  std::size_t bytes = 0;
  for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
    bytes += entry->deformer->bytes();
    if (bytes <= bound_ || entry == entries_.begin()) continue;
    entries_.erase(entry, entries_.end());
    return;
  }
}

}  // namespace flexkey
