#!/usr/bin/env python3
"""The pages that the grader writes, in a browser: they fit every width, light and dark; they are complete without script,
ask nothing of a network, can be used by keyboard and printed, and axe-core finds nothing against them.

    tests/pages/pages_test.py GRADE [--keep FOLDER]

Needs Chromium, and Playwright and axe-playwright-python from PyPI; 77 without. FOLDER gets a picture of each page at each
width.
"""

import argparse
import pathlib
import shutil
import subprocess
import sys
import tempfile

try:
    from axe_playwright_python.sync_playwright import Axe
    from playwright.sync_api import sync_playwright
except ImportError as missing:
    print(f"{missing}: pip install playwright axe-playwright-python")
    sys.exit(77)
chromium = shutil.which("chromium") or shutil.which("google-chrome")
if not chromium:
    print("there is no Chromium")
    sys.exit(77)

WIDTHS = (320, 768, 1280, 1920)
# A crash, a compiler's message, statistics, pictures, a time-out, a blank, and what passes.
FRAGMENTS = "integrate_stratified whitted shadow_ray light_sample lens_ray free_flight phong".split()
faults = []


def expect(holds, what):
    if not holds:
        faults.append(what)
        print("FAILED:", what)


def make_pages(grade, folder):
    def run(*words):
        subprocess.run([grade, *words], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)

    example = folder / "example"
    shutil.copytree("tests/example", example)
    (example / "fragments/uniform_disk.cpp").unlink()  # does not end, and would be part of the picture
    run(example, *FRAGMENTS, "--seed", "1", "--html", folder / "grade")
    run("stress", "solution", "--only", "phong", "--html", folder / "stress")
    run("lesson", "solution", "--out", folder / "stress")
    for student in ("anna", "ben"):  # twins, and alike in what is wrong
        (folder / f"export/hw1-{student}").mkdir(parents=True)
        for name in ("phong", "whitted"):
            shutil.copy(example / f"fragments/{name}.cpp", folder / f"export/hw1-{student}")
    (folder / "export/hw1-a-name-as-long-as-names-of-repositories-and-groups-are-at-some-schools.zip").write_text("no archive")
    run("class", folder / "export", "-o", folder / "class", "--seed", "1")
    return sorted(folder.glob("*/*.html"))


def check_widths(browser, page_file, keep):
    for scheme in ("light", "dark"):
        for width in WIDTHS:
            name = f"{page_file.stem} of {page_file.parent.name} at {width}, {scheme}"
            page = browser.new_page(viewport={"width": width, "height": 900}, color_scheme=scheme)
            asked = []
            page.on("request", lambda request: asked.append(request.url))
            page.goto(page_file.as_uri())
            wide = page.evaluate("document.documentElement.scrollWidth")
            expect(wide <= width, f"{name}: {wide} wide")
            outside = [url for url in asked if not url.startswith(("file:", "data:"))]
            expect(not outside, f"{name}: asks for {outside}")
            if (width, scheme) in ((320, "light"), (1280, "dark")):
                page.evaluate("for (const d of document.querySelectorAll('details')) d.open = true")
                found = Axe().run(page).response["violations"]
                for violation in found:
                    node = violation["nodes"][0]
                    expect(False, f"{name}: {violation['id']}, {len(violation['nodes'])} times: {node['html'][:120]} "
                                  f"{node['failureSummary'].splitlines()[-1]}")
            if keep:
                page.screenshot(path=keep / f"{page_file.parent.name}_{page_file.stem}_{scheme}_{width}.png", full_page=True)
            page.close()


def check_links(browser, folder):
    """The page that was written first leads to the one that followed, and back; both name what is not there."""
    page = browser.new_page()
    page.goto((folder / "stress.html").as_uri())
    page.get_by_role("link", name="integrals").click()
    expect(page.url.endswith("lesson.html"), f"pages of one folder: stress leads to {page.url}")
    expect(page.locator("nav.pages [aria-current]").inner_text() == "integrals", "pages of one folder: which one this is")
    shown = page.evaluate("[...document.images].every(image => image.naturalWidth > 0)")
    expect(shown and page.locator("img").count() == 3, "the lesson's plots")
    page.locator("nav.pages summary").click()
    expect("./grade converge" in page.locator("nav.pages ul").inner_text(), "pages of one folder: how to make the others")
    page.get_by_role("link", name="extreme cases").click()
    expect(page.url.endswith("stress.html"), f"pages of one folder: the lesson leads to {page.url}")
    page.close()


def check_without_script(browser, page_file):
    context = browser.new_context(java_script_enabled=False)
    page = context.new_page()
    page.goto(page_file.as_uri())
    expect(not page.locator(".tools").first.is_visible(), "without script: buttons that do nothing")
    expect(page.locator(".own img").count() == 3, "without script: yours, right and difference side by side")
    expect(page.locator("#whitted pre").inner_text().find("transmittance") >= 0, "without script: the compiler's message")
    context.close()


def check_comforts(browser, page_file):
    page = browser.new_page()
    page.goto(page_file.as_uri())
    page.keyboard.press("Tab")
    expect(page.evaluate("document.activeElement.className") == "skip", "keyboard: the first stop skips to the verdicts")
    page.keyboard.press("n")
    first = page.evaluate("document.activeElement.textContent")
    page.keyboard.press("n")
    second = page.evaluate("document.activeElement.textContent")
    expect(first == "integrate_stratified" and second == "shadow_ray", f"keyboard: n goes to {first}, then {second}")
    page.get_by_role("button", name="only what is not passed").press("Enter")
    expect(not page.locator("tr.is_passed").first.is_visible(), "only what is not passed: hides what is")
    page.get_by_role("button", name="most points").press("Enter")
    lost = page.evaluate("[...document.querySelectorAll('.overview tbody tr')].map(row => Number(row.dataset.lost))")
    expect(len(lost) == len(FRAGMENTS) and lost == sorted(lost, reverse=True), f"most points first: {lost}")
    page.get_by_role("button", name="compare").first.press("Enter")
    canvas = page.locator(".stack canvas").first
    canvas.hover()
    expect(page.locator(".stack output").first.inner_text().startswith("pixel "), "compare: the pixel's values")
    page.get_by_role("button", name="in turn").first.press("Enter")
    page.wait_for_timeout(700)
    page.close()


def check_print(browser, page_file):
    page = browser.new_page()
    page.goto(page_file.as_uri())
    page.evaluate("window.dispatchEvent(new Event('beforeprint'))")
    expect(page.evaluate("[...document.querySelectorAll('details')].every(d => d.open)"), "print: all is unfolded")
    page.emulate_media(media="print")
    expect(page.locator("header").bounding_box()["y"] < 100, "print: the first page begins with the score")
    expect(page.pdf().startswith(b"%PDF"), "print: a PDF")
    page.close()


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("grade", metavar="GRADE")
    parser.add_argument("--keep", metavar="FOLDER", type=pathlib.Path)
    words = parser.parse_args()
    if words.keep:
        words.keep.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        pages = make_pages(words.grade, pathlib.Path(folder))
        expect(len(pages) == 4, f"four pages are written, not {len(pages)}")
        browser = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        for page_file in pages:
            check_widths(browser, page_file, words.keep)
        check_links(browser, pathlib.Path(folder) / "stress")
        graded = pathlib.Path(folder) / "grade/index.html"
        for check in (check_without_script, check_comforts, check_print):
            check(browser, graded)
        browser.close()
    print(f"{len(faults)} faults" if faults else "all as expected")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
