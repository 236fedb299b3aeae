// A page that plays one shot. What it shows lies in two blocks of the page: `shot` (JSON) and `glb` (base64).
import { loadActor } from './actor.js';
import { listen } from './controls.js';
import { createMarkers } from './markers.js';
import { Player } from './player.js';
import { createStage } from './stage.js';

const element = (id) => document.getElementById(id);

function say(text) {
  element('message').textContent = text;
  element('message').hidden = false;
  element('dock').hidden = true;
}

function hasWebGL() {
  try {
    return Boolean(document.createElement('canvas').getContext('webgl2'));
  } catch {
    return false;
  }
}

function factsOf(actor) {
  const { facts, frames, fps } = actor.firstClip;
  const total = facts.frames ?? frames.length;
  return [`${total} frames`, `${fps} fps`, `${actor.vertexCount.toLocaleString('en')} vertices`, facts.profile]
    .filter(Boolean).join(' · ');
}

async function start() {
  const shot = JSON.parse(element('shot').textContent);
  document.title = shot.name;
  element('name').textContent = shot.name;
  if (!hasWebGL()) {
    say('This page draws with WebGL 2, which this browser does not have or has switched off.');
    return;
  }
  element('message').hidden = true;
  const actor = await loadActor(element('glb').textContent, new Map(Object.entries(shot.starts)));
  element('facts').textContent = factsOf(actor);
  const stage = createStage(element('canvas'), shot.bounds, actor.samplePoints());
  stage.scene.add(actor.root);
  listen(new Player(stage, actor, createMarkers(shot.handles, stage, element('labels'))));
}

start().catch((error) => say(`The shot cannot be shown: ${error.message}`));
