"""The page of a graded submission: without script, by keyboard, on paper; and what it says."""

import re

from helpers import expect
from opened import opened


def check_without_script(browser, page_file):
    with opened(browser, page_file, java_script_enabled=False) as page:
        expect(not page.locator(".tools").first.is_visible(), "without script: buttons that do nothing")
        expect(page.locator(".own img").count() == 3, "without script: yours, right and difference side by side")
        expect(page.locator("#whitted pre").inner_text().find("transmittance") >= 0, "without script: the compiler's message")


def check_comforts(browser, page_file, fragments):
    with opened(browser, page_file) as page:
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
        expect(len(lost) == len(fragments) and lost == sorted(lost, reverse=True), f"most points first: {lost}")
        page.get_by_role("button", name="compare").first.press("Enter")
        canvas = page.locator(".stack canvas").first
        canvas.wait_for()
        where = page.evaluate("[document.activeElement.type, document.activeElement.getBoundingClientRect().bottom <= innerHeight]")
        expect(where == ["range", True], f"compare: the focus is on {where[0]}, within the window: {where[1]}")
        canvas.hover()
        check_radiance(page)
        expect(page.locator(".stack .border").first.bounding_box()["width"] == 2, "compare: a line at the border")
        labels = page.locator(".stack").first.locator("b")
        expect(labels.all_inner_texts() == ["yours", "the right one"], "compare: which side is which")
        page.get_by_role("button", name="flicker").first.press("Enter")
        page.wait_for_timeout(700)
        expect(labels.first.is_visible() != labels.last.is_visible(), "compare: flicker names the one that is shown")


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
        with opened(browser, page_file, viewport={"width": width, "height": 900}) as page:
            page.evaluate("for (const d of document.querySelectorAll('details')) d.open = true")
            rows = page.evaluate("""[...document.querySelectorAll('.statistics tr:has(td)')].map(row => {
                const box = cell => row.querySelector(cell).getBoundingClientRect();
                return [box('.verdict').left, box('.number').top - Math.max(box('td').bottom, box('.verdict').top)];
            })""")
            expect(len({left for left, _ in rows}) == 1, f"rows at {width}: verdicts begin at {sorted({left for left, _ in rows})}")
            expect(all(below >= 0 for _, below in rows), f"rows at {width}: numbers beside what they are of")


def check_unfolded(page, how):
    """Everything that is folded on the screen is read on paper."""
    lost = page.evaluate("""[...document.querySelectorAll('main details:not(nav *) > :not(summary, .compare)')].filter(
        e => e.textContent.trim() && !e.checkVisibility({ contentVisibilityAuto: true })).map(e => e.textContent.slice(0, 40))""")
    expect(not lost, f"print, {how}: folded: {lost[:3]}")


def check_print(browser, page_file, fragments):
    with opened(browser, page_file, java_script_enabled=False) as page:
        page.emulate_media(media="print")
        expect(page.locator("#phong table").first.is_visible(), "print, without script: a check that passes is unfolded")
        check_unfolded(page, "without script")
    with opened(browser, page_file) as page:
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
        expect(2 <= pages <= 3 * len(fragments), f"print: {pages} pages of A4 for {len(fragments)} fragments")


def check_words(browser, page_file):
    """What is wrong is said once in a fragment, also in the overview; the words are the handout's."""
    with opened(browser, page_file) as page:
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


def check_plain_words(browser, page_file):
    """What students read speaks of errors, of what is theirs and of what is right."""
    with opened(browser, page_file) as page:
        text = page.evaluate("""() => {
            const main = document.querySelector('main').cloneNode(true);
            for (const code of main.querySelectorAll('pre, code, figcaption details')) code.remove();
            return main.textContent;
        }""")
        for word in ("RMSE", "MSE", "Welch", "replicates", "^", "the solution", "ubmission's", "the submission"):
            expect(word not in text, f"{page_file.stem} of {page_file.parent.name} says {word}")


def check_passing(browser, page_file):
    with opened(browser, page_file) as page:
        expect("All of it passes." in page.locator("header").inner_text(), "what passes says so at its head")
        expect(page.locator("details.check[open]").count() == 0, "what passes is folded")
        expect(page.locator(".own .map figcaption").inner_text() == "no difference", "a picture like the right one says so")
