// The words beside the buttons: frame, seconds and λ.

function strong(text, className = '') {
  const element = document.createElement('b');
  element.textContent = text;
  element.className = className;
  return element;
}

/// frame: counted from the clip's first.
export function showReadout(output, clip, frame, { time, lambda }) {
  const gap = '\u2003';
  output.replaceChildren('frame ', strong(clip.frames[frame].number), ` / ${clip.frames.at(-1).number}`, gap,
    strong(`${time.toFixed(2)} s`));
  if (Number.isFinite(lambda)) output.append(gap, strong(`λ ${lambda.toFixed(2)}`, 'lambda'));
}
