// What the mesh stands in: renderer, light and camera.
import {
  BackSide, BoxGeometry, DirectionalLight, Mesh, MeshBasicMaterial, NeutralToneMapping,
  PerspectiveCamera, PMREMGenerator, Scene, Vector3, WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

/// A box of shape `size` at `at` that shines, for the studio.
function lamp(size, at, brightness) {
  const material = new MeshBasicMaterial();
  material.color.setScalar(brightness);
  const mesh = new Mesh(new BoxGeometry(...size), material);
  mesh.position.set(...at);
  return mesh;
}

/// A dim room with a large soft light above, one at the left and a rim light behind.
function studio() {
  const room = new Scene();
  const walls = new Mesh(new BoxGeometry(20, 20, 20), new MeshBasicMaterial({ side: BackSide }));
  walls.material.color.setScalar(0.28);
  room.add(walls, lamp([12, 0.2, 8], [0, 9, 2], 5), lamp([0.2, 8, 8], [-9, 2, 3], 2.5), lamp([7, 5, 0.2], [4, 4, -9], 4));
  return room;
}

/// The light comes over the viewer's left shoulder, so that form shows from wherever one looks.
function keyLight(radius) {
  const key = new DirectionalLight(0xfff4e6, 2.2);
  key.castShadow = true;
  key.shadow.mapSize.set(2048, 2048);
  key.shadow.radius = 6;
  key.shadow.normalBias = radius / 200;
  key.shadow.bias = -0.0005;
  const reach = { left: -radius, right: radius, top: radius, bottom: -radius, near: radius, far: 7 * radius };
  Object.assign(key.shadow.camera, reach);
  return key;
}

/// The distance from which a camera that looks along `-direction` has all points in its picture. The points
/// are relative to what it looks at.
function fittingDistance(camera, points, direction) {
  const right = new Vector3().crossVectors(camera.up, direction).normalize();
  const up = new Vector3().crossVectors(direction, right);
  const tall = Math.tan((camera.fov * Math.PI) / 360), wide = tall * camera.aspect;
  return points.reduce((most, point) => Math.max(most, point.dot(direction) +
    Math.max(Math.abs(point.dot(right)) / wide, Math.abs(point.dot(up)) / tall)), 0);
}

/// bounds: {min, max} of everything that is ever shown; points: what the first view must hold.
export function createStage(canvas, bounds, points) {
  const renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
  renderer.toneMapping = NeutralToneMapping;
  renderer.shadowMap.enabled = true;

  const scene = new Scene();
  const pmrem = new PMREMGenerator(renderer);
  scene.environment = pmrem.fromScene(studio(), 0.03).texture;
  scene.environmentIntensity = 0.55;

  const low = new Vector3(...bounds.min), high = new Vector3(...bounds.max);
  const centre = low.clone().add(high).multiplyScalar(0.5);
  const size = high.clone().sub(low);
  const radius = Math.max(size.length() / 2, 1e-9);
  const around = points.map((point) => point.clone().sub(centre));

  const camera = new PerspectiveCamera(32, 1, radius / 100, radius * 100);
  const controls = new OrbitControls(camera, canvas);
  controls.enableDamping = true;
  controls.minDistance = radius / 20;
  controls.maxDistance = radius * 30;

  const key = keyLight(radius);
  key.target.position.copy(centre);
  scene.add(camera, key, key.target);

  let isAtStart = true;
  controls.addEventListener('start', () => { isAtStart = false; });

  function lookFromTheStart() {
    // What is long away from the viewer is seen more from its side.
    const azimuth = (size.z > 1.5 * size.x ? 62 : 34) * (Math.PI / 180), elevation = 14 * (Math.PI / 180);
    const direction = new Vector3(Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation), Math.cos(azimuth) * Math.cos(elevation));
    controls.target.copy(centre);
    camera.position.copy(centre).addScaledVector(direction, 1.12 * fittingDistance(camera, around, direction));
    controls.update();
    isAtStart = true;
  }

  function resize() {
    const { clientWidth, clientHeight } = canvas;
    renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    renderer.setSize(clientWidth, clientHeight, false);
    camera.aspect = clientWidth / Math.max(clientHeight, 1);
    camera.updateProjectionMatrix();
    if (isAtStart) lookFromTheStart();
  }

  function render() {
    key.position.copy(centre).addScaledVector(new Vector3(-0.65, 0.75, 0.9).normalize()
      .applyQuaternion(camera.quaternion), 4 * radius);
    renderer.render(scene, camera);
  }

  resize();
  return { scene, camera, controls, canvas, resize, render, lookFromTheStart };
}
