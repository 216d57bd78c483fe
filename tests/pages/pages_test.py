#!/usr/bin/env python3
"""The pages that the grader writes, in a browser: they fit every width, light and dark; they are complete without script,
ask nothing of a network, can be used by keyboard and printed, and axe-core finds nothing against them.

    tests/pages/pages_test.py GRADE [--keep FOLDER]

Needs Chromium, and Playwright and axe-playwright-python from PyPI; 77 without. FOLDER gets a picture of each page at each
width.
"""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from helpers import end, expect, skip  # noqa: E402

try:
    from playwright.sync_api import sync_playwright

    from every_page import check_handout, check_widths
except ImportError as missing:
    skip(f"{missing}: pip install playwright axe-playwright-python")
from graded_page import (check_comforts, check_passing, check_plain_words, check_print, check_rows, check_without_script,  # noqa: E402
                         check_words)
from opened import opened  # noqa: E402

# A crash, a compiler's message, statistics, pictures, a time-out, a blank, and what passes.
FRAGMENTS = "integrate_stratified whitted shadow_ray light_sample lens_ray free_flight phong".split()
chromium = shutil.which("chromium") or shutil.which("google-chrome")


def make_pages(grade, folder):
    def run(*words):
        subprocess.run([grade, *words], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)

    example = folder / "example"
    shutil.copytree("tests/example", example)
    (example / "fragments/uniform_disk.cpp").unlink()  # does not end, and would be part of the picture
    run(example, *FRAGMENTS, "--seed", "1", "--html", folder / "grade")
    run("solution", "phong", "shadow_ray", "--seed", "1", "--html", folder / "passing")
    run("stress", "solution", "--only", "phong", "--html", folder / "stress")
    run("stress", example, "--only", "hit_sphere", "--html", folder / "failing")
    run("lesson", "solution", "--out", folder / "stress")
    run("converge", "solution", "scenes/penumbra.toml", "--samples", "1,4", "--replicates", "2", "--side", "16", "--out",
        folder / "stress", "--folder", folder / "kept")
    run("calibrate", "phong", "--report", "--folder", folder / "empty", "--out", folder / "stress")
    for student in ("anna", "ben"):  # twins, and alike in what is wrong
        (folder / f"export/hw1-{student}").mkdir(parents=True)
        for name in ("phong", "whitted"):
            shutil.copy(example / f"fragments/{name}.cpp", folder / f"export/hw1-{student}")
    (folder / "export/hw1-a-name-as-long-as-names-of-repositories-and-groups-are-at-some-schools.zip").write_text("no archive")
    run("class", folder / "export", "-o", folder / "class", "--seed", "1")
    for copy in folder.glob("*/handout.html"):  # one of them is enough, below
        copy.unlink()
    subprocess.run(["scenes/make_page", "--html", folder / "handout"], stdout=subprocess.DEVNULL, check=False)
    return sorted(folder.glob("*/*.html"))


def check_links(browser, folder):
    """The page that was written first leads to the one that followed, and back; both name what is not there."""
    with opened(browser, folder / "stress.html") as page:
        page.get_by_role("link", name="integrals").click()
        expect(page.url.endswith("lesson.html"), f"pages of one folder: stress leads to {page.url}")
        expect(page.locator("nav.pages [aria-current]").inner_text() == "integrals", "pages of one folder: which one this is")
        shown = page.evaluate("[...document.images].every(image => image.naturalWidth > 0)")
        expect(shown and page.locator("img").count() == 3, "the lesson's plots")
        page.locator("nav.pages summary").click()
        expect("./grade [SUBMISSION --html DIR]" in page.locator("nav.pages ul").inner_text(), "pages of one folder: how to make the others")
        page.get_by_role("link", name="extreme cases").click()
        expect(page.url.endswith("stress.html"), f"pages of one folder: the lesson leads to {page.url}")


def check_reading(browser, folder):
    """Every page leads to the handout, and what fails to the section about it; each link has a target."""
    for name, section in (("grade/index.html", "integrate_stratified"), ("failing/stress.html", "hit_sphere"),
                          ("failing/stress.html", "what-to-use-instead-of-an-epsilon"),
                          ("stress/lesson.html", "integrals-in-one-dimension"),
                          ("stress/converge.html", "error-against-run-time"), ("class/index.html", "phong")):
        with opened(browser, folder / name) as page:
            links = [a.get_attribute("href") for a in page.locator("a[href*='handout.']").all()]
            expect(any(link.endswith(f"#{section}") for link in links), f"{name} leads not to {section}: {links[:3]}")
            inner = page.evaluate("[...document.querySelectorAll('a[href^=\"#\"]')].filter(a => !document.getElementById("
                                  "a.getAttribute('href').slice(1))).map(a => a.getAttribute('href'))")
            expect(not inner, f"{name}: links to nothing: {inner}")
            if "failing" in name:
                row = page.locator(".overview tr:has(.failed)").first.inner_text()
                expect(re.search(r"at 1e-?\d+: ", row), f"a family that fails says why: {row!r}")


def check_narrow_stress(browser, page_file):
    with opened(browser, page_file, viewport={"width": 320, "height": 900}) as page:
        expect(page.locator(".overview tr.part").first.inner_text().strip() == "phong", "stress at 320: of which fragment a family is")
        names = page.evaluate("[...document.querySelectorAll('.overview td[data-is]')].slice(0, 2).map("
                              "cell => getComputedStyle(cell, '::before').content)")
        expect(names == ['"passes "', '"the right one "'], f"stress at 320: what its numbers are: {names}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("grade", metavar="GRADE")
    parser.add_argument("--keep", metavar="FOLDER", type=pathlib.Path)
    words = parser.parse_args()
    if not chromium:
        skip("there is no Chromium")
    if words.keep:
        words.keep.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        pages = make_pages(words.grade, pathlib.Path(folder))
        kinds = 9 if shutil.which("pandoc") else 8
        expect(len(pages) == kinds, f"{kinds} pages are written, not {len(pages)}")
        browser = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        for page_file in pages:
            check_widths(browser, page_file, words.keep)
        if kinds == 9:
            check_handout(browser, pathlib.Path(folder) / "handout/handout.html")
        check_links(browser, pathlib.Path(folder) / "stress")
        check_reading(browser, pathlib.Path(folder))
        graded = pathlib.Path(folder) / "grade/index.html"
        student = [graded, pathlib.Path(folder) / "passing/index.html"]
        student += [pathlib.Path(folder) / f"stress/{name}.html" for name in ("stress", "lesson", "converge")]
        for page_file in student:
            check_plain_words(browser, page_file)
        check_passing(browser, student[1])
        check_narrow_stress(browser, student[2])
        for check in (check_without_script, check_words, check_rows):
            check(browser, graded)
        for check in (check_comforts, check_print):
            check(browser, graded, FRAGMENTS)
        browser.close()
    end("all as expected")


if __name__ == "__main__":
    main()
