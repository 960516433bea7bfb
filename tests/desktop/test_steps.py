# SPDX-License-Identifier: Apache-2.0
"""The runner of steps: which of them run after one has failed, what it prints, and its exit code. Needs no window."""

import contextlib
import io
import pathlib
import unittest

import steps
from driver import Failure, Silence, need
from steps import SKIPPED, Skip, Steps


class Running(unittest.TestCase):
    def setUp(self):
        self.test = Steps()
        self.done = []
        self.photographed = []
        original = steps.photograph
        steps.photograph = lambda display, path: self.photographed.append(path.name) or ""
        self.addCleanup(setattr, steps, "photograph", original)

    def run_steps(self, **given):
        """The exit code, and what was printed."""
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            code = self.test.run({"display": None, "folder": pathlib.Path("work"), **given})
        return code, said.getvalue()

    def three(self, failing):
        @self.test.step
        def first():
            self.done.append("first")
            if failing:
                raise failing
            return 1

        @self.test.step
        def second(first):
            self.done.append(f"second after {first}")

        @self.test.step
        def third():
            self.done.append("third")

    def test_all_run_in_order_and_are_given_results(self):
        self.three(None)
        code, said = self.run_steps()
        self.assertEqual((code, self.done), (0, ["first", "second after 1", "third"]))
        self.assertTrue(said.endswith("\npassed\n"), said)
        self.assertEqual(self.photographed, [])

    def test_what_needs_a_failed_step_is_not_run_and_all_else_is(self):
        for failure in (Failure("no picture"), KeyError("message"), AssertionError()):
            with self.subTest(failure=failure):
                self.setUp()
                self.three(failure)
                code, said = self.run_steps()
                self.assertEqual((code, self.done), (1, ["first", "third"]))
                self.assertIn("FAILED first", said)
                self.assertIn("Traceback", said)
                self.assertIn(f"{type(failure).__name__}", said)
                self.assertIn("NOT RUN second: it needs first", said)
                self.assertIn("passed third", said)
                self.assertIn("2 of 3 steps failed or did not run: first, second", said)
                self.assertEqual(self.photographed, ["failure_first.png"])

    def test_not_running_goes_on_to_what_needs_that(self):
        @self.test.step
        def first():
            need(False, "always")

        @self.test.step(after=[first])
        def second():
            self.done.append("second")

        @self.test.step(after=[second])
        def third():
            self.done.append("third")

        self.assertEqual(self.run_steps()[0], 1)
        self.assertEqual(self.done, [])

    def test_a_silent_studio_is_left_alone_and_another_is_not(self):
        silent, other = object(), object()

        @self.test.step
        def studio():
            return silent

        @self.test.step
        def key(studio):
            raise Silence(studio, "no answer")

        @self.test.step
        def drag(studio):
            self.done.append("drag")

        @self.test.step
        def next_studio():
            return other

        @self.test.step
        def look(next_studio):
            self.done.append("look")

        code, said = self.run_steps()
        self.assertEqual((code, self.done), (1, ["look"]))
        self.assertIn("NOT RUN drag: it needs studio", said)

    def test_a_test_that_is_skipped_ends_there(self):
        self.three(Skip("there is no scan"))
        code, said = self.run_steps()
        self.assertEqual((code, self.done), (SKIPPED, ["first"]))
        self.assertIn("skipped: there is no scan", said)

    def test_skipping_hides_no_failure(self):
        @self.test.step
        def broken():
            need(False, "always")

        self.three(Skip("there is no scan"))
        self.assertEqual(self.run_steps()[0], 1)

    def test_names_that_no_earlier_step_has_are_errors_at_once(self):
        with self.assertRaisesRegex(ValueError, "studoi"):
            @self.test.step
            def key(studoi):
                pass

        self.three(None)
        with self.assertRaisesRegex(ValueError, "the name is taken"):
            @self.test.step
            def first():
                pass


if __name__ == "__main__":
    unittest.main()
