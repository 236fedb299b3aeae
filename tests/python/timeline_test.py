"""Timeline: what the program makes of the same file, as arrays."""

import pathlib
import tempfile
import unittest

import numpy as np

import flexkey

TIMELINES = pathlib.Path(__file__).resolve().parents[2] / "timelines"


class TimelineTest(unittest.TestCase):
    def write(self, text):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = pathlib.Path(folder.name, "shot.yaml")
        path.write_text(text.replace("bar.obj", str(TIMELINES / "meshes" / "bar.obj")))
        return path

    def test_a_shot_is_solved_into_frames(self):
        shot = flexkey.Timeline(TIMELINES / "minimal.yaml")
        self.assertEqual((shot.name, shot.fps, shot.frame_count), ("minimal", 24, 49))
        self.assertEqual(shot.handles, ["base", "tip"])
        clip = shot.solve()
        frames = np.stack(clip.frames)
        self.assertEqual(frames.shape, (49, *shot.mesh.positions.shape))
        np.testing.assert_allclose(frames[0], shot.mesh.positions, atol=1e-12)
        self.assertTrue(all(report.converged for report in clip.reports))
        rest, end = frames[0], frames[-1]
        tip = rest[:, 2] == rest[:, 2].max()
        centre = rest[tip].mean(axis=0)
        turned = (rest[tip] - centre) @ np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 1]]) + centre
        np.testing.assert_allclose(end[tip], turned, atol=1e-9)

    def test_keys_are_overridden_and_sweeps_are_runs(self):
        shot = flexkey.Timeline(TIMELINES / "minimal.yaml", set={"lambda": 1, "duration": "0.25s"})
        self.assertEqual([report.lambda_ for report in shot.solve().reports], [1.0] * 7)
        swept = flexkey.Timeline(
            TIMELINES / "minimal.yaml",
            set={"sweep": "{lambda: [0, 1]}", "output": "<lambda>.glb", "duration": "0.25s"})
        with self.assertRaisesRegex(flexkey.UsageError, "sweep"):
            swept.solve()
        self.assertEqual([run.solve().reports[-1].lambda_ for run in swept.runs()], [0.0, 1.0])

    def test_a_frame_outlives_its_clip_and_is_read_only(self):
        frame = flexkey.Timeline(TIMELINES / "minimal.yaml", set={"duration": "0.1s"}).solve().frames[0]
        self.assertTrue(np.isfinite(frame).all())
        with self.assertRaises(ValueError):
            frame[0, 0] = 0

    def test_a_mistake_is_raised_with_the_programs_message(self):
        path = self.write("mesh: bar.obj\nhandles:\n  tip: {select: {axis: z, above: 99%}, rotat: 1}\nfsp: 3\n")
        with self.assertRaises(flexkey.TimelineError) as raised:
            flexkey.Timeline(path)
        lines = str(raised.exception).splitlines()
        self.assertIn(f"{path}:3:40: error: unknown key 'rotat' in handle 'tip'; did you mean 'rotate'?", lines)
        self.assertIn(f"{path}:4:1: error: unknown key 'fsp'; did you mean 'fps'?", lines)
        with self.assertRaises(flexkey.InputError):
            flexkey.Timeline(self.write("mesh: none.obj\nhandles: {a: {select: {axis: z, above: 99%}}}\n"))

    def test_a_glb_is_written_whole_or_not_at_all(self):
        clip = flexkey.Timeline(TIMELINES / "minimal.yaml", set={"duration": "0.1s"}).solve()
        with tempfile.TemporaryDirectory() as folder:
            clip.write_glb(pathlib.Path(folder, "bar.glb"))
            self.assertEqual(pathlib.Path(folder, "bar.glb").read_bytes()[:4], b"glTF")
        with self.assertRaises(flexkey.OutputError):
            clip.write_glb("/dev/null/bar.glb")


if __name__ == "__main__":
    unittest.main()
