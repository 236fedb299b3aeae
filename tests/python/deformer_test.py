"""Mesh, Deformer and solve: invariants of the method, and errors for what does not fit."""

import threading
import unittest
import warnings

import numpy as np

import flexkey


def grid(n):
    """A flat square of n x n quads in the plane z = 0."""
    x, y = np.meshgrid(np.arange(n + 1), np.arange(n + 1))
    positions = np.stack([x.ravel(), y.ravel(), 0 * x.ravel()], axis=1).astype(float)
    corner = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    return positions, np.stack([corner, corner + 1, corner + n + 2, corner + n + 1], axis=1)


def turned(points, degrees):
    """About the x axis."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return points @ np.array([[1, 0, 0], [0, c, s], [0, -s, c]])


class MeshTest(unittest.TestCase):
    def test_polygons_and_order_are_kept(self):
        positions = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0]], dtype=np.float32)
        mesh = flexkey.Mesh(positions, [[0, 1, 2, 3], [1, 4, 2]])
        np.testing.assert_array_equal(mesh.positions, positions)
        self.assertEqual([list(face) for face in mesh.faces], [[0, 1, 2, 3], [1, 4, 2]])

    def test_positions_are_a_view_that_outlives_its_mesh(self):
        positions, faces = grid(2)
        view = flexkey.Mesh(positions, faces).positions
        np.testing.assert_array_equal(view, positions)
        with self.assertRaises(ValueError):
            view[0, 0] = 1

    def test_what_is_no_mesh_is_refused_by_name(self):
        positions, faces = grid(2)
        for wrong, message in [
            (lambda: flexkey.Mesh(positions[:, :2], faces), r"positions: expected .* shape \(9, 2\)"),
            (lambda: flexkey.Mesh("abc", faces), "positions: expected an array of n x 3 numbers"),
            (lambda: flexkey.Mesh(positions, [[0, 1, 9]]), "face 0: there is no vertex 9 among 9"),
            (lambda: flexkey.Mesh(positions, [[0, 1, -1]]), "face 0: expected indices from 0, got -1"),
            (lambda: flexkey.Mesh(positions, [[0, 1]]), "face 0: it has 2 corners"),
            (lambda: flexkey.Mesh(positions, [[0.5, 1, 2]]), "face 0: expected an array of n indices"),
        ]:
            with self.assertRaisesRegex(ValueError, message):
                wrong()

    def test_a_missing_file_raises_the_programs_message(self):
        with self.assertRaisesRegex(flexkey.InputError, "missing.obj"):
            flexkey.Mesh.read("missing.obj")


class DeformerTest(unittest.TestCase):
    def setUp(self):
        self.positions, faces = grid(6)
        self.mesh = flexkey.Mesh(self.positions, faces)
        self.held = np.flatnonzero((self.positions[:, 0] == 0) | (self.positions[:, 0] == 6))

    def test_handles_are_met_and_a_rigid_motion_is_reproduced(self):
        for system in ["least-squares", "direct"]:
            targets = turned(self.positions[self.held], 30) + [1, 2, 3]
            bent = flexkey.solve(self.mesh, self.held, targets, 0.8, system=system, tolerance=1e-6, iterations=300)
            np.testing.assert_array_equal(bent[self.held], targets)
            np.testing.assert_allclose(bent, turned(self.positions, 30) + [1, 2, 3], atol=1e-3)

    def test_a_chain_of_frames_starts_each_from_the_one_before(self):
        deformer = flexkey.Deformer(self.mesh, self.held, owner=(self.held % 7 > 0).astype(int))
        pose = deformer.rest_pose()
        for degrees in (10, 20, 30):
            targets = self.positions[self.held].copy()
            targets[self.held % 7 > 0] = turned(targets[self.held % 7 > 0], degrees)
            report = deformer.solve(targets, 0.5, pose, turns=[[0, 0, 0], [np.radians(10), 0, 0]])
            self.assertTrue(report.converged, report)
            np.testing.assert_array_equal(pose.positions[self.held], targets)
        before = pose.copy()
        self.assertEqual(deformer.solve(targets, 0.5, pose).solves, 0)
        np.testing.assert_array_equal(pose.positions, before.positions)

    def test_lambda_may_be_a_field_and_a_mask_may_choose_handles(self):
        mask = np.zeros(len(self.positions), dtype=bool)
        mask[self.held] = True
        targets = self.positions[self.held] * [1.2, 1, 1]
        constant = flexkey.solve(self.mesh, self.held, targets, 0.3)
        painted = flexkey.solve(self.mesh, mask, targets, np.full(len(self.positions), 0.3))
        np.testing.assert_allclose(painted, constant, atol=1e-12)

    def test_errors_name_what_is_wrong_and_leave_the_pose(self):
        deformer = flexkey.Deformer(self.mesh, self.held)
        pose = deformer.rest_pose()
        with self.assertRaises(flexkey.DeformError):
            deformer.solve(self.positions[:2], 0.5, pose)
        with self.assertRaises(flexkey.DeformError):
            deformer.solve(self.positions[self.held], 1.5, pose)
        np.testing.assert_array_equal(pose.positions, self.positions)
        with self.assertRaisesRegex(flexkey.Error, "99"):
            flexkey.Deformer(self.mesh, [99])
        with self.assertRaisesRegex(TypeError, "unknown keyword 'toleranc'; did you mean 'tolerance'"):
            flexkey.Deformer(self.mesh, self.held, toleranc=1)
        with self.assertRaisesRegex(ValueError, "system: 'dense' is none of direct, least-squares"):
            flexkey.Deformer(self.mesh, self.held, system="dense")
        with self.assertRaisesRegex(ValueError, "iterations: expected a whole number, got 'many'"):
            flexkey.Deformer(self.mesh, self.held, iterations="many")

    def test_what_did_not_converge_is_said(self):
        targets = turned(self.positions[self.held], 80) * [0.5, 1, 1]
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            flexkey.solve(self.mesh, self.held, targets, 1.0, iterations=1, tolerance=1e-9)
        self.assertIn("did not converge", str(caught[0].message))

    def test_other_threads_run_while_it_solves(self):
        positions, faces = grid(120)
        mesh = flexkey.Mesh(positions, faces)
        held = np.flatnonzero((positions[:, 0] == 0) | (positions[:, 0] == 120))
        is_over = threading.Event()

        def solve():
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                flexkey.solve(mesh, held, positions[held] * [0.8, 1, 1], 1.0, tolerance=1e-12, iterations=60)
            is_over.set()

        thread = threading.Thread(target=solve)
        thread.start()
        ticks = 0
        while not is_over.wait(0.001):
            ticks += 1
        thread.join()
        # Where the solve held the interpreter, this thread would not wake before its end.
        self.assertGreater(ticks, 3)


if __name__ == "__main__":
    unittest.main()
