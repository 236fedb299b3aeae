// What play.mjs runs inside the page.
import { AnimationMixer, LoopOnce, Vector3 } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';

let meshes, mixer, action;

const bytesOf = (base64) => Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));

function base64Of(floats) {
  const bytes = new Uint8Array(floats.buffer);
  let text = '';
  for (let i = 0; i < bytes.length; i += 0x8000) {
    text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  }
  return btoa(text);
}

/// The file's meshes in the order of its primitives.
function meshesOf(gltf) {
  const found = [];
  gltf.scene.traverse((object) => object.isMesh && found.push(object));
  const primitive = (mesh) => gltf.parser.associations.get(mesh).primitives;
  return found.sort((a, b) => primitive(a) - primitive(b));
}

/// Loads a GLB (base64) and starts one of its animations. Returns its length in seconds.
export async function load(base64, name) {
  const gltf = await new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).parseAsync(bytesOf(base64).buffer, '');
  meshes = meshesOf(gltf);
  mixer = new AnimationMixer(gltf.scene);
  action = mixer.clipAction(gltf.animations.find((animation) => animation.name === name));
  action.setLoop(LoopOnce);
  action.clampWhenFinished = true;
  gltf.scene.updateMatrixWorld(true);
  return action.getClip().duration;
}

/// Every vertex in the scene at a time: floats in base64.
export function positionsAt(time) {
  action.reset().play();
  mixer.setTime(time);
  const count = meshes.reduce((sum, mesh) => sum + mesh.geometry.attributes.position.count, 0);
  const positions = new Float32Array(count * 3);
  const point = new Vector3();
  let at = 0;
  for (const mesh of meshes) {
    for (let v = 0; v < mesh.geometry.attributes.position.count; ++v, at += 3) {
      mesh.getVertexPosition(v, point).applyMatrix4(mesh.matrixWorld).toArray(positions, at);
    }
  }
  return base64Of(positions);
}
