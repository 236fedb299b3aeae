// A page on which a click or a brush on a mesh gives a selection to paste into a timeline.
import { BufferAttribute, BufferGeometry, Color, Mesh, MeshStandardMaterial, Raycaster, Vector2, Vector3 } from 'three';
import { createStage } from '../stage.js';
import { Surface } from './surface.js';

const element = (id) => document.getElementById(id);
const tools = ['point', 'vertices', 'sphere', 'geodesic'];
const plain = new Color(0xc9beb1), picked = new Color(0x3b82f6);

function say(text) {
  element('message').textContent = text;
  element('message').hidden = false;
  element('dock').hidden = true;
}

/// Coordinates to about six digits of the mesh's size.
function yamlOfPoint(point, diagonal) {
  const digits = Math.max(0, 5 - Math.floor(Math.log10(diagonal)));
  return `[${point.map((value) => String(digits > 20 ? value : Number(value.toFixed(digits)))).join(', ')}]`;
}

/// The mesh as it is drawn, with a colour a vertex.
function drawnMesh(surface) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(surface.positions), 3));
  geometry.setAttribute('color', new BufferAttribute(new Float32Array(3 * surface.count), 3));
  geometry.setIndex(surface.triangles());
  geometry.computeVertexNormals();
  return new Mesh(geometry, new MeshStandardMaterial({ vertexColors: true, roughness: 0.75, side: 2 }));
}

class Picker {
  tool = 'geodesic';
  brushed = new Set();
  place = null;  // where the last click met the surface

  constructor(surface, stage, mesh) {
    Object.assign(this, { surface, stage, mesh, caster: new Raycaster() });
  }

  get radius() { return Number(element('radius').value); }  // percent of the diagonal

  /// Where the surface lies under the pointer, or nothing.
  hit(event) {
    const box = this.stage.canvas.getBoundingClientRect();
    const at = new Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
    this.caster.setFromCamera(at, this.stage.camera);
    return this.caster.intersectObject(this.mesh)[0]?.point.toArray() ?? null;
  }

  use(place, remove) {
    if (this.tool === 'vertices') {
      const near = this.surface.within(place, (this.radius / 100) * this.surface.diagonal / 3);
      for (const v of near.length > 0 ? near : [this.surface.nearest(place)]) {
        if (remove) this.brushed.delete(v);
        else this.brushed.add(v);
      }
    }
    this.place = place;
    this.show();
  }

  clear() {
    this.brushed.clear();
    this.place = null;
    this.show();
  }

  /// What is selected: {yaml, vertices}, or nothing.
  selection() {
    const { surface, place, tool } = this;
    if (tool === 'vertices') {
      const vertices = [...this.brushed];
      return vertices.length > 0 ? { yaml: `{vertices: ${surface.fileList(vertices)}}`, vertices } : null;
    }
    if (!place) return null;
    const vertex = surface.nearest(place), reach = (this.radius / 100) * surface.diagonal;
    const point = yamlOfPoint(surface.point(vertex), surface.diagonal);
    if (tool === 'point') return { yaml: point, vertices: [vertex] };
    if (tool === 'sphere') {
      return { yaml: `{sphere: {center: ${point}, radius: ${this.radius}%}}`, vertices: surface.within(JSON.parse(point), reach) };
    }
    return { yaml: `{geodesic: {from: ${point}, radius: ${this.radius}%}}`, vertices: surface.around(vertex, reach) };
  }

  show() {
    const selection = this.selection(), vertices = selection?.vertices ?? [];
    element('yaml').textContent = selection?.yaml ?? '';
    element('list').textContent = selection ? `{vertices: ${this.surface.fileList(vertices)}}` : '';
    element('copy').disabled = element('copy_list').disabled = !selection;
    const count = this.surface.fileCount(vertices);
    element('count').textContent = selection ? `${count} ${count === 1 ? 'vertex' : 'vertices'}` : 'Click the mesh; drag beside it to turn it.';
    element('radius_text').textContent = `${this.radius} %`;
    const colours = this.mesh.geometry.getAttribute('color'), taken = new Set(vertices);
    for (let v = 0; v < this.surface.count; ++v) {
      const { r, g, b } = taken.has(v) ? picked : plain;
      colours.setXYZ(v, r, g, b);
    }
    colours.needsUpdate = true;
  }

  choose(tool) {
    this.tool = tool;
    for (const name of tools) element(name).setAttribute('aria-pressed', name === tool);
    this.show();
  }
}

async function copy(button, text) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {  // a page from a file may have no clipboard
    const range = document.createRange();
    range.selectNodeContents(element(button === 'copy' ? 'yaml' : 'list'));
    getSelection().removeAllRanges();
    getSelection().addRange(range);
    document.execCommand('copy');
  }
  const { textContent } = element(button);
  element(button).textContent = 'Copied';
  setTimeout(() => { element(button).textContent = textContent; }, 900);
}

function listen(picker) {
  const { canvas, controls } = picker.stage;
  let isDown = false;
  // On the mesh the pointer selects, beside it and with the other buttons it turns the view.
  canvas.addEventListener('pointerdown', (event) => {
    const place = event.button === 0 ? picker.hit(event) : null;
    controls.enabled = !place;
    isDown = Boolean(place);
    if (place) picker.use(place, event.shiftKey);
  }, { capture: true });
  canvas.addEventListener('pointermove', (event) => {
    const place = isDown ? picker.hit(event) : null;
    if (place) picker.use(place, event.shiftKey);
  });
  addEventListener('pointerup', () => {
    isDown = false;
    controls.enabled = true;
  });
  for (const [index, tool] of tools.entries()) {
    element(tool).addEventListener('click', () => picker.choose(tool));
    addEventListener('keydown', ({ key }) => key === String(index + 1) && picker.choose(tool));
  }
  element('radius').addEventListener('input', () => picker.show());
  element('clear').addEventListener('click', () => picker.clear());
  addEventListener('keydown', ({ key }) => key === 'Escape' && picker.clear());
  element('copy').addEventListener('click', () => copy('copy', element('yaml').textContent));
  element('copy_list').addEventListener('click', () => copy('copy_list', element('list').textContent));
  new ResizeObserver(() => picker.stage.resize()).observe(canvas.parentElement);
}

function start() {
  const data = JSON.parse(element('mesh').textContent);
  document.title = `${data.name}: pick`;
  element('name').textContent = data.name;
  const surface = new Surface(data), mesh = drawnMesh(surface);
  element('facts').textContent = `${surface.ofFile.length.toLocaleString('en')} vertices`;
  const points = [...Array(surface.count).keys()].map((v) => new Vector3(...surface.point(v)));
  const stage = createStage(element('canvas'), surface, points);
  stage.scene.add(mesh);
  const picker = new Picker(surface, stage, mesh);
  listen(picker);
  picker.show();
  element('message').hidden = true;
  const draw = () => {
    stage.controls.update();
    stage.render();
    requestAnimationFrame(draw);
  };
  draw();
}

try {
  start();
} catch (error) {
  say(`The mesh cannot be shown: ${error.message}`);
}
