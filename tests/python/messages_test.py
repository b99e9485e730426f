"""Messages of the programs in words of Python: an option is a keyword, and English stays English."""

import pathlib
import re
import unittest

from particle_methods.core import in_python

from support import TestCase

SOURCES = pathlib.Path(__file__).parents[2] / "src"


class InPython(TestCase):
    def test_an_option_with_its_value_is_a_keyword_with_it(self):
        for said, text in (
            ("try --smoothing 1.6", "try smoothing=1.6"),
            ("try --smoothing 0.51 or more", "try smoothing=0.51 or more"),
            ("take --perturb up to 0.25", "take perturb up to 0.25"),
            ("; try --snap 6.1e-08", "; try snap=6.1e-08"),
            ("try --shift -0.5", "try shift=-0.5"),
            ("--smoothing-from local", 'smoothing_from="local"'),
            ("try --smoothing-from 3-nearest, or more", 'try smoothing_from="3-nearest", or more'),
            ("try --smoothing-from 0.201", "try smoothing_from=0.201"),
            ("try --scaling 3.5 or --smoothing-from 0.201", "try scaling=3.5 or smoothing_from=0.201"),
            ("take --method hats or a finer mesh", 'take method="hats" or a finer mesh'),
            ("fix belongs to --equation elasticity;", 'fix belongs to equation="elasticity";'),
            ("try --plane strain.", 'try plane="strain".'),
            ('write --pressure "NAME: 1"', 'write pressure={"NAME": 1}'),
            ('write --traction "NAME: 0, -1e6"; or', 'write traction={"NAME": (0, -1e6)}; or'),
            ("SI units: --young 210e9 --poisson 0.3", "SI units: young=210e9, poisson=0.3"),
            ("for a scalar write --conductivity K", "for a scalar write conductivity=K"),
        ):
            with self.subTest(said=said):
                self.assertEqual(in_python(said), text)

    def test_an_option_without_a_value_is_the_name_of_the_keyword(self):
        for said, text in (
            ("--cut must be positive, got 0", "cut must be positive, got 0"),
            ("--method is given twice; give it once", "method is given twice; give it once"),
            ("--plot draws one method; name one by --method", "plot draws one method; name one by method"),
            ("--quality is that of errors; leave --states out", "quality is that of errors; leave states out"),
            ("--equation needs a value", "equation needs a value"),
            ("--plane is that of a body in the plane", "plane is that of a body in the plane"),
            ("--smoothing-from needs one of them", "smoothing_from needs one of them"),
            ("a smaller --size, or --test-scaling", "a smaller size, or test_scaling"),
            ("(--degree)", "(degree)"),
        ):
            with self.subTest(said=said):
                self.assertEqual(in_python(said), text)

    def test_help_is_that_of_python(self):
        self.assertEqual(in_python("there is no option '--foo'; see solve --help"),
                         "there is no option 'foo'; see help(solve)")

    def test_text_without_options_stays(self):
        for said in ("", "particle 1 lies before its predecessor; sort the positions (x = 0.909091)", "δ ≤ 1/2",
                     "a well-known word, a - b, 2--3 and a -- dash", "cells[0, 1] is -1", "'' and \"\""):
            with self.subTest(said=said):
                self.assertEqual(in_python(said), said)

    def test_no_option_of_the_sources_is_left_in_a_message(self):
        option, literal = r"(?<![\w-])--[a-z]", r'"((?:[^"\\\n]|\\.)*)"'
        messages = {
            text.replace('\\"', '"').replace("\\n", "\n")
            for path in [*SOURCES.glob("*/*.cpp"), *SOURCES.glob("*/*.hpp")]
            for text in re.findall(literal, path.read_text(encoding="utf-8"))
            if re.search(option, text) and not text.startswith(("Example", "Another", "--"))
        }
        self.assertGreater(len(messages), 20)
        for said in messages:
            with self.subTest(said=said):
                text = in_python(said)
                self.assertNotRegex(text, option)
                # The words are the same, whatever stands between them.
                words, same = (re.findall(r"[^\W_]+", each) for each in (said, text))
                self.assertEqual(same, words)


if __name__ == "__main__":
    unittest.main()
