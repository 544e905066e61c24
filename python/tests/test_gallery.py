"""The gallery: every example runs, and its page has its text. `python tests/test_gallery.py --write` writes the page and its pictures."""

import ast
import importlib
import runpy
import sys
from pathlib import Path

ROOT = Path(__file__).parent.parent
#: The page in the repository, or beside the tests where they are run alone.
PAGE = next((page for page in (ROOT.parent / "docs" / "gallery.md", ROOT / "pages" / "gallery.md") if page.exists()), ROOT.parent / "docs" / "gallery.md")
EXAMPLES = ("response_map", "labelled", "hysteresis", "spectrum_of_a_suite", "fragility", "decay_fit", "damper", "belt", "basins", "dask_study")
HEAD = """# Gallery for Python

Ten examples, each a file of `python/gallery` that the tests of the package run. They need matplotlib, and one each SciPy, xarray and Dask.
"""


def source(name):
    return (ROOT / "gallery" / f"{name}.py").read_text(encoding="utf-8")


def section(name):
    """An example as a section of the page."""
    text = source(name)
    told = ast.get_docstring(ast.parse(text))
    code = text.split('"""', 2)[2].strip()
    title, _, rest = told.replace("\n", " ").partition(": ")
    title = title if rest else " ".join(told.split()).partition(",")[0]
    return f"\n## {title}\n\n{' '.join(told.split())}\n\n```py\n{code}\n```\n\n![{title}](pictures/{name}.png)\n"


def page():
    return HEAD + "".join(map(section, EXAMPLES))


def drawn(name):
    """The figure of an example."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    plt.close("all")
    with plt.rc_context({"figure.figsize": (5.6, 3.4), "figure.dpi": 80, "font.size": 9}):
        runpy.run_path(str(ROOT / "gallery" / f"{name}.py"))
    return plt.gcf()


def needed(name):
    """The packages that an example imports."""
    tree = ast.parse(source(name))
    imports = [alias.name for node in ast.walk(tree) if isinstance(node, ast.Import) for alias in node.names]
    return [*imports, *(node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom))]


if __name__ == "__main__" and "--write" in sys.argv:
    PAGE.write_text(page(), encoding="utf-8")
    (PAGE.parent / "pictures").mkdir(exist_ok=True)
    for example in sys.argv[2:] or EXAMPLES:
        drawn(example).savefig(PAGE.parent / "pictures" / f"{example}.png", metadata={"Software": None})
else:
    import pytest

    @pytest.mark.parametrize("name", EXAMPLES)
    def test_an_example_runs_and_draws(name):
        for module in needed(name):
            if module != "stickslip":
                pytest.importorskip(module)
        axes = drawn(name).axes
        # Every axis but that of a colour bar says what it shows, with its unit.
        assert axes and axes[0].get_xlabel() and axes[0].get_ylabel() and axes[0].has_data()

    def test_the_page_has_every_example():
        assert {path.stem for path in (ROOT / "gallery").glob("*.py")} == set(EXAMPLES)
        assert PAGE.read_text(encoding="utf-8") == page()
        assert importlib.util.find_spec("stickslip") is not None
