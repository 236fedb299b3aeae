#pragma once

#include <list>
#include <memory>
#include <vector>

#include "flexkey/animate/active_set.h"
#include "flexkey/deform/deformer.h"

namespace flexkey {

/// The deformers of one scene, a set of active handles each, made where they are first asked for. They share
/// one order of elimination. Those asked for longest ago are let go while all together hold more than
/// `most_bytes`.
class DeformerCache {
 public:
  static constexpr std::size_t most_bytes = std::size_t{1} << 30;

  DeformerCache(const Scene& scene, const DeformOptions& options, std::size_t bound = most_bytes);

  /// Throws DeformError if the surface cannot be solved with these handles.
  std::shared_ptr<const Deformer> of(const ActiveSet& active);

  /// How many are held.
  std::size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    ActiveSet active;
    std::shared_ptr<const Deformer> deformer;
  };
  void let_go();

  const Scene& scene_;
  DeformOptions options_;
  std::size_t bound_;
  bool changes_;              // whether handles take hold and let go
  std::vector<int> order_;    // see surface_order; empty where one set serves the whole shot
  std::list<Entry> entries_;  // the one last asked for first
};

}  // namespace flexkey
