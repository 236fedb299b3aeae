// The handles as the paper's figures show them: blue where they are led, red where they are held.
import { Group, InstancedMesh, Matrix4, MeshBasicMaterial, OctahedronGeometry, SphereGeometry, Vector3 } from 'three';

const apparentSize = 0.0075;  // of a marker, as a share of its distance from the camera

// Colour is not the only sign of what is held: it is angular, too.
const shapes = {
  handle: { geometry: new SphereGeometry(1, 20, 14), color: 0x56a8ff },
  anchor: { geometry: new OctahedronGeometry(1.25), color: 0xff5d4d },
};

/// Markers show through the surface, since most handles lie in it.
function markersOf(handle) {
  const { geometry, color } = shapes[handle.anchor ? 'anchor' : 'handle'];
  const material = new MeshBasicMaterial({ color, depthTest: false, transparent: true, opacity: 0.9, toneMapped: false });
  const markers = new InstancedMesh(geometry, material, handle.points);
  markers.frustumCulled = false;
  markers.renderOrder = 1;
  return markers;
}

function labelOf(handle) {
  const label = document.createElement('span');
  label.textContent = handle.name;
  label.className = handle.anchor ? 'anchor' : 'handle';
  return label;
}

/// The point of a handle at a frame, which may lie between two; nothing where the handle does not hold.
function pointAt(handle, frame, point) {
  const before = handle.positions[Math.floor(frame)], after = handle.positions[Math.ceil(frame)];
  if (!before || !after) return null;
  const share = frame - Math.floor(frame);
  const at = [0, 1, 2].map((axis) => before[3 * point + axis] * (1 - share) + after[3 * point + axis] * share);
  return new Vector3(...at);
}

/// handles: [{name, anchor, points, positions: [[x, y, z, …] or null a frame]}]
export function createMarkers(handles, stage, labels) {
  const group = new Group();
  stage.scene.add(group);
  const shown = handles.map((handle) => {
    const entry = { handle, markers: markersOf(handle), label: labelOf(handle) };
    group.add(entry.markers);
    labels.append(entry.label);
    entry.width = entry.label.offsetWidth;
    return entry;
  });

  function place({ handle, markers, label, width }, frame) {
    const { camera, canvas } = stage;
    const points = [...Array(handle.points).keys()].map((point) => pointAt(handle, frame, point));
    const holds = points.every(Boolean);
    markers.visible = holds;
    label.hidden = !holds;
    if (!holds) return;
    const slim = handle.points > 1 ? 0.5 : 1;
    points.forEach((point, i) => {
      const size = slim * apparentSize * point.distanceTo(camera.position);
      markers.setMatrixAt(i, new Matrix4().makeScale(size, size, size).setPosition(point));
    });
    markers.instanceMatrix.needsUpdate = true;
    const centre = points[Math.floor(points.length / 2)].clone().project(camera);
    label.hidden = centre.z > 1;
    const x = (centre.x * 0.5 + 0.5) * canvas.clientWidth, y = (0.5 - centre.y * 0.5) * canvas.clientHeight - 9;
    const fits = x + 12 + width < canvas.clientWidth;  // else it goes to the marker's left
    label.style.transform = `translate(${(fits ? x + 12 : x - 12 - width).toFixed(1)}px, ${y.toFixed(1)}px)`;
  }

  return {
    /// frame: an index of the handles' positions, also between two
    update(frame) {
      for (const entry of shown) place(entry, frame);
    },
    show(visible) {
      group.visible = visible;
      labels.hidden = !visible;
    },
  };
}
