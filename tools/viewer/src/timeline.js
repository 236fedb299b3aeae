// The time line: λ over time, a ruler of frames, and the playhead that one drags.

const svg = (name, attributes) => {
  const element = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
};

/// A step of 1, 2 or 5 times a power of ten that gives at most `most` numbers.
function niceStep(count, most) {
  for (let power = 1; ; power *= 10) {
    for (const factor of [1, 2, 5]) if (count / (factor * power) <= most) return factor * power;
  }
}

function drawCurve(curve, frames, share) {
  curve.replaceChildren(svg('path', { class: 'grid', d: 'M0 0H1000M0 50H1000M0 100H1000' }));
  const points = frames.map((frame) => `${(1000 * share(frame)).toFixed(2)} ${(100 * (1 - frame.lambda)).toFixed(2)}`);
  const line = `M${points.join('L')}`;
  curve.append(svg('path', { class: 'area', d: `${line}V100H0Z` }), svg('path', { d: frames.length > 1 ? line : `${line}h1000` }));
}

function drawRuler(ruler, frames, share) {
  ruler.replaceChildren();
  const add = (name, frame, className = '') => {
    const element = document.createElement(name);
    element.style.left = `${100 * share(frame)}%`;
    element.className = className;
    ruler.append(element);
    return element;
  };
  const first = frames[0].number, last = frames.at(-1).number;
  const step = niceStep(last - first, ruler.clientWidth > 700 ? 12 : 6);
  for (const frame of frames) {
    if (frame.isKey) add('i', frame, 'key');
    if (frame.number % step !== 0) continue;
    add('i', frame);
    add('span', frame).textContent = frame.number;
  }
}

/// onScrub: called with the index of the frame to which the user drags.
export function createTimeline(element, onScrub) {
  const part = (id) => element.querySelector(`#${id}`);
  let frames = [], duration = 0;
  const share = (frame) => (duration > 0 ? frame.time / duration : 0);

  function scrub(event) {
    const box = part('ruler').getBoundingClientRect();
    const time = duration * Math.min(Math.max((event.clientX - box.left) / box.width, 0), 1);
    onScrub(nearest(time));
  }

  function nearest(time) {
    let best = 0;
    frames.forEach((frame, i) => { if (Math.abs(frame.time - time) < Math.abs(frames[best].time - time)) best = i; });
    return best;
  }

  function draw() {
    const hasLambda = frames.every((frame) => Number.isFinite(frame.lambda));
    element.classList.toggle('no-lambda', !hasLambda);
    if (hasLambda) drawCurve(part('curve'), frames, share);
    drawRuler(part('ruler'), frames, share);
  }

  element.addEventListener('pointerdown', (event) => {
    element.setPointerCapture(event.pointerId);
    scrub(event);
  });
  element.addEventListener('pointermove', (event) => {
    if (element.hasPointerCapture(event.pointerId)) scrub(event);
  });

  return {
    show(clip) {
      ({ frames, duration } = clip);
      element.setAttribute('aria-valuemax', frames.length - 1);
      draw();
    },
    draw,
    nearest,
    /// time: seconds; lambda: at that time
    moveTo(time, lambda) {
      const frame = frames[nearest(time)];
      part('playhead').style.setProperty('--at', `${duration > 0 ? (100 * time) / duration : 0}%`);
      part('playhead').style.setProperty('--lambda-now', lambda ?? 0);
      element.setAttribute('aria-valuenow', nearest(time));
      element.setAttribute('aria-valuetext', `frame ${frame.number}`);
    },
  };
}
