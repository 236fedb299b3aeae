// Keys and buttons, and what they do.

const element = (id) => document.getElementById(id);

const keyOfButton = {
  play: ' ', back: 'ArrowLeft', on: 'ArrowRight', wireframe: 'w', handles: 'h', reset: 'r', help: '?',
};

function toggle(button, show) {
  const isPressed = element(button).getAttribute('aria-pressed') !== 'true';
  element(button).setAttribute('aria-pressed', isPressed);
  show(isPressed);
}

function toggleHelp() {
  element('keys').hidden = !element('keys').hidden;
  element('help').setAttribute('aria-expanded', !element('keys').hidden);
}

function actionsOf(player) {
  const { stage, actor, markers } = player;
  return {
    ' ': () => player.play(!player.isPlaying),
    ArrowLeft: () => player.step(-1),
    ArrowRight: () => player.step(1),
    Home: () => player.goTo(0),
    End: () => player.goTo(player.clip.frames.length - 1),
    w: () => toggle('wireframe', actor.showWireframe),
    h: () => toggle('handles', markers.show),
    r: stage.lookFromTheStart,
    '?': toggleHelp,
    Escape: () => element('keys').hidden || toggleHelp(),
  };
}

function offerClips(player) {
  const list = element('clips'), { clips, firstClip } = player.actor;
  list.hidden = clips.length < 2;
  list.append(...clips.map(({ name }, index) => new Option(name, index)));
  list.value = clips.indexOf(firstClip);
  list.addEventListener('change', () => {
    player.choose(clips[list.value]);
    list.blur();  // so that the keys are the player's again
  });
}

export function listen(player) {
  const actions = actionsOf(player);
  const act = (key) => {
    actions[key]();
    player.redraw();
  };
  for (const [id, key] of Object.entries(keyOfButton)) element(id).addEventListener('click', () => act(key));
  addEventListener('keydown', (event) => {
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const isForAnother = event.ctrlKey || event.metaKey || event.altKey || event.target instanceof HTMLSelectElement;
    if (!Object.hasOwn(actions, key) || isForAnother) return;
    event.preventDefault();  // a space would also press the button that has the focus
    act(key);
  });
  new ResizeObserver(() => {
    player.stage.resize();
    player.timeline.draw();
    player.redraw();
  }).observe(player.stage.canvas.parentElement);
  offerClips(player);
}
