// The GLB: its meshes, its clips, and the pose at a time.
import { AnimationMixer, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

/// Lines over the faces, which follow the same morph targets.
function wireframeOf(mesh) {
  const material = new MeshBasicMaterial({ wireframe: true, color: 0x0b0d10, transparent: true, opacity: 0.3, depthWrite: false });
  const wires = new Mesh(mesh.geometry, material);
  wires.morphTargetInfluences = mesh.morphTargetInfluences;
  wires.frustumCulled = false;
  return wires;
}

/// Where the frames of an animation lie in it: the shot's frames that it plays. times: seconds, from 0.
function framesOf(animation, from) {
  const { fps = 24, sourceFrames, lambda = [], keyFrames = [] } = animation.userData;
  const numbers = sourceFrames ?? [...Array(Math.floor(animation.duration * fps + 1e-6) + 1).keys()];
  const slack = 1e-3 / fps;
  const frames = numbers.map((number, index) => (
    { number, time: (number - numbers[0]) / fps - from, lambda: lambda[index], index: sourceFrames ? index : NaN,
      isKey: keyFrames.includes(number) }
  )).filter(({ time }) => time >= -slack && time <= animation.duration + slack);
  for (const frame of frames) frame.time = Math.min(Math.max(frame.time, 0), animation.duration);
  return frames.length > 0 ? frames : [{ number: numbers[0], time: 0, lambda: lambda[0], index: sourceFrames ? 0 : NaN }];
}

/// starts: a map from the names of clips that are parts of the shot to seconds from its first frame.
export async function loadActor(base64, starts) {
  const gltf = await new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).parseAsync(bytesOf(base64).buffer, '');
  const meshes = [], wires = [];
  gltf.scene.traverse((object) => object.isMesh && meshes.push(object));
  for (const mesh of meshes) {
    mesh.frustumCulled = false;  // its bounds are those of rest
    mesh.castShadow = mesh.receiveShadow = true;
    Object.assign(mesh.material, { polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    wires.push(wireframeOf(mesh));
    wires.at(-1).visible = false;
    mesh.add(wires.at(-1));
  }
  const mixer = new AnimationMixer(gltf.scene);
  const clips = gltf.animations.map((animation) => {
    const from = starts.get(animation.name) ?? 0;
    return { name: animation.name, from, animation, duration: animation.duration,
             fps: animation.userData.fps ?? 24, facts: animation.userData, frames: framesOf(animation, from) };
  });
  let action;

  function choose(clip) {
    mixer.stopAllAction();
    action = mixer.clipAction(clip.animation).play();
  }

  /// time: seconds in the chosen clip, its very end included
  function pose(time) {
    action.time = time;
    mixer.update(0);
  }

  /// Some points of the surface, in the scene, at some times of every clip.
  function samplePoints() {
    const most = 800, poses = 8;
    const points = [];
    gltf.scene.updateMatrixWorld(true);
    for (const clip of clips) {
      choose(clip);
      for (let i = 0; i < poses; ++i) {
        pose((clip.duration * i) / (poses - 1));
        for (const mesh of meshes) {
          const count = mesh.geometry.attributes.position.count;
          for (let v = 0; v < count; v += Math.ceil(count / most)) {
            points.push(mesh.getVertexPosition(v, new Vector3()).applyMatrix4(mesh.matrixWorld));
          }
        }
      }
    }
    return points;
  }

  return {
    root: gltf.scene,
    clips,
    firstClip: clips.find(({ facts }) => facts.sourceFrames) ?? clips[0],  // a file may bring clips of its own
    choose,
    pose,
    samplePoints,
    showWireframe(visible) {
      for (const wire of wires) wire.visible = visible;
      // Faces step back a little under their lines, so that these are whole.
      for (const mesh of meshes) mesh.material.polygonOffset = visible;
    },
    vertexCount: meshes.reduce((sum, mesh) => sum + mesh.geometry.attributes.position.count, 0),
  };
}
