#!/usr/bin/env python3
"""The pages that the grader writes, in a browser: they fit every width, light and dark; they are complete without script,
ask nothing of a network, can be used by keyboard and printed, and axe-core finds nothing against them.

    tests/pages/pages_test.py GRADE [--keep FOLDER]

Needs Chromium, and Playwright and axe-playwright-python from PyPI; 77 without. FOLDER gets a picture of each page at each
width.
"""

import argparse
import base64
import pathlib
import re
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
patience = 600_000  # ms: of a machine that does much else
faults = []


def expect(holds, what):
    if not holds:
        faults.append(what)
        print("FAILED:", what)


def new_page(browser, **options):
    page = browser.new_page(**options)
    page.set_default_timeout(patience)
    return page


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


# What stands beyond the edge or beyond its card, or in a box that scrolls on a narrow page: nobody sees that digits are
# missing.
CUT = """[...document.querySelectorAll('td, th, header p, .score, figcaption, svg.bar, svg.reach, .plot, .points')].filter(e => {
    const box = e.getBoundingClientRect(), scroll = e.closest('.scroll, .wide');
    if (!box.width || e.closest('[role=region]')) return false;  // that one goes sideways, by keyboard too, with a cue
    const card = e.closest('.card'), edge = card && !scroll && card.getBoundingClientRect().right;
    return (edge && box.right > edge - 4) || box.right > innerWidth + 1 || (scroll && innerWidth <= 640 && scroll.scrollWidth > scroll.clientWidth + 1);
}).map(e => e.textContent.trim().slice(0, 60))"""


def share_of_white(page, element):
    """Of an element's pixels as they are seen."""
    shot = base64.b64encode(element.screenshot()).decode()
    return page.evaluate("""async shot => {
        const image = new Image();
        image.src = 'data:image/png;base64,' + shot;
        await image.decode();
        const canvas = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height });
        const context = canvas.getContext('2d');
        context.drawImage(image, 0, 0);
        const bytes = context.getImageData(0, 0, image.width, image.height).data;
        let white = 0;
        for (let i = 0; i < bytes.length; i += 4) white += Math.min(bytes[i], bytes[i + 1], bytes[i + 2]) > 245;
        return 4 * white / bytes.length;
    }""", shot)


def check_dark(page, name):
    """Maps of differences, their scales and plots are dark on a dark page."""
    page.evaluate("for (const image of document.images) image.loading = 'eager'")
    page.wait_for_function("[...document.images].every(image => image.complete)")
    for what in (".map img", ".scale", ".plot svg", ".plot img", ".plots svg"):
        for element in page.locator(what).all()[:3]:
            if element.is_visible():
                white = share_of_white(page, element)
                expect(white < 0.2, f"{name}: {white:.0%} of {what} is white")


def check_axe(page, name):
    page.evaluate("for (const d of document.querySelectorAll('details')) d.open = true")
    for violation in Axe().run(page).response["violations"]:
        node = violation["nodes"][0]
        expect(False, f"{name}: {violation['id']}, {len(violation['nodes'])} times: {node['html'][:120]} "
                      f"{node['failureSummary'].splitlines()[-1]}")


def check_handout(browser, page_file):
    """Links differ from text before and after a visit, light and dark; tables have names that tell them apart."""
    for scheme in ("light", "dark"):
        page = new_page(browser, color_scheme=scheme)
        page.goto(page_file.as_uri())
        rules = page.evaluate("[...document.styleSheets].flatMap(s => [...s.cssRules]).filter(r => r.selectorText === 'a:visited')"
                              ".map(r => r.cssText)")
        expect(not rules, f"handout, {scheme}: pandoc's own style for visited links: {rules}")
        pairs = "[...document.querySelectorAll('.pictures tr:not(:has(td + td + td)) img')]"
        sizes = page.evaluate("[getComputedStyle(document.documentElement).fontSize, "
                              f"Math.min(...{pairs}.map(i => i.getBoundingClientRect().width))]")
        expect(sizes[0] == "16px" and sizes[1] >= 480, f"handout, {scheme}: size of text and least width of pictures {sizes}")
        page.close()
    page = new_page(browser)
    page.goto(page_file.as_uri())
    names = page.evaluate("[...document.querySelectorAll('[role=region]')].map(e => e.ariaLabel)")
    expect(len(names) > 50 and len(names) == len(set(names)), f"handout: {len(names) - len(set(names))} tables go by another one's name")
    page.close()


def check_widths(browser, page_file, keep):
    for scheme in ("light", "dark"):
        for width in WIDTHS:
            name = f"{page_file.stem} of {page_file.parent.name} at {width}, {scheme}"
            page = new_page(browser, viewport={"width": width, "height": 900}, color_scheme=scheme)
            asked = []
            page.on("request", lambda request: asked.append(request.url))
            page.goto(page_file.as_uri())
            wide = page.evaluate("document.documentElement.scrollWidth")
            expect(wide <= width, f"{name}: {wide} wide")
            outside = [url for url in asked if not url.startswith(("file:", "data:"))]
            expect(not outside, f"{name}: asks for {outside}")
            cut = page.evaluate(CUT)
            expect(not cut, f"{name}: cut off: {cut[:3]}")
            if (width, scheme) == (768, "dark"):
                check_dark(page, name)
            if width in (320, 1280) and (page_file.stem == "handout" or (width == 320) == (scheme == "light")):
                check_axe(page, name)
            if keep:
                page.evaluate("for (const image of document.images) image.loading = 'eager'")
                page.wait_for_function("[...document.images].every(image => image.complete)")
                page.screenshot(path=keep / f"{page_file.parent.name}_{page_file.stem}_{scheme}_{width}.png", full_page=True)
            page.close()


def check_links(browser, folder):
    """The page that was written first leads to the one that followed, and back; both name what is not there."""
    page = new_page(browser)
    page.goto((folder / "stress.html").as_uri())
    page.get_by_role("link", name="integrals").click()
    expect(page.url.endswith("lesson.html"), f"pages of one folder: stress leads to {page.url}")
    expect(page.locator("nav.pages [aria-current]").inner_text() == "integrals", "pages of one folder: which one this is")
    shown = page.evaluate("[...document.images].every(image => image.naturalWidth > 0)")
    expect(shown and page.locator("img").count() == 3, "the lesson's plots")
    page.locator("nav.pages summary").click()
    expect("./grade SUBMISSION --html DIR" in page.locator("nav.pages ul").inner_text(), "pages of one folder: how to make the others")
    page.get_by_role("link", name="extreme cases").click()
    expect(page.url.endswith("stress.html"), f"pages of one folder: the lesson leads to {page.url}")
    page.close()


def check_reading(browser, folder):
    """Every page leads to the handout, and what fails to the section about it; each link has a target."""
    for name, section in (("grade/index.html", "integrate_stratified"), ("failing/stress.html", "hit_sphere"),
                          ("failing/stress.html", "what-to-use-instead-of-an-epsilon"),
                          ("stress/lesson.html", "integrals-in-one-dimension"),
                          ("stress/converge.html", "error-against-run-time"), ("class/index.html", "phong")):
        page = new_page(browser)
        page.goto((folder / name).as_uri())
        links = [a.get_attribute("href") for a in page.locator("a[href*='handout.']").all()]
        expect(any(link.endswith(f"#{section}") for link in links), f"{name} leads not to {section}: {links[:3]}")
        inner = page.evaluate("[...document.querySelectorAll('a[href^=\"#\"]')].filter(a => !document.getElementById("
                              "a.getAttribute('href').slice(1))).map(a => a.getAttribute('href'))")
        expect(not inner, f"{name}: links to nothing: {inner}")
        if "failing" in name:
            row = page.locator(".overview tr:has(.failed)").first.inner_text()
            expect(re.search(r"at 1e-?\d+: ", row), f"a family that fails says why: {row!r}")
        page.close()


def check_without_script(browser, page_file):
    context = browser.new_context(java_script_enabled=False)
    page = context.new_page()
    page.set_default_timeout(patience)
    page.goto(page_file.as_uri())
    expect(not page.locator(".tools").first.is_visible(), "without script: buttons that do nothing")
    expect(page.locator(".own img").count() == 3, "without script: yours, right and difference side by side")
    expect(page.locator("#whitted pre").inner_text().find("transmittance") >= 0, "without script: the compiler's message")
    context.close()


def check_comforts(browser, page_file):
    page = new_page(browser)
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
    check_radiance(page)
    expect(page.locator(".stack .border").first.bounding_box()["width"] == 2, "compare: a line at the border")
    labels = page.locator(".stack").first.locator("b")
    expect(labels.all_inner_texts() == ["yours", "the right one"], "compare: which side is which")
    page.get_by_role("button", name="flicker").first.press("Enter")
    page.wait_for_timeout(700)
    expect(labels.first.is_visible() != labels.last.is_visible(), "compare: flicker names the one that is shown")
    page.close()


def check_radiance(page):
    """What the pointer shows are the numbers of the caption below, of the same tile."""
    page.locator("#light_sample").get_by_role("button", name="compare").first.press("Enter")
    place = page.locator("#light_sample details.check:has(.stack)").first
    words = place.locator("figcaption").filter(has_text="Most clearly").first.inner_text()
    left, top = (int(n) for n in re.search(r"pixels (\d+) to .* and (\d+) to", words).groups())
    mine, right = (float(n) for n in re.search(r"are (\S+) bright, must be (\S+)", words).groups())
    canvas = place.locator(".stack canvas")
    box, size = canvas.bounding_box(), canvas.evaluate("c => c.width")
    canvas.hover(position={"x": (left + 4) * box["width"] / size, "y": (top + 4) * box["width"] / size})
    shown = place.locator(".stack output").inner_text()
    numbers = [float(n) for n in re.findall(r"[0-9][0-9.e-]*", shown.split(":")[1].replace("≥", ""))]
    expect(len(numbers) == 6, f"compare: the radiance of a pixel, in {shown!r}")
    for value, of_tile in ((numbers[1], mine), (numbers[4], right)):
        expect(abs(value - of_tile) <= 0.5 * of_tile + 1e-3, f"compare: {shown!r} where {words!r}")


def check_rows(browser, page_file):
    """Where a row of statistics is a block, verdicts stand below each other, and numbers begin in a line of their own."""
    for width in (320, 768, 1100):
        page = new_page(browser, viewport={"width": width, "height": 900})
        page.goto(page_file.as_uri())
        page.evaluate("for (const d of document.querySelectorAll('details')) d.open = true")
        rows = page.evaluate("""[...document.querySelectorAll('.statistics tr:has(td)')].map(row => {
            const box = cell => row.querySelector(cell).getBoundingClientRect();
            return [box('.verdict').left, box('.number').top - Math.max(box('td').bottom, box('.verdict').top)];
        })""")
        expect(len({left for left, _ in rows}) == 1, f"rows at {width}: verdicts begin at {sorted({left for left, _ in rows})}")
        expect(all(below >= 0 for _, below in rows), f"rows at {width}: numbers beside what they are of")
        page.close()


def check_unfolded(page, how):
    """Everything that is folded on the screen is read on paper."""
    lost = page.evaluate("""[...document.querySelectorAll('main details:not(nav *) > :not(summary, .compare)')].filter(
        e => e.textContent.trim() && !e.checkVisibility({ contentVisibilityAuto: true })).map(e => e.textContent.slice(0, 40))""")
    expect(not lost, f"print, {how}: folded: {lost[:3]}")


def check_print(browser, page_file):
    context = browser.new_context(java_script_enabled=False)
    page = new_page(context)
    page.goto(page_file.as_uri())
    page.emulate_media(media="print")
    expect(page.locator("#phong table").first.is_visible(), "print, without script: a check that passes is unfolded")
    check_unfolded(page, "without script")
    context.close()
    page = new_page(browser)
    page.goto(page_file.as_uri())
    page.evaluate("for (const d of document.querySelectorAll('details.check')) d.open = false")
    page.evaluate("window.dispatchEvent(new Event('beforeprint'))")
    folded = page.locator("main details:not([open])").count()
    expect(folded == 0, f"print: {folded} folds are closed")
    page.evaluate("window.dispatchEvent(new Event('afterprint'))")
    expect(page.locator("details.check[open]").count() == 0, "print: what was folded is folded again afterwards")
    page.emulate_media(media="print")
    expect(page.locator("header").bounding_box()["y"] < 100, "print: the first page begins with the score")
    kept = page.evaluate("[...document.querySelectorAll('.legend, .scale, .meter i')].map(e => getComputedStyle(e).printColorAdjust)")
    expect(set(kept) == {"exact"}, "print: legends and bars are there")
    for name in ("phong", "shadow_ray"):
        expect(page.locator(f"#{name} table").first.is_visible(), f"print: the checks of {name}, passed or not, are whole")
    check_unfolded(page, "with script")
    for section in page.locator("section.card.is_passed").all():
        words = section.locator("> p").first
        expect(words.is_visible() and re.fullmatch(r"(All of its \d+ checks pass|Its check passes): nothing is wrong\.",
                                                   words.inner_text()),
               f"print: {section.get_attribute('id')} says that it passes")
    beside = page.evaluate("""[...document.querySelectorAll('.statistics')].filter(table => {
        const [head, first] = table.rows;
        return first.getBoundingClientRect().left > head.getBoundingClientRect().left + 1;
    }).length""")
    expect(beside == 0, f"print: {beside} legends stand beside what they are of")
    pages = len(re.findall(rb"/Type\s*/Page\b", page.pdf(format="A4")))
    first = page.locator("#overview").bounding_box()
    expect(first["y"] < 400, "print: the overview begins on the first page")
    expect(not page.locator(".verdicts .read").first.is_visible(), "print: links take no room from hints")
    expect(2 <= pages <= 3 * len(FRAGMENTS), f"print: {pages} pages of A4 for {len(FRAGMENTS)} fragments")
    page.close()


def check_words(browser, page_file):
    """What is wrong is said once in a fragment, also in the overview; the words are the handout's."""
    page = new_page(browser)
    page.goto(page_file.as_uri())
    for text in page.locator("#overview tr:has-text('integrate_stratified')").all_inner_texts() + [
            page.locator("header").inner_text()]:
        expect("a null pointer is followed" in text, f"the line that crashes is in {text!r}")
    heads = page.locator(".verdicts th").all_inner_texts()
    expect(heads[:4] == ["fragment", "verdict", "points", "what is wrong"], f"the overview's heads: {heads}")
    for check in page.locator("details.check:has(> .hint)").all():
        expect("As said above" not in check.inner_text(), "a hint, and that it was said above")
    rows = page.evaluate("""[...document.querySelectorAll('.pictures')].filter(p => p.offsetParent).map(
        p => [p.children.length, new Set([...p.children].map(f => f.getBoundingClientRect().top)).size])""")
    expect(rows and all(lines == 1 for _, lines in rows), f"pictures of a check in one row: {rows}")
    link = page.locator("#integrate_stratified a").first
    expect(link.get_attribute("href").endswith("#integrate_stratified"), f"a crash leads to {link.get_attribute('href')}")
    for section in page.locator("section.card[id]:not(#overview)").all():
        hints = [line for hint in section.locator(".hint").all_inner_texts() for line in hint.splitlines()]
        expect(len(hints) == len(set(hints)), f"{section.get_attribute('id')}: told twice: {sorted(hints)}")
    headers = page.locator(".statistics").first.locator("th").all_text_contents()
    expect(headers[:5] == ["measures", "yours", "must be", "right within", "wrong beyond"], f"headers {headers}")
    page.close()


def check_plain_words(browser, page_file):
    """What students read speaks of errors, of what is theirs and of what is right."""
    page = new_page(browser)
    page.goto(page_file.as_uri())
    text = page.evaluate("""() => {
        const main = document.querySelector('main').cloneNode(true);
        for (const code of main.querySelectorAll('pre, code, figcaption details')) code.remove();
        return main.textContent;
    }""")
    for word in ("RMSE", "MSE", "Welch", "replicates", "^", "the solution", "ubmission's", "the submission"):
        expect(word not in text, f"{page_file.stem} of {page_file.parent.name} says {word}")
    page.close()


def check_passing(browser, page_file):
    page = new_page(browser)
    page.goto(page_file.as_uri())
    expect("All of it passes." in page.locator("header").inner_text(), "what passes says so at its head")
    expect(page.locator("details.check[open]").count() == 0, "what passes is folded")
    expect(page.locator(".own .map figcaption").inner_text() == "no difference", "a picture like the right one says so")
    page.close()


def check_narrow_stress(browser, page_file):
    page = new_page(browser, viewport={"width": 320, "height": 900})
    page.goto(page_file.as_uri())
    expect(page.locator(".overview tr.part").first.inner_text().strip() == "phong", "stress at 320: of which fragment a family is")
    names = page.evaluate("[...document.querySelectorAll('.overview td[data-is]')].slice(0, 2).map("
                          "cell => getComputedStyle(cell, '::before').content)")
    expect(names == ['"passes "', '"the right one "'], f"stress at 320: what its numbers are: {names}")
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
        for check in (check_without_script, check_comforts, check_words, check_rows, check_print):
            check(browser, graded)
        browser.close()
    print(f"{len(faults)} faults" if faults else "all as expected")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
