"""table and read_table: columns and their types, options as keywords, and what programs refuse."""

import contextlib
import io
import os
import pathlib
import tempfile
import unittest

import numpy
from numpy.testing import assert_allclose, assert_array_equal
from particle_methods import read_table, table

from support import TestCase, line

DATA = pathlib.Path(__file__).parents[2] / "data"


def written(text):
    """What read_table makes of a file with this text."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "table.csv"
        path.write_text(text, encoding="utf-8")
        return read_table(path)


class Options(TestCase):
    def assert_same(self, rows, others):
        """The same bytes, nan among them."""
        self.assertEqual((rows.dtype, rows.tobytes()), (others.dtype, others.tobytes()))

    def test_a_list_is_a_list_of_python_a_tuple_an_array_a_range_or_a_text(self):
        plain = table("derivative_test", formulation="fpm", particles="10,20")
        self.assertEqual(list(plain["particles"]), [10, 20])
        for particles in [10, 20], (10, 20), numpy.array([10, 20]), range(10, 30, 10), "10:10:20":
            with self.subTest(particles=particles):
                self.assert_same(table("derivative_test", formulation=["fpm"], particles=particles), plain)

    def test_names_in_a_list_keep_their_order(self):
        rows = table("derivative_test", formulation=["ssph", "fpm"], particles=20)
        self.assertEqual(list(rows["formulation"]), ["ssph", "fpm"])

    def test_a_flag_is_given_by_true_and_left_out_by_false_and_none(self):
        case = {"formulation": "fpm", "particles": 20}
        plain = table("derivative_test", **case)
        for no in False, None, numpy.False_:
            self.assert_same(table("derivative_test", quality=no, states=no, **case), plain)
        for yes in True, numpy.True_:
            rows = table("derivative_test", quality=yes, **case)
            self.assertEqual(rows.dtype.names, (*plain.dtype.names, "quality"))

    def test_an_underscore_is_a_hyphen(self):
        case = {"formulation": "fpm", "particles": 20, "perturb": 0.25}
        mean = table("derivative_test", smoothing_from="mean", **case)
        largest = table("derivative_test", smoothing_from="largest", **case)
        self.assertNotEqual(mean["error_first"], largest["error_first"])

    def test_zero_is_a_value_and_no_flag(self):
        rows = table("stencil", formulation="fpm", particles=20, particle=0)
        self.assertEqual(rows["offset"][0], 0)
        rows = table("derivative_test", formulation="fpm", particles=20, perturb=0)
        self.assertEqual(rows["perturbation"], 0)

    def test_numbers_arrive_with_all_of_their_digits(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "x.csv")
            x = line(20)
            numpy.savetxt(path, x, "%.17g")
            for smoothing in 1 + 2**-40, numpy.float64(1 + 2**-40), numpy.float32(1.25):
                rows, again = (table("derivative_test", positions=path, formulation="fpm", smoothing=number)
                               for number in (smoothing, repr(float(smoothing))))
                self.assert_same(again, rows)

    def test_texts_with_spaces_and_signs_arrive_whole(self):
        rows = table("derivative_test", formulation="second_order_fpm", particles=20, states=True,
                     function="-x^2 + 3 * sin( pi*x )")
        x = rows["x"]
        assert_allclose(rows["B"], 3 * numpy.sin(numpy.pi * x) - x**2, atol=1e-8)

    def test_nothing_is_read_by_a_shell(self):
        with self.assertRaises(ValueError) as refusal:
            table("derivative_test", particles="$(echo 20); *")
        self.assertIn("'$(echo 20); *'", str(refusal.exception))

    def test_output_writes_the_file_and_returns_what_it_holds(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "errors.csv"
            rows = table("derivative_test", formulation="fpm", particles=20, output=path)
            self.assert_same(rows, read_table(path))
            self.assertEqual(rows["particles"], 20)

    def test_help_is_printed(self):
        shown = io.StringIO()
        with contextlib.redirect_stdout(shown):
            self.assertIsNone(table("derivative_test", help=True))
        self.assertIn("--smoothing-from NAME", shown.getvalue())
        self.assertIn("Example: derivative_test", shown.getvalue())

    def test_the_programs_are_those_with_tables(self):
        with self.refuses("there is no program 'claims'; choose one of constants, constants_in_space, derivative_test, derivative_test_in_space, draws, hole, orders, plate, roundoff, static_test, static_test_in_space, stencil, vibration_test, vibration_test_in_space"):
            table("claims")

    def test_a_program_outside_of_the_package_is_refused(self):
        for program in "../../../bin/claims", "/bin/true", "", ".", "..", None:
            with self.subTest(program=program), self.assertRaisesRegex(ValueError, "^there is no program "):
                table(program)

    def test_a_refusal_is_a_value_error_in_words_of_python(self):
        for options, text in (
            ({"colour": 1}, "derivative_test: there is no option 'colour'; see table(\"derivative_test\", help=True)"),
            ({"particles": "x"}, "derivative_test: particles: 'x' is no number"),
            ({"particles": []}, "derivative_test: particles needs a value; see table(\"derivative_test\", help=True)"),
            ({"kernel": "box"}, "derivative_test: there is no kernel 'box'; choose one of gaussian, cubic_spline, quintic_spline, wendland_c2, wendland_c4"),
            ({"particles": 20, "positions": "x.csv"}, "derivative_test: particles and positions exclude each other; leave one out; see table(\"derivative_test\", help=True)"),
            ({"particles": 20, "smoothing_from": "farthest"}, "derivative_test: smoothing_from: there is no spacing 'farthest'; choose one of mean, largest, local, nearest, or K-nearest with a number K, such as 6-nearest, a length, or a file"),
            ({"particles": 20, "function": "sin(x"}, "derivative_test: function: 'sin(x' : ')' expected at character 6"),
        ):
            with self.subTest(**options), self.refuses(text):
                table("derivative_test", **options)

    def test_a_failed_computation_is_a_runtime_error_whose_remedy_works(self):
        options = {"formulation": "second_order_fpm", "particles": 20, "kernel": "cubic_spline"}
        pattern = r"^derivative_test: second_order_fpm: .*; try smoothing=[0-9.]+$"
        with self.assertRaisesRegex(RuntimeError, pattern) as failure:
            table("derivative_test", smoothing=0.7, **options)
        remedy = float(str(failure.exception).split("smoothing=")[1])
        self.assertEqual(len(table("derivative_test", smoothing=remedy, **options)), 1)

    def test_where_some_cases_fail_a_warning_says_so_and_the_rows_say_why(self):
        with self.assertWarnsRegex(UserWarning, "^plate: 1 of 2 cases failed, as the table's last column says"):
            errors = table("plate", method="strong", particles="16x4", degree=[2, 3], scaling=3)
        self.assertEqual(list(errors["failure"] == ""), [True, False])
        self.assertTrue(numpy.isfinite(errors["log_error_nd"][0]))


class Columns(TestCase):
    def test_a_column_holds_integers_numbers_or_texts(self):
        rows = table("derivative_test", formulation="fpm", particles=[10, 20], perturb=[0, 0.25])
        for name, kind in ("formulation", "U"), ("particles", "i"), ("spacing", "f"), ("seed", "i"):
            self.assertEqual(rows.dtype[name].kind, kind)

    def test_an_empty_cell_is_nan(self):
        rows = table("derivative_test", formulation="fpm", particles=[10, 40])
        self.assertTrue(numpy.isnan(rows["error_first_interior"][0]))
        self.assertGreater(rows["error_first_interior"][1], 0)

    def test_a_record_is_a_row_and_a_name_is_a_column(self):
        rows = table("derivative_test", formulation=["fpm", "ssph"], particles=[10, 20])
        self.assertEqual((rows.shape, rows[2]["formulation"], rows[3]["particles"]), ((4,), "ssph", 20))
        self.assertEqual(rows[rows["formulation"] == "ssph"]["particles"].tolist(), [10, 20])

    def test_quoted_commas_quotes_and_names_stay_in_their_cell(self):
        rows = written('# a comment, with a comma\n"a, b",text\n1,"x, y"\n2,"a ""quoted"" text"\n')
        self.assertEqual(rows.dtype.names, ("a, b", "text"))
        self.assertEqual(rows["text"].tolist(), ["x, y", 'a "quoted" text'])
        self.assertEqual(rows["a, b"].tolist(), [1, 2])

    def test_types_are_those_that_all_cells_have(self):
        rows = written("i,f,g,u,empty,big\n1,1.5,1,1,,1\n-2,1e-3,,x,,99999999999999999999999\n")
        self.assertEqual([rows.dtype[name].kind for name in ("i", "f", "g", "u", "empty")], list("iffUf"))
        self.assertEqual(rows["i"].tolist(), [1, -2])
        self.assertEqual(rows["f"].tolist(), [1.5, 1e-3])
        self.assertEqual(rows["u"].tolist(), ["1", "x"])
        assert_array_equal(rows["g"], [1, numpy.nan])
        assert_array_equal(rows["empty"], [numpy.nan, numpy.nan])
        self.assertIn(rows.dtype["big"].kind, "fU")

    def test_letters_of_any_alphabet_stay(self):
        self.assertEqual(written("name,δ\nBéla,1\n")["name"].tolist(), ["Béla"])

    def test_a_table_with_a_head_alone_has_no_rows(self):
        rows = written("# nothing\na,b\n")
        self.assertEqual((rows.shape, rows.dtype.names), ((0,), ("a", "b")))

    def test_a_file_without_a_table_is_refused_with_its_name(self):
        for text in "", "# a comment\n":
            with self.subTest(text=text), self.assertRaisesRegex(ValueError, r"table\.csv holds no table$"):
                written(text)

    def test_a_row_of_another_length_is_refused_with_its_number(self):
        with self.assertRaisesRegex(ValueError, r"table\.csv: row 2 has 1 cells, and the head has 2$"):
            written("a,b\n1,2\n3\n")

    def test_a_file_that_is_not_there_is_an_error_of_the_system(self):
        with self.assertRaises(FileNotFoundError):
            read_table("/no/such/table.csv")


class Files(TestCase):
    def test_each_table_of_the_repository_is_read(self):
        paths = sorted(DATA.glob("*/*.csv"))
        self.assertGreater(len(paths), 40)
        for path in paths:
            with self.subTest(path=path.name), open(path, encoding="utf-8") as file:
                lines = [text for text in file if not text.startswith("#")]
                rows = read_table(path)
                self.assertEqual(len(rows), len(lines) - 1)
                self.assertEqual(rows.dtype.names[0], lines[0].rstrip().split(",")[0])
                self.assertNotIn("O", [rows.dtype[name].kind for name in rows.dtype.names])

    def test_a_table_computed_again_is_that_of_the_file(self):
        figure = read_table(DATA / "asprone2010" / "figure_1.csv")
        again = table("derivative_test", particles=[20, 40], formulation=["fpm", "second_order_fpm"])
        for row in again:
            with self.subTest(formulation=row["formulation"], particles=row["particles"]):
                same = figure[numpy.logical_and.reduce(
                    [figure[name] == row[name] for name in ("formulation", "particles", "perturbation")])]
                self.assertEqual(len(same), 1)
                for name in "error_first", "error_second", "error_first_interior", "error_second_interior":
                    assert_allclose(row[name], same[name][0], rtol=1e-6, atol=2e-10)


if __name__ == "__main__":
    unittest.main()
