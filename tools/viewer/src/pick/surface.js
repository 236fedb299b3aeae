// The surface that selections are made on, and what each kind of selection takes: as flexkey's select.cpp and
// geodesic.cpp do, so that the page shows what the timeline will get.

function numbersOf(base64, Type) {
  return new Type(Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)).buffer);
}

/// A queue of [distance, vertex], nearest first.
class Front {
  #heap = [];
  get isEmpty() { return this.#heap.length === 0; }

  push(entry) {
    const heap = this.#heap;
    let at = heap.push(entry) - 1;
    for (let up = (at - 1) >> 1; at > 0 && heap[up][0] > heap[at][0]; at = up, up = (at - 1) >> 1) {
      [heap[at], heap[up]] = [heap[up], heap[at]];
    }
  }

  pop() {
    const heap = this.#heap, top = heap[0], last = heap.pop();
    if (heap.length === 0) return top;
    heap[0] = last;
    for (let at = 0; ;) {
      let least = at;
      for (const child of [2 * at + 1, 2 * at + 2]) {
        if (child < heap.length && heap[child][0] < heap[least][0]) least = child;
      }
      if (least === at) return top;
      [heap[at], heap[least]] = [heap[least], heap[at]];
      at = least;
    }
  }
}

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const length = (a) => Math.sqrt(dot(a, a));

/// Distance at c from those at a and b of its triangle, for one source behind ab; the better of the two edges where
/// the way does not cross ab.
function march(a, b, c, atA, atB) {
  const ac = minus(c, a), ab = minus(b, a), base = length(ab);
  const alongEdges = Math.min(atA + length(ac), atB + length(minus(c, b)));
  if (base <= 0 || Math.abs(atA - atB) > base) return alongEdges;
  const cX = dot(ac, ab) / base, cY = Math.sqrt(Math.max(0, dot(ac, ac) - cX * cX));
  const sourceX = (atA * atA - atB * atB + base * base) / (2 * base);
  const sourceY = -Math.sqrt(Math.max(0, atA * atA - sourceX * sourceX));
  if (cY - sourceY <= 0) return alongEdges;
  const crossing = sourceX - sourceY * (cX - sourceX) / (cY - sourceY);
  return crossing >= 0 && crossing <= base ? Math.min(alongEdges, Math.hypot(cX - sourceX, cY - sourceY)) : alongEdges;
}

/// data: {positions: #S x 3 doubles, offsets: #F + 1, corners, surface: #V, the surface vertex of each of the
/// file's}, each as base64 of little-endian numbers.
export class Surface {
  constructor(data) {
    this.positions = numbersOf(data.positions, Float64Array);
    this.offsets = numbersOf(data.offsets, Int32Array);
    this.corners = numbersOf(data.corners, Int32Array);
    this.ofFile = numbersOf(data.surface, Int32Array);
    this.count = this.positions.length / 3;
    this.min = [Infinity, Infinity, Infinity];
    this.max = [-Infinity, -Infinity, -Infinity];
    this.positions.forEach((value, k) => {
      this.min[k % 3] = Math.min(this.min[k % 3], value);
      this.max[k % 3] = Math.max(this.max[k % 3], value);
    });
    this.diagonal = length(minus(this.max, this.min));
    this.rounding = 1e-9 * this.diagonal;
  }

  point(v) { return [this.positions[3 * v], this.positions[3 * v + 1], this.positions[3 * v + 2]]; }

  face(f) { return this.corners.subarray(this.offsets[f], this.offsets[f + 1]); }

  /// Triangle fans, for drawing.
  triangles() {
    const triangles = [];
    for (let f = 0; f + 1 < this.offsets.length; ++f) {
      const face = this.face(f);
      for (let k = 1; k + 1 < face.length; ++k) triangles.push(face[0], face[k], face[k + 1]);
    }
    return triangles;
  }

  nearest(place) {
    let best = 0, least = Infinity;
    for (let v = 0; v < this.count; ++v) {
      const offset = minus(this.point(v), place), squared = dot(offset, offset);
      if (squared < least) [best, least] = [v, squared];
    }
    return best;
  }

  within(centre, radius) {
    return [...Array(this.count).keys()].filter((v) => length(minus(this.point(v), centre)) <= radius + this.rounding);
  }

  /// The triangles around each vertex: every fan of a polygon's corners, so that a quad has both diagonals.
  #oppositeEdges() {
    if (this.opposite) return this.opposite;
    this.opposite = Array.from({ length: this.count }, () => []);
    for (let f = 0; f + 1 < this.offsets.length; ++f) {
      const face = this.face(f), n = face.length;
      for (let i = 0; i < n; ++i) {
        for (let k = 1; k + 1 < n; ++k) {
          const a = face[i], b = face[(i + k) % n], c = face[(i + k + 1) % n];
          this.opposite[a].push([b, c]);
          if (n > 3) {
            this.opposite[b].push([c, a]);
            this.opposite[c].push([a, b]);
          }
        }
      }
    }
    return this.opposite;
  }

  /// Fast marching from one vertex.
  around(source, radius) {
    const opposite = this.#oppositeEdges(), distance = new Float64Array(this.count).fill(Infinity), front = new Front();
    const lower = (v, candidate) => {
      if (candidate >= distance[v]) return;
      distance[v] = candidate;
      front.push([candidate, v]);
    };
    lower(source, 0);
    while (!front.isEmpty) {
      const [reached, v] = front.pop();
      if (reached > distance[v] || reached > radius) continue;
      for (const [a, b] of opposite[v]) {
        lower(a, march(this.point(v), this.point(b), this.point(a), reached, distance[b]));
        lower(b, march(this.point(v), this.point(a), this.point(b), reached, distance[a]));
      }
    }
    return [...distance.keys()].filter((v) => distance[v] <= radius + this.rounding);
  }

  /// The file's vertices that these of the surface stand for, as a timeline lists them: "[0, 12-40]".
  fileList(vertices) {
    const taken = new Set(vertices), ranges = [];
    this.ofFile.forEach((v, index) => {
      if (!taken.has(v)) return;
      if (ranges.length > 0 && ranges.at(-1)[1] === index - 1) ranges.at(-1)[1] = index;
      else ranges.push([index, index]);
    });
    return `[${ranges.map(([first, last]) => (first === last ? first : `${first}-${last}`)).join(', ')}]`;
  }

  fileCount(vertices) {
    const taken = new Set(vertices);
    return this.ofFile.reduce((count, v) => count + taken.has(v), 0);
  }
}
