#include "flexkey/preview/tracer.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>

#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

// Ids of the geometries, in the order in which one hit is preferred to none.
constexpr unsigned kSurface = 0, kWires = 1, kDots = 2;
// Bits of the masks: what casts shadows, and what is only seen.
constexpr unsigned kSolid = 1, kMark = 2;

unsigned to_unsigned(std::size_t i) {
  return static_cast<unsigned>(i);
}

struct ReleaseDevice {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct ReleaseGeometry {
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using Device = std::unique_ptr<RTCDeviceTy, ReleaseDevice>;
using SceneHandle = std::unique_ptr<RTCSceneTy, ReleaseScene>;
using Geometry = std::unique_ptr<RTCGeometryTy, ReleaseGeometry>;

void check(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  if (error != RTC_ERROR_NONE)
    throw Error(fmt::format("Embree cannot trace the frame: error {}", static_cast<int>(error)));
}

Device make_device() {
  Device device(rtcNewDevice(nullptr));
  if (!device) throw Error("Embree does not run on this processor; draft quality does");
  return device;
}

/// A new buffer of `count` items of a geometry. Embree pads it for its vector loads.
template <class Item>
Item* new_buffer(const Geometry& geometry, RTCBufferType type, RTCFormat format, std::size_t count) {
  return static_cast<Item*>(rtcSetNewGeometryBuffer(geometry.get(), type, 0, format, sizeof(Item), count));
}

struct Sphere {
  float x, y, z, radius;
};

Geometry dots_of(RTCDevice device, const DrawnFrame& frame) {
  Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT));
  Sphere* spheres =
      new_buffer<Sphere>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, frame.dots.size());
  check(device);
  for (const Dot& dot : frame.dots) *spheres++ = {dot.centre.x(), dot.centre.y(), dot.centre.z(), dot.radius};
  return geometry;
}

Geometry wires_of(RTCDevice device, const DrawnFrame& frame) {
  const auto& wires = frame.surface.wires;
  Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE));
  Sphere* ends = new_buffer<Sphere>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 2 * wires.size());
  auto* firsts = new_buffer<unsigned>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, wires.size());
  check(device);
  for (std::size_t k = 0; k < wires.size(); ++k) {
    for (const int v : wires[k])
      *ends++ = {frame.points(v, 0), frame.points(v, 1), frame.points(v, 2), frame.wire_radius};
    *firsts++ = to_unsigned(2 * k);
  }
  return geometry;
}

RTCRay16 rays_of(const Rays& rays, unsigned mask) {
  RTCRay16 out;
  std::copy(rays.origin_x.begin(), rays.origin_x.end(), out.org_x);
  std::copy(rays.origin_y.begin(), rays.origin_y.end(), out.org_y);
  std::copy(rays.origin_z.begin(), rays.origin_z.end(), out.org_z);
  std::copy(rays.direction_x.begin(), rays.direction_x.end(), out.dir_x);
  std::copy(rays.direction_y.begin(), rays.direction_y.end(), out.dir_y);
  std::copy(rays.direction_z.begin(), rays.direction_z.end(), out.dir_z);
  std::copy(rays.reach.begin(), rays.reach.end(), out.tfar);
  std::fill_n(out.tnear, kLanes, 0.0f);
  std::fill_n(out.time, kLanes, 0.0f);
  std::fill_n(out.mask, kLanes, mask);
  std::fill_n(out.flags, kLanes, 0u);
  std::fill_n(out.id, kLanes, 0u);
  return out;
}

/// -1 for the lanes that are traced.
struct alignas(64) Valid {
  std::array<int, kLanes> lanes;
};

Valid valid_lanes(const std::bitset<kLanes>& active) {
  Valid valid;
  for (std::size_t k = 0; k < kLanes; ++k) valid.lanes[k] = active[k] ? -1 : 0;
  return valid;
}

Hit hit_of(const RTCRayHit16& traced, std::size_t lane) {
  Hit hit;
  const unsigned geometry = traced.hit.geomID[lane];
  if (geometry == RTC_INVALID_GEOMETRY_ID) return hit;
  hit.what = geometry == kSurface ? Hit::What::surface
             : geometry == kWires ? Hit::What::wire
                                  : Hit::What::dot;
  hit.index = static_cast<int>(traced.hit.primID[lane]);
  hit.u = traced.hit.u[lane];
  hit.v = traced.hit.v[lane];
  hit.distance = traced.ray.tfar[lane];
  return hit;
}

}  // namespace

void Rays::set(std::size_t lane, const Ray& ray, float far) {
  origin_x[lane] = ray.origin.x();
  origin_y[lane] = ray.origin.y();
  origin_z[lane] = ray.origin.z();
  direction_x[lane] = ray.direction.x();
  direction_y[lane] = ray.direction.y();
  direction_z[lane] = ray.direction.z();
  reach[lane] = far;
  is_active[lane] = true;
}

struct Tracer::Scene {
  Device device = make_device();
  SceneHandle scene{rtcNewScene(device.get())};
  Geometry surface{rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE)};
  float* vertices = nullptr;

  std::bitset<3> is_attached;

  void detach(unsigned id) {
    if (is_attached[id]) rtcDetachGeometry(scene.get(), id);
    is_attached[id] = false;
  }

  void attach(unsigned id, const Geometry& geometry, unsigned mask) {
    rtcSetGeometryBuildQuality(geometry.get(), RTC_BUILD_QUALITY_LOW);
    rtcSetGeometryMask(geometry.get(), mask);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(scene.get(), geometry.get(), id);
    is_attached[id] = true;
  }
};

Tracer::Tracer(const Surface& surface) : scene_(std::make_unique<Scene>()) {
  rtcSetSceneFlags(scene_->scene.get(),
                   static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_DYNAMIC | RTC_SCENE_FLAG_ROBUST));
  rtcSetSceneBuildQuality(scene_->scene.get(), RTC_BUILD_QUALITY_LOW);
  if (surface.triangles.empty()) return;
  using Corners = std::array<unsigned, 3>;
  const auto vertices = static_cast<std::size_t>(surface.vertex_count);
  auto* corners =
      new_buffer<Corners>(scene_->surface, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, surface.triangles.size());
  auto* points =
      new_buffer<std::array<float, 3>>(scene_->surface, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, vertices);
  check(scene_->device.get());
  for (const auto& [a, b, c] : surface.triangles)
    *corners++ = {static_cast<unsigned>(a), static_cast<unsigned>(b), static_cast<unsigned>(c)};
  scene_->vertices = reinterpret_cast<float*>(points);
  std::fill_n(scene_->vertices, 3 * vertices, 0.0f);
  scene_->attach(kSurface, scene_->surface, kSolid);
}

Tracer::~Tracer() = default;
Tracer::Tracer(Tracer&&) noexcept = default;
Tracer& Tracer::operator=(Tracer&&) noexcept = default;

void Tracer::update(const DrawnFrame& frame) {
  if (scene_->is_attached[kSurface]) {
    std::copy_n(frame.points.data(), frame.points.size(), scene_->vertices);
    rtcUpdateGeometryBuffer(scene_->surface.get(), RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(scene_->surface.get());
  }
  RTCDevice device = scene_->device.get();
  scene_->detach(kDots);
  scene_->detach(kWires);
  if (!frame.dots.empty()) scene_->attach(kDots, dots_of(device, frame), kMark);
  if (frame.wire_radius > 0 && !frame.surface.wires.empty())
    scene_->attach(kWires, wires_of(device, frame), kMark);
  rtcCommitScene(scene_->scene.get());
  check(device);
}

Hits Tracer::first_hits(const Rays& rays) const {
  const Valid valid = valid_lanes(rays.is_active);
  RTCRayHit16 traced;
  traced.ray = rays_of(rays, kSolid | kMark);
  std::fill_n(traced.hit.geomID, kLanes, RTC_INVALID_GEOMETRY_ID);
  std::fill_n(traced.hit.instID[0], kLanes, RTC_INVALID_GEOMETRY_ID);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect16(valid.lanes.data(), scene_->scene.get(), &context, &traced);
  Hits hits;
  for (std::size_t k = 0; k < kLanes; ++k)
    if (rays.is_active[k]) hits[k] = hit_of(traced, k);
  return hits;
}

std::bitset<kLanes> Tracer::blocked(const Rays& rays) const {
  std::bitset<kLanes> is_blocked;
  if (rays.is_active.none()) return is_blocked;
  const Valid valid = valid_lanes(rays.is_active);
  RTCRay16 traced = rays_of(rays, kSolid);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded16(valid.lanes.data(), scene_->scene.get(), &context, &traced);
  // Embree marks a ray that was stopped by a reach of minus infinity.
  for (std::size_t k = 0; k < kLanes; ++k) is_blocked[k] = rays.is_active[k] && traced.tfar[k] < 0;
  return is_blocked;
}

}  // namespace flexkey
