"""The example of the README's section on Python, run as it stands there."""

import os
import pathlib
import re
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Readme(unittest.TestCase):
    def test_the_example_runs(self):
        text = (ROOT / "README.md").read_text(encoding="utf-8")
        examples = re.findall(r"```python\n(.*?)```", text, re.S)
        self.assertEqual(len(examples), 1)
        names = {}
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(ROOT / "timelines", os.path.join(folder, "timelines"))
            os.chdir(folder)
            try:
                exec(compile(examples[0], "README.md", "exec"), names)
            finally:
                os.chdir(before)
            glb = pathlib.Path(folder, "twist.glb").read_bytes()
        self.assertEqual(glb[:4], b"glTF")
        self.assertEqual(names["frames"].shape[2], 3)
        self.assertEqual(names["bent"].shape, names["mesh"].positions.shape)


if __name__ == "__main__":
    unittest.main()
