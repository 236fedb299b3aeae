// Time: which clip plays, where it is, and what is drawn of it when.
import { showReadout } from './readout.js';
import { createTimeline } from './timeline.js';

const element = (id) => document.getElementById(id);

/// `pick` of the frames on both sides of a time, blended.
function between(frames, time, pick) {
  const next = frames.findIndex((frame) => frame.time > time);
  if (next <= 0) return pick(frames.at(next === 0 ? 0 : -1));
  const before = frames[next - 1], after = frames[next];
  const share = (time - before.time) / (after.time - before.time);
  return pick(before) * (1 - share) + pick(after) * share;
}

export class Player {
  constructor(stage, actor, markers) {
    Object.assign(this, { stage, actor, markers });
    this.timeline = createTimeline(element('timeline'), (frame) => this.goTo(frame));
    this.time = 0;  // seconds in the clip
    this.lapTime = 0;  // seconds since it began again, which goes on a little after its end
    this.last = 0;  // milliseconds of the last picture
    this.choose(actor.firstClip);
    this.play(!matchMedia('(prefers-reduced-motion: reduce)').matches);
    const tick = (now) => {
      requestAnimationFrame(tick);
      this.advance(now);
    };
    requestAnimationFrame(tick);
  }

  choose(clip) {
    this.clip = clip;
    this.time = this.lapTime = 0;
    this.actor.choose(clip);
    this.timeline.show(clip);
    this.redraw();
  }

  play(isPlaying) {
    this.isPlaying = isPlaying;
    this.lapTime = this.time;
    element('play').classList.toggle('is-playing', isPlaying);
    element('play').setAttribute('aria-label', isPlaying ? 'Pause' : 'Play');
  }

  /// frame: counted from the clip's first; beyond its ends the nearest.
  goTo(frame) {
    this.play(false);
    this.time = this.clip.frames[Math.min(Math.max(frame, 0), this.clip.frames.length - 1)].time;
    this.redraw();
  }

  step(by) {
    this.goTo(this.timeline.nearest(this.time) + by);
  }

  /// The next picture is drawn even if nothing moves.
  redraw() {
    this.isDirty = true;
  }

  advance(now) {
    if (this.isPlaying) {
      // The last frame is shown as long as every other before the clip begins again.
      const lap = this.clip.duration + 1 / this.clip.fps;
      this.lapTime = (this.lapTime + Math.min(now - this.last, 250) / 1000) % lap;
      this.time = Math.min(this.lapTime, this.clip.duration);
    }
    this.last = now;
    if (this.stage.controls.update() || this.isPlaying || this.isDirty) this.draw();
    this.isDirty = false;
  }

  draw() {
    const { clip, time } = this;
    const lambda = between(clip.frames, time, (frame) => frame.lambda);
    this.actor.pose(time);
    this.markers.update(between(clip.frames, time, (frame) => frame.index));
    this.timeline.moveTo(time, lambda);
    showReadout(element('readout'), clip, this.timeline.nearest(time), { time, lambda });
    this.stage.render();
  }
}
